// The simulators: what a page shows is what the program says, for many settings; and their time, by a clock in the test's hand.

import assert from "node:assert/strict";
import { execFile } from "node:child_process";
import { writeFileSync } from "node:fs";
import { join } from "node:path";
import { test } from "node:test";
import { promisify } from "node:util";

import { program } from "./server.js";
import { site, still_clock } from "./site.js";

const run = promisify(execFile);

/** How many random settings of each simulator are compared. */
const SETTINGS = 200;

/** How many programs run at once. */
const TOGETHER = 8;

/** Random numbers that are the same in every run. */
function generator(seed = 1) {
  let state = seed;
  return () => {
    state = (Math.imul(state, 1664525) + 1013904223) >>> 0;
    return state / 2 ** 32;
  };
}

/** @typedef {Record<string, number>} Setting */

const random = generator();

/**
 * A number of a slider.
 * @param {number} least
 * @param {number} most
 * @param {number} digits
 */
function slid(least, most, digits) {
  // No negative zero.
  return Number((least + random() * (most - least)).toFixed(digits)) + 0;
}

/** @returns {Setting} */
function collision() {
  return { m_A: slid(0.1, 20, 1), v_A: slid(-10, 10, 1), m_B: slid(0.1, 20, 1), v_B: slid(-10, 10, 1), x_A: slid(-6, -1, 1), x_B: slid(1, 6, 1), e: slid(0, 1, 2) };
}

/** @returns {Setting} */
function discs() {
  return { m_A: slid(0.1, 20, 1), v_A: slid(-10, 10, 1), m_B: slid(0.1, 20, 1), v_B: slid(-10, 10, 1), b: slid(-0.78, 0.78, 2), e: slid(0, 1, 2) };
}

/** @returns {Setting} */
function restitution() {
  return { h: slid(0.1, 20, 1), e: slid(0, 0.99, 2), n: slid(1, 12, 0), v_t: 0 };
}

/**
 * What the program says: the answers of the laws, and the impacts of the simulation, of the same scene as a file of its own.
 * @param {string} name
 * @param {string} scene
 * @param {Record<string, string>} given
 * @param {string[]} asked
 */
async function said(name, scene, given, asked) {
  const file = join(site.folder, `${name}.yaml`);
  const values = Object.entries(given).map(([own, value]) => `${own}: ${value}`);
  const questions = asked.map((find) => `  - { find: ${find} }`).join("\n");
  const text = `"${Object.keys(given).map((own) => `{{ ${own} }}`).join(", ")}"`;
  writeFileSync(
    file,
    `id: tried/${name}\ntitle: Tried\nlevel: intro\n${scene}\ngiven: { ${values.join(", ")} }\ntext: ${text}\nask:\n${questions}\n`,
  );
  /** @param {string} command */
  const ask = async (command) => {
    const { stdout } = await run(program, [command, file, "--format", "json"], { cwd: site.folder, maxBuffer: 1 << 26 });
    return JSON.parse(stdout);
  };
  const [solved, simulated] = await Promise.all([ask("solve"), ask("simulate")]);
  return {
    /** @type {Record<string, { value: number, printed: string }>} */
    answers: Object.fromEntries(solved.ask.map((/** @type {any} */ part) => [part.id, part])),
    /** @type {{ time: number, impulse: number[], energy_before: number, energy_after: number }[]} */
    impacts: simulated.stages.at(-1).impacts,
  };
}

const CARTS = `scene:
  axes: { x: to the right }
  bodies: { A: { name: cart A, mass: m_A }, B: { name: cart B, mass: m_B } }
  stages: [ { impact: { between: [A, B], restitution: e } } ]`;

const BALL = `scene:
  axes: { y: upwards }
  plane: vertical
  bodies: { ball: { name: the ball } }
  stages: [ { fall: { body: ball, height: h_0 } }, { bounces: { body: ball, restitution: e, count: n } } ]`;

/**
 * Sets the controls, and waits until the page shows what belongs to them.
 * @param {import("playwright-core").Page} page
 * @param {Setting} setting
 */
async function put(page, setting) {
  await page.evaluate((setting) => {
    for (const [name, value] of Object.entries(setting)) {
      const field = document.getElementById(name);
      if (!(field instanceof HTMLInputElement)) throw new Error(`no control ${name}`);
      field.value = String(value);
      field.dispatchEvent(new Event("input", { bubbles: true }));
    }
  }, setting);
  const shown = new URLSearchParams(Object.entries(setting).map(([name, value]) => [name, String(value)]));
  await page.locator(`[data-simulator][data-state="shown"][data-shown="${shown}"]`).waitFor();
}

/**
 * A text of the page as the program prints it on a terminal.
 * @param {string} text
 */
function plain(text) {
  const digits = "⁰¹²³⁴⁵⁶⁷⁸⁹";
  const power = text.replace(/10([⁻⁰¹²³⁴⁵⁶⁷⁸⁹]+)/, (_, raised) => `10^${[...raised].map((one) => (one === "⁻" ? "-" : digits.indexOf(one))).join("")}`);
  return power.replaceAll("\u2212", "-").replaceAll("\u00a0", " ");
}

/**
 * The texts of places on the page.
 * @param {import("playwright-core").Page} page
 * @param {string[]} places
 */
async function texts(page, places) {
  const found = await page.evaluate((places) => places.map((place) => document.querySelector(place)?.textContent ?? ""), places);
  return found.map(plain);
}

/**
 * The number of a text such as "-1.20 kg m/s" or "2 × 10^-7 m".
 * @param {string | undefined} text
 */
function number(text) {
  return Number.parseFloat(plain(text ?? "").replace(/ × 10\^/, "e"));
}

/**
 * Whether a shown number is that one, to the figures that are shown; what is less than 1e-10 of its scale may be shown as nothing.
 * @param {string | undefined} text
 * @param {number} value
 * @param {string} where
 * @param {number} [scale]
 */
function same(text, value, where, scale = 1) {
  const reach = 0.0051 * Math.abs(value) + 1e-10 * scale;
  assert.ok(Math.abs(number(text) - value) <= reach, `${where}: shown ${text}, said ${value}`);
}

/**
 * @template Item
 * @param {Item[]} items
 * @returns {Item[][]}
 */
function batches(items) {
  return Array.from({ length: Math.ceil(items.length / TOGETHER) }, (_, place) => items.slice(place * TOGETHER, (place + 1) * TOGETHER));
}

/** @param {string} path */
const show = (path) => `[data-show="${path}"]`;

test("the collision shows what solve and simulate say", async () => {
  const { page, complaints, close } = await site.open();
  await page.goto(`${site.url}/simulators/collision`);
  const all = Array.from({ length: SETTINGS }, collision);
  for (const [batch, settings] of batches(all).entries()) {
    const meeting = settings.map(({ v_A = 0, v_B = 0 }) => v_A > v_B);
    const known = await Promise.all(
      settings.map(({ m_A, v_A, m_B, v_B, e }, place) => {
        const given = { m_A: `${m_A} kg`, m_B: `${m_B} kg`, v_A1: `${v_A} m/s`, v_B1: `${v_B} m/s`, e: `${e}` };
        return meeting[place] ? said(`carts-${batch}-${place}`, CARTS, given, ["v_A2", "v_B2", "T_lost"]) : null;
      }),
    );
    for (const [place, setting] of settings.entries()) {
      const where = JSON.stringify(setting);
      await put(page, setting);
      const [told, v_A, v_B, lost, before, after] = await texts(page, [
        show("told"),
        show("bodies.0.after"),
        show("bodies.1.after"),
        show("lost"),
        show("energy.2.before"),
        show("energy.2.after"),
      ]);
      const own = known[place];
      if (!own) {
        assert.match(told ?? "", /^No impact: .*would not catch up/, where);
        assert.equal(number(v_A), setting.v_A, where);
        continue;
      }
      assert.deepEqual([v_A, v_B, lost], ["v_A2", "v_B2", "T_lost"].map((id) => own.answers[id]?.printed), where);
      const [impact] = own.impacts;
      assert.ok(impact);
      same(before, impact.energy_before, where);
      same(after, impact.energy_after, where);
      same(told?.match(/impulse (\S+(?: × \S+)?)/)?.[1], impact.impulse[0] ?? NaN, where);
    }
  }
  assert.deepEqual(complaints, []);
  await close();
});

/** Two discs on a table, whose line of impact points from A to B. */
const DISCS = `scene:
  axes: { x: to the right, y: [up the page, down the page] }
  bodies: { A: { name: disc A, mass: m_A }, B: { name: disc B, mass: m_B } }
  stages: [ { impact: { between: [A, B], restitution: e, line_of_impact: alpha above +x } } ]`;

test("the discs show what solve and simulate say", async () => {
  const { page, complaints, close } = await site.open();
  await page.goto(`${site.url}/simulators/discs`);
  // Two discs of 0.4 m whose centres pass each other at b touch where the sine of the line's angle is b / 0.8 m.
  const angle = (/** @type {number} */ b) => (Math.asin(b / 0.8) * 180) / Math.PI;
  const all = Array.from({ length: SETTINGS / 4 }, discs).filter(({ v_A = 0, v_B = 0 }) => v_A > v_B);
  for (const [batch, settings] of batches(all).entries()) {
    const known = await Promise.all(
      settings.map(({ m_A, v_A, m_B, v_B, b = 0, e }, place) => {
        const given = { m_A: `${m_A} kg`, m_B: `${m_B} kg`, "v_A1.x": `${v_A} m/s`, "v_B1.x": `${v_B} m/s`, "v_A1.y": "0 m/s", "v_B1.y": "0 m/s", alpha: `${angle(b).toFixed(2)} deg`, e: `${e}` };
        return said(`discs-${batch}-${place}`, DISCS, given, ["v_A2.x", "v_A2.y", "v_B2.x", "v_B2.y", "T_lost"]);
      }),
    );
    for (const [place, setting] of settings.entries()) {
      const where = JSON.stringify(setting);
      await put(page, setting);
      const shown = await texts(page, ["bodies.0.after.0", "bodies.0.after.1", "bodies.1.after.0", "bodies.1.after.1", "lost"].map(show));
      const [answers] = [known[place]?.answers ?? {}];
      for (const [own, id] of ["v_A2.x", "v_A2.y", "v_B2.x", "v_B2.y", "T_lost"].entries()) {
        // What is lost is small beside the energies of heavy discs.
        same(shown[own], Object.values(answers)[own]?.value ?? NaN, `${where}, ${id}`, id === "T_lost" ? 1e4 : 10);
      }
    }
  }
  await put(page, { m_A: 2, v_A: 4, m_B: 2, v_B: 0, b: 0.9, e: 1 });
  assert.match((await texts(page, [show("told")]))[0] ?? "", /pass each other without touching/);
  await put(page, { m_A: 2, v_A: 4, m_B: 2, v_B: 0, b: 0.4, e: 1 });
  assert.match((await page.locator("[data-solution]").textContent()) ?? "", /line of impact/);
  assert.deepEqual(complaints, []);
  await close();
});

test("bodies and arrows are dragged with the pointer and moved with the keys", async () => {
  const { page, complaints, close } = await site.open();
  await page.setViewportSize({ width: 1280, height: 800 });
  await page.goto(`${site.url}/simulators/collision`);
  await page.locator('[data-simulator][data-state="shown"]').waitFor();
  /** @param {string} selector @param {[number, number]} by */
  const drag = async (selector, [right, down]) => {
    const box = (await page.locator(selector).boundingBox()) ?? assert.fail(selector);
    const [x, y] = [box.x + box.width / 2, box.y + box.height / 2];
    await page.mouse.move(x, y);
    await page.mouse.down();
    await page.mouse.move(x + right, y + down, { steps: 5 });
    await page.mouse.up();
  };
  await drag('[data-grip="x_A"]', [-80, 0]);
  const place = Number(await page.locator("#x_A").inputValue());
  assert.ok(place < -2.7 && place > -4, `dragged to ${place}`);
  await drag('[data-grip="v_B"]', [300, 0]);
  const velocity = Number(await page.locator("#v_B").inputValue());
  assert.ok(velocity > 0 && velocity <= 10, `its arrow dragged to ${velocity}`);
  const cart = page.getByRole("slider", { name: "Place of B at the start", exact: true });
  await cart.focus();
  await cart.press("ArrowRight");
  assert.equal(await page.locator("#x_B").inputValue(), "2.6");
  await cart.press("Home");
  assert.equal(await page.locator("#x_B").inputValue(), "1");
  await page.locator('[data-shown*="x_B=1&"][data-state="shown"]').waitFor();
  assert.equal(await cart.getAttribute("aria-valuetext"), "1 m");
  await page.goto(`${site.url}/simulators/discs`);
  await page.locator('[data-simulator][data-state="shown"]').waitFor();
  await drag('[data-at="1"] [data-grip="b"]', [0, 30]);
  const beside = Number(await page.locator("#b").inputValue());
  assert.ok(beside < 0.3, `lower: ${beside}`);
  await page.goto(`${site.url}/simulators/restitution`);
  await page.locator('[data-simulator][data-state="shown"]').waitFor();
  await drag('[data-at="0"] [data-grip="h"]', [0, 60]);
  const height = Number(await page.locator("#h").inputValue());
  assert.ok(height < 3.5 && height > 1, `let go at ${height}`);
  assert.deepEqual(complaints, []);
  await close();
});

test("bars follow the time, and momentum together stays", async () => {
  const { page, complaints, close } = await site.open();
  await page.addInitScript(still_clock);
  await page.goto(`${site.url}/simulators/collision`);
  await page.locator('[data-simulator][data-state="shown"]').waitFor();
  const numbers = async () => (await page.locator("[data-bars] td:last-child").allTextContents()).map(number);
  // By hand: 3 kg at 3 m/s, 2 kg at -2 m/s; afterwards -0.4 m/s and 3.1 m/s.
  assert.deepEqual(await numbers(), [9, -4, 5, 13.5, 4, 17.5, 0]);
  await page.getByRole("button", { name: "Play" }).click();
  await page.evaluate("pass(1.5)");
  const after = await numbers();
  for (const [place, value] of [-1.2, 6.2, 5, 0.24, 9.61, 9.85, 7.65].entries()) {
    assert.ok(Math.abs((after[place] ?? NaN) - value) <= 0.0501, `${after}`);
  }
  assert.deepEqual(complaints, []);
  await close();
});

test("a second ball falls beside the first", async () => {
  const { page, complaints, close } = await site.open();
  await page.goto(`${site.url}/simulators/restitution?h=4&e=0.75`);
  await page.locator('[data-simulator][data-state="shown"]').waitFor();
  assert.equal(await page.locator('[data-at="1"]').isVisible(), false);
  await page.getByRole("checkbox", { name: "A second ball beside it, with" }).check();
  await page.locator('[data-shown$="&e_2=0.5"][data-state="shown"]').waitFor();
  assert.equal(await page.locator('[data-at="1"]').isVisible(), true);
  // By hand: a fall of 0.9031 s, and the sum (1 + e) / (1 - e) of it.
  assert.equal((await texts(page, [show("second.rests")]))[0], "2.71 s");
  const row = await page.locator("[data-bounces] tr").nth(1).locator("td").last().textContent();
  assert.equal(plain(row ?? ""), "1.00 m");
  await page.waitForURL("**&e_2=0.5");
  await page.reload();
  await page.locator('[data-shown$="&e_2=0.5"][data-state="shown"]').waitFor();
  await page.getByRole("checkbox", { name: "A second ball beside it, with" }).uncheck();
  await page.locator('[data-shown$="&v_t=0"][data-state="shown"]').waitFor();
  assert.equal(await page.locator('[data-at="1"]').isVisible(), false);
  assert.deepEqual(complaints, []);
  await close();
});

test("the bouncing ball shows what solve and simulate say", async () => {
  const { page, complaints, close } = await site.open();
  await page.goto(`${site.url}/simulators/restitution`);
  const all = Array.from({ length: SETTINGS }, restitution);
  for (const [batch, settings] of batches(all).entries()) {
    const known = await Promise.all(
      settings.map(({ h, e, n }, place) => {
        const given = { v_ball1: "0 m/s", h_0: `${h} m`, e: `${e}`, n: `${n}` };
        return said(`ball-${batch}-${place}`, BALL, given, ["h_n", "t_total", "path_total"]);
      }),
    );
    for (const [place, setting] of settings.entries()) {
      const where = JSON.stringify(setting);
      await put(page, setting);
      const [time, path] = await texts(page, [show("sums.time"), show("sums.path")]);
      const rows = await page.evaluate(() =>
        [...document.querySelectorAll("[data-bounces] tr")].map((row) => [...row.children].map((cell) => cell.textContent ?? "")),
      );
      const { answers, impacts } = known[place] ?? assert.fail();
      assert.deepEqual([time, path], [answers.t_total?.printed, answers.path_total?.printed], where);
      const looked_at = rows[setting.n ?? 0];
      if (looked_at && impacts.length >= (setting.n ?? 0)) same(looked_at[3], answers.h_n?.value ?? NaN, where, setting.h);
      for (const [count, row] of rows.slice(1).entries()) {
        const impact = impacts[count];
        if (!impact) break;
        same(row[1], impact.time, `${where}, bounce ${count + 1}`);
        // Of 1 kg: v^2 = 2 T.
        same(row[2], Math.sqrt(2 * impact.energy_after), `${where}, bounce ${count + 1}`);
      }
    }
  }
  assert.deepEqual(complaints, []);
  await close();
});

test("time runs by the clock, and stops, steps and starts again", async () => {
  const { page, complaints, close } = await site.open();
  await page.addInitScript(still_clock);
  await page.goto(`${site.url}/simulators/collision?m_A=3&v_A=3&m_B=2&v_B=-2&e=0.7`);
  await page.locator('[data-simulator][data-state="shown"]').waitFor();
  const state = () => texts(page, ["[data-state-words]", "[data-now]"]);
  /** @param {number} time */
  const pass = (time) => page.evaluate(`pass(${time / 1000})`);
  assert.deepEqual(await state(), ["approaching", "0.00 s: A at -2.50 m, B at 2.50 m, centre of mass at -0.50 m"]);
  await page.getByRole("button", { name: "Play" }).click();
  await pass(500);
  assert.deepEqual(await state(), ["approaching", "0.50 s: A at -1.00 m, B at 1.50 m, centre of mass at 0.00 m"]);
  await pass(340);
  assert.equal((await state())[0], "contact");
  await page.getByRole("button", { name: "Pause" }).click();
  await pass(500);
  assert.match((await state())[1] ?? "", /^0\.84 s/);
  await page.getByRole("button", { name: "One step" }).click();
  assert.deepEqual((await state())[0], "separating");
  await page.getByLabel("Speed").selectOption("0.1");
  await page.getByRole("button", { name: "Play" }).click();
  await pass(1000);
  assert.match((await state())[1] ?? "", /^0\.97 s/, "slow motion");
  await page.getByRole("button", { name: "Reset" }).click();
  assert.match((await state())[1] ?? "", /^0\.00 s/);
  assert.deepEqual(complaints, []);
  await close();
});

test("a preset, a method and the address go together", async () => {
  const { page, complaints, close } = await site.open();
  await page.goto(`${site.url}/simulators/collision`);
  await page.locator('[data-simulator][data-state="shown"]').waitFor();
  await page.getByRole("link", { name: "Plastic" }).click();
  await page.locator('[data-shown="m_A=3&v_A=3&m_B=2&v_B=-2&x_A=-2.5&x_B=2.5&e=0"][data-state="shown"]').waitFor();
  await page.waitForURL("**/simulators/collision?m_A=3&v_A=3&m_B=2&v_B=-2&x_A=-2.5&x_B=2.5&e=0");
  assert.equal(await page.locator("[data-magnified]").isVisible(), false, "no spring and dashpot are plastic");
  await page.getByLabel("Compare with a method").selectOption("penalty");
  await page.locator('[data-shown$="method=penalty&step=0.06"][data-state="shown"]').waitFor();
  assert.match((await texts(page, ["[data-method-refused]"]))[0] ?? "", /no calibration/);
  await page.getByLabel("Compare with a method").selectOption("explicit-euler");
  await page.locator('[data-shown$="method=explicit-euler&step=0.06"][data-state="shown"]').waitFor();
  await page.locator("#e").fill("0.7");
  await page.locator('[data-shown*="&e=0.7&method="][data-state="shown"]').waitFor();
  const contact = await page.locator("[data-magnified] tr").allTextContents();
  assert.match(contact.find((row) => row.startsWith("Their ratio")) ?? "", /0\.70|0\.699/);
  await page.waitForURL("**&e=0.7&method=explicit-euler&step=0.06");
  await page.reload();
  await page.locator('[data-shown$="method=explicit-euler&step=0.06"][data-state="shown"]').waitFor();
  assert.equal(await page.locator("#compared").textContent(), "The exact motion and explicit Euler");
  await page.locator("#e").fill("1.5");
  await page.locator('[data-simulator][data-state="refused"]').waitFor();
  assert.match((await texts(page, ["[data-refused]"]))[0] ?? "", /above 1 would create energy/);
  await page.locator("#e").fill("0.5");
  await page.locator('[data-simulator][data-state="shown"]').waitFor();
  assert.equal(await page.locator("[data-refused]").isVisible(), false);
  assert.deepEqual(complaints, []);
  await close();
});

test("without JavaScript the same numbers are asked for by the form", async () => {
  const { page, close } = await site.open({ javaScriptEnabled: false });
  await page.goto(`${site.url}/simulators/collision`);
  await page.locator("#e").fill("1");
  await page.getByRole("button", { name: "Show" }).click();
  assert.match((await page.locator(show("told")).textContent()) ?? "", /12\.0.N.s from A/);
  assert.equal(await page.locator(show("lost")).textContent(), "0 J");
  assert.ok((await page.locator('[data-plot="places"] polyline').count()) === 3);
  assert.ok((await page.locator('[data-plot="contact"] polyline').count()) === 2);
  await page.getByRole("link", { name: "Show the solution" }).click();
  assert.match(page.url(), /solution\/impact\/two-carts\?set\.m_A=3\+kg/);
  assert.match((await page.locator("article.solution").textContent()) ?? "", /Worked solution/);
  await close();
});

test("a problem is made of the numbers that are set, and answered", async () => {
  const { page, complaints, close } = await site.open();
  await page.goto(`${site.url}/simulators/collision`);
  await page.locator('[data-simulator][data-state="shown"]').waitFor();
  await page.locator("#v_B").fill("-1.5");
  await page.locator('[data-shown*="v_B=-1.5"][data-state="shown"]').waitFor();
  // By hand: the centre of mass moves at (3 * 3 - 2 * 1.5) / 5 = 1.2 m/s, so v_A2 = 1.2 - 0.7 (3 - 1.2) and v_B2 = 1.2 + 0.7 (1.2 + 1.5).
  await page.getByRole("link", { name: "Make a problem of this" }).click();
  await page.waitForURL("**/practice/impact/two-carts?set.*");
  assert.match((await page.locator(".statement").textContent()) ?? "", /Cart A \(3.kg\).* at 1\.5.m\/s to the left/);
  await page.locator('[data-part="v_A2"]').fill("-0,0600 m/s");
  await page.locator('[data-reading="v_A2"][data-state="read"]').waitFor();
  assert.match((await page.locator('[data-reading="v_A2"]').textContent()) ?? "", /Read as -0\.0600 metres per second/);
  await page.locator('[data-part="v_B2"]').fill("3.09 m/s");
  // The energy lost: half of the reduced mass 1.2 kg, times 1 - 0.49, times (4.5 m/s)^2.
  await page.locator('[data-part="T_lost"]').fill("6.1965 J");
  await page.getByRole("button", { name: "Check" }).click();
  assert.match((await page.locator(".total").textContent()) ?? "", /5 of 5 points/);
  await page.getByRole("link", { name: "Whole solution" }).click();
  assert.match(page.url(), /set\.v_B1=-1\.5/);
  assert.match((await page.locator("article.solution").textContent()) ?? "", /3\.09/);
  assert.deepEqual(complaints, []);
  await close();
});

test("an empty field is said to be empty", async () => {
  const { page, complaints, close } = await site.open();
  await page.goto(`${site.url}/simulators/restitution`);
  await page.locator('[data-simulator][data-state="shown"]').waitFor();
  await page.locator("#h").fill("");
  await page.locator('[data-simulator][data-state="refused"]').waitFor();
  assert.match((await texts(page, ["[data-refused]"]))[0] ?? "", /“Height of release” holds no number: type one\./);
  await page.locator("#h").fill("2");
  await page.locator('[data-simulator][data-state="shown"]').waitFor();
  await page.getByRole("link", { name: "Nothing lost" }).click();
  await page.locator('[data-shown*="&e=1&"][data-state="shown"]').waitFor();
  assert.match((await texts(page, ["[data-no-problem]"]))[0] ?? "", /has no limit/);
  assert.equal(await page.getByRole("link", { name: "Make a problem of this" }).isVisible(), false);
  assert.deepEqual(complaints, []);
  await close();
});

for (const [name, address] of /** @type {const} */ ([
  ["collision", "/simulators/collision"],
  ["restitution", "/simulators/restitution?e=0.9"],
])) {
  test(`the ${name} says what happens at most once a second`, async () => {
    const { page, complaints, close } = await site.open();
    await page.addInitScript(still_clock);
    await page.goto(site.url + address);
    await page.locator('[data-simulator][data-state="shown"]').waitFor();
    await page.evaluate(() => {
      const said = document.querySelector("[data-announced]");
      if (!said) throw new Error("nothing is announced");
      /** @type {[number, string][]} */
      const heard = [];
      const { now } = Reflect.get(globalThis, "momentousClock");
      new MutationObserver(() => heard.push([now(), said.textContent ?? ""])).observe(said, { childList: true, characterData: true, subtree: true });
      Object.assign(globalThis, { heard });
    });
    await page.getByRole("button", { name: "Play" }).click();
    // Twelve seconds, a twentieth at a time, in which the ball falls, touches and rises many times.
    for (let step = 0; step < 240; step += 1) await page.evaluate("pass(0.05)");
    /** @type {[number, string][]} */
    const heard = await page.evaluate("heard");
    assert.ok(heard.length > (name === "collision" ? 0 : 4), JSON.stringify(heard));
    for (const [place, [time]] of heard.entries()) {
      const before = heard[place - 1];
      assert.ok(!before || time - before[0] >= 999.9, JSON.stringify(heard));
    }
    const last = await page.locator("[data-state-words]").textContent();
    assert.equal(heard.at(-1)?.[1], last, "what is said last is what is the case");
    assert.deepEqual(complaints, []);
    await close();
  });

  test(`whoever wants no motion sees the end of the ${name} at once`, async () => {
    const { page, close } = await site.open({ reducedMotion: "reduce" });
    await page.addInitScript(still_clock);
    await page.goto(site.url + address);
    await page.locator('[data-simulator][data-state="shown"]').waitFor();
    await page.getByRole("button", { name: "Play" }).click();
    const time = page.locator("input[data-time]");
    const [shown, end] = [Number(await time.inputValue()), Number(await time.getAttribute("max"))];
    assert.ok(end > 1 && Math.abs(shown - end) < 1e-9 * end, `${shown} s of ${end} s`);
    assert.equal(await page.locator("[data-simulator]").getAttribute("data-playing"), "false");
    await close();
  });
}

test("the drift of a method is a table as well as a plot", async () => {
  const { page, complaints, close } = await site.open();
  const values = { m_A: 3, v_A: 3, m_B: 2, v_B: -2, e: 0.7 };
  await page.goto(`${site.url}/simulators/collision?method=explicit-euler&step=0.06`);
  await page.locator('[data-simulator][data-state="shown"]').waitFor();
  await page.getByText("The plot as a table").last().click();
  const heads = await page.locator("[data-drifts] th").allTextContents();
  assert.deepEqual(heads, ["time in s", "momentum", "energy"]);
  const rows = await page.locator("[data-drifts] tbody tr").evaluateAll((all) => all.map((row) => [...row.children].map((cell) => cell.textContent ?? "")));
  const response = await page.request.post(`${site.url}/api/collision`, { data: { values, method: "explicit-euler", step: 0.06 } });
  const { compared } = await response.json();
  assert.equal(rows.length, 21);
  for (const [column, { points }] of compared.drifts.entries()) {
    assert.equal(number(rows.at(0)?.[column + 1]), points[0][1]);
    const [last, shown] = [points.at(-1)[1], number(rows.at(-1)?.[column + 1])];
    assert.ok(Math.abs(shown - last) <= 1e-3 * Math.abs(last), `${shown} instead of ${last}`);
  }
  assert.deepEqual(complaints, []);
  await close();
});
