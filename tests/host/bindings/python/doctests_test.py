"""Runs the examples of the docstrings and of the README, and compares signatures with docstrings and annotations.

doctests_test.py README
"""
import doctest
import inspect
import os
import sys
import tempfile
import unittest

import sightline


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
        with open(readme) as file:
            test = doctest.DocTestParser().get_doctest(file.read(), {}, "README.md", readme, 0)
        with tempfile.TemporaryDirectory() as folder:
            before = os.getcwd()
            os.chdir(folder)
            try:
                self.assertGreater(self.run_examples(test), 10)
            finally:
                os.chdir(before)

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
    (readme,) = sys.argv[1:2]
    unittest.main(argv=sys.argv[:1])
