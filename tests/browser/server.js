// The program under test, and a browser that looks at its pages.

import { spawn } from "node:child_process";
import { once } from "node:events";
import { existsSync, mkdtempSync, rmSync } from "node:fs";
import { tmpdir } from "node:os";
import { dirname, join, resolve } from "node:path";
import { createInterface } from "node:readline";
import { fileURLToPath } from "node:url";

import { chromium } from "playwright-core";

const project = resolve(dirname(fileURLToPath(import.meta.url)), "../..");

/** The program: MOMENTOUS, else what the last build made. */
export const program =
  process.env.MOMENTOUS ??
  ["release", "debug"].map((kind) => join(project, "target", kind, "momentous")).find(existsSync) ??
  "momentous";

/** The same server with a clock that a test sets: CLOCKED, else the example `clocked` as the last build made it. */
const clocked_program =
  process.env.CLOCKED ??
  ["release", "debug"].map((kind) => join(project, "target", kind, "examples/clocked")).find(existsSync) ??
  "clocked";

/** The browser: CHROMIUM, else Debian's. */
const executablePath = process.env.CHROMIUM ?? "/usr/bin/chromium";

const FLAGS = [
  "--no-sandbox",
  "--disable-gpu",
  "--disable-quic",
  "--no-first-run",
  "--disable-background-networking",
  "--disable-component-update",
  "--disable-sync",
];

/**
 * Starts the program in an empty folder, on a port that is free.
 * @param {string[]} [more] further arguments
 * @returns {Promise<{ url: string, folder: string, stop: () => Promise<void> }>}
 */
export async function start(more = []) {
  const folder = mkdtempSync(join(tmpdir(), "momentous-"));
  const server = spawn(program, ["serve", "--quiet", "--bind", "127.0.0.1:0", ...more], {
    cwd: folder,
    stdio: ["ignore", "pipe", "inherit"],
  });
  const lines = createInterface({ input: server.stdout });
  const url = (await first_address(server, lines, "serve")).replace(/\/$/, "");
  return { url, folder, stop: () => stopped(server, folder) };
}

/**
 * Starts the server in an empty folder with a clock that stands where the test puts it.
 * @param {string} moment when it begins, as ISO 8601
 * @returns {Promise<{ url: string, link: string, folder: string, set: (moment: string) => Promise<void>, stop: () => Promise<void> }>}
 *   with the link by which the first operator signs in
 */
export async function start_clocked(moment) {
  const folder = mkdtempSync(join(tmpdir(), "momentous-"));
  const server = spawn(clocked_program, [program, "smtp://127.0.0.1:1"], { cwd: folder, stdio: ["pipe", "pipe", "inherit"] });
  const lines = createInterface({ input: server.stdout });
  server.stdin.write(`${Date.parse(moment)}\n`);
  const link = await first_address(server, lines, "clocked");
  return {
    url: new URL(link).origin,
    link,
    folder,
    set: async (moment) => {
      const heard = once(lines, "line");
      server.stdin.write(`${Date.parse(moment)}\n`);
      await heard;
    },
    stop: () => stopped(server, folder),
  };
}

/**
 * The address that a server prints first.
 * @param {import("node:child_process").ChildProcess} server
 * @param {import("node:readline").Interface} lines
 * @param {string} name
 */
async function first_address(server, lines, name) {
  const first = await Promise.race([once(lines, "line"), once(server, "exit"), once(server, "error")]);
  const address = String(first[0]).match(/http:\/\/\S+/)?.[0];
  if (!address) throw new Error(`${name} did not start: ${first[0]}`);
  return address;
}

/**
 * @param {import("node:child_process").ChildProcess} server
 * @param {string} folder
 */
async function stopped(server, folder) {
  server.kill("SIGTERM");
  if (server.exitCode === null) await once(server, "exit");
  rmSync(folder, { recursive: true, force: true });
}

/** A headless browser. */
export function browse() {
  return chromium.launch({ executablePath, args: FLAGS });
}

/**
 * A page that fails the test where anything is logged as an error, or the page's policy is broken.
 * @param {import("playwright-core").Browser} browser
 * @param {import("playwright-core").BrowserContextOptions} [options]
 */
export async function strict_page(browser, options = {}) {
  const context = await browser.newContext(options);
  const page = await context.newPage();
  /** @type {string[]} */
  const complaints = [];
  page.on("console", (message) => {
    // A refusal of the engine is answered with a status of its own, which Chromium logs.
    const is_status = message.text().startsWith("Failed to load resource: the server responded with a status of 4");
    if (message.type() === "error" && !is_status) complaints.push(message.text());
  });
  page.on("pageerror", (error) => complaints.push(String(error)));
  return { page, complaints, close: () => context.close() };
}
