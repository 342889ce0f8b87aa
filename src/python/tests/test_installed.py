"""What one install brings: the program and the module, without a compiler."""

import ast
import inspect
import pathlib
import shutil
import subprocess
import unittest

import momentous


def printed(*arguments):
    return subprocess.run(["momentous", *arguments], check=True, capture_output=True, text=True).stdout


class Installed(unittest.TestCase):
    def test_there_is_no_compiler(self):
        self.assertIsNone(shutil.which("cargo"))
        self.assertIsNone(shutil.which("rustc"))

    def test_program_and_module_are_of_one_version(self):
        self.assertEqual(printed("--version").split(), ["momentous", momentous.__version__])

    def test_program_and_module_have_one_bank(self):
        listed = printed("list", "--format", "json").splitlines()
        self.assertEqual(len(listed), len(momentous.Bank()))
        self.assertGreater(len(listed), 100)

    def test_program_and_module_print_one_sheet(self):
        variant = momentous.Bank()["impact/two-carts"].variant(7)
        asked = ["impact/two-carts", "--seed", "7"]
        for format in ["markdown", "latex", "html", "typst"]:
            self.assertEqual(printed("generate", *asked, "--format", format), variant.sheet(format), format)

    def test_a_notebook_shows_the_sheet_with_its_figure(self):
        variant = momentous.Bank.built_in()["impact/two-carts"].variant(7)
        shown = variant._repr_html_()
        self.assertIn("&lt;svg", shown)
        self.assertNotIn("<svg", shown)
        self.assertIn("<svg", variant.figure())

    def test_the_stub_names_what_is_there(self):
        package = pathlib.Path(momentous.__file__).parent
        self.assertTrue((package / "py.typed").is_file())
        stub = ast.parse((package / "_engine.pyi").read_text(encoding="utf-8"))
        for declared in (node for node in stub.body if isinstance(node, ast.ClassDef)):
            stated = {node.name for node in declared.body if isinstance(node, ast.FunctionDef)}
            real = getattr(momentous, declared.name)
            public = {name for name in vars(real) if not name.startswith("_")}
            self.assertEqual({name for name in stated if not name.startswith("_")}, public, declared.name)
            for name in stated - {"__init__"}:
                self.assertTrue(callable(getattr(real, name)) or inspect.isdatadescriptor(getattr(real, name)), name)
