// The practice page that needs no server: one file from disk, a folder, a package in a learning platform.

import assert from "node:assert/strict";
import { execFileSync } from "node:child_process";
import { createReadStream, mkdtempSync, readFileSync, rmSync } from "node:fs";
import { createServer } from "node:http";
import { createRequire } from "node:module";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { after, before, test } from "node:test";
import { pathToFileURL } from "node:url";

import { barriers } from "./axe.js";
import { browse, program, strict_page } from "./server.js";

/** @type {string} */
let folder;
/** @type {import("playwright-core").Browser} */
let browser;

before(async () => {
  folder = mkdtempSync(join(tmpdir(), "momentous-"));
  browser = await browse();
});

after(async () => {
  await browser.close();
  rmSync(folder, { recursive: true });
});

/** @param {string[]} problems what goes into the page, and how */
function made(...problems) {
  execFileSync(program, ["page", ...problems], { cwd: folder, encoding: "utf8" });
}

// A program without the engine for browsers makes no page. Where there is said to be one, it must.
const skip = !process.env.MOMENTOUS_ENGINE && "the program has no engine: MOMENTOUS_ENGINE was not set when it was built";

/**
 * The answers of a variant, as the program prints them.
 * @param {string} problem
 * @param {string} form
 * @param {number} seed
 * @returns {Record<string, string>}
 */
function key(problem, form, seed) {
  const arguments_ = ["solve", problem, "--form", form, "--seed", String(seed), "--format", "json"];
  const { ask } = JSON.parse(execFileSync(program, arguments_, { cwd: folder, encoding: "utf8" }));
  return Object.fromEntries(ask.map((/** @type {any} */ part) => [part.id, part.printed]));
}

/**
 * The sheet of two carts, answered.
 * @param {import("playwright-core").FrameLocator} frame
 */
async function answer(frame) {
  for (const [part, text] of Object.entries(key("impact/two-carts", "forward", 1))) {
    await frame.locator(`[name="answer.${part}"]`).fill(text);
  }
  await frame.getByRole("button", { name: "Check" }).click();
  await frame.locator(".total.right").waitFor();
}

/** Serves the folder of the test. */
async function served() {
  const kinds = /** @type {Record<string, string>} */ ({ html: "text/html", js: "text/javascript", gz: "application/octet-stream" });
  const server = createServer(({ url = "" }, response) => {
    const path = url.split("?")[0] ?? "";
    response.setHeader("content-type", kinds[path.split(".").at(-1) ?? ""] ?? "text/plain");
    createReadStream(join(folder, path)).on("error", () => response.writeHead(404).end()).pipe(response);
  });
  await new Promise((resolve) => server.listen(0, "127.0.0.1", () => resolve(undefined)));
  const address = /** @type {import("node:net").AddressInfo} */ (server.address());
  return { url: `http://127.0.0.1:${address.port}`, stop: () => server.close() };
}

test("a file from disk shows, marks and solves without a network", { skip }, async () => {
  made("impact/two-carts", "bouncing/", "-o", "practice.html");
  const { page, complaints, close } = await strict_page(browser, { offline: true, bypassCSP: true });
  await page.goto(pathToFileURL(join(folder, "practice.html")).href);
  const frame = page.frameLocator("iframe");
  await frame.getByRole("link", { name: "Two carts", exact: false }).first().click();
  await frame.locator('[data-part="v_A2"]').fill("0,5 m/s left");
  await frame.locator('[data-reading="v_A2"][data-state="read"]').waitFor();
  assert.equal(await frame.locator('[data-reading="v_A2"]').textContent(), "Read as 0.5 metres per second to the left.");
  await answer(frame);
  assert.match(page.url(), /#\/practice\/impact\/two-carts\?form=forward&seed=1$/);
  assert.deepEqual(await barriers(page), []);

  await frame.locator('[data-part="v_A2"]').fill("12.0 m/s");
  await frame.getByRole("button", { name: "Check" }).click();
  await frame.getByRole("link", { name: "(a)" }).click();
  assert.equal(await frame.locator(":focus").getAttribute("data-part"), "v_A2");
  await answer(frame);

  await page.reload();
  await frame.locator(".total.right").waitFor();
  await frame.getByRole("link", { name: "Whole solution" }).click();
  await frame.getByRole("heading", { name: "Two carts" }).waitFor();
  assert.match(page.url(), /#\/solution\//);
  await page.goBack();
  await frame.getByRole("link", { name: "Play" }).click();
  await frame.locator("section.film").waitFor();
  await frame.getByRole("link", { name: "Momentous" }).click();
  await frame.getByText("✓ all right").waitFor();
  await frame.locator("img[data-figure][src]").first().waitFor();

  const download = page.waitForEvent("download");
  await page.getByText("Your answers").click();
  await page.getByLabel("Name").fill("Ada");
  await page.getByRole("button", { name: "Download answers" }).click();
  await (await download).saveAs(join(folder, "answers.csv"));
  const graded = execFileSync(program, ["grade", "answers.csv"], { cwd: folder, encoding: "utf8" });
  assert.match(graded, /Ada,impact\/two-carts.*right/);
  assert.deepEqual(complaints, []);
  await close();
});

for (const simulator of ["Collision", "Collision in the plane", "Restitution"]) {
  test(`the ${simulator.toLowerCase()} simulator runs from disk`, { skip }, async () => {
    made("impact/two-carts", "-o", "practice.html");
    const { page, complaints, close } = await strict_page(browser, { offline: true, bypassCSP: true });
    await page.goto(pathToFileURL(join(folder, "practice.html")).href);
    const frame = page.frameLocator("iframe");
    await frame.getByRole("link", { name: simulator, exact: true }).click();
    await frame.locator('[data-simulator][data-state="shown"]').waitFor();
    await frame.locator("form.controls input[data-for]").first().press("ArrowRight");
    await page.waitForURL(/\?.*=/);
    await frame.getByRole("link", { name: "Show the solution" }).click();
    await frame.getByRole("heading", { level: 1 }).waitFor();
    assert.match(page.url(), /#\/solution\/.*set\./);
    assert.deepEqual(complaints, []);
    await close();
  });
}

test("a folder is a page in a web space", { skip }, async () => {
  made("impact/two-carts", "-o", "web/");
  const space = await served();
  const { page, complaints, close } = await strict_page(browser);
  await page.goto(`${space.url}/web/index.html`);
  await page.frameLocator("iframe").locator('[data-part="v_A2"]').waitFor();
  assert.deepEqual(complaints, []);
  await close();
  space.stop();
});

test("a learning platform is told what was right", { skip }, async () => {
  made("impact/two-carts", "--scorm", "--score", "-o", "two-carts.zip");
  execFileSync("unzip", ["-q", "-o", "two-carts.zip", "-d", "package"], { cwd: folder });
  const runtime = createRequire(import.meta.url).resolve("scorm-again/scorm12/min");
  const space = await served();
  const { page, complaints, close } = await strict_page(browser);
  await page.route("**/platform.html", (route) => {
    const script = readFileSync(runtime, "utf8");
    const body = `<!DOCTYPE html><script>${script}</script><script>window.API = new Scorm12API({ autocommit: false });</script><iframe src="/package/index.html" style="width: 90vw; height: 80vh"></iframe>`;
    return route.fulfill({ contentType: "text/html", body });
  });
  await page.goto(`${space.url}/platform.html`);
  const frame = page.frameLocator("iframe").frameLocator("iframe");
  await frame.locator('[data-part="v_A2"]').waitFor();
  const told = (/** @type {string} */ name) => page.evaluate((name) => Reflect.get(window, "API").LMSGetValue(name), name);
  assert.equal(await told("cmi.core.lesson_status"), "incomplete");
  await answer(frame);
  assert.equal(await told("cmi.core.lesson_status"), "completed");
  assert.equal(await told("cmi.suspend_data"), "1");
  assert.equal(await told("cmi.core.score.raw"), "100");
  assert.deepEqual(complaints, []);
  await close();
  space.stop();
});
