// @ts-check
// The pages, one at a time, each in a frame of its own: what a page asks of a server, it asks of this script.

/** The fields of an address. @param {string} query @returns {[string, string][]} */
function fields_of(query) {
  return [...new URLSearchParams(query)];
}

/** The pages, one at a time, and what they ask. */
class Shell {
  #engine;
  #memory;
  #place;
  /** @type {Assets} */
  #assets;
  /** @type {(memory: Kept) => void} */
  #told;
  /** The fields of the page that is shown. @type {[string, string][]} */
  #fields = [];

  /**
   * @param {Engine} engine
   * @param {{ directory: string, files: Asset[] }} assets
   * @param {Memory} memory
   * @param {HTMLElement} place where pages are shown
   * @param {(memory: Kept) => void} told hears of what is kept
   */
  constructor(engine, assets, memory, place, told) {
    this.#engine = engine;
    this.#assets = new Assets(assets);
    this.#memory = memory;
    this.#place = place;
    this.#told = told;
    window.addEventListener("hashchange", () => this.go());
    // A frame is printed as long as what it holds.
    window.addEventListener("beforeprint", () => this.#stretch(true));
    window.addEventListener("afterprint", () => this.#stretch(false));
  }

  /** The address of now: a path with its fields, and a place in the page. */
  get #address() {
    const [address = "", anchor = ""] = location.hash.slice(1).split("#");
    return { address: address || document.body.dataset.start || "/", anchor };
  }

  /** Shows the page of the address. */
  go() {
    const { address, anchor } = this.#address;
    const [path = "", query = ""] = address.split("?");
    this.#show(path, this.#memory.kept.answers[address] ?? fields_of(query), anchor);
  }

  /**
   * A call of the engine.
   * @param {string} name
   * @param {object} request
   */
  call(name, request) {
    return this.#asked({ call: { name, request } });
  }

  /**
   * Writes the address of what is shown. A sheet that was answered under that address is shown with its answers.
   * @param {string} address
   */
  keep(address) {
    const [path] = this.#address.address.split("?");
    history.replaceState(history.state, "", address.startsWith("?") ? `#${path}${address}` : address);
    const answers = this.#memory.kept.answers[this.#address.address];
    if (answers && answers !== this.#fields) this.go();
  }

  /**
   * @param {object} request
   * @returns {Answer}
   */
  #asked(request) {
    try {
      return this.#engine.ask(request);
    } catch (error) {
      if (!(error instanceof WebAssembly.RuntimeError)) throw error;
      void this.#engine.start();
      return { refused: { kind: "fault", message: "the engine stopped and was started again", help: "try once more" } };
    }
  }

  /**
   * @param {string} path
   * @param {[string, string][]} fields
   * @param {string} anchor
   */
  #show(path, fields, anchor) {
    this.#fields = fields;
    const { text, refused } = this.#asked({ page: { path, fields } });
    const page = new DOMParser().parseFromString(text ?? "", "text/html");
    if (refused) page.body.textContent = `${refused.message}${refused.help ? `: ${refused.help}` : ""}.`;
    this.#rewrite(page);
    const frame = document.createElement("iframe");
    frame.title = page.title;
    document.title = page.title;
    frame.addEventListener("load", () => this.#listen(frame, anchor));
    frame.srcdoc = `<!DOCTYPE html>${page.documentElement.outerHTML}`;
    this.#place.replaceChildren(frame);
    this.#note(page, fields);
  }

  /** What the page names of a server, the page gets from here. @param {Document} page */
  #rewrite(page) {
    const base = page.createElement("base");
    base.target = "_parent";
    page.head.prepend(base);
    const { directory } = this.#assets;
    const name = (/** @type {string | null} */ address) => address?.slice(directory.length + 1) ?? "";
    for (const link of page.querySelectorAll(`link[href^="${directory}"]`)) {
      if (link.getAttribute("rel") === "stylesheet") {
        const style = page.createElement("style");
        style.textContent = this.#assets.style(name(link.getAttribute("href")));
        link.replaceWith(style);
      } else {
        link.remove();
      }
    }
    for (const script of page.querySelectorAll(`script[src^="${directory}"]`)) {
      script.setAttribute("src", this.#assets.script(name(script.getAttribute("src"))));
    }
    for (const image of page.querySelectorAll('img[src^="#/figure/"]')) {
      image.setAttribute("data-figure", image.getAttribute("src")?.slice("#/figure/".length) ?? "");
      image.removeAttribute("src");
    }
    for (const link of page.querySelectorAll('li > a[href^="#/practice/"]')) {
      const problem = link.getAttribute("href")?.replace(/^#\/practice\/|\?.*$/g, "") ?? "";
      if (this.#memory.kept.right.includes(problem)) link.append(" ✓", hidden(page, " all right"));
    }
  }

  /**
   * @param {HTMLIFrameElement} frame
   * @param {string} anchor
   */
  #listen(frame, anchor) {
    const page = frame.contentDocument;
    if (!page) return;
    page.addEventListener("submit", (event) => this.#submit(event));
    page.addEventListener("click", (event) => within(page, event));
    const seen = new IntersectionObserver((entries) => {
      for (const { isIntersecting, target } of entries) {
        if (!isIntersecting) continue;
        seen.unobserve(target);
        const { text } = this.#asked({ figure: { problem: target.getAttribute("data-figure") } });
        if (text) target.setAttribute("src", `data:image/svg+xml,${encodeURIComponent(text)}`);
      }
    }, { root: page });
    for (const image of page.querySelectorAll("img[data-figure]")) seen.observe(image);
    frame.contentWindow?.focus();
    if (anchor) reveal(page, anchor);
  }

  /**
   * A form, which a server would have been sent.
   * @param {SubmitEvent} event
   */
  #submit(event) {
    const form = /** @type {HTMLFormElement} */ (event.target);
    if (event.defaultPrevented) return;
    event.preventDefault();
    const [address = "", anchor = ""] = (form.getAttribute("action") ?? "").slice(1).split("#");
    /** @type {[string, string][]} */
    const fields = [...new FormData(form, event.submitter)].map(([name, value]) => [name, String(value)]);
    if (form.method !== "post") {
      location.hash = `${address}?${new URLSearchParams(fields)}`;
      return;
    }
    this.#memory.kept.answers[address] = fields;
    history.replaceState(history.state, "", `#${address}`);
    const [path = ""] = address.split("?");
    this.#show(path, fields, anchor);
  }

  /**
   * Keeps what was answered, and what was right.
   * @param {Document} page
   * @param {[string, string][]} fields
   */
  #note(page, fields) {
    const variant = page.querySelector("form.answers")?.getAttribute("data-variant");
    const is_right = page.querySelector(".outcome .total.right") !== null;
    if (variant && is_right && fields.length > 0) {
      const { problem } = JSON.parse(variant);
      if (!this.#memory.kept.right.includes(problem)) this.#memory.kept.right.push(problem);
    }
    this.#memory.save();
    this.#told(this.#memory.kept);
  }

  /** @param {boolean} is_printed */
  #stretch(is_printed) {
    const frame = this.#place.querySelector("iframe");
    const height = frame?.contentDocument?.documentElement.scrollHeight;
    if (frame) frame.style.height = is_printed && height ? `${height}px` : "";
  }
}

/**
 * Shows a place of a page, and goes on from there by keyboard.
 * @param {Document} page
 * @param {string} anchor
 */
function reveal(page, anchor) {
  const place = page.getElementById(anchor);
  place?.scrollIntoView();
  place?.focus();
}

/**
 * A link to a place of the same page: the address of a frame is not that of the page.
 * @param {Document} page
 * @param {MouseEvent} event
 */
function within(page, event) {
  const link = /** @type {Element} */ (event.target).closest('a[href^="#"]:not([href^="#/"])');
  if (!link) return;
  event.preventDefault();
  reveal(page, link.getAttribute("href")?.slice(1) ?? "");
}

/**
 * A text for those who listen.
 * @param {Document} page
 * @param {string} text
 */
function hidden(page, text) {
  const made = page.createElement("span");
  made.className = "hidden";
  made.textContent = text;
  return made;
}
