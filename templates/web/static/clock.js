// @ts-check
// Model time for animations: played, paused, stepped and set.

/**
 * Where time comes from. A test sets `globalThis.momentousClock` before it plays, and turns the hands itself.
 * @typedef {object} Source
 * @property {() => number} now milliseconds
 * @property {(callback: () => void) => void} frame a call before the next picture
 * @property {(callback: () => void, wait: number) => () => void} after a call after so many milliseconds; the result calls it off
 */

/** @type {Source["after"]} */
function later(callback, wait) {
  const timer = setTimeout(callback, wait);
  return () => clearTimeout(timer);
}

/** @returns {Source} */
export function source() {
  const set = /** @type {{ momentousClock?: Source }} */ (globalThis).momentousClock;
  return set ?? { now: () => performance.now(), frame: (callback) => void requestAnimationFrame(callback), after: later };
}

/** The steps from start to end. */
const STEPS = 60;

/** A clock from 0 to `end`, in s of the model. */
export class Clock {
  /** Seconds of the model in a second of the reader's. */
  rate = 1;
  /** Whether it runs. */
  playing = false;
  /** The present time. */
  time = 0;
  /** How far one step goes. */
  stride;
  #tick;
  /** Counts the runs, so that a picture that an earlier run asked for does nothing. */
  #run = 0;

  /** @param {{ end: number, tick: (time: number) => void }} settings `tick` hears the time whenever it or `playing` has changed */
  constructor({ end, tick }) {
    this.end = end;
    this.stride = end / STEPS;
    this.#tick = tick;
  }

  /** Runs on, at the end from the start. Where the reader wants no motion it goes to the end at once. */
  play() {
    if (this.playing) return;
    if (matchMedia("(prefers-reduced-motion: reduce)").matches) return this.seek(this.end);
    if (this.time >= this.end) this.time = 0;
    this.playing = true;
    const run = ++this.#run;
    const { now, frame } = source();
    let last = now();
    const advance = () => {
      if (run !== this.#run) return;
      const present = now();
      this.#set(this.time + ((present - last) / 1000) * this.rate);
      last = present;
      if (this.playing) frame(advance);
    };
    this.#tick(this.time);
    frame(advance);
  }

  pause() {
    this.seek(this.time);
  }

  /** A step forwards, or so many; backwards where it is negative. */
  step(count = 1) {
    this.seek(this.time + count * this.stride);
  }

  reset() {
    this.seek(0);
  }

  /**
   * Stops at a time.
   * @param {number} time
   */
  seek(time) {
    this.playing = false;
    this.#run += 1;
    this.#set(time);
  }

  /** @param {number} time */
  #set(time) {
    this.time = Math.min(Math.max(time, 0), this.end);
    if (this.time >= this.end) this.playing = false;
    this.#tick(this.time);
  }
}
