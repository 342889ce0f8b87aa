// Answers the requests of standard input, one a line, by the module that the argument names.
import { readFileSync } from "node:fs";
import { createInterface } from "node:readline";
import { gunzipSync } from "node:zlib";

const { instance } = await WebAssembly.instantiate(gunzipSync(readFileSync(process.argv[2])), {});
const { memory, reserve, answer, answered_at } = instance.exports;

for await (const line of createInterface({ input: process.stdin })) {
  const request = new TextEncoder().encode(line);
  // The memory may grow, and then its buffer is another.
  const place = reserve(request.length);
  new Uint8Array(memory.buffer, place, request.length).set(request);
  const length = answer();
  process.stdout.write(new TextDecoder().decode(new Uint8Array(memory.buffer, answered_at(), length)) + "\n");
}
