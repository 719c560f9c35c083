"""Random views: the sums of everything that a drawing contains are those of the C++ library, and lines are those of the command.

views_test.py VIEW_SUMS COMMAND
"""
import json
import os
import subprocess
import sys
import tempfile
import unittest
import zlib

import numpy as np
import sightline

VIEWS = 10000


class Numbers:
    """The generator that view_sums.cpp specifies."""

    def __init__(self, seed):
        self.state = seed

    def below(self, n):
        self.state = (self.state * 1664525 + 1013904223) % 2**32
        return (self.state >> 8) % n


def boxes(numbers, count):
    corners = np.array([(i & 1, i >> 1 & 1, i >> 2) for i in range(8)])
    ring = np.array([[int(c) for c in face] for face in "0264 1573 0451 2376 0132 4675".split()])
    vertices, faces = [], []
    for b in range(count):
        low = [numbers.below(1000) for _ in range(3)]
        size = [1 + numbers.below(300) for _ in range(3)]
        vertices.append(low + corners * size)
        faces.append(8 * b + ring)
    return np.concatenate(vertices), np.concatenate(faces)


def direction(numbers):
    d = [numbers.below(1001) - 500 for _ in range(3)]
    if all(abs(c) < 300 for c in d):
        d[0] = 400
    return np.array(d)


def sum_of(d):
    u32 = np.uint32
    arrays = [
        d.lines,
        d.line_kinds,
        d.line_hidden,
        np.diff(d.line_edge_offsets).astype(u32),
        d.line_edges,
        d.part_edges,
        d.part_fractions,
        d.part_hidden,
        d.part_hidden_by,
        d.edge_kinds,
        d.edge_ends,
        d.edge_vertices,
        np.diff(d.edge_face_offsets).astype(u32),
        d.edge_bodies,
        d.edge_faces,
    ]
    total = 0
    for array in arrays:
        total = zlib.crc32(array, total)
    return f"{len(d.lines)} {total:08x}"


class Views(unittest.TestCase):
    def test_sums_are_those_of_the_cpp_library(self):
        seed, count = 20261128, 12
        expected = subprocess.run(
            [view_sums, str(seed), str(count), str(VIEWS)], check=True, capture_output=True, text=True
        ).stdout.splitlines()
        self.assertEqual(len(expected), VIEWS)
        self.assertGreater(len(set(expected)), VIEWS * 0.99)
        numbers = Numbers(seed)
        prepared = sightline.Scene(*boxes(numbers, count)).prepare(hidden=True)
        for view in range(VIEWS):
            d = direction(numbers)
            drawing = prepared.draw(direction=d) if view % 2 == 0 else prepared.draw(eye=500 - 5 * d)
            self.assertEqual(sum_of(drawing), expected[view], f"view {view}")

    def test_lines_are_those_of_the_command(self):
        numbers = Numbers(7)
        with tempfile.TemporaryDirectory() as folder:
            for mesh in range(10):
                vertices, faces = boxes(numbers, 6)
                path = os.path.join(folder, f"boxes{mesh}.off")
                with open(path, "w") as file:
                    file.write(f"OFF\n{len(vertices)} {len(faces)} 0\n")
                    file.writelines(" ".join(map(str, v)) + "\n" for v in vertices.tolist())
                    file.writelines("4 " + " ".join(map(str, f)) + "\n" for f in faces.tolist())
                scenes = [sightline.Scene(vertices, faces), sightline.Scene.load(path)]
                for _ in range(10):
                    d = direction(numbers)
                    # The command's paper is 200 x 200 mm with a margin of 10 mm.
                    self.check(path, scenes, d, os.path.join(folder, "drawing.svg"))

    def check(self, path, scenes, d, picture):
        output = subprocess.run(
            [command, "draw", "exact", path, "--orthographic", ",".join(map(str, d)), "--hidden", "--strokes", "-", "-o", picture],
            check=True,
            capture_output=True,
            text=True,
        ).stdout
        strokes = [json.loads(line) for line in output.splitlines()]
        for scene in scenes:
            drawing = scene.draw(direction=d, hidden=True, width=180, height=180)
            self.assertEqual(len(drawing.lines), len(strokes))
            np.testing.assert_allclose(drawing.lines + 10, [(s["from"], s["to"]) for s in strokes], rtol=0, atol=1e-6)
            self.assertEqual([sightline.Kind(kind).name.lower() for kind in drawing.line_kinds], [s["kind"] for s in strokes])
            self.assertEqual(drawing.line_hidden.tolist(), [s["hidden"] for s in strokes])
            for line, stroke in enumerate(strokes):
                edges = drawing.line_edges[drawing.line_edge_offsets[line] : drawing.line_edge_offsets[line + 1]]
                self.assertEqual(drawing.edge_ends[edges].tolist(), stroke["edges"])
                found = {
                    int(f)
                    for e in edges
                    for f in drawing.edge_faces[drawing.edge_face_offsets[e] : drawing.edge_face_offsets[e + 1]]
                }
                self.assertEqual(sorted(f + 1 for f in found), stroke["faces"])
            with open(picture, "rb") as file:
                self.assertEqual(drawing.file(title=path), file.read())


if __name__ == "__main__":
    view_sums, command = sys.argv[1:3]
    unittest.main(argv=sys.argv[:1])
