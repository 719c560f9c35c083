"""Exact hidden-line drawings of meshes: NumPy arrays in, lines out.

>>> import sightline
>>> vertices = [(0, 0, 0), (1, 0, 0), (0, 1, 0), (0, 0, 1)]
>>> faces = [(0, 2, 1), (0, 1, 3), (1, 2, 3), (2, 0, 3)]
>>> drawing = sightline.hidden_lines(vertices, faces, "iso", hidden=True)
>>> drawing
<sightline.Drawing: 6 lines, 3 of them hidden>
>>> drawing.svg()[:5]
'<?xml'

Visibility is decided without tolerances. When a scene is made, its coordinates are rounded once to a grid (65,536 steps or more
across the scene; whole numbers up to 262,143 and short decimals are not changed), and damage of the mesh is repaired:
`Scene.notes` says what was done. After that everything is computed in integers and fractions; only positions on the drawing are
floating-point numbers. Equal input gives equal output.

Errors are exceptions of the class `Error`; their texts name the argument, what was found and what is expected. The interpreter's
lock is released during the work, and Ctrl-C ends it.
"""
from __future__ import annotations

import enum
import os

import numpy as np

from . import _arguments, _core
from ._errors import Cancelled, Error, FileError, InputError

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any, Callable, Optional, Sequence, Union

    from numpy.typing import ArrayLike, NDArray

    Ring = Union[Sequence[int], NDArray[Any]]
    Faces = Union[NDArray[Any], Sequence[Union[Ring, tuple[Ring, Sequence[Ring]]]]]
    Polylines = Union[NDArray[Any], Sequence[Ring]]
    Progress = Callable[[float], Optional[bool]]
    Path = Union[str, bytes, os.PathLike[Any]]

__all__ = ["Cancelled", "Drawing", "Error", "FileError", "InputError", "Kind", "Prepared", "Scene", "hidden_lines", "view_names"]
__version__ = _core.version()


class Kind(enum.IntEnum):
    """What an edge is. An edge of several kinds has the first of them."""

    SILHOUETTE = 0  #: between a face turned to the eye and one turned away
    JUNCTION = 1  #: of three or more faces; drawn with every choice of edges
    BOUNDARY = 2  #: of one face
    CREASE = 3  #: between two faces that bend by more than the angle `crease`
    BORDER = 4  #: between two materials of a file
    INTERSECTION = 5  #: where two faces pass through each other
    POLYLINE = 6  #: of a polyline
    FLAT = 7  #: all others


class Drawing:
    """What a camera sees of a scene: n lines, made of m parts of k edges.

    The lines are what is to be drawn. No two of them cover each other; edges that lie exactly behind one another share a line.

    lines              (n, 2, 2) float64  the ends of each line: [i, 0] is (x, y) of one, [i, 1] of the other, in the unit of
                                          `width` and `height`, from the bottom left corner
    line_kinds         (n,)      uint8    numbers of `Kind`
    line_hidden        (n,)      bool     the line is behind a face
    line_edges         (any,)    int32    numbers of the edges that lie in each line ...
    line_edge_offsets  (n + 1,)  int64    ... i: line_edges[line_edge_offsets[i]:line_edge_offsets[i + 1]], ascending

    The parts are the exact result. A part is a piece of an edge from P + low (Q - P) to P + high (Q - P), where P and Q are the
    edge's ends. Parts ascend by edge, then along it.

    part_edges         (m,)      int32    numbers of edges
    part_fractions     (m, 2, 2) int64    [i, 0] is low and [i, 1] is high, each a numerator and a positive denominator in lowest
                                          terms. Those of intersections are rounded to multiples of 2**-60; all others are exact
    part_hidden        (m,)      bool
    part_hidden_by     (m,)      int32    a face that hides the part. -1: it is visible or behind the eye, or its edge is one of a
                                          curved surface, which itself hides it

    The edges say where lines come from. Faces and vertices have the numbers of the mesh or file, from 0.

    edge_kinds         (k,)      uint8    numbers of `Kind`
    edge_ends          (k, 2, 3) float64  in the unit of the mesh, on the grid of the scene
    edge_vertices      (k, 2)    int32    -1: the end of an intersection, or a vertex that is not in an array of the input
    edge_faces         (any,)    int32    numbers of the faces at each edge (of an intersection: both faces) ...
    edge_face_offsets  (k + 1,)  int64    ... i: edge_faces[edge_face_offsets[i]:edge_face_offsets[i + 1]], ascending
    edge_bodies        (k,)      int32    numbers of `Scene.bodies`. -1: of a polyline

    The camera: a point p has the image x = axes[0] . (p - eye), y = axes[1] . (p - eye), both divided by axes[2] . (p - eye) in
    perspective, and is drawn at scale * (x - low[0], y - low[1]).

    perspective        bool
    eye                (3,)      float64  in the unit of the mesh
    axes               (3, 3)    float64  the directions to the right, upwards and forwards, of length 1
    scale              float
    low                (2,)      float64
    camera_error       float              degrees between the direction of view and the one that was asked for
    width, height      float              size of the drawing; larger than asked for if a scale needs it

    notes              list of str        sentences on what differs from what was asked for
    certificate        str                a proof of what is visible, which `sightline verify` checks; empty unless asked for

    >>> plate = [(-5, -5, 0), (5, -5, 0), (5, 5, 0), (-5, 5, 0)]
    >>> scene = sightline.Scene(plate + [(-10, 1, -4), (10, 1, -4)], [(0, 1, 2, 3)], polylines=[(4, 5)])
    >>> drawing = scene.draw("front", hidden=True)
    >>> parts = drawing.edge_kinds[drawing.part_edges] == sightline.Kind.POLYLINE
    >>> drawing.part_fractions[parts].tolist()
    [[[0, 1], [1, 4]], [[1, 4], [3, 4]], [[3, 4], [1, 1]]]
    >>> drawing.part_hidden_by[parts].tolist()
    [-1, 0, -1]
    """

    lines: NDArray[np.float64]
    line_kinds: NDArray[np.uint8]
    line_hidden: NDArray[np.bool_]
    line_edges: NDArray[np.int32]
    line_edge_offsets: NDArray[np.int64]
    part_edges: NDArray[np.int32]
    part_fractions: NDArray[np.int64]
    part_hidden: NDArray[np.bool_]
    part_hidden_by: NDArray[np.int32]
    edge_kinds: NDArray[np.uint8]
    edge_ends: NDArray[np.float64]
    edge_vertices: NDArray[np.int32]
    edge_faces: NDArray[np.int32]
    edge_face_offsets: NDArray[np.int64]
    edge_bodies: NDArray[np.int32]
    perspective: bool
    eye: NDArray[np.float64]
    axes: NDArray[np.float64]
    scale: float
    low: NDArray[np.float64]
    camera_error: float
    width: float
    height: float
    notes: list[str]
    certificate: str

    __slots__ = (*__annotations__, "_picture")

    def __init__(self, members: dict[str, Any], picture: Any) -> None:
        # Called by Scene.draw and Prepared.draw only.
        for name, value in members.items():
            setattr(self, name, value)
        self._picture = picture

    def __repr__(self) -> str:
        return f"<sightline.Drawing: {len(self.lines)} lines, {np.count_nonzero(self.line_hidden)} of them hidden>"

    def file(
        self,
        format: str = "svg",
        *,
        title: str = "",
        margin: float = 10,
        pen: float = 0.2,
        dpi: float = 150,
        as_found: bool = False,
    ) -> bytes:
        """The drawing as the bytes of a file, in which its unit is a millimetre.

        format    svg, pdf, dxf, hpgl, png or steps
        title     is written into SVG and PDF files
        margin    mm around the drawing, added to its width and height
        pen       mm: width of a line, in SVG, PDF and PNG
        dpi       pixels per inch, in PNG
        as_found  keep the order of the lines; otherwise the raised pen's way is made short

        Raises InputError (a wrong option) and FileError (a PNG of this size is impossible).

        >>> sightline.Scene.load("boxes-10").draw("top").file("pdf")[:5]
        b'%PDF-'
        """
        return self._picture.file(_arguments.fill(_core.FileOptions(), locals()))

    def svg(self, *, title: str = "", margin: float = 10, pen: float = 0.2, as_found: bool = False) -> str:
        """The drawing as the text of an SVG file: see `file`."""
        return self.file("svg", title=title, margin=margin, pen=pen, as_found=as_found).decode()

    def save(
        self, path: Path, *, title: str = "", margin: float = 10, pen: float = 0.2, dpi: float = 150, as_found: bool = False
    ) -> None:
        """Writes a file. Its extension selects the format: .svg, .pdf, .dxf, .plt, .hpgl, .png or .steps. Options: see `file`.

        Raises InputError (another extension, a wrong option) and OSError (the file cannot be written).
        """
        name = os.fsdecode(_arguments.file_name(path))
        extension = os.path.splitext(name)[1]
        if not extension:
            raise _arguments.wrong("path", repr(name), "a name that ends in .svg, .pdf, .dxf, .plt, .hpgl, .png or .steps")
        contents = self.file(extension[1:], title=title, margin=margin, pen=pen, dpi=dpi, as_found=as_found)
        with open(name, "wb") as file:
            file.write(contents)

    def _repr_svg_(self) -> str:
        # What Jupyter shows.
        return self.svg()


class Prepared:
    """A scene made ready for many views with the same options: `Scene.prepare` makes it. Several threads can use it at once.

    >>> prepared = sightline.Scene.load("boxes-10").prepare(hidden=True)
    >>> drawings = {view: prepared.draw(view) for view in sightline.view_names()}
    >>> drawings["front"].perspective
    False
    """

    __slots__ = ("_prepared",)

    def __init__(self, prepared: Any) -> None:
        # Called by Scene.prepare only.
        self._prepared = prepared

    def draw(
        self,
        view: Optional[str] = None,
        *,
        direction: Optional[ArrayLike] = None,
        eye: Optional[ArrayLike] = None,
        look_at: Optional[ArrayLike] = None,
        up: Optional[ArrayLike] = None,
        vertical: Optional[str] = None,
        perspective: bool = False,
        progress: Optional[Progress] = None,
    ) -> Drawing:
        """Draws one view. The arguments and errors are those of `Scene.draw`."""
        return Drawing(*self._prepared.draw(_arguments.fill(_core.Camera(), locals()), _arguments.function(progress)))


class Scene:
    """A mesh on its grid, repaired and checked. It does not change, and several threads can use it at once.

    vertices   (n, 3) array of any real type, in any unit
    faces      (m, k) integer array of vertex numbers from 0, k at least 3; or a sequence of faces, each a sequence of 3 or more
               numbers or a pair (outline, [hole, ...]) of such sequences. Outlines are counterclockwise as seen from outside,
               and a face with holes has at most 1,024 corners. Faces around a closed volume are a solid, whichever way they
               are turned; other faces are sheets, visible from both sides. Faces of four corners and more that are not planar
               become triangles
    polylines  (m, k) integer array, k at least 2, or a sequence of sequences: lines that hide nothing
    bodies     (number of faces,) integers from 0, less than the number of faces: the body of each face. Numbers without a face
               are left out of `Scene.bodies`. None: faces that an edge joins are one body
    mend       repair damage: join vertices at one place, turn faces, split faces that are not planar, leave out faces without
               area, close cracks that rounding makes. False: the first damage raises InputError
    weld       vertices at most this far apart become one, in the unit of the mesh
    planar_tolerance
               faces whose vertices are within this distance of the plane of a larger neighbour belong to one surface with it.
               None: as the precision of the numbers requires
    eye        an eye far outside the scene, or between the points of a grid of whole numbers, from which it will be drawn: it
               must be known when the scene is rounded
    jobs       threads; the scene is the same for any number
    progress   called now and then with the part that is done, from 0 to 1. If it returns False, the work ends with Cancelled; if
               it raises, the exception ends the work

    Raises InputError: an array of another shape or type, a coordinate that is not finite, the number of a vertex that does not
    exist, a mesh without faces and polylines.

    >>> square_with_hole = ([0, 1, 2, 3], [[4, 5, 6, 7]])
    >>> vertices = [(0, 0, 0), (9, 0, 0), (9, 9, 0), (0, 9, 0), (3, 3, 0), (3, 6, 0), (6, 6, 0), (6, 3, 0)]
    >>> sightline.Scene(vertices, [square_with_hole]).draw("front")
    <sightline.Drawing: 8 lines, 0 of them hidden>
    >>> sightline.Scene(vertices, [(0, 1, 2, 8)])
    Traceback (most recent call last):
    sightline.InputError: faces[0][3]: found vertex 8, expected a number from 0 to 7
    """

    __slots__ = ("_scene",)

    def __init__(
        self,
        vertices: ArrayLike,
        faces: Optional[Faces] = None,
        *,
        polylines: Optional[Polylines] = None,
        bodies: Optional[ArrayLike] = None,
        mend: bool = True,
        weld: float = 0,
        planar_tolerance: Optional[float] = None,
        eye: Optional[ArrayLike] = None,
        jobs: int = 1,
        progress: Optional[Progress] = None,
    ) -> None:
        options = _arguments.fill(_core.LoadOptions(), locals())
        self._scene = _core.Scene(*_arguments.mesh_of(vertices, faces, polylines, bodies), options, _arguments.function(progress))

    @classmethod
    def load(
        cls,
        path: Path,
        *,
        mend: bool = True,
        weld: float = 0,
        planar_tolerance: Optional[float] = None,
        eye: Optional[ArrayLike] = None,
        jobs: int = 1,
        progress: Optional[Progress] = None,
    ) -> Scene:
        """Reads a file (OBJ, OFF, STL, PLY, glTF, 3MF or JSON, recognized by its beginning), a built-in scene ("house") or a
        generated one ("boxes-100-7").

        The options are those of Scene.

        Raises FileError (the file cannot be read) and InputError (its first fault, with its place).

        >>> sightline.Scene.load("boxes-10").face_count
        60
        >>> sightline.Scene.load("missing.obj")  # doctest: +ELLIPSIS
        Traceback (most recent call last):
        sightline.FileError: missing.obj: no such file, ...
        """
        options = _arguments.fill(_core.LoadOptions(), locals())
        scene = cls.__new__(cls)
        scene._scene = _core.Scene.load(_arguments.file_name(path), options, _arguments.function(progress))
        return scene

    def draw(
        self,
        view: Optional[str] = None,
        *,
        direction: Optional[ArrayLike] = None,
        eye: Optional[ArrayLike] = None,
        look_at: Optional[ArrayLike] = None,
        up: Optional[ArrayLike] = None,
        vertical: Optional[str] = None,
        perspective: bool = False,
        edges: str = "feature",
        crease: float = 30,
        hidden: bool = False,
        width: float = 200,
        height: float = 200,
        scale: Optional[float] = None,
        field: Optional[float] = None,
        min_length: float = 0,
        jobs: int = 1,
        certificate: bool = False,
        progress: Optional[Progress] = None,
    ) -> Drawing:
        """Draws one view.

        The camera: one of `view`, `direction` and `eye`. Without any, it is that of the file, or from above, right and in front.

        view         a standard view in parallel projection: front, back, left, right, top, bottom, iso, dimetric, trimetric, NE,
                     NW, SE or SW
        perspective  show `view` in perspective
        direction    three numbers: parallel projection, looking in this direction
        eye          three numbers: perspective from this point, in the unit of the mesh
        look_at      three numbers: the point that the eye looks at. None: the middle of the scene; from within its bounds, the eye
                     looks in the direction of the scene's own camera
        up           three numbers: points up on the drawing, as nearly as possible. None: the vertical
        vertical     the axis of the scene that points up: x, y, z, -x, -y or -z. None: as the format of the file says, or y

        The drawing:

        edges        which edges are drawn: "feature" (all kinds but flat), "all", or some of silhouette, boundary, crease, border,
                     intersection and wire (polylines), separated by commas. Junctions are drawn with every choice
        crease       degrees: the least angle between the faces at a crease
        hidden       also the hidden parts
        width, height
                     the size of the drawing: millimetres, if it becomes a file. The picture is fitted to it, in its middle
        scale        units of the drawing per unit of the mesh, instead of fitting; only in parallel projection
        field        angle of the image across the shorter side, in degrees, instead of fitting; only in perspective
        min_length   shorter lines on the drawing that join no others are left out
        jobs         threads; the drawing is the same for any number
        certificate  fill in `Drawing.certificate`
        progress     as of Scene

        Raises InputError: an option is wrong, or the eye is inside a solid or on a face.

        >>> scene = sightline.Scene.load("boxes-10")
        >>> scene.draw(eye=(400, 300, 600)).perspective
        True
        >>> scene.draw("side")  # doctest: +ELLIPSIS
        Traceback (most recent call last):
        sightline.InputError: view: found "side", expected front, back, left, ...
        """
        arguments = locals()
        camera = _arguments.fill(_core.Camera(), arguments)
        options = _arguments.fill(_core.DrawOptions(), arguments)
        return Drawing(*self._scene.draw(camera, options, _arguments.function(progress)))

    def prepare(
        self,
        *,
        edges: str = "feature",
        crease: float = 30,
        hidden: bool = False,
        width: float = 200,
        height: float = 200,
        scale: Optional[float] = None,
        field: Optional[float] = None,
        min_length: float = 0,
        jobs: int = 1,
        certificate: bool = False,
        progress: Optional[Progress] = None,
    ) -> Prepared:
        """Computes what many views share. The arguments and errors are those of `draw`."""
        options = _arguments.fill(_core.DrawOptions(), locals())
        return Prepared(self._scene.prepare(options, _arguments.function(progress)))

    @property
    def face_count(self) -> int:
        """Faces after repairs."""
        return self._scene.face_count

    @property
    def vertex_count(self) -> int:
        """Vertices after repairs."""
        return self._scene.vertex_count

    @property
    def bounds(self) -> NDArray[np.float64]:
        """(2, 3) float64: the least and the greatest coordinates, in the unit of the mesh."""
        return self._scene.bounds

    @property
    def bodies(self) -> list[str]:
        """The names of the bodies, which may be empty."""
        return self._scene.bodies

    @property
    def step(self) -> float:
        """The step of the grid, in the unit of the mesh."""
        return self._scene.step

    @property
    def notes(self) -> list[str]:
        """Sentences on what rounding and repairs changed."""
        return self._scene.notes

    def __repr__(self) -> str:
        def count(number: int, one: str, many: str) -> str:
            return f"{number} {one if number == 1 else many}"

        return f"<sightline.Scene: {count(self.face_count, 'face', 'faces')}, {count(self.vertex_count, 'vertex', 'vertices')}>"


def hidden_lines(
    vertices: ArrayLike,
    faces: Optional[Faces] = None,
    view: Optional[str] = None,
    hidden: bool = False,
    *,
    polylines: Optional[Polylines] = None,
    bodies: Optional[ArrayLike] = None,
    mend: bool = True,
    weld: float = 0,
    planar_tolerance: Optional[float] = None,
    direction: Optional[ArrayLike] = None,
    eye: Optional[ArrayLike] = None,
    look_at: Optional[ArrayLike] = None,
    up: Optional[ArrayLike] = None,
    vertical: Optional[str] = None,
    perspective: bool = False,
    edges: str = "feature",
    crease: float = 30,
    width: float = 200,
    height: float = 200,
    scale: Optional[float] = None,
    field: Optional[float] = None,
    min_length: float = 0,
    jobs: int = 1,
    certificate: bool = False,
    progress: Optional[Progress] = None,
) -> Drawing:
    """Draws one view of a mesh: makes a `Scene` and calls its `draw`, whose arguments and errors these are.

    For several views of a mesh make the scene once; for many with the same options, use `Scene.prepare`.

    >>> sightline.hidden_lines([(0, 0, 0), (1, 0, 0), (0, 1, 0)], [(0, 1, 2)], "iso")
    <sightline.Drawing: 3 lines, 0 of them hidden>
    """

    def part(begin: float) -> Optional[Progress]:
        # The first half is the scene, the second one the drawing.
        return (lambda done: progress(begin + done / 2)) if progress is not None else None

    _arguments.function(progress)
    scene = Scene(
        vertices,
        faces,
        polylines=polylines,
        bodies=bodies,
        mend=mend,
        weld=weld,
        planar_tolerance=planar_tolerance,
        eye=eye,
        jobs=jobs,
        progress=part(0),
    )
    return scene.draw(
        view,
        direction=direction,
        eye=eye,
        look_at=look_at,
        up=up,
        vertical=vertical,
        perspective=perspective,
        edges=edges,
        crease=crease,
        hidden=hidden,
        width=width,
        height=height,
        scale=scale,
        field=field,
        min_length=min_length,
        jobs=jobs,
        certificate=certificate,
        progress=part(0.5),
    )


def view_names() -> list[str]:
    """The names of standard views, for the argument `view`."""
    return _core.view_names()
