// What makes a page hard to use for somebody: what axe-core finds, and what lies beyond its window.

import { readFileSync } from "node:fs";
import { createRequire } from "node:module";

const axe = readFileSync(createRequire(import.meta.url).resolve("axe-core/axe.min.js"), "utf8");

/**
 * What is wrong with the page that is shown; its context has to bypass its policy.
 * @param {import("playwright-core").Page} page
 * @returns {Promise<string[]>}
 */
export async function barriers(page) {
  const beyond = await page.evaluate(() => {
    const root = document.documentElement;
    return root.scrollWidth - root.clientWidth;
  });
  await page.addScriptTag({ content: axe });
  const found = await page.evaluate("axe.run()");
  const violations = found.violations.map(
    (/** @type {any} */ own) => `${own.id}: ${own.nodes.map((/** @type {any} */ node) => node.html).join("; ")}`,
  );
  return beyond > 0 ? [`${beyond} px too wide`, ...violations] : violations;
}
