// @ts-check
// Where answers come from: the engine of the page in whose frame this script runs.

import { Refused } from "./refused.js";

export { Refused };

/**
 * Asks the engine.
 * @param {string} name the call: "read", "mark", "simulate", ...
 * @param {object} request
 * @returns {Promise<any>}
 */
export async function call(name, request) {
  const { refused, value } = Reflect.get(window.parent, "momentous").call(name, request);
  if (refused) throw new Refused(refused);
  return value;
}
