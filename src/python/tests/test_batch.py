"""Marks of a table are those of single calls, whatever the columns look like."""

import json
import pathlib
import tempfile
import unittest

import pyarrow

import momentous
from momentous.batch import mark_batch, packed
from test_marks import typings

#: One problem of so many is asked.
EVERY = 7


def submissions():
    """Rows with the reports that single calls give."""
    rows, expected = [], []
    bank = momentous.Bank.built_in()
    for name in bank.ids()[::EVERY]:
        problem = bank[name]
        form = problem.forms[-1] if problem.forms else None
        for seed in (3, 1_000_003):
            variant = problem.variant(seed, form=form)
            for answers in typings(variant.answers()):
                rows.append({"student": f"s{len(rows)}", "problem": name, "form": form, "seed": seed, "answers": answers})
                expected.append(variant.mark(answers).record())
    return rows, expected


class Batches(unittest.TestCase):
    def test_a_table_is_marked_as_its_rows_are(self):
        rows, expected = submissions()
        self.assertGreater(len(rows), 200)
        kind = pyarrow.map_(pyarrow.string(), pyarrow.string())
        columns = {name: [row[name] for row in rows] for name in ("student", "problem", "form", "seed")}
        answers = [row["answers"] for row in rows]
        for given in (
            pyarrow.array([list(row.items()) for row in answers], kind),
            [json.dumps(row) for row in answers],
            answers,
        ):
            marked = mark_batch({**columns, "answers": given})
            self.assertEqual(marked["student"].to_pylist(), columns["student"])
            self.assertEqual(marked["fault"].null_count, len(rows))
            self.assertEqual([json.loads(report) for report in marked["report"].to_pylist()], expected)
            points = [report["total"] for report in expected]
            self.assertTrue(all(abs(a - b) < 1e-9 for a, b in zip(marked["points"].to_pylist(), points)), points[:3])

    def test_one_problem_has_a_struct_of_answers(self):
        answers = pyarrow.array([{"v_A2": "1 m/s", "v_B2": None}, {"v_A2": None, "v_B2": "2 m/s"}])
        table = pyarrow.table({"problem": ["impact/two-carts"] * 2, "seed": pyarrow.array([7.0, 8.0]), "answers": answers})
        verdicts = [[part["verdict"] for part in json.loads(report)["parts"]] for report in mark_batch(table)["report"].to_pylist()]
        self.assertEqual([sheet.count("unanswered") for sheet in verdicts], [2, 2])

    def test_a_row_that_cannot_be_marked_says_why(self):
        good = ("impact/two-carts", 7, None, "{}")
        rows = [
            (good, None),
            (("impact/two-cart", 7, None, "{}"), "did you mean `impact/two-carts`?"),
            (("../secret.yaml", 7, None, "{}"), "there is no problem"),
            (("impact/two-carts", -7, None, "{}"), "a seed is a whole number"),
            (("impact/two-carts", None, None, "{}"), "a seed is a whole number"),
            (("impact/two-carts", 7, "backward", "{}"), "backward"),
            (("impact/two-carts", 7, None, '{"v_C": "1"}'), "`v_C` is not a part"),
            (("impact/two-carts", 7, None, "1 m/s"), "no object of JSON"),
            (("impact/two-carts", 7, None, "[1]"), "no object of JSON"),
        ]
        columns = zip(*(row for row, _ in rows))
        table = {name: list(values) for name, values in zip(("problem", "seed", "form", "answers"), columns)}
        marked = mark_batch(table)
        for fault, points, (row, said) in zip(marked["fault"].to_pylist(), marked["points"].to_pylist(), rows):
            if said is None:
                self.assertEqual((fault, points), (None, 0), row)
            else:
                self.assertIn(said, fault or "nothing", row)
                self.assertIsNone(points)
        with self.assertRaisesRegex(ValueError, "no column `seed`"):
            mark_batch({"problem": ["impact/two-carts"], "answers": ["{}"]})
        with self.assertRaisesRegex(momentous.Error, "decimal mark"):
            mark_batch(table, decimal="dot")
        self.assertEqual(mark_batch({name: [] for name in table}).num_rows, 0)

    def test_a_bank_goes_along_as_bytes(self):
        with tempfile.TemporaryDirectory() as folder:
            home = pathlib.Path(folder) / "problem_bank"
            (home / "own").mkdir(parents=True)
            text = "id: own/push\ntitle: Push\nlevel: intro\nscene:\n  axes: { x: to the right }\n"
            text += "  bodies: { A: { name: trolley A }, B: { name: trolley B } }\n"
            text += "  stages: [{ impact: { between: [A, B], restitution: 0 } }]\n"
            text += "given: { m_A: 4 kg, m_B: 2 kg, v_A1: 3 m/s, v_B1: 0 m/s }\n"
            text += "text: Trolley A ({{ m_A }}) moves {{ v_A1 | motion }}; trolley B ({{ m_B }}) {{ v_B1 | motion }}. They couple.\n"
            text += "ask: [{ find: v_A2, unit: m/s }]\n"
            (home / "own" / "push.yaml").write_text(text)
            (home / "course.yaml").write_text("symbols: { kinetic_energy: K }\n")
            bank = packed(home)
            there = momentous.Bank(home)
            expected = there["own/push"].variant(1).mark({"v_A2": "2 m/s"}).record()
        rows = {"problem": ["own/push"], "seed": [1], "answers": [{"v_A2": "2 m/s"}]}
        marked = [mark_batch(rows, bank=problems) for problems in (bank, bank)]
        self.assertEqual([json.loads(table["report"][0].as_py()) for table in marked], [expected] * 2)
        self.assertIn("there is no problem", mark_batch(rows)["fault"][0].as_py())
