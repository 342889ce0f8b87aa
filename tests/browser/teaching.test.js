// The tour of docs/teaching.md, step by step: each heading there is a test here, in the same order. With PICTURES=FOLDER the pictures of
// that page are written to a folder. The server's clock stands where a step puts it.

import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { join } from "node:path";
import { after, before, test } from "node:test";

import { ROSTER, RULES, STUDENTS, Visitor, cells_of, coupled, fields_of, key_of, plain } from "./classroom.js";
import { browse, start_clocked, strict_page } from "./server.js";

const guide = readFileSync(new URL("../../docs/teaching.md", import.meta.url), "utf8");
/** The problem of the guide, with its mistake. */
const TROLLEYS = guide.match(/```yaml\n([\s\S]*?)```/)?.[1] ?? "";

/** The problems of the assignment, each worth ten points. */
const PROBLEMS = [
  "class/coupled-trolleys",
  "impulse/parcel-push",
  "impulse/tram-stops",
  "conservation/coupling-wagons",
  "impact/two-carts",
  "mass-centre/walk-along-barge",
];

/** Who works in a browser: one in time, one late, one with more time. One more is late. */
const [EAGER, LATE, ALSO_LATE, EXTENDED] = /** @type {const} */ (["s01", "s02", "s03", "s40"]);
/** Whose points are set by hand at a problem that this student did not hand in, and who is erased. */
const [BY_HAND, ERASED] = /** @type {const} */ (["s09", "s05"]);

/** Whether a student leaves a problem out. @param {string} id @param {number} place */
const leaves_out = (id, place) => place > 0 && (Number(id.slice(1)) + place) % 7 === 0;

/** @type {Awaited<ReturnType<typeof start_clocked>>} */
let server;
/** @type {import("playwright-core").Browser} */
let browser;
/** @type {Awaited<ReturnType<typeof strict_page>>} */
let teacher;
/** What the steps find on their way: addresses, links by login, the key, what each student was told. */
const found = {
  course: "",
  assignment: "",
  /** @type {string[]} */
  items: [],
  /** @type {Map<string, string>} */
  links: new Map(),
  /** @type {Map<string, string[]>} */
  key: new Map(),
  /** @type {Map<string, number[]>} */
  told: new Map(),
};

before(async () => {
  [server, browser] = await Promise.all([start_clocked("2026-10-05T09:00:00+02:00"), browse()]);
  teacher = await strict_page(browser, { viewport: { width: 1000, height: 760 }, locale: "en-GB" });
});

after(async () => {
  await browser.close();
  await server.stop();
});

/**
 * Writes a picture, where somebody asks for pictures.
 * @param {import("playwright-core").Page} page
 * @param {string} name
 * @param {import("playwright-core").Locator} [part] a part of the page, in place of what stands in the window
 */
async function picture(page, name, part) {
  if (!process.env.PICTURES) return;
  await (part ?? page).screenshot({ path: join(process.env.PICTURES, `teaching-${name}.png`) });
}

/**
 * The text of a file that a button or a link saves.
 * @param {import("playwright-core").Page} page
 * @param {import("playwright-core").Locator} button
 */
async function saved(page, button) {
  const [download] = await Promise.all([page.waitForEvent("download"), button.click()]);
  return readFileSync(await download.path(), "utf8");
}

/**
 * Presses a button or a link, and waits for the heading to which it leads.
 * @param {import("playwright-core").Page} page
 * @param {"button" | "link"} role
 * @param {string} name
 * @param {string | RegExp} heading
 */
async function press(page, role, name, heading) {
  await page.getByRole(role, { name, exact: true }).click();
  await page.getByRole("heading", { name: heading, level: 1 }).waitFor();
}

/**
 * A student in a browser, signed in by the own link.
 * @param {string} id
 * @param {import("playwright-core").BrowserContextOptions} [options]
 */
async function student(id, options) {
  const own = await strict_page(browser, { viewport: { width: 800, height: 900 }, ...options });
  await own.page.goto(found.links.get(id) ?? "");
  await own.page.getByRole("button", { name: "Sign in as" }).click();
  await own.page.getByRole("link", { name: "Mechanics 1" }).click();
  await own.page.getByRole("link", { name: "Sheet 1" }).click();
  return own;
}

/**
 * What a student answers at the problem of that place.
 * @param {string} id
 * @param {number} place
 * @param {string} text the sheet
 */
function answers(id, place, text) {
  return place === 0 ? [coupled(text)] : (found.key.get(`${id} ${PROBLEMS[place]}`) ?? []);
}

/**
 * Fills in a problem and hands it in, from the page of the assignment and back.
 * @param {import("playwright-core").Page} page
 * @param {string} id
 * @param {number} place
 */
async function hand_in(page, id, place) {
  await page.locator(`a[href="${found.items[place]}"]`).click();
  await page.locator(".answers").waitFor();
  const fields = fields_of(await page.content());
  const right = answers(id, place, plain(await page.content()));
  assert.equal(fields.length, right.length, `${id} ${PROBLEMS[place]}`);
  for (const [index, name] of fields.entries()) await page.locator(`[name="${name}"]`).fill(right[index] ?? "");
  await page.getByRole("button", { name: "Submit" }).click();
  await page.locator(".receipts li").waitFor();
}

/** The points that the page of an assignment tells a student, problem by problem. @param {string} page */
function told(page) {
  return [...page.matchAll(/<td>([\d.]+|–) of 10/g)].map(([, points]) => Number(points) || 0);
}

/** A student without a browser hands in everything but what is left out. @param {string} id */
async function work_unseen(id) {
  const visitor = await Visitor.by(found.links.get(id) ?? "");
  for (const [place, item] of found.items.entries()) {
    if (leaves_out(id, place)) continue;
    const page = await visitor.get(item);
    const right = answers(id, place, plain(page));
    const filled = fields_of(page).map((name, index) => [name, right[index] ?? ""]);
    await visitor.post(item, { request: page.match(/name="request" value="([^"]+)"/)?.[1] ?? "", ...Object.fromEntries(filled) });
  }
  found.told.set(id, told(await visitor.get(found.assignment)));
}

/** The gradebook as its page shows it: the cells of each student, by name. */
async function gradebook() {
  const { page } = teacher;
  await page.goto(`${server.url}${found.assignment}/gradebook`);
  const rows = await page.locator("tbody tr").evaluateAll((rows) =>
    rows.map((row) => [...row.children].map((cell) => (cell.querySelector("a, strong") ?? cell).textContent?.trim() ?? "")),
  );
  return new Map(rows.map(([name, , ...points]) => [String(name), points.map((text) => (/^\d/.test(text) ? Number(text) : undefined))]));
}

/** @param {string} id */
const name_of = (id) => STUDENTS.find((own) => own.id === id)?.name ?? "";

/** @type {[string, () => Promise<void>][]} */
const TOUR = [
  ["Start the server", async () => {
    const { page } = teacher;
    await page.goto(server.link);
    await press(page, "button", "Sign in as Operator", "Courses");
    await page.getByLabel("New password").fill("forty small carts");
    await page.getByLabel("The same again").fill("forty small carts");
    await press(page, "button", "Save password", "Courses");
    assert.match((await page.getByRole("status").textContent()) ?? "", /The password is changed/);
  }],

  ["Make a course", async () => {
    const { page } = teacher;
    await press(page, "link", "New course", "New course");
    assert.equal(await page.getByLabel("Time zone").inputValue(), await page.evaluate(() => Intl.DateTimeFormat().resolvedOptions().timeZone));
    await page.getByLabel("Title").fill("Mechanics 1");
    await page.getByLabel("Time zone").fill("Europe/Berlin");
    await press(page, "button", "Create course", "Mechanics 1");
    found.course = new URL(page.url()).pathname;
  }],

  ["Paste the roster", async () => {
    const { page } = teacher;
    await press(page, "link", "Roster", "Roster");
    await page.locator("textarea[name=table]").fill(ROSTER);
    await press(page, "button", "Preview changes", "What changes");
    assert.equal(await page.locator("tbody tr").count(), 40);
    await picture(page, "roster");
    await press(page, "button", "Apply changes", "Roster");
    assert.equal(await page.locator("caption").last().textContent(), "40 students");
  }],

  ["Hand out the links", async () => {
    const { page } = teacher;
    const table = cells_of(await saved(page, page.getByRole("button", { name: "Download sign-in links" })));
    for (const [id, , , role, link] of table.slice(1)) if (role === "student") found.links.set(String(id), String(link));
    assert.deepEqual([...found.links.keys()].sort(), STUDENTS.map((own) => own.id));
  }],

  ["Or let students ask for a place", async () => {
    const { page } = teacher;
    await press(page, "button", "New code", "Roster");
    const code = (await page.locator("strong > code.link").textContent()) ?? "";
    const stranger = await strict_page(browser, { viewport: { width: 390, height: 800 } });
    await stranger.page.goto(`${server.url}/sign-in`);
    await press(stranger.page, "link", "Ask for a place", "Ask for a place");
    await stranger.page.getByLabel("Code of the course").fill(code.toLowerCase());
    await press(stranger.page, "button", "Continue", "Mechanics 1");
    const typed = { login: "s99", name: "Zoe Zimmer", new: "forty small carts", again: "forty small carts" };
    for (const [name, text] of Object.entries(typed)) await stranger.page.locator(`[name=${name}]`).fill(text);
    await stranger.page.getByRole("button", { name: "Ask for a place" }).click();
    await stranger.page.getByText("Your request was sent").waitFor();
    assert.deepEqual(stranger.complaints, []);
    await stranger.close();
    await page.reload();
    assert.ok(await page.getByLabel("Zoe Zimmer").isChecked());
    await picture(page, "requests", page.locator("section[aria-labelledby=requests]"));
    await press(page, "button", "Decline selected", "Roster");
    assert.equal(await page.getByLabel("Zoe Zimmer").count(), 0);
    await press(page, "button", "End this code", "Roster");
  }],

  ["Write a problem of your own", async () => {
    const { page } = teacher;
    await press(page, "link", "Problems of the course", "Problems of the course");
    await press(page, "link", "New problem", "New problem");
    await page.locator("textarea[name=text]").fill(TROLLEYS);
    await page.locator("#preview article.sheet").nth(2).waitFor();
    await press(page, "button", "Save draft", "Two trolleys that couple");
    assert.equal(await page.locator("article.sheet").count(), 3);
    await press(page, "button", "Check over 100 seeds", "Two trolleys that couple");
    await page.getByRole("status").waitFor();
    await page.getByRole("button", { name: "Publish" }).click();
    await page.getByText("published", { exact: false }).first().waitFor();
  }],

  ["Make an assignment", async () => {
    const { page } = teacher;
    await press(page, "link", "Assignments", "Mechanics 1");
    await press(page, "link", "New assignment", "New assignment");
    await page.getByRole("button", { name: "Search" }).click();
    for (const problem of PROBLEMS) await page.locator(`input[name="add"][value="${problem}"]`).check();
    await page.getByRole("button", { name: "Add selected problems" }).click();
    for (const problem of PROBLEMS) {
      const row = page.locator("fieldset.item", { has: page.locator(`input[value="${problem}"]`) });
      await row.getByLabel("Place").fill(String(PROBLEMS.indexOf(problem) + 1));
      await row.getByLabel("Points").fill("10");
    }
    for (const [field, text] of Object.entries(RULES)) await page.locator(`input[name="${field}"]`).fill(text);
    await picture(page, "assignment", page.getByRole("region", { name: "Title and times" }));
    await page.getByRole("button", { name: "Save", exact: true }).click();
    await page.getByRole("status").waitFor();
    found.assignment = new URL(page.url()).pathname.replace(/\/edit$/, "");
    await press(page, "link", "Student view", "Sheet 1");
    found.items = await page.locator("tbody a").evaluateAll((links) => links.map((link) => link.getAttribute("href") ?? ""));
    assert.equal(found.items.length, 6);
  }],

  ["Give one student more time", async () => {
    const { page } = teacher;
    await press(page, "link", "Edit", "Edit the assignment");
    await press(page, "link", "Extensions", "Extensions");
    await page.getByLabel("Student").selectOption({ label: `${name_of(EXTENDED)} (${EXTENDED})` });
    await page.locator('input[name="due"]').fill("2026-10-19T18:00");
    // The dates of the assignment stand there: this student hands in nothing late.
    await page.locator('input[name="late_until"]').fill("");
    await page.locator('input[name="closes"]').fill("2026-10-20T18:00");
    await page.locator('input[name="reason"]').fill("was ill for a week");
    await press(page, "button", "Save extension", "Extensions");
    assert.match((await page.locator("tbody").textContent()) ?? "", /Hugo Eriksen.*20 Oct.*was ill for a week/s);
  }],

  ["Print the sheets and the key", async () => {
    const { page } = teacher;
    await page.goto(`${server.url}${found.assignment}/print`);
    const sheets = await saved(page, page.getByRole("link", { name: "Sheets of the class" }));
    for (const { id, name } of STUDENTS) assert.ok(sheets.includes(`${name} (${id})`), name);
    found.key = key_of(await saved(page, page.getByRole("link", { name: "Key" })));
    assert.equal(found.key.size, 240, "six problems for forty students");
  }],

  ["Students work", async () => {
    await server.set("2026-10-06T15:00:00+02:00");
    const { page, complaints, close } = await student(EAGER);
    await page.locator(`a[href="${found.items[1]}"]`).click();
    // Not before the script of the page is there to read what is typed.
    await page.waitForURL(`**${found.items[1]}`);
    const field = page.locator("[data-part]").first();
    await field.fill("3..2 N");
    await page.locator("[data-reading].unreadable").waitFor();
    await field.fill("3.2 N");
    await page.locator("[data-saved][data-state=saved]").waitFor();
    await page.reload();
    assert.equal(await field.inputValue(), "3.2 N", "what was typed is a draft");
    assert.equal(await page.locator(".receipts").count(), 0, "and no attempt");
    await page.getByRole("link", { name: "Sheet 1" }).click();
    for (const place of PROBLEMS.keys()) {
      await hand_in(page, EAGER, place);
      const text = (await page.locator(".receipts li").textContent()) ?? "";
      assert.match(text, /^Tue, 6 Oct 2026, 15:00:00, counts/);
      assert.match((await page.locator(".total").textContent()) ?? "", place === 0 ? /^0 of 10/ : /^10 of 10/);
      if (place === 4) await picture(page, "sheet", page.locator("main"));
      await page.getByRole("link", { name: "Sheet 1" }).click();
    }
    found.told.set(EAGER, told(await page.content()));
    assert.equal((await page.goto(`${server.url}/practice/impact/two-carts`))?.status(), 403, "the problem is reserved");
    assert.equal((await page.goto(`${server.url}${found.assignment}/gradebook`))?.status(), 403);
    assert.deepEqual(complaints, []);
    await close();
    const others = STUDENTS.map((own) => own.id).filter((id) => ![EAGER, LATE, ALSO_LATE, EXTENDED].some((own) => own === id));
    // As many at a time as a small class that comes home from school.
    const queue = [...others];
    const work = async () => {
      for (let id = queue.shift(); id; id = queue.shift()) await work_unseen(id);
    };
    await Promise.all([work(), work(), work(), work()]);
    assert.equal(found.told.size, 37);
  }],

  ["Two hand in late", async () => {
    await server.set("2026-10-13T10:00:00+02:00");
    const late = await student(LATE, { viewport: { width: 320, height: 800 }, colorScheme: "dark" });
    await late.page.locator(`a[href="${found.items[1]}"]`).click();
    assert.match((await late.page.locator(".terms").textContent()) ?? "", /It is late: what is new now earns 80 %/);
    await late.page.getByRole("link", { name: "Sheet 1" }).click();
    for (const place of PROBLEMS.keys()) {
      await hand_in(late.page, LATE, place);
      assert.match((await late.page.locator(".receipts li").textContent()) ?? "", /late/);
      await late.page.getByRole("link", { name: "Sheet 1" }).click();
    }
    found.told.set(LATE, told(await late.page.content()));
    assert.deepEqual(found.told.get(LATE), [0, 8, 8, 8, 8, 8]);
    await work_unseen(ALSO_LATE);
    await server.set("2026-10-16T12:00:00+02:00");
    const extended = await student(EXTENDED);
    for (const place of PROBLEMS.keys()) {
      await hand_in(extended.page, EXTENDED, place);
      await extended.page.getByRole("link", { name: "Sheet 1" }).click();
    }
    found.told.set(EXTENDED, told(await extended.page.content()));
    assert.deepEqual(found.told.get(EXTENDED), [0, 10, 10, 10, 10, 10], "nothing is lost, though the class has closed");
    await extended.close();
    await late.page.locator(`a[href="${found.items[1]}"]`).click();
    assert.match((await late.page.locator(".terms").textContent()) ?? "", /The time for answers is over/);
    assert.deepEqual(late.complaints, []);
    await late.close();
  }],

  ["Read the gradebook", async () => {
    const { page } = teacher;
    const book = await gradebook();
    await picture(page, "gradebook");
    assert.equal(book.size, 40);
    for (const { id, name } of STUDENTS) {
      const points = book.get(name)?.slice(0, 6);
      assert.deepEqual(points?.map((own) => own ?? 0), found.told.get(id), `${name} was told the same`);
      assert.deepEqual(points?.map((own) => own === undefined), PROBLEMS.map((_, place) => is_missing(id, place)), name);
    }
    await press(page, "link", "Statistics", /^Statistics/);
    assert.match((await page.locator("tr", { hasText: "Two trolleys that couple: (a)" }).textContent()) ?? "", /400 %/);
  }],

  ["Change points by hand", async () => {
    const { page } = teacher;
    const place = PROBLEMS.findIndex((_, place) => is_missing(BY_HAND, place));
    const before = await gradebook();
    await page.locator("tr", { hasText: name_of(BY_HAND) }).locator("td a").nth(place).click();
    await page.getByLabel("Points, from 0 to 10").fill("11");
    await page.getByLabel("Reason").first().fill("showed it on the board");
    await page.getByRole("button", { name: "Save points", exact: true }).click();
    await page.getByRole("alert").waitFor();
    await page.getByLabel("Points, from 0 to 10").fill("7");
    await page.getByRole("button", { name: "Save points", exact: true }).click();
    await page.getByRole("heading", { name: "Set by hand", exact: true }).waitFor();
    assert.match((await page.locator("main").textContent()) ?? "", /7 of 10\. showed it on the board/);
    await picture(page, "points");
    const own = (await gradebook()).get(name_of(BY_HAND)) ?? [];
    assert.equal(own[place], 7);
    assert.equal(own[6], (before.get(name_of(BY_HAND))?.[6] ?? 0) + 7);
  }],

  ["Correct a problem", async () => {
    const { page } = teacher;
    await page.goto(`${server.url}${found.course}/problems`);
    await page.getByRole("link", { name: "Two trolleys that couple" }).click();
    const file = page.getByLabel("Problem file");
    await file.fill((await file.inputValue()).replace("restitution: 1", "restitution: 0"));
    await page.getByRole("button", { name: "Save draft" }).click();
    await page.getByRole("button", { name: "Publish" }).click();
    await page.getByText("published", { exact: false }).first().waitFor();
    const before = await gradebook();
    await press(page, "link", "Regrade", /^Regrade/);
    await picture(page, "regrade");
    await page.getByRole("radio", { name: "Mark what was submitted by the corrected problem" }).check();
    await press(page, "button", "Apply", /^Gradebook/);
    const book = await gradebook();
    for (const { id, name } of STUDENTS) {
      const [was, is] = [before.get(name) ?? [], book.get(name) ?? []];
      assert.equal(is[0], id === LATE || id === ALSO_LATE ? 8 : 10, `${name} was right, and ${id} keeps what being late costs`);
      assert.deepEqual(is.slice(1, 6), was.slice(1, 6), `${name}: the other problems stay`);
    }
    await page.getByRole("link", { name: "Regrade" }).click();
    await page.getByText("No problem of this assignment has changed").waitFor();
  }],

  ["Save the gradebook", async () => {
    const { page } = teacher;
    const book = await gradebook();
    const [headings, ...rows] = cells_of(await saved(page, page.getByRole("link", { name: "Save as CSV" })));
    assert.deepEqual(headings?.slice(0, 3).concat(headings.slice(-2)), ["login", "name", "section", "total", "out_of"]);
    assert.equal(rows.length, 40);
    for (const [login, name, section, ...points] of rows) {
      assert.deepEqual({ id: login, name, section }, STUDENTS.find((own) => own.id === login));
      assert.equal(points.pop(), "60");
      assert.deepEqual(points.map((text) => (text === "" ? undefined : Number(text))), book.get(String(name)), name);
    }
  }],

  ["Hand over what is kept about a student", async () => {
    const { page } = teacher;
    await gradebook();
    await press(page, "link", name_of(ERASED), name_of(ERASED));
    const text = await saved(page, page.getByRole("link", { name: "Save everything" }));
    const data = JSON.parse(text);
    assert.deepEqual([data.login, data.name, data.course], [ERASED, name_of(ERASED), "Mechanics 1"]);
    assert.deepEqual(data.sheets.map((/** @type {any} */ own) => own.problem).sort(), [...PROBLEMS].sort());
    const carts = data.sheets.find((/** @type {any} */ own) => own.problem === "impact/two-carts");
    assert.deepEqual(Object.values(carts.attempts[0].answers).sort(), [...answers(ERASED, 4, "")].sort());
    assert.ok(!text.includes('"seed"'), "a seed draws the answers");
    for (const other of STUDENTS.filter((own) => own.id !== ERASED)) assert.ok(!text.includes(other.name), other.name);
  }],

  ["Erase a student's name", async () => {
    const { page } = teacher;
    const before = (await gradebook()).get(name_of(ERASED));
    await page.getByRole("link", { name: name_of(ERASED) }).click();
    await page.getByLabel("Type the name by which the person signs in").fill(ERASED);
    await press(page, "button", "Erase", "(erased)");
    const book = await gradebook();
    assert.deepEqual([book.get("(erased)"), book.has(name_of(ERASED)), book.size], [before, false, 40]);
    await page.goto(`${server.url}${found.course}/trail`);
    const trail = (await page.locator("main").textContent()) ?? "";
    for (const done of ["name erased", "correction applied", "points set by hand", "extension given", "roster changed"]) {
      assert.ok(trail.includes(done), done);
    }
    assert.ok(!trail.includes(name_of(ERASED)));
    assert.deepEqual(teacher.complaints, []);
  }],
];

/** Whether nothing was handed in: the browsers hand in everything. @param {string} id @param {number} place */
function is_missing(id, place) {
  return ![EAGER, LATE, EXTENDED].some((own) => own === id) && leaves_out(id, place);
}

test("docs/teaching.md has these steps, in this order", () => {
  const headings = [...guide.matchAll(/^## (.+)$/gm)].map(([, heading]) => heading);
  assert.deepEqual(headings, TOUR.map(([heading]) => heading));
});

/** Whether a step has failed: those after it could only say the same again. */
let is_broken = false;

for (const [heading, step] of TOUR) {
  test(heading, async (own) => {
    if (is_broken) return own.skip("a step before failed");
    is_broken = true;
    await step();
    is_broken = false;
  });
}
