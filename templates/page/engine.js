// @ts-check
// The engine of this file: a module of WebAssembly that answers every address with a page, as a server would.

/** @typedef {{ kind: string, message: string, help?: string }} Refusal */
/** @typedef {{ name: string, kind: string, base64: string }} Asset */
/** @typedef {{ assets?: { directory: string, files: Asset[] }, text?: string, value?: unknown, refused?: Refusal }} Answer */

/**
 * The text of an element of this file.
 * @param {string} id
 */
function text_in(id) {
  return document.getElementById(id)?.textContent ?? "";
}

/** @param {string} base64 */
function bytes_of(base64) {
  return Uint8Array.from(atob(base64), (letter) => letter.charCodeAt(0));
}

/** The engine, which answers JSON with JSON. */
class Engine {
  /** @type {WebAssembly.Module} */
  #module;
  /** @type {any} */
  #exports;

  /** @param {WebAssembly.Module} module */
  constructor(module) {
    this.#module = module;
  }

  /** The module that stands in this file, or beside it in a folder. */
  static async unpacked() {
    const beside = document.getElementById("engine")?.dataset.beside;
    const found = beside ? await (await fetch(beside)).blob() : new Blob([bytes_of(text_in("engine"))]);
    const [first, second] = new Uint8Array(await found.slice(0, 2).arrayBuffer());
    // Some servers unpack what they send.
    const is_packed = first === 0x1f && second === 0x8b;
    const stream = is_packed ? found.stream().pipeThrough(new DecompressionStream("gzip")) : found.stream();
    return new Engine(await WebAssembly.compile(await new Response(stream).arrayBuffer()));
  }

  /** Starts it; again where it stopped. */
  async start() {
    this.#exports = (await WebAssembly.instantiate(this.#module, {})).exports;
    return this.ask({ open: { problems: JSON.parse(text_in("problems")) } });
  }

  /**
   * @param {object} request
   * @returns {Answer}
   */
  ask(request) {
    const { memory, reserve, answer, answered_at } = this.#exports;
    const bytes = new TextEncoder().encode(JSON.stringify(request));
    const place = reserve(bytes.length);
    new Uint8Array(memory.buffer, place, bytes.length).set(bytes);
    const length = answer();
    return JSON.parse(new TextDecoder().decode(new Uint8Array(memory.buffer, answered_at(), length)));
  }
}
