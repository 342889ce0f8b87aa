// Every page, as anybody meets it: accessible, within a narrow window, in light and dark, with nothing that its policy forbids.

import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { createRequire } from "node:module";
import { test } from "node:test";

import { site } from "./site.js";

const axe = readFileSync(createRequire(import.meta.url).resolve("axe-core/axe.min.js"), "utf8");

/** One page of each kind. */
const PAGES = [
  "/",
  "/?search=spring&level=core",
  "/practice/impact/two-carts",
  "/practice/impact/two-carts?form=find-e&seed=9",
  "/practice/concepts/coupling-in-symbols",
  "/practice/no/such-problem",
  "/solution/impact/two-carts?steps=1",
  "/solution/impact/two-carts",
  "/solve/impact/two-carts?set.m_A=3+kg&find=v_A2",
  "/solve/impact/two-carts?set.e=2",
  "/simulators/collision",
  "/simulators/restitution",
  "/play/impact/two-carts",
];

const WIDTHS = [320, 768, 1280];

for (const path of PAGES) {
  test(`${path} is accessible, light and dark`, async () => {
    for (const colorScheme of /** @type {const} */ (["light", "dark"])) {
      const { page, complaints, close } = await site.open({ colorScheme, bypassCSP: true });
      await page.goto(site.url + path);
      await page.addScriptTag({ content: axe });
      const found = await page.evaluate("axe.run()");
      const violations = found.violations.map(
        (/** @type {any} */ own) => `${own.id}: ${own.nodes.map((/** @type {any} */ node) => node.html).join("; ")}`,
      );
      assert.deepEqual(violations, [], colorScheme);
      assert.deepEqual(complaints, []);
      await close();
    }
  });

  test(`${path} fits narrow and wide windows, and keeps to its policy`, async () => {
    const { page, complaints, close } = await site.open();
    for (const width of WIDTHS) {
      await page.setViewportSize({ width, height: 800 });
      await page.goto(site.url + path);
      const beyond = await page.evaluate(() => {
        const root = document.documentElement;
        return root.scrollWidth - root.clientWidth;
      });
      assert.ok(beyond <= 0, `${beyond} px too wide at ${width}`);
    }
    assert.deepEqual(complaints, []);
    await close();
  });
}
