// @ts-check
// Where answers come from. Pages ask the engine through this file alone: here by requests to the server.

import { Refused } from "./refused.js";

export { Refused };

const base = document.body.dataset.base ?? "";

/**
 * Asks the engine.
 * @param {string} name the call: "read", "mark", "simulate", ...
 * @param {object} request
 * @param {AbortSignal} [signal]
 * @returns {Promise<any>}
 */
export async function call(name, request, signal) {
  const response = await fetch(`${base}/api/${name}`, {
    method: "POST",
    headers: { "content-type": "application/json" },
    body: JSON.stringify(request),
    signal,
  });
  if (response.ok) return response.json();
  const is_json = response.headers.get("content-type")?.startsWith("application/json");
  throw new Refused(is_json ? await response.json() : { kind: "fault", message: await response.text() });
}
