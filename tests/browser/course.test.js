// A course from an empty folder to a gradebook, by its pages alone: an operator, an instructor and a student.

import assert from "node:assert/strict";
import { execFileSync } from "node:child_process";
import { test } from "node:test";

import { barriers } from "./axe.js";
import { program } from "./server.js";
import { site } from "./site.js";

/**
 * The path of a link with which somebody signs in, as the command prints it.
 * @param {string} login
 */
function link(login) {
  const printed = execFileSync(program, ["serve", "user", "link", login], { cwd: site.folder, encoding: "utf8" });
  const path = printed.match(/\/sign-in\/\S+/)?.[0];
  assert.ok(path, printed);
  return path;
}

/**
 * A browser in which somebody signs in.
 * @param {string} login
 * @param {import("playwright-core").BrowserContextOptions} [options]
 */
async function signed_in(login, options) {
  const own = await site.open({ bypassCSP: true, ...options });
  await own.page.goto(site.url + link(login));
  await own.page.getByRole("button", { name: "Sign in as" }).click();
  await own.page.getByRole("heading", { name: "Courses", exact: true }).waitFor();
  return own;
}

/**
 * A local time of so many days from now, as a field takes it.
 * @param {number} days
 */
function day(days) {
  return new Date(Date.now() + 86_400_000 * days).toISOString().slice(0, 16);
}

test("a course from an empty folder to its gradebook", async () => {
  const operator = await signed_in("operator");
  let { page } = operator;
  assert.deepEqual(await barriers(page), [], "courses");
  await page.goto(`${site.url}/courses/new`);
  assert.deepEqual(await barriers(page), [], "new course");
  await page.getByLabel("Title").fill("Mechanics");
  await page.getByLabel("Time zone").fill("UTC");
  await page.getByLabel("Login").fill("ida");
  await page.getByLabel("Name", { exact: false }).last().fill("Ida");
  await page.getByRole("button", { name: "Make the course" }).click();
  const address = (await page.locator("code.link").textContent())?.trim() ?? "";
  assert.match(address, /\/sign-in\//);
  assert.deepEqual(operator.complaints, []);
  await operator.close();

  const instructor = await signed_in("ida", { viewport: { width: 1280, height: 900 } });
  page = instructor.page;
  await page.getByRole("link", { name: "Mechanics" }).click();
  const course = page.url();
  assert.deepEqual(await barriers(page), [], "course of an instructor");
  await page.goto(`${course}/roster`);
  assert.deepEqual(await barriers(page), [], "roster");
  await page.locator("textarea[name=table]").fill("id,name,section\nada,Ada <b>,A\nbob,Bob,A\n");
  await page.getByRole("button", { name: "Show what changes" }).click();
  assert.match((await page.locator("main").textContent()) ?? "", /Ada <b>/);
  assert.deepEqual(await barriers(page), [], "preview of the roster");
  await page.getByRole("button", { name: "Make these changes" }).click();
  await page.getByRole("status").first().waitFor();

  await page.goto(`${course}/assignments/new`);
  await page.getByLabel("Search").fill("two carts");
  await page.getByRole("button", { name: "Search" }).click();
  await page.getByRole("checkbox", { name: "Two carts on a straight track" }).check();
  await page.getByRole("button", { name: "Add those that are ticked" }).click();
  await page.locator('input[name="title"]').fill("Sheet 1");
  for (const [name, days] of /** @type {const} */ ([["opens", -2], ["due", -0.5], ["late_until", 1], ["closes", 1]])) {
    await page.locator(`input[name="${name}"]`).fill(day(days));
  }
  await page.locator('input[name="late_penalty"]').fill("20 %");
  assert.deepEqual(await barriers(page), [], "editor");
  await page.getByRole("button", { name: "Keep", exact: true }).click();
  await page.getByRole("status").first().waitFor();
  const assignment = page.url().replace(/\/edit.*$/, "");

  const student = await signed_in("ada", { viewport: { width: 320, height: 800 }, colorScheme: "dark" });
  const own = student.page;
  await own.getByRole("link", { name: "Mechanics" }).click();
  await own.getByRole("link", { name: "Sheet 1" }).click();
  assert.deepEqual(await barriers(own), [], "assignment");
  await own.getByRole("link", { name: "Two carts on a straight track" }).click();
  assert.match((await own.locator(".terms").textContent()) ?? "", /It is late: what is new now earns 80 %/);
  await own.locator('[data-part="v_A2"]').fill("3..2 m/s");
  await own.locator('[data-reading="v_A2"].unreadable').waitFor();
  await own.locator('[data-part="v_A2"]').fill("99 m/s");
  await own.locator("[data-saved][data-state=saved]").waitFor();
  assert.deepEqual(await barriers(own), [], "sheet");
  await own.getByRole("button", { name: "Hand in" }).click();
  await own.locator(".receipts li").waitFor();
  assert.match((await own.locator(".receipts li").textContent()) ?? "", /late/);
  assert.match((await own.locator(".total").textContent()) ?? "", /^0 of 5 points/);
  assert.deepEqual(await barriers(own), [], "marked sheet");
  assert.equal((await own.goto(`${site.url}/practice/impact/two-carts`))?.status(), 403, "the problem is reserved");
  assert.equal((await own.goto(`${assignment}/gradebook`))?.status(), 403);
  await student.close();

  for (const path of ["gradebook", "statistics", "regrade", "extensions", "print"]) {
    await page.goto(`${assignment}/${path}`);
    assert.deepEqual(await barriers(page), [], path);
  }
  await page.goto(`${assignment}/gradebook`);
  assert.match((await page.locator("main").textContent()) ?? "", /Ada <b>/);
  for (const path of ["trail", "settings", "retention", "problems", "problems/new"]) {
    await page.goto(`${course}/${path}`);
    assert.deepEqual(await barriers(page), [], path);
  }
  assert.deepEqual(instructor.complaints, []);
  await instructor.close();
});
