// Every page of a course, as its students and its teacher meet it: accessible, nothing beyond the window and nothing cut off, narrow, wide,
// and enlarged, in light and dark, with nothing that its policy forbids.

import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { after, before, test } from "node:test";

import { barriers, cut_off } from "./axe.js";
import { Visitor } from "./classroom.js";
import { browse, strict_page } from "./server.js";
import { small_course } from "./small_course.js";

/** The widths at which pages are read; 640 is a window of 1280 at 200 %. In the dark nothing is wider. */
const WIDTHS = { light: [320, 640, 768, 1280], dark: [1280] };

/** @type {Awaited<ReturnType<typeof small_course>>} */
let made;
/** @type {import("playwright-core").Browser} */
let browser;
/** Who looks. @type {Record<"nobody" | "student" | "fresh" | "teacher", Visitor>} */
let visitors;

before(async () => {
  [made, browser] = await Promise.all([small_course(), browse()]);
  visitors = {
    nobody: new Visitor(made.server.url),
    student: made.visitors[0] ?? new Visitor(made.server.url),
    fresh: await Visitor.by(made.links.get("ada") ?? ""),
    teacher: made.operator,
  };
});

after(async () => {
  await browser.close();
  await made.server.stop();
});

/** @typedef {{ who: keyof typeof visitors, at: () => string, then?: (page: import("playwright-core").Page) => Promise<void> }} Look */

/** By the row of the table of routes: who looks at which page, and what is done there first. @type {[string, Look][]} */
const PAGES = [
  ["/sign-in", { who: "nobody", at: () => "/sign-in" }],
  ["/sign-in/{token}", { who: "nobody", at: () => "/sign-in/0" }],
  ["/mail", { who: "nobody", at: () => "/mail" }],
  ["/mail/{token}", { who: "nobody", at: () => "/mail/0" }],
  ["/join", { who: "nobody", at: () => "/join" }],
  ["/join/{code}", { who: "nobody", at: () => made.join }],
  ["/join/{code}", { who: "nobody", at: () => made.join, then: (page) => page.getByRole("button", { name: "Ask for a place" }).click() }],
  ["/join/{code}", { who: "teacher", at: () => made.join }],
  ["/courses", { who: "fresh", at: () => "/courses" }],
  ["/courses", { who: "teacher", at: () => "/courses" }],
  ["/courses/{course}", { who: "student", at: () => made.course }],
  ["/courses/{course}", { who: "teacher", at: () => made.course }],
  ["/courses/{course}/assignments/{assignment}", { who: "student", at: () => made.assignment }],
  ["/courses/{course}/assignments/{assignment}", { who: "teacher", at: () => made.assignment }],
  ["/courses/{course}/items/{item}", { who: "fresh", at: () => made.items[1] ?? "" }],
  ["/courses/{course}/items/{item}", { who: "fresh", at: () => made.items[2] ?? "" }],
  ["/courses/{course}/items/{item}", { who: "student", at: () => made.items[1] ?? "" }],
  ["/courses/{course}/items/{item}/solution", { who: "teacher", at: () => `${made.items[1]}/solution` }],
  ["/courses/{course}/gradebook", { who: "teacher", at: () => `${made.course}/gradebook` }],
  ["/courses/{course}/assignments/{assignment}/gradebook", { who: "teacher", at: () => `${made.assignment}/gradebook` }],
  ["/courses/{course}/assignments/{assignment}/statistics", { who: "teacher", at: () => `${made.assignment}/statistics` }],
  ["/courses/{course}/assignments/{assignment}/regrade", { who: "teacher", at: () => `${made.assignment}/regrade` }],
  ["/courses/{course}/items/{item}/students/{member}", { who: "teacher", at: () => `${made.items[1]}/students/${made.member}` }],
  ["/courses/{course}/items/{item}/students/{member}", { who: "teacher", at: () => `${made.items[1]}/students/${made.members[0]}` }],
  ["/courses/{course}/members/{member}", { who: "teacher", at: () => `${made.course}/members/${made.member}` }],
  ["/courses/{course}/trail", { who: "teacher", at: () => `${made.course}/trail` }],
  ["/courses/{course}/retention", { who: "teacher", at: () => `${made.course}/retention` }],
  ["/people", { who: "teacher", at: () => "/people" }],
  ["/people", { who: "teacher", at: () => "/people", then: (page) => page.getByRole("button", { name: "New link for bob" }).click() }],
  ["/courses/new", { who: "teacher", at: () => "/courses/new" }],
  ["/courses/new", { who: "teacher", at: () => "/courses/new", then: (page) => page.getByRole("button", { name: "Create course" }).click() }],
  ["/courses/{course}/settings", { who: "teacher", at: () => `${made.course}/settings` }],
  ["/courses/{course}/roster", { who: "teacher", at: () => `${made.course}/roster` }],
  ["/courses/{course}/roster", { who: "teacher", at: () => `${made.course}/roster`, then: (page) => paste(page, "id,name,section\nada,Ada <b>,B\n") }],
  ["/courses/{course}/roster", { who: "teacher", at: () => `${made.course}/roster`, then: (page) => paste(page, "name\nAda\n") }],
  ["/courses/{course}/problems", { who: "teacher", at: () => `${made.course}/problems` }],
  ["/courses/{course}/problems/new", { who: "teacher", at: () => `${made.course}/problems/new?from=impact/two-carts` }],
  ["/courses/{course}/problems/new", { who: "teacher", at: () => `${made.course}/problems/new?from=impact/two-carts`, then: (page) => page.getByRole("button", { name: "Preview" }).click() }],
  ["/courses/{course}/problems/{digest}", { who: "teacher", at: () => made.problem }],
  ["/courses/{course}/assignments/{assignment}/print", { who: "teacher", at: () => `${made.assignment}/print` }],
  ["/courses/{course}/look", { who: "teacher", at: () => `${made.course}/look?problem=impact/two-carts` }],
  ["/courses/{course}/assignments/new", { who: "teacher", at: () => `${made.course}/assignments/new` }],
  ["/courses/{course}/assignments/{assignment}/edit", { who: "teacher", at: () => `${made.assignment}/edit` }],
  ["/courses/{course}/assignments/{assignment}/extensions", { who: "teacher", at: () => `${made.assignment}/extensions` }],
];

/** What is shown by saving it. */
const FILES = ["gradebook.csv", "/members/{member}/data", "/print/sheets", "/print/key"];

/**
 * Shows what a roster would change.
 * @param {import("playwright-core").Page} page
 * @param {string} table
 */
async function paste(page, table) {
  await page.locator("textarea[name=table]").fill(table);
  await page.getByRole("button", { name: "Preview changes" }).click();
}

test("every page in the table of routes is looked at", () => {
  const routes = readFileSync(new URL("../../src/course_pages/table.rs", import.meta.url), "utf8");
  const shown = [...routes.matchAll(/^ +Shows +"([^"]+)"/gm)].map(([, address]) => String(address));
  assert.ok(shown.length > 25, "the table was read");
  const pages = shown.filter((address) => !FILES.some((end) => address.endsWith(end)));
  assert.deepEqual([...new Set(PAGES.map(([address]) => address))].sort(), pages.sort());
});

for (const [pattern, { who, at, then }] of PAGES) {
  for (const colorScheme of /** @type {const} */ (["light", "dark"])) {
    const what = `${pattern}${then ? ", and a form" : ""}`;
    test(`${what} is accessible and fits, ${who}, ${colorScheme}`, async () => {
      const { page, complaints, close } = await strict_page(browser, { colorScheme, bypassCSP: true });
      if (who !== "nobody") await page.context().addCookies([visitors[who].session]);
      for (const width of WIDTHS[colorScheme]) {
        await page.setViewportSize({ width, height: width === 640 ? 400 : 800 });
        await page.goto(made.server.url + at());
        await then?.(page);
        await page.locator("h1").first().waitFor();
        const found = width === 320 || width === 1280 ? await barriers(page) : await cut_off(page);
        assert.deepEqual(found, [], `${width} px`);
      }
      assert.deepEqual(complaints, []);
      await close();
    });
  }
}
