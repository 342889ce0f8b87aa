"""What is wrong is an exception with its place and the way out."""

import os
import tempfile
import unittest

import momentous

CARTS = """id: my/wagons
title: Two wagons couple
level: intro
scene:
  axes: { x: to the right }
  bodies:
    A: { name: wagon A }
    B: { name: wagon B }
  stages:
    - impact: { between: [A, B], plastic: true, becomes: C }
given:
  m_A: { min: 10, max: 30, step: 1, unit: t }
  m_B: { min: 10, max: 30, step: 1, unit: t }
  v_A1: { min: 1, max: 3, step: 0.5, unit: m/s }
  v_B1: 0 m/s
text: >
  Wagon A ({{ m_A }}) rolls {{ v_A1 | motion }} into wagon B ({{ m_B }}), which {{ v_B1 | motion }}; they couple.
ask:
  - { find: v_C2, unit: m/s }
"""


class Errors(unittest.TestCase):
    def fault(self, call):
        with self.assertRaises(momentous.Error) as raised:
            call()
        return raised.exception

    def test_a_fault_of_a_file_has_its_place(self):
        error = self.fault(lambda: momentous.Problem(CARTS.replace("find: v_C2", "find: v_C22"), name="wagons.yaml"))
        self.assertEqual((error.place, error.advice), ("wagons.yaml:19:13", "did you mean `v_C2`?"))
        self.assertIn("19 |", str(error))
        self.assertEqual(len(error.faults), 1)

    def test_names_that_are_not_known_are_told_with_the_nearest(self):
        variant = momentous.Bank.built_in()["impact/two-carts"].variant(7)
        for call, advice in [
            (lambda: momentous.Bank.built_in()["impact/two-cart"], "did you mean `impact/two-carts`?"),
            (lambda: momentous.Bank.built_in()["impact/two-carts"].variant(7, form="forwards"), "did you mean `forward`?"),
            (lambda: variant.mark({"v_A": "1"}), "did you mean `v_A2`?"),
            (lambda: variant.mark({}, decimal="dot"), "choose one of point, comma"),
        ]:
            self.assertEqual(self.fault(call).advice, advice)
        self.assertIn("markdown", str(self.fault(lambda: variant.sheet("word"))))
        self.assertIn("whole number", str(self.fault(lambda: momentous.mark("impact/two-carts", "x", {}))))

    def test_a_folder_is_a_bank(self):
        with tempfile.TemporaryDirectory() as folder:
            with open(os.path.join(folder, "wagons.yaml"), "w", encoding="utf-8") as file:
                file.write(CARTS)
            bank = momentous.Bank(folder)
            self.assertEqual(bank.ids(), ["my/wagons"])
            self.assertTrue("my/wagons" in bank and bank.topics() == ["my"])
        self.assertIn("no-such-folder", str(self.fault(lambda: momentous.Bank("no-such-folder"))))

    def test_a_secret_changes_the_numbers_and_is_asked_for(self):
        problem = momentous.Bank.built_in().problem("impact/two-carts", secret=b"course 2026\n")
        self.assertNotEqual(problem.variant(7).sheet(), momentous.Bank.built_in()["impact/two-carts"].variant(7).sheet())
        mark = problem.variant(7).record()["secret"]
        answers = problem.variant(7).answers()
        self.assertTrue(momentous.mark("impact/two-carts", f"7-{mark}", answers, secret=b"course 2026").is_right)
        error = self.fault(lambda: momentous.mark("impact/two-carts", 7, answers, secret=b"course 2026"))
        self.assertIn(f"7-{mark}", error.advice + str(error))
        self.assertIn("empty", str(self.fault(lambda: momentous.Problem(CARTS, secret=b" \n"))))
