"""What a drawing contains: shapes and types of all arrays, and what can be counted by hand.

That visibility is right is shown by the tests of the algorithm."""
import concurrent.futures
import unittest
import xml.etree.ElementTree
from fractions import Fraction

import numpy as np
import sightline
from shapes import CUBE, CUBE_FACES, many_boxes
from sightline import Kind, Scene

TYPES = {
    "lines": ("n 2 2", "float64"),
    "line_kinds": ("n", "uint8"),
    "line_hidden": ("n", "bool"),
    "line_edges": ("?", "int32"),
    "line_edge_offsets": ("n+1", "int64"),
    "part_edges": ("m", "int32"),
    "part_fractions": ("m 2 2", "int64"),
    "part_hidden": ("m", "bool"),
    "part_hidden_by": ("m", "int32"),
    "edge_kinds": ("k", "uint8"),
    "edge_ends": ("k 2 3", "float64"),
    "edge_vertices": ("k 2", "int32"),
    "edge_faces": ("?", "int32"),
    "edge_face_offsets": ("k+1", "int64"),
    "edge_bodies": ("k", "int32"),
    "eye": ("3", "float64"),
    "axes": ("3 3", "float64"),
    "low": ("2", "float64"),
}


class Members(unittest.TestCase):
    def check_types(self, drawing):
        sizes = {"n": len(drawing.lines), "m": len(drawing.part_edges), "k": len(drawing.edge_kinds)}
        sizes |= {f"{name}+1": size + 1 for name, size in sizes.items()}
        for name, (shape, dtype) in TYPES.items():
            array = getattr(drawing, name)
            self.assertEqual(array.dtype, np.dtype(dtype), name)
            expected = [
                array.shape[i] if word == "?" else sizes.get(word) or int(word if word.isdigit() else 0)
                for i, word in enumerate(shape.split())
            ]
            self.assertEqual(list(array.shape), expected, name)
            self.assertTrue(array.flags.c_contiguous and array.flags.writeable, name)
        self.assertEqual(
            set(TYPES) | {"perspective", "scale", "camera_error", "width", "height", "notes", "certificate"}, set(sightline.Drawing.__annotations__)
        )

    def test_every_array_has_its_shape_and_type(self):
        for side in (1, 6):
            for options in ({}, {"hidden": True}, {"eye": (40, 30, 45), "hidden": True}, {"edges": "all"}):
                self.check_types(Scene(*many_boxes(side)).draw(**options))
        # A drawing without lines.
        empty = Scene(CUBE, CUBE_FACES).draw("iso", edges="border")
        self.assertEqual(len(empty.lines), 0)
        self.check_types(empty)

    def test_arrays_outlive_their_drawing(self):
        lines = Scene(CUBE, CUBE_FACES).draw("iso").lines
        again = Scene(CUBE, CUBE_FACES).draw("iso").lines
        lines[0] = 7
        self.assertFalse((again == 7).any())

    def test_of_a_cube_nine_edges_are_visible_and_three_are_hidden(self):
        scene = Scene(CUBE, CUBE_FACES)
        self.assertEqual((scene.face_count, scene.vertex_count, scene.step, scene.bodies, scene.notes), (6, 8, 1, [""], []))
        self.assertEqual(scene.bounds.tolist(), [[0, 0, 0], [10, 10, 10]])
        drawing = scene.draw("iso", hidden=True)
        self.assertEqual(repr(drawing), "<sightline.Drawing: 12 lines, 3 of them hidden>")
        self.assertEqual(len(scene.draw("iso").lines), 9)
        self.assertEqual(drawing.part_fractions.tolist(), [[[0, 1], [1, 1]]] * 12)
        self.assertEqual(sorted(drawing.edge_kinds.tolist()), [Kind.SILHOUETTE] * 6 + [Kind.CREASE] * 6)
        self.assertEqual(np.diff(drawing.edge_face_offsets).tolist(), [2] * 12)
        for edge in range(12):
            faces = drawing.edge_faces[2 * edge : 2 * edge + 2]
            self.assertEqual(set(drawing.edge_vertices[edge]), set(CUBE_FACES[faces[0]]) & set(CUBE_FACES[faces[1]]))
            self.assertEqual(drawing.edge_ends[edge].tolist(), CUBE[drawing.edge_vertices[edge]].tolist())

    def test_edges_are_chosen_by_kind(self):
        scene = Scene([*CUBE, (20, 0, 0), (30, 5, 5)], CUBE_FACES, polylines=[(8, 9)])
        seen = set()
        for name in ("silhouette", "boundary", "crease", "border", "intersection", "wire"):
            kinds = set(scene.draw("iso", edges=name).edge_kinds.tolist())
            self.assertLessEqual(kinds, {Kind.POLYLINE if name == "wire" else Kind[name.upper()]})
            seen |= kinds
        self.assertEqual(seen, {Kind.SILHOUETTE, Kind.CREASE, Kind.POLYLINE})

    def test_axes_scale_and_low_tell_where_a_point_is_drawn(self):
        for camera in ({"view": "iso"}, {"eye": (30, 25, 40)}):
            drawing = Scene(CUBE, CUBE_FACES).draw(**camera, width=150, height=100)
            self.assertEqual(drawing.perspective, "eye" in camera)
            along = (drawing.edge_ends - drawing.eye) @ drawing.axes.T
            image = along[..., :2] / (along[..., 2:] if drawing.perspective else 1)
            drawn = drawing.scale * (image - drawing.low)
            self.assertEqual(np.diff(drawing.line_edge_offsets).tolist(), [1] * 9)
            for line, edge in zip(drawing.lines, drawing.line_edges):
                found = sorted(map(tuple, line.round(6).tolist()))
                np.testing.assert_allclose(found, sorted(map(tuple, drawn[edge].round(6).tolist())), atol=2e-6)
            self.assertTrue((drawing.lines >= -1e-9).all() and (drawing.lines <= [150 + 1e-9, 100 + 1e-9]).all())

    def test_parts_of_every_edge_are_its_whole_length(self):
        drawing = Scene(*many_boxes(6)).draw(eye=(40, 30, 45), hidden=True)
        lengths = [Fraction(0)] * len(drawing.edge_kinds)
        for edge, (low, high) in zip(drawing.part_edges, drawing.part_fractions.tolist()):
            lengths[edge] += Fraction(*high) - Fraction(*low)
        self.assertEqual(set(lengths), {1})
        self.assertTrue((drawing.part_hidden_by[~drawing.part_hidden] == -1).all())
        self.assertTrue((drawing.part_hidden_by < 6 * 36).all())
        self.assertEqual(set(drawing.line_edges.tolist()), set(range(len(drawing.edge_kinds))))


class Views(unittest.TestCase):
    def test_prepared_views_are_the_views_of_each(self):
        vertices, faces = many_boxes(4)
        scene = Scene(vertices, faces)
        prepared = scene.prepare(hidden=True)
        self.assertEqual(len(sightline.view_names()), 13)
        for view in sightline.view_names():
            expected = scene.draw(view, hidden=True).file()
            self.assertEqual(prepared.draw(view).file(), expected, view)
            self.assertEqual(scene.draw(view, hidden=True, jobs=3).file(), expected, view)
            self.assertEqual(sightline.hidden_lines(vertices, faces, view, True).file(), expected, view)

    def test_several_threads_may_use_one_scene(self):
        prepared = Scene(*many_boxes(5)).prepare()
        expected = prepared.draw("iso").file()
        with concurrent.futures.ThreadPoolExecutor(4) as pool:
            for file in pool.map(lambda _: prepared.draw("iso").file(), range(16)):
                self.assertEqual(file, expected)

    def test_hidden_lines_takes_the_options_of_both(self):
        vertices, faces = many_boxes(3)
        options = dict(
            eye=(40, 30, 45),
            look_at=(4, 0, 4),
            up=(1, 2, 0),
            vertical="z",
            edges="all",
            crease=10,
            hidden=True,
            width=90,
            height=80,
            field=20,
            min_length=1,
            jobs=2,
            certificate=True,
        )
        one = sightline.hidden_lines(
            vertices, faces, polylines=[(0, 20)], bodies=np.arange(54) // 6, mend=True, weld=0.001, planar_tolerance=0.01, **options
        )
        scene = Scene(
            vertices, faces, polylines=[(0, 20)], bodies=np.arange(54) // 6, weld=0.001, planar_tolerance=0.01, eye=(40, 30, 45), jobs=2
        )
        other = scene.draw(**options)
        for name in TYPES:
            self.assertEqual(getattr(one, name).tobytes(), getattr(other, name).tobytes(), name)
        self.assertEqual(one.certificate, other.certificate)
        self.assertNotEqual(one.certificate, "")
        flat = sightline.hidden_lines(vertices, faces, direction=(1, -1, 2), scale=3, perspective=False)
        self.assertEqual(flat.scale, 3)


class Files(unittest.TestCase):
    def test_svg_has_a_path_for_the_lines_and_the_size_of_the_paper(self):
        drawing = Scene(CUBE, CUBE_FACES).draw("iso", hidden=True, width=100, height=50)
        svg = xml.etree.ElementTree.fromstring(drawing.svg(title="A <cube>", margin=5))
        self.assertEqual((svg.get("width"), svg.get("height")), ("110.000mm", "60.000mm"))
        name = "{http://www.w3.org/2000/svg}"
        self.assertEqual(svg.find(f"{name}title").text, "A <cube>")
        self.assertGreater(len(svg.findall(f".//{name}path")), 0)
        self.assertEqual(drawing.svg().encode(), drawing.file())
        # What Jupyter calls to show a drawing.
        self.assertEqual(drawing._repr_svg_(), drawing.svg())

    def test_files_have_the_beginning_of_their_format(self):
        drawing = Scene(CUBE, CUBE_FACES).draw()
        for name, beginning in {
            "svg": b"<?xml",
            "pdf": b"%PDF-",
            "dxf": b"  0\nSECTION",
            "png": b"\x89PNG",
            "hpgl": b"IN;",
            "steps": b"",
        }.items():
            self.assertEqual(drawing.file(name)[: len(beginning)], beginning, name)


if __name__ == "__main__":
    unittest.main()
