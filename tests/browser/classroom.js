// A class of forty as a test meets it: who is in it, what they hand in without a browser, and what pages and tables say of it.

import assert from "node:assert/strict";

const GIVEN = ["Ada", "Ben", "Chen", "Dora", "Emil", "Farah", "Gita", "Hugo"];
const FAMILY = ["Adams", "Brandt", "Costa", "Diallo", "Eriksen"];

/** @typedef {{ id: string, name: string, section: string }} Student */

/** Forty students in two sections. @type {Student[]} */
export const STUDENTS = FAMILY.flatMap((family, row) =>
  GIVEN.map((given, column) => ({
    id: `s${String(row * GIVEN.length + column + 1).padStart(2, "0")}`,
    name: `${given} ${family}`,
    section: column % 2 === 0 ? "A" : "B",
  })),
);

/** The roster as a table. */
export const ROSTER = ["id,name,section", ...STUDENTS.map((own) => `${own.id},${own.name},${own.section}`), ""].join("\n");

/** The fields of an assignment: its title, its times and what it takes off. */
export const RULES = {
  title: "Sheet 1",
  opens: "2026-10-05T10:00",
  due: "2026-10-12T18:00",
  late_until: "2026-10-14T18:00",
  late_penalty: "20 %",
  closes: "2026-10-15T18:00",
  attempts: "3",
  attempt_penalty: "10 %",
};

/**
 * The cells of a table of comma-separated values.
 * @param {string} text
 * @returns {string[][]}
 */
export function cells_of(text) {
  const rows = text.trimEnd().split(/\r?\n/);
  const cell = /(?:^|,)(?:"((?:[^"]|"")*)"|([^,]*))/g;
  return rows.map((row) => [...row.matchAll(cell)].map(([, quoted, plain]) => quoted?.replaceAll('""', '"') ?? plain ?? ""));
}

/**
 * The right answers by student and problem, in the order of the parts, as a printed key says them.
 * @param {string} html
 * @returns {Map<string, string[]>} under `id problem`
 */
export function key_of(html) {
  const answers = new Map();
  for (const table of html.split("<section>").slice(1)) {
    const problem = /<code>([^<]+)<\/code>/.exec(table)?.[1];
    for (const [, id, cells] of table.matchAll(/<tr><td>[^<]*\((\w+)\)<\/td><td>[^<]*<\/td>(.*?)<\/tr>/g)) {
      const parts = [...String(cells).matchAll(/<td>(.*?)<\/td>/g)].map(([, part]) => String(part));
      const texts = parts.map((part) => part.replaceAll(/<[^>]+>/g, "").replaceAll("\u00a0", " ").trim());
      answers.set(`${id} ${problem}`, texts);
    }
  }
  return answers;
}

/** Somebody who asks the server without a browser, as one browser would. */
export class Visitor {
  #cookie = "";

  /** @param {string} url */
  constructor(url) {
    this.url = url;
  }

  /**
   * A visitor who has signed in by a link.
   * @param {string} link
   */
  static async by(link) {
    const own = new Visitor(new URL(link).origin);
    await own.#ask(link, {});
    return own;
  }

  /**
   * The text of a page.
   * @param {string} path
   */
  async get(path) {
    const response = await this.#ask(path);
    assert.equal(response.status, 200, path);
    return response.text();
  }

  /**
   * Sends a form that is answered by a page or a file; its text.
   * @param {string} path
   * @param {Record<string, string>} fields
   */
  async send(path, fields) {
    const response = await this.#ask(path, fields);
    assert.equal(response.status, 200, path);
    return response.text();
  }

  /** The cookie of the session, as a browser takes it. */
  get session() {
    const [name = "", value = ""] = this.#cookie.split("=");
    return { name, value, url: this.url };
  }

  /**
   * Sends a form; the address to which it leads.
   * @param {string} path
   * @param {Record<string, string>} fields
   */
  async post(path, fields) {
    const response = await this.#ask(path, fields);
    assert.equal(response.status, 303, `${path}: ${await response.text()}`);
    return response.headers.get("location") ?? "";
  }

  /**
   * @param {string} path
   * @param {Record<string, string>} [fields]
   */
  async #ask(path, fields) {
    const body = fields && new URLSearchParams(fields);
    const method = body ? "POST" : "GET";
    const headers = { cookie: this.#cookie, origin: this.url };
    const response = await fetch(new URL(path, this.url), { method, body, headers, redirect: "manual" });
    const cookie = response.headers.get("set-cookie");
    if (cookie) this.#cookie = cookie.split(";")[0] ?? "";
    return response;
  }
}

/**
 * The names of the fields of a sheet, in the order of its parts.
 * @param {string} page
 */
export function fields_of(page) {
  const names = [...page.matchAll(/name="(answer\.[^"]+)"/g)].map(([, name]) => String(name));
  return [...new Set(names)].filter((name) => name !== "answer.work");
}

/**
 * The common velocity of the two trolleys after they have coupled, by the momentum that the text of a sheet gives them.
 * @param {string} text
 */
export function coupled(text) {
  const carts = [...text.matchAll(/rolley [AB] \((\d+) kg\) moves at (\d+) m\/s to the (right|left)/g)];
  assert.equal(carts.length, 2, text);
  const bodies = carts.map(([, mass, speed, way]) => ({ mass: Number(mass), velocity: (way === "left" ? -1 : 1) * Number(speed) }));
  const momentum = bodies.reduce((sum, own) => sum + own.mass * own.velocity, 0);
  const mass = bodies.reduce((sum, own) => sum + own.mass, 0);
  return `${(momentum / mass).toPrecision(4)} m/s`;
}

/**
 * The text of a page without its marks, with plain spaces.
 * @param {string} page
 */
export function plain(page) {
  return page.replaceAll(/<[^>]+>/g, "").replaceAll(/(\s|&nbsp;)+/g, " ");
}
