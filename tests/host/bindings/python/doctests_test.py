"""Runs the examples of the docstrings, of the README and of the notebook; compares signatures with docstrings and annotations.

doctests_test.py FOLDER        FOLDER: host/bindings/python
"""
import ast
import contextlib
import doctest
import inspect
import json
import os
import sys
import tempfile
import unittest

import sightline


@contextlib.contextmanager
def empty_folder():
    before = os.getcwd()
    with tempfile.TemporaryDirectory() as folder:
        os.chdir(folder)
        try:
            yield
        finally:
            os.chdir(before)


class Documentation(unittest.TestCase):
    def run_examples(self, test):
        runner = doctest.DocTestRunner()
        report = []
        runner.run(test, out=report.append)
        self.assertEqual(runner.failures, 0, "".join(report))
        return runner.tries

    def test_examples_of_docstrings(self):
        tests = doctest.DocTestFinder().find(sightline, extraglobs={"sightline": sightline})
        self.assertGreater(sum(self.run_examples(test) for test in tests), 20)

    def test_examples_of_the_readme(self):
        path = os.path.join(source, "README.md")
        with open(path) as file:
            test = doctest.DocTestParser().get_doctest(file.read(), {}, "README.md", path, 0)
        with empty_folder():
            self.assertGreater(self.run_examples(test), 10)

    def test_cells_of_the_notebook(self):
        with open(os.path.join(source, "hidden_lines.ipynb")) as file:
            cells = [cell for cell in json.load(file)["cells"] if cell["cell_type"] == "code"]
        names = {}
        shown = []
        with empty_folder():
            for cell in cells:
                self.assertEqual((cell["outputs"], cell["execution_count"]), ([], None), "outputs are left out of the repository")
                body = ast.parse("".join(cell["source"])).body
                # A notebook shows the value of an expression at the end of a cell.
                last = ast.Expression(body.pop().value) if isinstance(body[-1], ast.Expr) else None
                exec(compile(ast.Module(body, []), "cell", "exec"), names)
                shown.append(eval(compile(last, "cell", "eval"), names) if last else None)
            with open("stair.pdf", "rb") as file:
                self.assertEqual(file.read(5), b"%PDF-")
        self.assertEqual([getattr(value, "_repr_svg_", str)()[:5] for value in shown[:2]], ["<?xml"] * 2)
        self.assertRegex(shown[2], "^[1-9][0-9]%$")

    def test_everything_public_has_a_docstring_and_annotations(self):
        functions = [sightline.hidden_lines, sightline.view_names]
        for name in sightline.__all__:
            value = getattr(sightline, name)
            self.assertTrue(value.__doc__, name)
            if inspect.isclass(value) and not issubclass(value, (Exception, sightline.Kind)):
                for member, function in vars(value).items():
                    function = function.fget if isinstance(function, property) else getattr(function, "__func__", function)
                    if inspect.isfunction(function) and not member.startswith("_"):
                        self.assertTrue(function.__doc__, f"{name}.{member}")
                        functions.append(function)
        for function in functions:
            signature = inspect.signature(function)
            self.assertNotEqual(signature.return_annotation, signature.empty, function)
            for parameter in signature.parameters.values():
                if parameter.name not in ("self", "cls"):
                    self.assertNotEqual(parameter.annotation, parameter.empty, f"{function}: {parameter.name}")
        # Arguments of a scene and of a view are explained where they are first named.
        for function, text in (
            (sightline.Scene.__init__, sightline.Scene.__doc__),
            (sightline.Scene.draw, sightline.Scene.draw.__doc__),
            (sightline.Drawing.file, sightline.Drawing.file.__doc__),
        ):
            for name in inspect.signature(function).parameters:
                if name != "self":
                    self.assertRegex(text, rf"(?m)^ *(\w+, )?{name}\b", f"{function}: {name}")

    def test_hidden_lines_has_the_arguments_of_scene_and_draw_with_their_defaults(self):
        def defaults(function):
            return {p.name: p.default for p in inspect.signature(function).parameters.values() if p.name not in ("self", "cls")}

        self.assertEqual(defaults(sightline.hidden_lines), defaults(sightline.Scene.__init__) | defaults(sightline.Scene.draw))
        self.assertEqual(defaults(sightline.Scene.draw), defaults(sightline.Scene.prepare) | defaults(sightline.Prepared.draw))


if __name__ == "__main__":
    (source,) = sys.argv[1:2]
    unittest.main(argv=sys.argv[:1])
