// What makes a page hard to use for somebody: what axe-core finds, what lies beyond its window, and what is cut off.

import { readFileSync } from "node:fs";
import { createRequire } from "node:module";

const axe = readFileSync(createRequire(import.meta.url).resolve("axe-core/axe.min.js"), "utf8");

/**
 * What is wrong with the page that is shown; its context has to bypass its policy.
 * @param {import("playwright-core").Page} page
 * @returns {Promise<string[]>}
 */
export async function barriers(page) {
  const cut = await cut_off(page);
  const violations = [];
  // Each by itself: frames of a file from disk do not speak with each other.
  for (const frame of page.frames()) {
    await frame.addScriptTag({ content: axe });
    violations.push(...(await frame.evaluate("axe.run({ iframes: false })")).violations);
  }
  const said = violations.map((own) => `${own.id}: ${own.nodes.map((/** @type {any} */ node) => node.html).join("; ")}`);
  return [...cut, ...said];
}

/**
 * What cannot be seen of the page that is shown without scrolling it sideways: what lies beyond the window, what an element hides of what is
 * in it, choices longer than their field, numbers longer than theirs, what runs out of a table's cell, and letters too small to read.
 *
 * A window that has just got another size may show a frame of the old layout: a fault is one that is still there afterwards.
 * @param {import("playwright-core").Page} page
 * @returns {Promise<string[]>}
 */
export async function cut_off(page) {
  const faults = await cut_off_now(page);
  if (faults.length === 0) return faults;
  await page.evaluate(() => new Promise((laid_out) => requestAnimationFrame(() => requestAnimationFrame(() => setTimeout(laid_out, 200)))));
  return cut_off_now(page);
}

/**
 * @param {import("playwright-core").Page} page
 * @returns {Promise<string[]>}
 */
function cut_off_now(page) {
  return page.evaluate(() => {
    /** The height of the smallest text that can be read, in px. */
    const SMALLEST = 6;
    const root = document.documentElement;
    const beyond = root.scrollWidth - root.clientWidth;
    const found = beyond > 0 ? [`${beyond} px too wide`] : [];
    const name = (/** @type {Element} */ element) => element.outerHTML.slice(0, 120);
    for (const element of document.querySelectorAll("body *")) {
      if (!(element instanceof HTMLElement) || element.closest(".aside, .hidden, .skip, [hidden]")) continue;
      if (!element.matches("input, select")) {
        const { overflowX, overflowY } = getComputedStyle(element);
        const is_hidden = (/** @type {string} */ overflow) => overflow === "hidden" || overflow === "clip";
        // What is laid out below an equation's last line is no ink.
        const is_low = element.scrollHeight > element.clientHeight + (element.matches(".equation") ? 8 : 1);
        if ((is_hidden(overflowX) && element.scrollWidth > element.clientWidth + 1) || (is_hidden(overflowY) && is_low)) found.push(`hides a part: ${name(element)}`);
      }
      if (element.matches("td, th") && element.scrollWidth > element.clientWidth + 1) found.push(`runs out of its cell: ${name(element)}`);
      if (element.matches("input[type=number]") && element.scrollWidth > element.clientWidth + 1) found.push(`a number is cut: ${name(element)}`);
    }
    for (const text of document.querySelectorAll("svg text")) {
      const { height } = text.getBoundingClientRect();
      if (height > 0 && height < SMALLEST) found.push(`a text is ${height} px high: ${name(text)}`);
    }
    for (const select of document.querySelectorAll("select")) {
      // Names of people may have any length; the list that opens shows them whole.
      if (select.clientWidth === 0 || select.name === "member") continue;
      // As wide as its longest choice wants it.
      const free = /** @type {HTMLSelectElement} */ (select.cloneNode(true));
      free.style.cssText = "position: absolute; width: auto; min-width: 0; max-width: none; visibility: hidden";
      select.after(free);
      const wanted = free.offsetWidth;
      free.remove();
      if (wanted > select.offsetWidth + 1) found.push(`a choice needs ${wanted} px of ${select.offsetWidth}: ${name(select)}`);
    }
    return found;
  });
}
