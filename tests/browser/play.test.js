// A scene played: its clock is in the hands of the test, and the bodies have to be where the engine's record has them.

import assert from "node:assert/strict";
import { test } from "node:test";

import { site, still_clock } from "./site.js";

/**
 * A page that plays a problem, with a clock that stands still until `pass` turns it.
 * @param {string} problem
 * @param {import("playwright-core").BrowserContextOptions} [options]
 */
async function played(problem, options) {
  const own = await site.open(options);
  const { page } = own;
  await page.addInitScript(still_clock);
  await page.goto(`${site.url}/play/${problem}?seed=1`);
  await page.locator("html[data-state=ready]").waitFor();
  const request = { problem, seed: 1, together: true };
  const response = await page.request.post(`${site.url}/api/simulate`, { data: request });
  const scene = page.locator("section.film");
  return {
    ...own,
    record: await response.json(),
    scene,
    /** @param {string} state */
    is: (state) => page.locator(`section.film[data-state=${state}]`).waitFor(),
    /** @param {number} seconds */
    pass: (seconds) => page.evaluate(`pass(${seconds})`),
    /** How many seconds of the scene are shown in one of the reader's. */
    rate: async () => {
      const [, number, sense] = ((await page.locator(".paced").textContent()) ?? "").match(/Shown ([\d.,]+) times (slower|as fast)/) ?? [];
      if (!number) return 1;
      return sense === "slower" ? 1 / Number(number.replaceAll(",", "")) : Number(number.replaceAll(",", ""));
    },
    time: async () => Number(await scene.getAttribute("data-time")),
  };
}

/**
 * A body's place at a time by the record, in m.
 * @param {any} film
 * @param {number} body
 * @param {number} time
 * @returns {number[]}
 */
function recorded(film, body, time) {
  const next = film.moments.findIndex((/** @type {any} */ moment) => moment.time > time);
  if (next < 0) return film.moments.at(-1).positions[body];
  const [one, other] = [film.moments[next - 1], film.moments[next]];
  const share = (time - one.time) / (other.time - one.time);
  return one.positions[body].map((/** @type {number} */ part, /** @type {number} */ axis) => part + share * (other.positions[body][axis] - part));
}

/**
 * Holds every body against the record: on the page, and in the table beneath it.
 * @param {import("playwright-core").Page} page
 * @param {any} film
 * @param {number} time
 */
async function in_place(page, film, time) {
  const { scale, left, top } = await page.locator("svg.motion").evaluate((svg) => ({ .../** @type {SVGElement} */ (svg).dataset }));
  for (const [body, { name }] of film.bodies.entries()) {
    const place = recorded(film, body, time);
    const moved = (await page.locator(`[data-body="${name}"]`).getAttribute("transform")) ?? "";
    const [x, y] = moved.match(/-?[\d.]+/g)?.map(Number) ?? [];
    const units = film.directions.map((/** @type {any} */ own) => own.on_page);
    const sum = (/** @type {number} */ part) => place.reduce((all, own, axis) => all + own * units[axis][part], 0);
    // On a line only the place along it is the record's.
    const along = units.length > 1 ? [0, 1] : [units[0][0] ? 0 : 1];
    const found = [((x ?? NaN) - Number(left)) / Number(scale), (Number(top) - (y ?? NaN)) / Number(scale)];
    for (const part of along) {
      const apart = Math.abs((found[part] ?? NaN) - sum(part)) * Number(scale);
      assert.ok(apart < 0.02, `${name} at ${time} s is ${apart} px away from its place`);
    }
    const cells = await page.locator(".values tbody tr").nth(body).locator("td").allTextContents();
    for (const [axis, own] of place.entries()) {
      const shown = Number((cells[1 + axis] ?? "").replace("\u2212", "-"));
      const largest = Math.max(...film.moments.map((/** @type {any} */ moment) => Math.abs(moment.positions[body][axis])));
      assert.ok(Math.abs(shown - own) <= 1e-3 * largest, `${name}: ${shown} instead of ${own}`);
    }
  }
}

for (const problem of ["impact/two-carts", "impact/hockey-pucks", "chains/ballistic-pendulum", "vectors/drone-in-wind"]) {
  test(`the bodies of ${problem} are where the record has them`, async () => {
    const { page, complaints, close, record, is, pass, rate, time } = await played(problem);
    const [film] = record.stages;
    const start = film.moments[0].time;
    const speed = await rate();
    await in_place(page, film, start);
    await page.getByRole("button", { name: "Play" }).click();
    await is("playing");
    for (const seconds of [0.25, 0.5, 1, 1.75]) {
      const before = await time();
      await pass(seconds);
      const now = await time();
      assert.ok(Math.abs(now - before - seconds * speed) < 1e-9 * speed, `${now - before} s at ${speed}`);
      await in_place(page, film, now);
    }
    assert.deepEqual(complaints, []);
    await close();
  });
}

test("a scene is played, stopped, stepped and set by keyboard alone", async () => {
  const { page, complaints, close, record, is, pass, time } = await played("impact/two-carts");
  const [film] = record.stages;
  const [first, last] = [film.moments[0].time, film.moments.at(-1).time];
  const focus = async (/** @type {string} */ name) => {
    for (let steps = 0; steps < 40; steps += 1) {
      await page.keyboard.press("Tab");
      const own = await page.evaluate(() => document.activeElement?.getAttribute("aria-label") ?? document.activeElement?.textContent);
      if (own === name) return;
    }
    assert.fail(`${name} is not reached`);
  };
  await focus("Time");
  await page.keyboard.press("End");
  await is("ended");
  assert.ok(Math.abs((await time()) - last) < 1e-12);
  await in_place(page, film, last);
  await page.keyboard.press("Home");
  await is("paused");
  for (let steps = 0; steps < 12; steps += 1) await page.keyboard.press("ArrowRight");
  const set = await time();
  assert.ok(Math.abs(set - first - (12 * (last - first)) / 240) < 1e-6 * (last - first), `${set}`);
  await in_place(page, film, set);
  await focus("Play");
  await page.keyboard.press("Space");
  await is("playing");
  await pass(0.5);
  await page.keyboard.press("Space");
  await is("paused");
  const stopped = await time();
  assert.ok(stopped > set);
  await pass(0.5);
  assert.equal(await time(), stopped, "a frame after the stop moves nothing");
  await focus("Step");
  await page.keyboard.press("Enter");
  assert.ok(Math.abs((await time()) - stopped - (last - first) / 60) < 1e-9);
  await focus("Reset");
  await page.keyboard.press("Enter");
  assert.equal(await time(), first);
  assert.deepEqual(complaints, []);
  await close();
});

test("one stage follows another, and each can be chosen", async () => {
  const { page, close, record, scene, is, pass } = await played("chains/ballistic-pendulum");
  assert.equal(record.stages.length, 2);
  await page.getByRole("button", { name: "Play" }).click();
  await is("playing");
  await pass(1000);
  assert.equal(await scene.getAttribute("data-film"), "1");
  await is("playing");
  await in_place(page, record.stages[1], record.stages[1].moments[0].time);
  await pass(1000);
  await is("ended");
  await page.getByRole("button", { name: "1 impact" }).click();
  assert.equal(await scene.getAttribute("data-film"), "0");
  await is("paused");
  await close();
});

test("whoever wants no motion sees the end at once", async () => {
  const { page, close, record, is, time } = await played("impact/two-carts", { reducedMotion: "reduce" });
  await page.getByRole("button", { name: "Play" }).click();
  await is("ended");
  assert.equal(await time(), record.stages[0].moments.at(-1).time);
  await page.getByRole("button", { name: "Back one step" }).click();
  await is("paused");
  await close();
});

test("without JavaScript the places stand as curves, with the impacts as a table", async () => {
  const { page, complaints, close } = await site.open({ javaScriptEnabled: false });
  await page.goto(`${site.url}/play/impact/two-carts?seed=1`);
  assert.equal(await page.locator(".filmed figure svg").count(), 1);
  assert.equal(await page.locator(".impacts tbody tr").count(), 1);
  assert.deepEqual(complaints, []);
  await close();
});

test("a single instant is not played, and the page says why", async () => {
  const { page, close } = await site.open();
  await page.goto(`${site.url}/play/mass-centre/three-boats`);
  assert.match((await page.getByRole("alert").textContent()) ?? "", /a single instant/);
  await close();
});
