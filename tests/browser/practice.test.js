// A student at a practice sheet: with and without JavaScript, and by keyboard alone.

import assert from "node:assert/strict";
import { execFileSync } from "node:child_process";
import { test } from "node:test";

import { program } from "./server.js";
import { site } from "./site.js";

const SHEET = "/practice/impact/two-carts?form=forward&seed=7";

/**
 * The answers of a variant, as the program prints them.
 * @param {string} problem
 * @param {string} form
 * @param {number} seed
 * @returns {Record<string, string>}
 */
function key(problem, form, seed) {
  const arguments_ = ["solve", problem, "--form", form, "--seed", String(seed), "--format", "json"];
  const { ask } = JSON.parse(execFileSync(program, arguments_, { cwd: site.folder, encoding: "utf8" }));
  return Object.fromEntries(ask.map((/** @type {any} */ part) => [part.id, part.printed]));
}

test("what is typed is read while it is typed", async () => {
  const { page, complaints, close } = await site.open();
  await page.goto(site.url + SHEET);
  const said = page.locator('[data-reading="v_A2"]');
  await page.locator('[data-part="v_A2"]').fill("0,5 m/s left");
  await page.locator('[data-reading="v_A2"][data-state="read"]').waitFor();
  assert.equal(await said.textContent(), "Read as 0.5 metres per second to the left.");
  await page.locator('[data-part="v_A2"]').fill("3..2 m/s");
  await page.locator('[data-reading="v_A2"].unreadable').waitFor();
  assert.match((await said.textContent()) ?? "", /not a number/);
  assert.deepEqual(complaints, []);
  await close();
});

for (const javaScriptEnabled of [true, false]) {
  const how = javaScriptEnabled ? "with" : "without";

  test(`a sheet is answered, marked and explained ${how} JavaScript`, async () => {
    const { page, complaints, close } = await site.open({ javaScriptEnabled });
    const right = key("impact/two-carts", "forward", 7);
    await page.goto(site.url + SHEET);
    await page.locator('[name="answer.v_A2"]').fill("3..2 m/s");
    await page.locator('[name="answer.v_B2"]').fill(right.v_B2 ?? "");
    await page.getByRole("button", { name: "Check" }).click();
    const verdict = (/** @type {string} */ part) =>
      page.locator(`fieldset:has([name="answer.${part}"]) .verdict`).getAttribute("data-verdict");
    assert.equal(await verdict("v_A2"), "unreadable");
    assert.equal(await verdict("v_B2"), "right");
    assert.equal(await verdict("T_lost"), "unanswered");
    assert.equal(await page.locator('[name="answer.v_A2"]').inputValue(), "3..2 m/s", "what was typed stays");
    await page.getByRole("button", { name: "Hint", exact: true }).click();
    assert.equal(await page.locator("aside.hint").count(), 1);
    assert.equal(await page.locator('[name="answer.v_B2"]').inputValue(), right.v_B2, "a hint keeps what was typed");
    for (const [part, text] of Object.entries(right)) await page.locator(`[name="answer.${part}"]`).fill(text);
    await page.getByRole("button", { name: "Check" }).click();
    assert.match((await page.locator(".total").textContent()) ?? "", /5 of 5 points/);
    await page.getByRole("link", { name: "Solution, step by step" }).click();
    assert.match((await page.locator(".onward .main").textContent()) ?? "", /1 of \d+ shown/);
    await page.locator(".onward .main").click();
    assert.match((await page.locator(".onward .main").textContent()) ?? "", /2 of \d+ shown/);
    await page.getByRole("link", { name: "Whole solution" }).click();
    assert.equal(await page.locator(".space").count(), 0);
    assert.deepEqual(complaints, []);
    await close();
  });
}

test("a formula is set as mathematics while it is typed", async () => {
  const { page, complaints, close } = await site.open();
  await page.goto(`${site.url}/practice/concepts/coupling-in-symbols?seed=1`);
  const field = page.locator('[data-kind="formula"]').first();
  const said = page.locator(`[data-reading="${await field.getAttribute("data-part")}"]`);
  await field.fill("m_A v_A1/(m_A + m_B)");
  await said.locator("math mfrac").waitFor();
  await page.getByRole("button", { name: "Check" }).click();
  assert.equal(await said.locator("math mfrac").count(), 1, "as it was read it stays");
  assert.deepEqual(complaints, []);
  await close();
});

test("a verdict belongs to its field, and the page says what to look at", async () => {
  const { page, close } = await site.open();
  const right = key("impact/two-carts", "forward", 7);
  await page.goto(site.url + SHEET);
  await page.locator('[name="answer.v_A2"]').fill("900 m/s");
  await page.locator('[name="answer.v_B2"]').fill(right.v_B2 ?? "");
  await page.getByRole("button", { name: "Check" }).click();
  const wrong = page.locator('[name="answer.v_A2"]');
  assert.equal(await wrong.getAttribute("aria-invalid"), "true");
  const told = (await wrong.getAttribute("aria-describedby"))?.split(" ")[0];
  assert.equal(await page.locator(`#${told}`).getAttribute("data-verdict"), "wrong");
  assert.equal(await page.locator('[name="answer.v_B2"]').getAttribute("aria-invalid"), null);
  assert.match(await page.title(), /^2 of 5 points · Two carts/);
  await page.locator(".look-again").getByRole("link", { name: "(a)" }).click();
  await page.waitForURL(/#answer-a$/);
  await close();
});

test("the address holds the numbers, and a check of nothing says so", async () => {
  const { page, close } = await site.open();
  await page.goto(`${site.url}/practice/impact/two-carts`);
  await page.waitForURL(/[?&]seed=1$/);
  await page.getByRole("button", { name: "Check" }).click();
  assert.match((await page.locator(".outcome").textContent()) ?? "", /Nothing to check yet/);
  assert.match(page.url(), /form=forward&seed=1#marks$/);
  await close();
});

test("what comes next depends on how it went", async () => {
  const { page, close } = await site.open();
  await page.goto(`${site.url}/practice/impact/hockey-pucks?seed=1`);
  const easier = page.getByText("an easier one on the same law");
  for (let failures = 0; failures < 3; failures += 1) {
    assert.equal(await easier.count(), 0);
    await page.locator("[data-kind]").first().fill("900 m/s");
    await page.getByRole("button", { name: "Check" }).click();
  }
  assert.equal(await easier.count(), 1);
  await page.goto(site.url + SHEET);
  for (const [part, text] of Object.entries(key("impact/two-carts", "forward", 7))) {
    await page.locator(`[name="answer.${part}"]`).fill(text);
  }
  await page.getByRole("button", { name: "Check" }).click();
  await page.getByRole("link", { name: "Another like this" }).click();
  await page.waitForURL(/form=forward&seed=8$/);
  await close();
});

test("a sheet is answered by keyboard alone", async () => {
  const { page, close } = await site.open();
  const right = key("impact/two-carts", "forward", 7);
  await page.goto(site.url + SHEET);
  const focused = () => page.evaluate(() => document.activeElement?.getAttribute("name"));
  for (const [part, text] of Object.entries(right)) {
    for (let steps = 0; steps < 30 && (await focused()) !== `answer.${part}`; steps += 1) await page.keyboard.press("Tab");
    await page.keyboard.type(text);
  }
  await Promise.all([page.waitForURL(/practice/), page.keyboard.press("Enter")]);
  assert.match((await page.locator(".total").textContent()) ?? "", /5 of 5 points/);
  await close();
});

test("hostile answers are shown as they were typed", async () => {
  const { page, complaints, close } = await site.open();
  await page.goto(site.url + SHEET);
  const text = "\"><script>document.title='gone'</script>";
  await page.locator('[name="answer.v_A2"]').fill(text);
  await page.getByRole("button", { name: "Check" }).click();
  assert.equal(await page.locator('[name="answer.v_A2"]').inputValue(), text);
  assert.match(await page.title(), /Two carts/);
  assert.deepEqual(complaints, []);
  await close();
});

test("lines of work are judged while they are typed", async () => {
  const { page, complaints, close } = await site.open();
  await page.goto(site.url + SHEET);
  await page.getByText("Show your work").click();
  await page.getByLabel("Your work").fill("m_A v_A1 + m_B v_B1 = m_A v_A2 + m_B v_B2\nm_A v_A1 = v_A2");
  await page.locator('[data-lines][data-state="judged"]').waitFor();
  const verdicts = await page.locator("[data-lines] li").evaluateAll((lines) => lines.map((line) => line.dataset.verdict));
  assert.deepEqual(verdicts, ["follows", "dimensions"]);
  assert.deepEqual(complaints, []);
  await close();
});

test("lines of work are judged and led on without JavaScript", async () => {
  const { page, complaints, close } = await site.open({ javaScriptEnabled: false });
  await page.goto(site.url + SHEET);
  await page.getByText("Show your work").click();
  await page.getByLabel("Your work").fill("m_A v_A1 + m_B v_B1 = m_A v_A2 + m_B v_B2");
  await page.getByRole("button", { name: "What comes next?" }).click();
  assert.equal(await page.locator('[data-lines] li[data-verdict="follows"]').count(), 1);
  assert.match((await page.locator(".next").textContent()) ?? "", /law of restitution/);
  await page.getByRole("button", { name: "Say it more plainly" }).click();
  const equation = await page.locator(".next math").allTextContents();
  assert.match(equation.join(""), /^vB2−vA2=e/, "the equation is set, in as many pieces as a telephone needs");
  assert.deepEqual(complaints, []);
  await close();
});
