// A course with something on each of its pages, made without a browser: an assignment that is open, answers, points set by hand, more
// time for somebody, and a problem that was corrected.

import { RULES, Visitor, coupled, plain } from "./classroom.js";
import { start_clocked } from "./server.js";

/** When the server's clock stands: the assignment is open. */
const NOW = "2026-10-06T15:00:00+02:00";

/** The problems of the assignment; the last has an answer to be chosen. */
export const PROBLEMS = /** @type {const} */ (["class/trolleys", "impact/two-carts", "concepts/kinds-of-impact"]);

/** Two trolleys that couple, and in the first version do not. @param {number} restitution */
const file = (restitution) => `
id: class/trolleys
title: Two trolleys
level: intro
scene:
  axes: { x: to the right }
  bodies: { A: { name: trolley A, mass: m_A }, B: { name: trolley B, mass: m_B } }
  stages: [{ impact: { between: [A, B], restitution: ${restitution} } }]
given:
  m_A: { min: 4, max: 8, step: 1, unit: kg }
  m_B: { min: 1, max: 3, step: 1, unit: kg }
  v_A1: { min: 4, max: 8, step: 1, unit: m/s }
  v_B1: { min: 1, max: 2, step: 1, unit: m/s }
text: Trolley A ({{ m_A }}) moves {{ v_A1 | motion }}; trolley B ({{ m_B }}) {{ v_B1 | motion }}. They couple.
ask: [{ find: v_A2, unit: m/s, points: 2 }]
`;

/** The value of a hidden field. @param {string} page @param {string} name */
const hidden = (page, name) => page.match(new RegExp(`name="${name}" value="([^"]*)"`))?.[1] ?? "";

/**
 * Starts a server with the course.
 * @param {string[]} [students] those who have handed in, and one more, `ada`, who has not
 * @param {Record<string, string>} [rules] further fields of the assignment
 */
export async function small_course(students = ["bob", "cleo"], rules = {}) {
  const server = await start_clocked("2026-10-05T09:00:00+02:00");
  const operator = await Visitor.by(server.link);
  const made = { title: "Mechanics", zone: "Europe/Berlin", decimal: "either", retention: "", login: "operator", name: "" };
  const course = await operator.post("/courses/new", made);
  const table = ["id,name,section", ...["ada", ...students].map((id) => `${id},${id} Example-Long-Family-Name,A`), ""].join("\n");
  const shown = hidden(await operator.send(`${course}/roster/preview`, { table }), "shown");
  await operator.post(`${course}/roster/apply`, { table, shown });
  const problem = await operator.post(`${course}/problems/new`, { text: file(1) });
  await operator.post(`${problem}/publish`, {});
  const fields = {
    do: "save",
    ...RULES,
    ...rules,
    hint_penalty: "10 %",
    ...Object.fromEntries(PROBLEMS.flatMap((id, place) => [[`item.${place}.problem`, id], [`item.${place}.points`, "5"]])),
  };
  const assignment = (await operator.post(`${course}/assignments/new`, fields)).replace(/\/edit.*/, "");
  const links = new Map(
    [...(await operator.send(`${course}/roster/links`, {})).matchAll(/^(\w+),.*,(http\S+)$/gm)].map(([, id, link]) => [id, String(link)]),
  );
  await server.set(NOW);
  const items = [...(await operator.get(assignment)).matchAll(/href="([^"]*\/items\/[^"]+)"/g)].map(([, item]) => String(item));
  /** @type {Visitor[]} */
  const visitors = [];
  for (const id of students) {
    const visitor = await Visitor.by(links.get(id) ?? "");
    visitors.push(visitor);
    const [trolleys, carts] = [items[0] ?? "", items[1] ?? ""];
    const page = await visitor.get(trolleys);
    await visitor.post(trolleys, { request: hidden(page, "request"), "answer.v_A2": coupled(plain(page)) });
    const wrong = { "answer.v_A2": "99.0 m/s", "answer.v_B2": "3..2 m/s", "answer.T_lost": "" };
    await visitor.post(carts, { request: hidden(await visitor.get(carts), "request"), ...wrong });
  }
  // In the order of their names: the first has handed in nothing.
  const book = await operator.get(`${assignment}/gradebook`);
  const [member = "", ...members] = [...book.matchAll(/\/members\/([0-9a-f]{32})/g)].map(([, key]) => String(key));
  await operator.post(`${items[1]}/students/${member}/points`, { points: "3", reason: "showed it on the board" });
  const more = { member, due: "2026-10-19T18:00", closes: "2026-10-20T18:00", reason: "was ill" };
  await operator.post(`${assignment}/extensions`, more);
  const corrected = await operator.post(`${course}/problems/new`, { text: file(0) });
  await operator.post(`${corrected}/publish`, {});
  await operator.post(`${course}/roster/code`, { days: "60" });
  const code = (await operator.get(`${course}/roster`)).match(/<code class="link">(\w{4})-(\w{4})</);
  const join = `/join/${code?.[1]}${code?.[2]}`;
  const asks = { login: "dora", name: "Dora Example-Long-Family-Name", new: "a few short words", again: "a few short words" };
  await new Visitor(server.url).post(join, asks);
  return { server, operator, course, assignment, items, links, visitors, member, members, problem: corrected, join };
}
