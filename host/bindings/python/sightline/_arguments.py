"""Checks of arguments: from what users pass to the arrays and options of the compiled module."""
import itertools
import numbers
import os

import numpy as np

from ._errors import InputError


def wrong(place, found, expected):
    return InputError(f"{place}: found {found}, expected {expected}")


# ------------------------------------------------------------------------------------------------------------- Options


def _flag(name, value):
    if not isinstance(value, (bool, np.bool_)):
        raise wrong(name, repr(value), "True or False")
    return bool(value)


def _number(name, value):
    if not isinstance(value, numbers.Real):
        raise wrong(name, repr(value), "a number")
    try:
        return float(value)
    except OverflowError:
        raise wrong(name, "an integer that is too large", "a number up to 1e308") from None


def _text(name, value):
    if not isinstance(value, str):
        raise wrong(name, repr(value), "a string")
    return value


def _point(name, value):
    expected = "three finite numbers"
    try:
        point = np.asarray(value)
    except ValueError:
        raise wrong(name, repr(value), expected) from None
    if point.shape != (3,) or point.dtype.kind not in "iuf" or not np.isfinite(point).all():
        raise wrong(name, repr(value), expected)
    return [float(c) for c in point]


def _jobs(name, value):
    if not isinstance(value, numbers.Integral):
        raise wrong(name, repr(value), "a whole number")
    if not 1 <= value <= 1024:
        raise wrong(name, value, "1 to 1024")
    return int(value)


_LOAD = {"mend": _flag, "weld": _number, "planar_tolerance": _number, "eye": _point, "jobs": _jobs}
_CAMERA = {
    "view": _text,
    "perspective": _flag,
    "direction": _point,
    "eye": _point,
    "look_at": _point,
    "up": _point,
    "vertical": _text,
}
_DRAW = {
    "edges": _text,
    "crease": _number,
    "hidden": _flag,
    "width": _number,
    "height": _number,
    "scale": _number,
    "field": _number,
    "min_length": _number,
    "jobs": _jobs,
    "certificate": _flag,
}
_FILE = {"format": _text, "title": _text, "margin": _number, "pen": _number, "dpi": _number, "as_found": _flag}
_CHECKS = {"LoadOptions": _LOAD, "Camera": _CAMERA, "DrawOptions": _DRAW, "FileOptions": _FILE}


def fill(options, arguments):
    """Sets the members of `options` to the arguments of these names; those that are None keep their default."""
    for name, check in _CHECKS[type(options).__name__].items():
        if arguments[name] is not None:
            setattr(options, name, check(name, arguments[name]))
    return options


def function(progress):
    if progress is not None and not callable(progress):
        raise wrong("progress", repr(progress), "a function")
    return progress


def file_name(path):
    try:
        return os.fsencode(path)
    except (TypeError, UnicodeEncodeError):
        raise wrong("path", repr(path), "the name of a file or of a generated scene") from None


# -------------------------------------------------------------------------------------------------------------- Meshes


def vertices_of(vertices):
    """An (n, 3) array of float64."""
    try:
        array = np.asarray(vertices)
    except ValueError:
        raise wrong("vertices", "rows of different lengths", "an array of shape (n, 3)") from None
    if array.ndim != 2 or array.shape[1] != 3:
        raise wrong("vertices", f"an array of shape {array.shape}", "(n, 3)")
    if array.dtype.kind not in "iuf":
        raise wrong("vertices", f"elements of type {array.dtype}", "real numbers")
    array = np.ascontiguousarray(array, np.float64)
    finite = np.isfinite(array)
    if not finite.all():
        v, c = np.argwhere(~finite)[0]
        raise wrong(f"vertices[{v}][{c}]", array[v, c], "a finite number")
    return array


def _numbers(values, place, below, noun):
    """A flat array of uint32 from one of whole numbers from 0. `place` names the element of a number."""
    if values.size == 0:
        return np.empty(0, np.uint32)
    if values.dtype.kind not in "iu":
        raise wrong(place(None), f"elements of type {values.dtype}", "whole numbers")
    bad = values >= below if values.dtype.kind == "u" else (values < 0) | (values >= below)
    if bad.any():
        i = int(np.argmax(bad))
        raise wrong(
            place(i), f"{noun} {values[i]}", f"a number from 0 to {below - 1}" if below > 0 else "none, as there are no vertices"
        )
    return values.astype(np.uint32)


class _Rings:
    """Rings of vertex numbers, one after the other: the corners of faces or the points of polylines."""

    def __init__(self, argument, rows, vertex_count, least, holes=False):
        self.face_rings = np.empty(0, np.uint32)
        if isinstance(rows, np.ndarray) and rows.dtype.kind != "O":
            self._from_table(argument, rows, vertex_count, least)
        else:
            self._from_rows(argument, rows, vertex_count, least, holes)

    def _from_table(self, argument, table, vertex_count, least):
        if table.size == 0:
            table = np.empty((0, least), np.uint32)
        if table.ndim != 2 or table.shape[1] < least:
            raise wrong(argument, f"an array of shape {table.shape}", f"(m, k) with k at least {least}")
        m, k = table.shape
        self.numbers = _numbers(
            table.reshape(-1), lambda i: argument if i is None else f"{argument}[{i // k}][{i % k}]", vertex_count, "vertex"
        )
        self.sizes = np.full(m, k, np.uint32)

    def _from_rows(self, argument, rows, vertex_count, least, holes):
        try:
            rings = list(rows)
            sizes = list(map(len, rings))
        except TypeError:
            raise wrong(argument, _first_without_length(rows), "a sequence of vertex numbers for each") from None
        names = None  # of the rings, if they are not those of `rows`
        if holes and 2 in sizes and any(len(row) == 2 and not isinstance(row[0], numbers.Integral) for row in rings):
            rings, names, self.face_rings = _with_holes(argument, rings)
            try:
                sizes = list(map(len, rings))
            except TypeError:
                bad = next(i for i, ring in enumerate(rings) if not hasattr(ring, "__len__"))
                raise wrong(names[bad], repr(rings[bad]), "a sequence of vertex numbers") from None

        def place(i):
            if i is None:
                return argument
            ring = int(np.searchsorted(ends, i, "right"))
            name = names[ring] if names else f"{argument}[{ring}]"
            return f"{name}[{i - int(ends[ring]) + sizes[ring]}]"

        ends = np.cumsum(sizes, dtype=np.int64)
        for ring in np.flatnonzero(np.asarray(sizes, np.int64) < least)[:1]:
            raise wrong(names[ring] if names else f"{argument}[{ring}]", f"{sizes[ring]} vertex numbers", f"at least {least}")
        try:
            flat = np.array(list(itertools.chain.from_iterable(rings)))
        except (TypeError, ValueError):
            flat = np.empty((0, 0))
        if flat.ndim != 1:
            raise wrong(argument, "sequences within the sequences", "a sequence of vertex numbers for each")
        self.numbers = _numbers(flat, place, vertex_count, "vertex")
        self.sizes = np.asarray(sizes, np.uint32)


def _first_without_length(rows):
    if not hasattr(rows, "__iter__"):
        return repr(rows)
    return next((f"{row!r} as element {i}" for i, row in enumerate(rows) if not hasattr(row, "__len__")), repr(rows))


def _with_holes(argument, faces):
    """The rings of faces, some of which are pairs of an outline and a list of holes; their names; how many each face has."""
    rings, names, counts = [], [], []
    for f, face in enumerate(faces):
        if len(face) == 2 and not isinstance(face[0], numbers.Integral):
            outline, holes = face
            if not isinstance(holes, (list, tuple)):
                raise wrong(f"{argument}[{f}][1]", repr(holes), "a list of holes, each a sequence of vertex numbers")
            rings += [outline, *holes]
            names += [f"{argument}[{f}][0]", *(f"{argument}[{f}][1][{h}]" for h in range(len(holes)))]
            counts.append(1 + len(holes))
        else:
            rings.append(face)
            names.append(f"{argument}[{f}]")
            counts.append(1)
    return rings, names, np.asarray(counts, np.uint32)


def mesh_of(vertices, faces, polylines, bodies):
    """The arrays from which the compiled module makes a scene, in its order."""
    array = vertices_of(vertices)
    count = len(array)
    rings = _Rings("faces", [] if faces is None else faces, count, 3, holes=True)
    lines = _Rings("polylines", [] if polylines is None else polylines, count, 2)
    owners = np.empty(0, np.uint32)
    if bodies is not None:
        face_count = len(rings.face_rings) or len(rings.sizes)
        try:
            owners = np.asarray(bodies)
        except ValueError:
            raise wrong("bodies", "rows of different lengths", f"({face_count},), a number for each face") from None
        if owners.shape != (face_count,):
            raise wrong("bodies", f"an array of shape {owners.shape}", f"({face_count},), a number for each face")
        owners = _numbers(owners, lambda i: "bodies" if i is None else f"bodies[{i}]", face_count, "body")
    return array, rings.numbers, rings.sizes, rings.face_rings, owners, lines.numbers, lines.sizes
