// Sheets and solutions on a telephone: nothing that a page holds is wider than its screen.

import assert from "node:assert/strict";
import { execFileSync } from "node:child_process";
import { test } from "node:test";

import { program } from "./server.js";
import { site } from "./site.js";

/** A telephone that is 390 pixels wide. */
const TELEPHONE = { width: 390, height: 844 };

/** The seed at which every form is looked at. */
const SEED = 1;

/**
 * The equations that cannot be broken so far that they fit, by the address of their page, with the reason.
 * @type {Record<string, string>}
 */
const TOO_WIDE = {
  [`/solution/conservation/crate-off-trolley-ramp?form=velocities&seed=${SEED}`]:
    "a bracket of three products, each with the square of a sine or a cosine, in the denominator of a fraction under a root",
};

/** Where the pages of a problem begin: its sheet, to be answered, and its worked solution. */
const PAGES = ["/practice/", "/solution/"];

/** The sheets and solutions of the whole bank, one of each for a form. */
function addresses() {
  const lines = execFileSync(program, ["list", "--format", "json"], { cwd: site.folder, encoding: "utf8" }).trim().split("\n");
  const forms = lines.map((line) => JSON.parse(line)).flatMap((/** @type {{ id: string, forms: string[] }} */ { id, forms }) =>
    forms.length === 0 ? [`${id}?seed=${SEED}`] : forms.map((form) => `${id}?form=${form}&seed=${SEED}`),
  );
  return PAGES.flatMap((begin) => forms.map((form) => begin + form));
}

/** How many pages are asked for at once. */
const AT_ONCE = 8;

/**
 * What is too wide in the pages at those addresses, each shown in the page that is open: the text of such an equation or
 * table, and "the page" where that itself is too wide. All that is folded is opened.
 * @param {string[]} addresses
 * @returns {Promise<string[][]>}
 */
async function too_wide(addresses) {
  const texts = addresses.map(async (address) => (await fetch(address)).text());
  return (await Promise.all(texts)).map((text) => {
    const main = new DOMParser().parseFromString(text, "text/html").querySelector("main");
    if (!main) throw new Error("a page without a main part");
    document.querySelector("main")?.replaceWith(document.adoptNode(main));
    for (const folded of document.querySelectorAll("details")) folded.open = true;
    const wide = [...document.querySelectorAll(".equation, .table")].filter((part) => part.scrollWidth > part.clientWidth + 1);
    const said = wide.map((part) => (part.textContent ?? "").replace(/\s+/g, " ").trim());
    const { scrollWidth, clientWidth } = document.documentElement;
    return scrollWidth > clientWidth ? ["the page", ...said] : said;
  });
}

test("no sheet or solution of the bank scrolls sideways on a telephone", async () => {
  const { page, complaints, close } = await site.open({ viewport: TELEPHONE });
  const all = addresses();
  await page.goto(site.url + all[0]);
  await page.evaluate(() => document.fonts.ready);
  const found = [];
  for (let first = 0; first < all.length; first += AT_ONCE) {
    const some = all.slice(first, first + AT_ONCE);
    const wide = await page.evaluate(too_wide, some);
    for (const [place, address] of some.entries()) {
      const parts = wide[place] ?? [];
      if (parts.length > 0 && !(address in TOO_WIDE)) found.push(`${address}: ${parts.join(" | ")}`);
      if (parts.length === 0 && address in TOO_WIDE) found.push(`${address} fits, and need not be listed`);
    }
  }
  assert.deepEqual(found, []);
  assert.deepEqual(complaints, []);
  await close();
});
