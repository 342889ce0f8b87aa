// @ts-check
// A call of the engine that was refused.

/** What is said of it is for the reader. */
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
