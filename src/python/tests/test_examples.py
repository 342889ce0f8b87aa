"""Every example of the package and of its page in the docs runs."""

import doctest
import importlib
import os
import pathlib
import re
import unittest

MODULES = ["momentous", "momentous.batch", "momentous.notebooks", "momentous.prairielearn"]
PAGE = pathlib.Path(os.environ["DOCS"]) / "python.md"


class Examples(unittest.TestCase):
    def test_those_of_the_package_run(self):
        for name in MODULES:
            result = doctest.testmod(importlib.import_module(name), optionflags=doctest.ELLIPSIS)
            self.assertGreater(result.attempted, 2, name)
            self.assertEqual(result.failed, 0, name)

    def test_those_of_the_page_run(self):
        result = doctest.testfile(str(PAGE), module_relative=False, optionflags=doctest.ELLIPSIS, encoding="utf-8")
        self.assertGreater(result.attempted, 10)
        self.assertEqual(result.failed, 0)

    def test_the_server_of_the_page_marks(self):
        server = {}
        exec(re.search(r"```python\n(.*?)```", PAGE.read_text(encoding="utf-8"), re.DOTALL).group(1), server)
        data = {"variant_seed": 42, "params": {}, "correct_answers": {}, "partial_scores": {}, "feedback": {}, "score": 0}
        server["generate"](data)
        self.assertIn("srcdoc", data["params"]["sheet"])
        data["submitted_answers"] = data["correct_answers"]
        server["grade"](data)
        self.assertEqual(data["score"], 1)
        data["submitted_answers"] = {name: "" for name in data["correct_answers"]}
        server["grade"](data)
        self.assertEqual((data["score"], {part["score"] for part in data["partial_scores"].values()}), (0, {0}))
