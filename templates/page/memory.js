// @ts-check
// What stays in this browser: answers, and the problems that were right. They can be taken along as a table.

/** @typedef {{ answers: Record<string, [string, string][]>, right: string[], student: string }} Kept */

/** What stays in this browser, for these problems. */
class Memory {
  #key;
  /** @type {Kept} */
  kept = { answers: {}, right: [], student: "" };

  /** @param {string} key */
  constructor(key) {
    this.#key = key;
    try {
      this.kept = { ...this.kept, ...JSON.parse(localStorage.getItem(key) ?? "{}") };
    } catch {
      // A browser may refuse; then nothing stays.
    }
  }

  save() {
    try {
      localStorage.setItem(this.#key, JSON.stringify(this.kept));
    } catch {
      // As above.
    }
  }

  forget() {
    this.kept = { ...this.kept, answers: {}, right: [] };
    this.save();
  }
}

/** A cell of a table as `momentous grade` reads it. @param {string} text */
function cell(text) {
  return /[",\n\r]/.test(text) ? `"${text.replaceAll('"', '""')}"` : text;
}

/**
 * The answers as the table of submissions that `momentous grade` marks.
 * @param {Kept} kept
 */
function submissions({ answers, student }) {
  const rows = Object.entries(answers).map(([address, fields]) => {
    const [path = "", query = ""] = address.split("?");
    const asked = new URLSearchParams(query);
    /** @type {Record<string, string>} */
    const row = { student, problem: path.replace("/practice/", ""), seed: asked.get("seed") ?? "1", form: asked.get("form") ?? "" };
    for (const [name, value] of fields) if (name.startsWith("answer.")) row[name.slice("answer.".length)] = value;
    return row;
  });
  const names = [...new Set(["student", "problem", "seed", "form", ...rows.flatMap((row) => Object.keys(row))])];
  return [names, ...rows.map((row) => names.map((name) => row[name] ?? ""))].map((line) => line.map(cell).join(",")).join("\r\n");
}
