// @ts-check
// An author's preview: the page is loaded again when a watched file was saved.

const base = document.body.dataset.base ?? "";
const shown = document.body.dataset.watch;

async function look() {
  try {
    const response = await fetch(`${base}/watch`);
    if (response.ok && (await response.text()) !== shown) location.reload();
  } catch {
    // The server is being started anew.
  }
}

setInterval(look, 1000);
