// What a student types and is given: nothing typed disappears, and decisions about points are read where the student looks.

import assert from "node:assert/strict";
import { after, before, test } from "node:test";

import { Visitor, fields_of, plain } from "./classroom.js";
import { browse, strict_page } from "./server.js";
import { small_course } from "./small_course.js";

/** @type {Awaited<ReturnType<typeof small_course>>} */
let made;
/** @type {import("playwright-core").Browser} */
let browser;

before(async () => {
  [made, browser] = await Promise.all([small_course(["bob", "cleo", "dina"]), browse()]);
  // What is saved from now on is later than what was handed in.
  await made.server.set("2026-10-06T15:01:00+02:00");
});

after(async () => {
  await browser.close();
  await made.server.stop();
});

/**
 * A sheet in the browser of a student.
 * @param {Visitor | undefined} visitor
 * @param {number} place
 * @param {import("playwright-core").BrowserContextOptions} [options]
 */
async function sheet(visitor, place, options) {
  const own = await strict_page(browser, options);
  assert.ok(visitor);
  await own.page.context().addCookies([visitor.session]);
  await own.page.goto(made.server.url + made.items[place]);
  return own;
}

/** How often something was handed in. @param {import("playwright-core").Page} page */
const receipts = (page) => page.locator(".receipts > li").count();

for (const javaScriptEnabled of [true, false]) {
  test(`Enter in a field hands in nothing, ${javaScriptEnabled ? "with" : "without"} JavaScript`, async () => {
    const visitor = made.visitors[javaScriptEnabled ? 0 : 1];
    const { page, complaints, close } = await sheet(visitor, 1, { javaScriptEnabled });
    const field = page.locator("[name='answer.v_A2']");
    const before = await receipts(page);
    assert.ok(before > 0);
    await field.fill("1,50 m/s left");
    if (javaScriptEnabled) {
      await field.press("Enter");
      await page.locator("[data-saved]", { hasText: "Saved, not submitted" }).waitFor();
    } else {
      await Promise.all([page.waitForNavigation(), field.press("Enter")]);
    }
    await page.getByText("Read as 1.50 metres per second to the left.").waitFor();
    assert.equal(await field.inputValue(), "1,50 m/s left");
    assert.equal(await receipts(page), before);
    // Beside the button stands what it hands in, and what it costs; one press does it.
    const line = page.locator("[data-new='answer.v_A2']");
    assert.equal(await line.textContent(), "(a) 1,50 m/s left: for 90 % of its points");
    await Promise.all([page.waitForNavigation(), page.getByRole("button", { name: "Submit" }).click()]);
    assert.equal(await receipts(page), before + 1);
    assert.deepEqual(complaints, []);
    await close();
  });
}

test("the lines beside the button follow what is typed", async () => {
  const { page, complaints, close } = await sheet(made.visitors[2], 1);
  const line = page.locator("[data-new='answer.v_A2']");
  const nothing = page.locator("[data-no-new]");
  assert.deepEqual([await line.isVisible(), await nothing.isVisible()], [false, true]);
  await page.locator("[name='answer.v_A2']").fill("3.00 m/s");
  assert.deepEqual([await line.isVisible(), await nothing.isVisible()], [true, false]);
  await page.locator("[name='answer.v_A2']").fill("99.0 m/s");
  assert.deepEqual([await line.isVisible(), await nothing.isVisible()], [false, true], "as it was handed in");
  assert.deepEqual(complaints, []);
  await close();
});

test("an answer that cannot be read stays in its field", async () => {
  const { page, close } = await sheet(made.visitors[2], 1);
  const field = page.locator("[name='answer.T_lost']");
  await field.fill("1,45 Joule oder so");
  await Promise.all([page.waitForNavigation(), page.getByRole("button", { name: "Submit" }).click()]);
  assert.equal(await field.inputValue(), "1,45 Joule oder so");
  assert.match((await page.locator("[data-reading=T_lost]").textContent()) ?? "", /oder/);
  await close();
});

test("points set by hand reach the student with the reason and the comment", async () => {
  const teacher = await strict_page(browser);
  await teacher.page.context().addCookies([made.operator.session]);
  await teacher.page.goto(`${made.server.url}${made.items[1]}/students/${made.members[2]}`);
  await teacher.page.getByLabel("Points, from 0 to 5").fill("4,5");
  await teacher.page.getByLabel("Reason, which").fill("An oral answer.");
  await teacher.page.getByLabel("Comment to the student").fill("Mind the sign.");
  await Promise.all([teacher.page.waitForNavigation(), teacher.page.getByRole("button", { name: "Save points", exact: true }).click()]);
  assert.match(plain(await teacher.page.content()), /4\.5 of 5 points by hand/);
  const { page, close } = await sheet(made.visitors[2], 1);
  const text = plain(await page.content());
  for (const said of ["4.5 of 5 points, by hand", "An oral answer.", "Mind the sign."]) assert.ok(text.includes(said), text);
  await page.getByRole("link", { name: "Sheet 1" }).click();
  assert.match(plain(await page.content()), /4\.5 of 5 by hand/);
  await close();
  await teacher.close();
});

test("full marks after a correction reach the student, with the corrected solution", async () => {
  const teacher = await strict_page(browser);
  await teacher.page.context().addCookies([made.operator.session]);
  await teacher.page.goto(`${made.server.url}${made.assignment}/regrade`);
  await teacher.page.getByLabel("Give everybody full marks").check();
  await teacher.page.getByLabel("Reason, which").fill("They couple, and the problem let them bounce.");
  await Promise.all([teacher.page.waitForNavigation(), teacher.page.getByRole("button", { name: "Apply" }).click()]);
  const visitor = made.visitors[0];
  const { page, close } = await sheet(visitor, 0);
  const text = plain(await page.content());
  for (const said of ["5 of 5 points, full marks", "let them bounce"]) assert.ok(text.includes(said), text);
  assert.ok(fields_of(await page.content()).length > 0);
  await made.server.set("2026-10-16T18:00:00+02:00");
  await page.goto(`${made.server.url}${made.items[0]}/solution`);
  assert.match(plain(await page.content()), /Trolley A and trolley B do not separate again/);
  await close();
  await teacher.close();
});
