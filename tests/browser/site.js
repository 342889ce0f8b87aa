// The pages under test: a server and a browser, started before the tests of a file and stopped after them.

import { after, before } from "node:test";

import { browse, start, strict_page } from "./server.js";

/** @type {Awaited<ReturnType<typeof start>>} */
let server;
/** @type {import("playwright-core").Browser} */
let browser;

before(async () => {
  [server, browser] = await Promise.all([start(), browse()]);
});

after(async () => {
  await browser.close();
  await server.stop();
});

export const site = {
  /** Where the pages begin. */
  get url() {
    return server.url;
  },
  /** The folder in which the program runs. */
  get folder() {
    return server.folder;
  },
  /**
   * A page that notes what is logged as an error, or breaks the page's policy.
   * @param {import("playwright-core").BrowserContextOptions} [options]
   */
  open(options) {
    return strict_page(browser, options);
  },
};

/** A clock that stands still until the test turns it: `pass(seconds)` in the page, before which nothing moves. */
export function still_clock() {
  /** @type {(() => void)[]} */
  let waiting = [];
  let now = 0;
  /** @type {{ due: number, call: () => void }[]} */
  let timers = [];
  const pass = (/** @type {number} */ seconds) => {
    now += 1000 * seconds;
    const late = timers.filter(({ due }) => due <= now);
    timers = timers.filter(({ due }) => due > now);
    for (const { call } of late) call();
    const due = waiting;
    waiting = [];
    for (const callback of due) callback();
  };
  Object.assign(globalThis, {
    momentousClock: {
      now: () => now,
      frame: (/** @type {() => void} */ callback) => void waiting.push(callback),
      /** @param {() => void} call @param {number} wait */
      after: (call, wait) => {
        const timer = { due: now + wait, call };
        timers.push(timer);
        return () => void (timers = timers.filter((own) => own !== timer));
      },
    },
    pass,
  });
}
