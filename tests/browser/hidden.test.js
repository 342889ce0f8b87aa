// What solves an open assignment is hidden from its students, where the assignment says so: the simulators play, and solve nothing.

import assert from "node:assert/strict";
import { after, before, test } from "node:test";

import { Visitor } from "./classroom.js";
import { browse, strict_page } from "./server.js";
import { small_course } from "./small_course.js";

/** @type {Awaited<ReturnType<typeof small_course>>} */
let made;
/** @type {import("playwright-core").Browser} */
let browser;

before(async () => {
  [made, browser] = await Promise.all([small_course(["bob"], { solvers: "hidden" }), browse()]);
});

after(async () => {
  await browser.close();
  await made.server.stop();
});

/** @type {[string, () => Visitor | undefined, boolean][]} */
const READERS = [
  ["a student", () => made.visitors[0], false],
  ["somebody who is not known", () => undefined, false],
  ["who teaches", () => made.operator, true],
];

for (const [who, visitor, solves] of READERS) {
  test(`the collision plays and ${solves ? "is" : "is not"} solved for ${who}`, async () => {
    const { page, complaints, close } = await strict_page(browser);
    const own = visitor();
    if (own) await page.context().addCookies([own.session]);
    await page.goto(`${made.server.url}/simulators/collision`);
    await page.locator("[data-simulator][data-state=ready], [data-simulator][data-playing]").first().waitFor();
    const solution = page.locator("[data-solution]");
    const velocity = page.locator("[data-show='bodies.0.after']");
    for (const mass of ["3", "12"]) {
      const before = await velocity.textContent();
      await page.locator("#m_A").fill(mass);
      await page.locator("#m_A").blur();
      if (mass === "12") await page.waitForFunction((before) => document.querySelector("[data-show='bodies.0.after']")?.textContent !== before, before);
      assert.equal(((await solution.textContent()) ?? "").trim() !== "", solves, mass);
      assert.equal(await page.locator("[data-problem]").isVisible(), solves);
    }
    await page.getByRole("button", { name: "Play" }).click();
    await page.locator("[data-now]", { hasText: "s" }).waitFor();
    assert.equal(await page.getByRole("navigation", { name: "Site" }).getByRole("link", { name: "Collision" }).count(), 0);
    assert.deepEqual(complaints, []);
    await close();
  });
}

test("the sheet of the assignment offers no simulator that solves it", async () => {
  const { page, close } = await strict_page(browser);
  const [visitor] = made.visitors;
  assert.ok(visitor);
  await page.context().addCookies([visitor.session]);
  await page.goto(made.server.url + made.items[1]);
  assert.deepEqual(await page.getByRole("navigation", { name: "Site" }).getByRole("link").allTextContents(), ["Restitution", "Courses"]);
  await page.goto(`${made.server.url}/solve/conservation/coupling-wagons`);
  assert.match((await page.locator("main").textContent()) ?? "", /not solved with own numbers/);
  await close();
});
