// @ts-check
// The page opens: the engine is unpacked, and the page of the address is shown.

/** The bar below: the answers as a table, and what is forgotten. @param {Memory} memory @param {() => void} again */
function bar(memory, again) {
  const student = document.getElementById("student");
  if (student instanceof HTMLInputElement) {
    student.value = memory.kept.student;
    student.addEventListener("input", () => {
      memory.kept.student = student.value;
      memory.save();
    });
  }
  document.getElementById("download")?.addEventListener("click", () => {
    const link = document.createElement("a");
    link.href = URL.createObjectURL(new Blob([submissions(memory.kept), "\r\n"], { type: "text/csv" }));
    link.download = "answers.csv";
    link.click();
  });
  document.getElementById("forget")?.addEventListener("click", () => {
    if (!confirm("Remove all answers of this page from this browser?")) return;
    memory.forget();
    again();
  });
}

async function start() {
  const place = /** @type {HTMLElement} */ (document.getElementById("page"));
  try {
    const engine = await Engine.unpacked();
    const { assets, refused } = await engine.start();
    if (!assets) throw new Error(refused?.message);
    const memory = new Memory(document.body.dataset.key ?? "momentous");
    const report = typeof platform_for === "function" ? platform_for(memory) : () => {};
    const shell = new Shell(engine, assets, memory, place, report);
    // Pages find it here.
    Reflect.set(window, "momentous", { call: shell.call.bind(shell), keep: shell.keep.bind(shell) });
    bar(memory, () => shell.go());
    shell.go();
    document.documentElement.dataset.state = "ready";
  } catch (error) {
    place.textContent = `This browser cannot run the page (${error instanceof Error ? error.message : error}). A current one can.`;
  }
}

void start();
