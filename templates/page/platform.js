// @ts-check
// What a learning platform is told, by SCORM 1.2: which problems were right, and that all were.

/** How many windows out the platform is looked for. */
const WINDOWS = 10;

/**
 * The platform's object, in a window around this one or in the one that opened it.
 * @param {Window | null} from
 */
function platform_of(from) {
  for (let count = 0, at = from; at && count < WINDOWS; count += 1, at = at.parent) {
    try {
      const api = Reflect.get(at, "API");
      if (api) return api;
    } catch {
      // A window of somebody else's.
    }
    if (at.parent === at) return undefined;
  }
  return undefined;
}

/**
 * Takes up what the platform kept, and gives what tells it of progress.
 * @param {Memory} memory
 * @returns {(kept: Kept) => void}
 */
function platform_for(memory) {
  const api = platform_of(window) ?? platform_of(window.opener);
  if (!api) return () => {};
  api.LMSInitialize("");
  /** @type {string[]} */
  const ids = JSON.parse(document.body.dataset.ids ?? "[]");
  // A letter for each problem: whatever their names, it stays within the 4096 letters that a platform keeps.
  const before = api.LMSGetValue("cmi.suspend_data");
  const right = ids.filter((id, place) => before[place] === "1" || memory.kept.right.includes(id));
  memory.kept.right = right;
  const place = api.LMSGetValue("cmi.core.lesson_location");
  if (place && !location.hash) history.replaceState(history.state, "", place);
  window.addEventListener("pagehide", () => api.LMSFinish(""));
  return (kept) => {
    const marks = ids.map((id) => (kept.right.includes(id) ? "1" : "0"));
    const count = marks.filter((mark) => mark === "1").length;
    api.LMSSetValue("cmi.suspend_data", marks.join(""));
    api.LMSSetValue("cmi.core.lesson_location", location.hash.slice(0, 255));
    api.LMSSetValue("cmi.core.lesson_status", count === ids.length ? "completed" : "incomplete");
    if (document.body.dataset.scored !== undefined) {
      api.LMSSetValue("cmi.core.score.min", "0");
      api.LMSSetValue("cmi.core.score.max", "100");
      api.LMSSetValue("cmi.core.score.raw", String(Math.round((100 * count) / ids.length)));
    }
    api.LMSCommit("");
  };
}
