"""Every form of a mesh that is accepted, and every kind of wrong argument: the exception and its text."""
import os
import pickle
import tempfile
import unittest
from fractions import Fraction
from pathlib import Path

import numpy as np
import sightline
from shapes import CUBE, CUBE_FACES
from sightline import FileError, InputError, Scene, hidden_lines

SQUARE = [(0, 0, 0), (9, 0, 0), (9, 9, 0), (0, 9, 0)]
HOLE = [(3, 3, 0), (3, 6, 0), (6, 6, 0), (6, 3, 0)]


class Accepted(unittest.TestCase):
    def test_all_forms_of_a_mesh_give_the_same_drawing(self):
        expected = hidden_lines(CUBE, CUBE_FACES, "iso").file()
        for dtype in (np.int8, np.uint16, np.int64, np.uint64, np.float16, np.float32, np.float64, np.longdouble, ">f8"):
            self.assertEqual(hidden_lines(CUBE.astype(dtype), CUBE_FACES, "iso").file(), expected, dtype)
        for dtype in (np.int8, np.uint8, np.int32, np.uint64, ">i4"):
            self.assertEqual(hidden_lines(CUBE, CUBE_FACES.astype(dtype), "iso").file(), expected, dtype)
        ragged = np.empty(6, object)
        ragged[:] = [np.array(face) for face in CUBE_FACES]
        forms = {
            "lists": CUBE_FACES.tolist(),
            "tuples": tuple(map(tuple, CUBE_FACES.tolist())),
            "arrays": list(CUBE_FACES),
            "array of arrays": ragged,
            "column order": np.asfortranarray(CUBE_FACES),
            "view": np.repeat(CUBE_FACES, 2, axis=0)[::2],
            "pairs without holes": [(face, []) for face in CUBE_FACES.tolist()],
            "a generator": (face for face in CUBE_FACES.tolist()),
        }
        for name, faces in forms.items():
            self.assertEqual(hidden_lines(CUBE, faces, "iso").file(), expected, name)
        self.assertEqual(hidden_lines(np.asfortranarray(CUBE), CUBE_FACES, "iso").file(), expected)
        self.assertEqual(hidden_lines(CUBE.tolist(), CUBE_FACES, "iso").file(), expected)

    def test_rings_of_different_lengths(self):
        # A pyramid on a square: 8 edges.
        vertices = [(0, 0, 0), (4, 0, 0), (4, 0, 4), (0, 0, 4), (2, 3, 2)]
        faces = [(0, 1, 2, 3), (1, 0, 4), [2, 1, 4], np.array([3, 2, 4]), (0, 3, 4)]
        drawing = hidden_lines(vertices, faces, "iso", hidden=True)
        self.assertEqual(len(drawing.edge_kinds), 8)
        self.assertEqual(
            {tuple(sorted(pair)) for pair in drawing.edge_vertices.tolist()},
            {(0, 1), (1, 2), (2, 3), (0, 3), (0, 4), (1, 4), (2, 4), (3, 4)},
        )

    def test_a_hole_shows_what_is_behind_it(self):
        # A line from one side of the square to the other is hidden by the frame only.
        vertices = SQUARE + HOLE + [(0, 5, -3), (9, 5, -3)]
        drawing = hidden_lines(vertices, [((0, 1, 2, 3), [(4, 5, 6, 7)])], direction=(0, 0, -1), hidden=True, polylines=[(8, 9)])
        parts = drawing.edge_kinds[drawing.part_edges] == sightline.Kind.POLYLINE
        self.assertEqual(drawing.part_fractions[parts & ~drawing.part_hidden].tolist(), [[[1, 3], [2, 3]]])
        self.assertEqual(set(drawing.part_hidden_by[parts & drawing.part_hidden].tolist()), {0})
        for faces in ([([0, 1, 2, 3], [[4, 5, 6, 7]])], [(np.array([0, 1, 2, 3]), (np.array([4, 5, 6, 7]),))]):
            self.assertEqual(
                Scene(vertices, faces, polylines=np.array([[8, 9]])).draw(direction=(0, 0, -1), hidden=True).file(), drawing.file()
            )

    def test_bodies_are_counted(self):
        faces = [(0, 1, 2), (3, 4, 5)]
        vertices = [(0, 0, 0), (1, 0, 0), (0, 1, 0), (0, 0, 5), (1, 0, 5), (0, 1, 5)]
        drawing = hidden_lines(vertices, faces, "iso", bodies=[1, 0])
        for edge, body in enumerate(drawing.edge_bodies.tolist()):
            first = drawing.edge_face_offsets[edge]
            self.assertEqual(body, [1, 0][drawing.edge_faces[first]])

    def test_options_of_numpy_types(self):
        scene = Scene(CUBE, CUBE_FACES)
        expected = scene.draw(eye=(30, 40, 50), hidden=True, width=100, jobs=2).file()
        self.assertEqual(
            scene.draw(eye=np.array([30, 40, 50], np.int16), hidden=np.True_, width=np.float32(100), jobs=np.int64(2)).file(),
            expected,
        )
        self.assertEqual(scene.draw(eye=[30, 40, 50], hidden=True, width=Fraction(100), jobs=2).file(), expected)

    def test_a_path_may_be_an_object_and_need_not_be_utf_8(self):
        with tempfile.TemporaryDirectory() as folder:
            drawing = hidden_lines(CUBE, CUBE_FACES)
            for extension in ("svg", "pdf", "dxf", "plt", "hpgl", "png", "steps", "SVG"):
                drawing.save(Path(folder) / f"cube.{extension}")
                self.assertEqual((Path(folder) / f"cube.{extension}").read_bytes(), drawing.file(extension), extension)
            name = os.path.join(os.fsencode(folder), b"\xff.obj")
            with open(name, "w") as file:
                file.write("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n")
            self.assertEqual(Scene.load(name).face_count, 1)
            self.assertEqual(Scene.load(os.fsdecode(name)).face_count, 1)
            with open(name, "w") as file:
                file.write("v 0 0 0\nf 1 2 9\n")
            with self.assertRaisesRegex(InputError, "\udcff.obj"):
                Scene.load(name)


class Wrong(unittest.TestCase):
    def check(self, expected, call, error=InputError, kind="bad_input"):
        with self.assertRaises(error) as caught:
            call()
        self.assertIsInstance(caught.exception, sightline.Error)
        self.assertEqual(caught.exception.kind, kind)
        text = str(caught.exception)
        self.assertEqual(text if not expected.endswith("...") else text[: len(expected) - 3] + "...", expected)

    def check_scene(self, expected, *arguments, **options):
        self.check(expected, lambda: Scene(*arguments, **options))

    def test_vertices(self):
        self.check_scene("vertices: found an array of shape (8, 2), expected (n, 3)", CUBE[:, :2], CUBE_FACES)
        self.check_scene("vertices: found an array of shape (24,), expected (n, 3)", CUBE.reshape(-1), CUBE_FACES)
        self.check_scene("vertices: found an array of shape (), expected (n, 3)", None, CUBE_FACES)
        self.check_scene("vertices: found an array of shape (0,), expected (n, 3)", [], CUBE_FACES)
        self.check_scene(
            "vertices: found rows of different lengths, expected an array of shape (n, 3)", [(0, 0, 0), (1, 2)], CUBE_FACES
        )
        for dtype, name in ((complex, "complex128"), (bool, "bool"), (str, "<U21"), (object, "object")):
            self.check_scene(f"vertices: found elements of type {name}, expected real numbers", CUBE.astype(dtype), CUBE_FACES)
        for value, name in ((np.nan, "nan"), (np.inf, "inf"), (-np.inf, "-inf")):
            damaged = CUBE.astype(float)
            damaged[2, 1] = value
            self.check_scene(f"vertices[2][1]: found {name}, expected a finite number", damaged, CUBE_FACES)

    def test_faces(self):
        for value, noun in ((8, 8), (-1, -1), (2**31, 2**31), (2**40, 2**40), (-(2**62), -(2**62))):
            damaged = CUBE_FACES.astype(np.int64)
            damaged[5, 2] = value
            text = f"faces[5][2]: found vertex {noun}, expected a number from 0 to 7"
            self.check_scene(text, CUBE, damaged)
            self.check_scene(text, CUBE, damaged.tolist())
            self.check_scene(text, CUBE, [*damaged.tolist()[:5], (damaged[5], [])][:5] + [damaged[5]])
        self.check_scene(
            "faces[1][0][3]: found vertex 9, expected a number from 0 to 7",
            SQUARE + HOLE,
            [(0, 1, 2), ((0, 1, 2, 9), [(4, 5, 6, 7)])],
        )
        self.check_scene(
            "faces[1][1][1][2]: found vertex 9, expected a number from 0 to 7",
            SQUARE + HOLE,
            [(0, 1, 2), ((0, 1, 2, 3), [(4, 5, 6), (4, 6, 9)]), (1, 2, 3)],
        )
        self.check_scene("faces[0][1][0]: found 2 vertex numbers, expected at least 3", SQUARE + HOLE, [((0, 1, 2, 3), [(4, 5)])])
        self.check_scene(
            "faces[0][1]: found 7, expected a list of holes, each a sequence of vertex numbers", SQUARE, [((0, 1, 2, 3), 7)]
        )
        self.check_scene(
            "faces[0][1][0]: found 4, expected a sequence of vertex numbers", SQUARE + HOLE, [((0, 1, 2, 3), [4, 5, 6, 7])]
        )
        self.check_scene("faces[1]: found 2 vertex numbers, expected at least 3", CUBE, [(0, 1, 2), (0, 1)])
        self.check_scene("faces[0]: found 0 vertex numbers, expected at least 3", CUBE, [()])
        self.check_scene("faces: found an array of shape (24,), expected (m, k) with k at least 3", CUBE, CUBE_FACES.reshape(-1))
        self.check_scene("faces: found an array of shape (6, 2), expected (m, k) with k at least 3", CUBE, CUBE_FACES[:, :2])
        self.check_scene(
            "faces: found an array of shape (3, 2, 4), expected (m, k) with k at least 3", CUBE, CUBE_FACES.reshape(3, 2, 4)
        )
        for dtype in (float, complex, bool):
            text = f"faces: found elements of type {np.dtype(dtype)}, expected whole numbers"
            self.check_scene(text, CUBE, CUBE_FACES.astype(dtype))
            self.check_scene(text, CUBE, CUBE_FACES.astype(dtype).tolist())
        self.check_scene("faces: found elements of type <U1, expected whole numbers", CUBE, ["abc"])
        self.check_scene("faces: found elements of type object, expected whole numbers", CUBE, [(0, 1, 2**70)])
        self.check_scene("faces: found elements of type object, expected whole numbers", CUBE, [(0, 1, None)])
        self.check_scene("faces: found 5, expected a sequence of vertex numbers for each", CUBE, 5)
        self.check_scene("faces: found 0 as element 0, expected a sequence of vertex numbers for each", CUBE, [0, 1, 2])
        self.check_scene(
            "faces: found sequences within the sequences, expected a sequence of vertex numbers for each",
            CUBE,
            CUBE_FACES.reshape(2, 3, 4).tolist(),
        )
        self.check_scene("faces[0][0]: found vertex 0, expected none, as there are no vertices", np.empty((0, 3)), [(0, 1, 2)])

    def test_polylines_and_bodies(self):
        self.check_scene("polylines[0][1]: found vertex 8, expected a number from 0 to 7", CUBE, polylines=[(0, 8)])
        self.check_scene("polylines[1]: found 1 vertex numbers, expected at least 2", CUBE, polylines=[(0, 1), (1,)])
        self.check_scene(
            "polylines: found an array of shape (8, 1), expected (m, k) with k at least 2", CUBE, polylines=np.arange(8)[:, None]
        )
        self.check_scene(
            "bodies: found an array of shape (5,), expected (6,), a number for each face", CUBE, CUBE_FACES, bodies=[0] * 5
        )
        self.check_scene(
            "bodies: found rows of different lengths, expected (6,), a number for each face", CUBE, CUBE_FACES, bodies=[0, [1, 2]]
        )
        self.check_scene("bodies[1]: found body -1, expected a number from 0 to 5", CUBE, CUBE_FACES, bodies=[0, -1, 0, 0, 0, 0])
        self.check_scene(
            "bodies[5]: found body 4294967295, expected a number from 0 to 5", CUBE, CUBE_FACES, bodies=[0, 0, 0, 0, 0, 2**32 - 1]
        )
        self.check_scene("bodies: found elements of type float64, expected whole numbers", CUBE, CUBE_FACES, bodies=np.zeros(6))

    def test_empty_meshes(self):
        for faces in (None, [], (), np.empty((0, 3)), np.empty((0, 4), int)):
            self.check_scene("mesh: found no faces, expected a mesh; points alone make no drawing", CUBE, faces)
            self.check_scene("mesh: found no faces, expected a mesh; points alone make no drawing", np.empty((0, 3)), faces)
        # One triangle without area.
        self.check_scene("mesh: no face...", [(0, 0, 0), (1, 1, 1), (2, 2, 2)], [(0, 1, 2)])

    def test_options_of_the_scene(self):
        def check(expected, kind="bad_input", **options):
            self.check(expected, lambda: Scene(CUBE, CUBE_FACES, **options), kind=kind)

        check("mend: found 1, expected True or False", mend=1)
        check("weld: found '1', expected a number", weld="1")
        check("weld: found -1, expected a finite number, at least 0", "usage", weld=-1)
        check("weld: found nan, expected a finite number, at least 0", "usage", weld=float("nan"))
        check("weld: found an integer that is too large, expected a number up to 1e308", weld=10**400)
        check("planar_tolerance: found inf, expected a finite number, at least 0", "usage", planar_tolerance=float("inf"))
        check("mend: found false with weld or planar_tolerance, expected true", "usage", mend=False, weld=1)
        check("eye: found (1, 2), expected three finite numbers", eye=(1, 2))
        check("progress: found 3, expected a function", progress=3)
        with self.assertRaises(TypeError):
            Scene(CUBE, CUBE_FACES, hidden=True)

    def test_cameras(self):
        scene = Scene(CUBE, CUBE_FACES)

        def check(expected, kind="bad_input", **options):
            self.check(expected, lambda: scene.draw(**options), kind=kind)
            self.check(expected, lambda: scene.prepare().draw(**options), kind=kind)
            if "eye" not in options:
                self.check(expected, lambda: hidden_lines(CUBE, CUBE_FACES, **options), kind=kind)

        check('view: found "side", expected front, ...', "usage", view="side")
        check("view: found 3, expected a string", view=3)
        check("eye: found besides view, expected one of them", "usage", view="iso", eye=(30, 30, 30))
        check("direction: found 0,0,0, expected a direction", "usage", direction=(0, 0, 0))
        for name in ("direction", "eye", "look_at", "up"):
            for value in (
                (1, 2),
                "abc",
                5,
                (1, 2, float("nan")),
                (1, float("inf"), 0),
                [[1, 2, 3]],
                (1, 2, [3]),
                (1j, 0, 0),
                ("1", "2", "3"),
            ):
                check(f"{name}: found {value!r}, expected three finite numbers", **{name: value})
        check('vertical: found "w", expected x, ...', "usage", vertical="w")
        check("perspective: found 'yes', expected True or False", perspective="yes")
        with self.assertRaisesRegex(InputError, "inside this solid"):
            scene.draw(eye=(5, 5, 5))

    def test_options_of_drawings(self):
        scene = Scene(CUBE, CUBE_FACES)

        def check(expected, kind="usage", **options):
            self.check(expected, lambda: scene.draw(**options), kind=kind)
            self.check(expected, lambda: hidden_lines(CUBE, CUBE_FACES, **options), kind=kind)

        def check_all(expected, kind="usage", **options):
            check(expected, kind, **options)
            self.check(expected, lambda: scene.prepare(**options), kind=kind)

        for name in ("width", "height", "scale"):
            for value in (0, -1, 2e9, float("nan")):
                check_all(f"{name}: found {value:.12g}, expected a number above 0, at most 1e9", **{name: value})
            check_all(f"{name}: found 'a', expected a number", "bad_input", **{name: "a"})
            check_all(f"{name}: found 1j, expected a number", "bad_input", **{name: 1j})
        check_all("field: found 171, expected degrees above 0, at most 170", field=171)
        check("field: found in parallel projection, expected perspective, or scale", view="iso", field=60)
        check("scale: found in perspective, expected parallel projection", eye=(30, 30, 30), scale=2)
        check_all("min_length: found -1, expected a finite number, at least 0", min_length=-1)
        check_all('edges: found "corners"...', edges="corners")
        check_all("edges: found ['crease'], expected a string", "bad_input", edges=["crease"])
        check_all("hidden: found 'no', expected True or False", "bad_input", hidden="no")
        check_all("certificate: found 1, expected True or False", "bad_input", certificate=1)
        for value in (0, -1, 1025, 2**40):
            check_all(f"jobs: found {value}, expected 1 to 1024", "bad_input", jobs=value)
        check_all("jobs: found 1.5, expected a whole number", "bad_input", jobs=1.5)
        check_all("progress: found 'f', expected a function", "bad_input", progress="f")
        with self.assertRaises(InputError):
            scene.draw(crease=float("nan"))
        with self.assertRaises(TypeError):
            scene.draw(hiden=True)

    def test_files(self):
        drawing = hidden_lines(CUBE, CUBE_FACES)
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "cube")
            self.check(
                'format: found "bmp", expected svg, pdf, dxf, hpgl, png or steps', lambda: drawing.save(path + ".bmp"), kind="usage"
            )
            self.check(f"path: found {path!r}, expected a name that ends in ...", lambda: drawing.save(path))
            self.check("path: found 5, expected the name of a file or of a generated scene", lambda: drawing.save(5))
            self.assertEqual(os.listdir(folder), [])
            with self.assertRaises(FileNotFoundError):
                drawing.save(os.path.join(folder, "none", "cube.svg"))
        self.check("format: found 3, expected a string", lambda: drawing.file(3))
        self.check("title: found b'x', expected a string", lambda: drawing.svg(title=b"x"))
        self.check("pen: found 0, expected a width above 0, at most 100", lambda: drawing.file(pen=0), kind="usage")
        self.check("margin: found -1, expected 0 to 1e6", lambda: drawing.file(margin=-1), kind="usage")
        self.check("dpi: found 0, expected 1 to 2400", lambda: drawing.file("png", dpi=0), kind="usage")
        self.check("missing.obj: no such file...", lambda: Scene.load("missing.obj"), FileError, "io")
        self.check("path: found None, expected the name of a file or of a generated scene", lambda: Scene.load(None))
        with self.assertRaises(InputError):
            Scene.load("boxes-1000000000000")


class Errors(unittest.TestCase):
    def test_classes_are_those_that_a_user_may_catch(self):
        self.assertTrue(issubclass(InputError, ValueError))
        self.assertTrue(issubclass(FileError, OSError))
        for error in (InputError("a", "usage"), FileError("b"), sightline.Cancelled()):
            self.assertIsInstance(error, sightline.Error)
            copy = pickle.loads(pickle.dumps(error))
            self.assertEqual((type(copy), str(copy), copy.kind), (type(error), str(error), error.kind))
        self.assertEqual(str(FileError("b")), "b")

    def test_an_error_changes_nothing(self):
        scene = Scene(CUBE, CUBE_FACES)
        before = scene.draw("iso").file()
        for options in ({"width": -1}, {"eye": (5, 5, 5)}, {"view": "side"}):
            with self.assertRaises(InputError):
                scene.draw(**options)
        self.assertEqual(scene.draw("iso").file(), before)


if __name__ == "__main__":
    unittest.main()
