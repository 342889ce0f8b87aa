// @ts-check
// The picture of a simulator's scene: a window that shows what must be seen, and arrows in it.

/** @typedef {[number, number]} Pair */
/** The free space around what is shown, in px. @typedef {{ left: number, right: number, above: number, below: number }} Room */

/** The head of an arrow, and the tip by which it is taken, in px. */
const HEAD = 9;
const TIP = 12;

/**
 * The picture of a page. One that was served without results has none, and is loaded anew as soon as there are any.
 * @param {Element} root
 * @returns {SVGSVGElement}
 */
export function picture(root) {
  const svg = root.querySelector("svg[data-scene]");
  return svg instanceof SVGSVGElement ? svg : document.createElementNS("http://www.w3.org/2000/svg", "svg");
}

/** The window of a picture, in m to the right and downwards. Texts and arrows in it keep their size on the screen. */
export class Frame {
  /** How long a px is, in m. */
  unit = 0.01;
  #svg;
  #room;
  /** @type {[Pair, Pair] | undefined} */
  #seen;
  #redraw = () => {};

  /**
   * @param {SVGSVGElement} svg
   * @param {Room} room
   */
  constructor(svg, room) {
    this.#svg = svg;
    this.#room = room;
    new ResizeObserver(() => {
      this.#fit();
      this.#redraw();
    }).observe(svg);
  }

  /** How wide the window is, in m. */
  get width() {
    return this.unit * (this.#svg.clientWidth || 800);
  }

  /**
   * Shows at least that, and says when it has to be drawn anew. While a part is held the window stays where it is.
   * @param {Pair} across
   * @param {Pair} down
   * @param {() => void} redraw
   */
  show(across, down, redraw) {
    this.#seen = [across, down];
    this.#redraw = redraw;
    if (!("held" in this.#svg.dataset)) this.#fit();
  }

  #fit() {
    if (!this.#seen) return;
    const [[left, right], [top, bottom]] = this.#seen;
    const { left: before, right: after, above, below } = this.#room;
    const [wide, high] = [this.#svg.clientWidth || 800, this.#svg.clientHeight || 300];
    this.unit = Math.max((right - left) / (wide - before - after), (bottom - top) / (high - above - below));
    // What is left free goes to both sides alike.
    const [width, height] = [wide * this.unit, high * this.unit];
    const x = (left + right - width + (after - before) * this.unit) / 2;
    const y = (top + bottom - height + (below - above) * this.unit) / 2;
    this.#svg.setAttribute("viewBox", `${x} ${y} ${width} ${height}`);
    this.#svg.style.setProperty("--u", String(this.unit));
  }
}

/**
 * The line of an arrow; nothing for one that is too short to be seen.
 * @param {Pair} from
 * @param {Pair} along
 * @param {number} unit how long a px is
 */
export function arrow([x, y], [dx, dy], unit) {
  const long = Math.hypot(dx, dy);
  if (!(long > unit)) return "";
  const head = Math.min(HEAD * unit, long);
  const [ex, ey] = [(head * dx) / long, (head * dy) / long];
  /** @param {number} side */
  const barb = (side) => `M${x + dx} ${y + dy}l${-ex - side * 0.5 * ey} ${-ey + side * 0.5 * ex}`;
  return `M${x} ${y}l${dx} ${dy}${barb(1)}${barb(-1)}`;
}

/**
 * Draws the velocity of a body, and the tip by which it is taken where it has one.
 * @param {Element} group
 * @param {Pair} from
 * @param {Pair} along
 * @param {number} unit how long a px is
 */
export function draw_velocity(group, from, along, unit) {
  group.querySelector(".velocity")?.setAttribute("d", arrow(from, along, unit));
  const tip = group.querySelector(".tip");
  tip?.setAttribute("cx", String(from[0] + along[0]));
  tip?.setAttribute("cy", String(from[1] + along[1]));
  tip?.setAttribute("r", String(TIP * unit));
}

/**
 * The greatest amount of some curves.
 * @param {import("./plot.js").Curve[]} curves
 */
export function greatest(curves) {
  return Math.max(1e-300, ...curves.flatMap(({ points }) => points.map(([, value]) => Math.abs(value))));
}

/**
 * The scene on the whole screen, where the browser can.
 * @param {Element} root
 */
export function fill_screen(root) {
  const [stage, button] = [root.querySelector("[data-stage]"), root.querySelector("[data-whole-screen]")];
  if (!stage || !(button instanceof HTMLButtonElement) || !document.fullscreenEnabled) return;
  button.hidden = false;
  button.addEventListener("click", () => {
    void (document.fullscreenElement ? document.exitFullscreen() : stage.requestFullscreen());
  });
  document.addEventListener("fullscreenchange", () => {
    button.textContent = document.fullscreenElement ? "Leave full screen" : "Full screen";
  });
}
