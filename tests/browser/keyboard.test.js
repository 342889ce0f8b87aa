// A whole assignment by keyboard alone: Tab, Shift+Tab, Enter, Space and typing, from the link to sign in to the receipt of each problem.

import assert from "node:assert/strict";
import { after, before, test } from "node:test";

import { browse, strict_page } from "./server.js";
import { PROBLEMS, small_course } from "./small_course.js";

/** More stops than any page of a student has. */
const MOST = 60;

/** @type {Awaited<ReturnType<typeof small_course>>} */
let made;
/** @type {import("playwright-core").Browser} */
let browser;

before(async () => {
  [made, browser] = await Promise.all([small_course(["bob"]), browse()]);
});

after(async () => {
  await browser.close();
  await made.server.stop();
});

/**
 * What has the focus: its name, what it is, and whether one sees that it has it.
 * @param {import("playwright-core").Page} page
 */
function focused(page) {
  return page.evaluate(() => {
    const own = document.activeElement ?? document.body;
    const { outlineStyle, outlineWidth } = getComputedStyle(own);
    const box = own.getBoundingClientRect();
    return {
      kind: own instanceof HTMLInputElement ? own.type : own.tagName.toLowerCase(),
      name: (own.getAttribute("name") ?? own.textContent ?? "").trim(),
      is_seen: outlineStyle !== "none" && parseFloat(outlineWidth) >= 2 && box.width > 0 && box.bottom > 0 && box.top < innerHeight,
    };
  });
}

/**
 * Goes on by a key until something has the focus; each stop on the way must be seen.
 * @param {import("playwright-core").Page} page
 * @param {string} kind
 * @param {string | RegExp} name
 * @param {"Tab" | "Shift+Tab"} [key]
 */
async function reach(page, kind, name, key = "Tab") {
  for (let stops = 0; stops < MOST; stops += 1) {
    await page.keyboard.press(key);
    const own = await focused(page);
    if (own.kind === "body") continue;
    assert.ok(own.is_seen, `nobody sees that ${own.kind} "${own.name}" has the focus`);
    if (own.kind === kind && (typeof name === "string" ? own.name === name : name.test(own.name))) return;
  }
  assert.fail(`${MOST} stops, and no ${kind} "${name}"`);
}

/**
 * Presses Enter on what has the focus, and waits for the page to which it leads.
 * @param {import("playwright-core").Page} page
 */
async function enter(page) {
  await Promise.all([page.waitForEvent("load"), page.keyboard.press("Enter")]);
}

test("an assignment is done by keyboard alone, from the link to the receipts", async () => {
  const { page, complaints, close } = await strict_page(browser);
  await page.goto(made.links.get("ada") ?? "");
  await reach(page, "button", /^Sign in as ada/);
  await enter(page);
  await reach(page, "a", "Mechanics");
  await enter(page);
  await reach(page, "a", "Sheet 1");
  await enter(page);
  for (const [place, problem] of PROBLEMS.entries()) {
    const title = await page.locator(`a[href="${made.items[place]}"]`).textContent();
    await reach(page, "a", title ?? "");
    await enter(page);
    const fields = await page.locator(".answers [name^='answer.']").evaluateAll((all) => [
      ...new Map(all.filter((own) => own.checkVisibility()).map((own) => [own.getAttribute("name") ?? "", /** @type {HTMLInputElement} */ (own).type])),
    ]);
    assert.ok(fields.length > 0, problem);
    for (const [name, kind] of fields) {
      await reach(page, kind, name);
      if (kind === "radio") await page.keyboard.press("Space");
      else await page.keyboard.type("2.00 m/s");
    }
    if (place === 1) {
      // What was typed first is mended, on the way back.
      const [first = ""] = fields[0] ?? [];
      await reach(page, "text", first, "Shift+Tab");
      await page.keyboard.press("Control+A");
      await page.keyboard.type("2,50 m/s left");
      await page.locator("[data-reading][data-state=read]").first().waitFor();
      await reach(page, "button", "Save");
      await Promise.all([page.waitForEvent("load"), page.keyboard.press("Space")]);
      assert.match((await page.locator("[data-saved]").textContent()) ?? "", /^Saved, not submitted/);
      assert.equal(await page.locator(`[name="${first}"]`).inputValue(), "2,50 m/s left");
    }
    await reach(page, "button", "Submit");
    await enter(page);
    await page.locator(".receipts li").waitFor();
    assert.match((await page.locator(".receipts li").textContent()) ?? "", /^Tue, 6 Oct 2026, 15:00:00/);
    await reach(page, "a", "Sheet 1");
    await enter(page);
  }
  const attempts = await page.locator("tbody tr td:nth-child(2)").allTextContents();
  assert.deepEqual(attempts, PROBLEMS.map(() => "1"));
  await reach(page, "button", "Sign out", "Shift+Tab");
  await enter(page);
  assert.equal(await page.getByRole("button", { name: "Sign out" }).count(), 0);
  assert.deepEqual(complaints, []);
  await close();
});
