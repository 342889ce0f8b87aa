// @ts-check
// The address of what is shown.

/**
 * Writes an address, or new fields of the present one behind "?". The page stays.
 * @param {string} address
 */
export function keep(address) {
  history.replaceState(history.state, "", address + (address.startsWith("?") ? "" : location.hash));
}
