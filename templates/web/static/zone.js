// @ts-check
// A new course has the time zone of the browser in which it is created, until another is typed.

const field = document.querySelector("input[name=zone]");
const { timeZone } = Intl.DateTimeFormat().resolvedOptions();
const zones = document.querySelectorAll("#zones option");
if (field instanceof HTMLInputElement && [...zones].some((zone) => zone instanceof HTMLOptionElement && zone.value === timeZone)) {
  field.value = timeZone;
}
