// @ts-check
// The address of what is shown, where the page stands in a frame.

/**
 * Writes an address, or new fields of the present one behind "?".
 * @param {string} address
 */
export function keep(address) {
  Reflect.get(window.parent, "momentous").keep(address);
}
