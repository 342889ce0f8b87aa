"""Marks of the module are those of `momentous grade`, over forms, seeds and typed answers."""

import json
import subprocess
import unittest
from concurrent.futures import ThreadPoolExecutor

import momentous

#: One problem of so many is asked, in every form.
EVERY = 9
SEEDS = [1, 77]


def typings(answers):
    """Sets of answers as students type them."""
    yield answers
    yield {name: text.split(" ")[0] for name, text in answers.items()}
    yield {name: text.replace("1", "7").replace("2", "3") for name, text in answers.items()}
    yield {name: "-" + text for name, text in answers.items()}
    first = next(iter(answers))
    yield {**answers, first: "3 apples?"}
    yield {first: answers[first].replace(".", ",")}


def by_program(problem, seed, form, answers):
    command = ["momentous", "grade", "--problem", problem, "--seed", str(seed), "--format", "json"]
    command += ["--form", form] if form else []
    command += [f"--answer={name}={text}" for name, text in answers.items()]
    done = subprocess.run(command, capture_output=True, text=True)
    return json.loads(done.stdout) if done.stdout else done.stderr


class Marks(unittest.TestCase):
    def test_the_module_marks_as_the_program(self):
        bank = momentous.Bank.built_in()
        asked = []
        for name in bank.ids()[::EVERY]:
            problem = bank[name]
            for form in problem.forms or [None]:
                for seed in SEEDS:
                    variant = problem.variant(seed, form=form)
                    for answers in typings(variant.answers()):
                        asked.append((variant, answers))
        self.assertGreater(len(asked), 200)
        with ThreadPoolExecutor() as pool:
            program = lambda question: by_program(question[0].problem, question[0].seed, question[0].form, question[1])
            theirs = list(pool.map(program, asked))
            ours = list(pool.map(lambda question: question[0].mark(question[1]).record(), asked))
        for (variant, answers), marked, expected in zip(asked, ours, theirs):
            self.assertEqual(marked, expected, f"{variant!r} {answers}")
        self.assertGreater(len({part["verdict"] for report in ours for part in report["parts"]}), 4)

    def test_a_comma_is_read_where_it_is_said(self):
        answers = {"v_A2": "-0,400 m/s", "v_B2": "3,10 m/s"}
        report = momentous.mark("impact/two-carts", 7, answers, decimal="comma")
        command = ["momentous", "grade", "--problem", "impact/two-carts", "--seed", "7", "--decimal", "comma"]
        command += [f"--answer={name}={text}" for name, text in answers.items()] + ["--format", "json"]
        self.assertEqual(report.record(), json.loads(subprocess.run(command, capture_output=True).stdout))

    def test_points_add_up(self):
        variant = momentous.Bank.built_in()["impact/two-carts"].variant(7)
        report = variant.mark({**variant.answers(), "v_A2": "99 m/s"})
        self.assertEqual(report.points, sum(part.points for part in report.parts))
        self.assertEqual(report.out_of, sum(part.out_of for part in report.parts))
        self.assertFalse(report.is_right)
        self.assertEqual(report.score, report.points / report.out_of)
