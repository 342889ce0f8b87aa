// @ts-check
// Where answers come from: the engine of the page in whose frame this script runs.

/**
 * A call was refused: the message is for the reader.
 */
export class Refused extends Error {
  /**
   * @param {{ kind: string, message: string, help?: string }} said
   */
  constructor(said) {
    super(said.message);
    this.kind = said.kind;
    this.help = said.help;
  }
}

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
