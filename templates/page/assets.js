// @ts-check
// The files to which pages refer: styles, fonts and scripts, which stand in the engine.

/** The files to which pages refer. Scripts become addresses of their own, in which they name each other. */
class Assets {
  directory = "";
  /** @type {Map<string, Asset>} */
  #files = new Map();
  /** @type {Map<string, string>} */
  #scripts = new Map();

  /** @param {{ directory: string, files: Asset[] }} assets */
  constructor({ directory, files }) {
    this.directory = directory;
    for (const file of files) this.#files.set(file.name, file);
  }

  /** @param {string} name */
  #text(name) {
    return new TextDecoder().decode(bytes_of(this.#files.get(name)?.base64 ?? ""));
  }

  /** @param {string} name */
  data(name) {
    const { kind, base64 } = this.#files.get(name) ?? { kind: "text/plain", base64: "" };
    return `data:${kind};base64,${base64}`;
  }

  /** A style sheet with the fonts that it names. @param {string} name */
  style(name) {
    return this.#text(name).replace(/url\("([^":]+)"\)/g, (_, file) => `url("${this.data(file)}")`);
  }

  /**
   * The address of a script.
   * @param {string} name
   * @returns {string}
   */
  script(name) {
    const at = this.#scripts.get(name);
    if (at) return at;
    // Those that would ask a server ask this page instead.
    const source = document.querySelector(`[data-instead-of="${name}"]`)?.textContent ?? this.#text(name);
    const linked = source.replace(/from "\.\/([\w-]+\.js)"/g, (_, other) => `from "${this.script(other)}"`);
    const address = URL.createObjectURL(new Blob([linked], { type: "text/javascript" }));
    this.#scripts.set(name, address);
    return address;
  }
}
