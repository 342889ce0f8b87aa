// @ts-check
// What is said aloud to those who listen: the latest, and at most once a second.

import { source } from "./clock.js";

/** Announcements are at least so far apart, in ms. */
const QUIET = 1000;

/** The voice of a live region. */
export class Announcer {
  #region;
  #said = -Infinity;
  #waiting = () => {};

  /** @param {HTMLElement} region an element with `aria-live` */
  constructor(region) {
    this.#region = region;
  }

  /**
   * Says a text, now or as soon as the last one is a second old. What waits to be said gives way to what is said later.
   * @param {string} text
   */
  say(text) {
    this.#waiting();
    this.#waiting = () => {};
    if (text === this.#region.textContent) return;
    const { now, after } = source();
    const say = () => {
      this.#said = now();
      this.#region.textContent = text;
    };
    const wait = this.#said + QUIET - now();
    if (wait <= 0) say();
    else this.#waiting = after(say, wait);
  }
}
