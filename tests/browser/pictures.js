// The pictures of the README: `npm run pictures` writes them to docs/pictures/.

import { mkdirSync } from "node:fs";
import { dirname, join } from "node:path";
import { fileURLToPath } from "node:url";

import { browse, start } from "./server.js";

const folder = join(dirname(fileURLToPath(import.meta.url)), "../../docs/pictures");

/** Name, address, width and height of each picture. */
const PICTURES = /** @type {const} */ ([
  ["collision", "/simulators/collision", 1000, 900],
  ["restitution", "/simulators/restitution", 1000, 900],
  ["play", "/play/impact/two-carts?seed=7", 1000, 900],
]);

mkdirSync(folder, { recursive: true });
const [server, browser] = await Promise.all([start(), browse()]);
try {
  for (const [name, address, width, height] of PICTURES) {
    const page = await browser.newPage({ viewport: { width, height } });
    await page.goto(server.url + address);
    await page.screenshot({ path: join(folder, `${name}.png`) });
    await page.close();
  }
  const page = await browser.newPage({ viewport: { width: 800, height: 900 } });
  await page.goto(`${server.url}/practice/impact/two-carts?seed=7`);
  await page.locator('[name="answer.v_A2"]').fill("1,39 m/s");
  await page.locator('[name="answer.v_B2"]').fill("2.89 m/s to the right");
  await page.locator('[name="answer.T_lost"]').fill("45.0 kJ");
  await page.getByRole("button", { name: "Check" }).click();
  await page.screenshot({ path: join(folder, "practice.png"), fullPage: true });
} finally {
  await browser.close();
  await server.stop();
}
