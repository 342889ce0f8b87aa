// Every page, as anybody meets it: accessible and within its window, narrow and wide, in light and dark, with nothing that its policy
// forbids.

import assert from "node:assert/strict";
import { test } from "node:test";

import { barriers } from "./axe.js";
import { site } from "./site.js";

/** One page of each kind. */
const PAGES = [
  "/",
  "/?search=spring&level=core",
  "/?search=xylophone",
  "/practice/impact/two-carts",
  "/practice/impact/two-carts?form=find-e&seed=9",
  "/practice/concepts/coupling-in-symbols",
  "/practice/no/such-problem",
  "/solution/impact/two-carts?steps=1",
  "/solution/impact/two-carts",
  "/solve/impact/two-carts?set.m_A=3+kg&find=v_A2",
  "/solve/impact/two-carts?set.e=2",
  "/practice/impact/two-carts?set.m_A=3+kg&set.e=0.5",
  "/practice/impact/two-carts?set.e=2",
  "/simulators/collision",
  "/simulators/collision?method=penalty&step=0.01",
  "/simulators/collision?m_A=",
  "/simulators/discs",
  "/simulators/discs?b=0.9",
  "/simulators/restitution",
  "/simulators/restitution?e=0.8&e_2=0.5",
  "/simulators/restitution?e=1&v_t=20",
  "/play/impact/two-carts",
  "/play/impact/hockey-pucks",
  "/play/chains/ballistic-pendulum",
  "/play/mass-centre/three-boats",
];

/** The widths at which pages are read; 640 is a window of 1280 at 200 %. */
const WIDTHS = [320, 640, 768, 1280];

/** A page is looked at when its scripts have shown what they ask for. */
const SHOWN = "article.simulator:not([data-state=waiting], [data-state=asking]), html[data-state=ready], main:not(:has(.simulator, .play, .answers))";

for (const path of PAGES) {
  for (const colorScheme of /** @type {const} */ (["light", "dark"])) {
    test(`${path} is accessible and fits, ${colorScheme}`, async () => {
      const { page, complaints, close } = await site.open({ colorScheme, bypassCSP: true });
      for (const width of WIDTHS) {
        await page.setViewportSize({ width, height: 800 });
        await page.goto(site.url + path);
        await page.locator(SHOWN).first().waitFor();
        assert.deepEqual(await barriers(page), [], `${width} px`);
      }
      assert.deepEqual(complaints, []);
      await close();
    });
  }

  test(`${path} keeps to its policy`, async () => {
    const { page, complaints, close } = await site.open();
    await page.goto(site.url + path);
    await page.locator(SHOWN).first().waitFor();
    assert.deepEqual(complaints, []);
    await close();
  });
}
