# SPDX-License-Identifier: GPL-3.0-or-later
"""Functions of triangle meshes and smooth surfaces."""

from __future__ import annotations

import os
from typing import Any, Iterator, Mapping, Sequence

import numpy as np
from numpy.typing import ArrayLike

from . import _arrays as check
from ._crest import InputError
from ._fields import Mesh
from ._results import Geometry, Result
from ._run import Progress, run


def _picture(picture: Any, view: Any, up: Any) -> dict[str, Any]:
    if picture is None and (view is not None or up is not None):
        raise InputError("view: goes with picture, as up does")
    return {"picture": None if picture is None else os.fsdecode(picture),
            "view": None if view is None else check.numbers(view, "view", 3),
            "up": None if up is None else check.numbers(up, "up", 3)}


def _mesh(V: Any, F: Any) -> dict[str, Any]:
    return {"V": check.rows(V, "V", 3), "F": check.cells(F, "F", 3)}


class Umbilics:
    """The umbilics of a ridge graph.

    points: (U, 3) float64, units of the input.
    index: (U,) float64, +0.5 or -0.5 where it is generic.
    kind: (U,) int32: 1 1-ridge umbilic, 3 3-ridge umbilic, 0 degenerate.
    face: (U,) int64, the central face of each; of smooth surfaces None.
    level: (U,) int32: 0 doubtful, 1 significant, 2 salient; of smooth surfaces None.
    """

    def __init__(self, points: np.ndarray, index: np.ndarray, kind: np.ndarray,
                 face: np.ndarray | None, level: np.ndarray | None):
        self.points, self.index, self.kind = points, index, kind
        self.face, self.level = face, level

    def __len__(self) -> int:
        return len(self.points)

    def __repr__(self) -> str:
        return f"<Umbilics: {len(self)}>"


def _polylines(geometry: Geometry, wanted: np.ndarray) -> tuple[np.ndarray, list[np.ndarray]]:
    """Of the cells that are wanted, vertices or lines, in the order of their first points: their
    rows and their points."""
    found = []
    row = 0
    for cells in (geometry.vertices, geometry.lines):
        for ids in cells.lists():
            if wanted[row]:
                found.append((ids[0], row, ids))
            row += 1
    found.sort(key=lambda item: item[:2])
    return np.array([row for _, row, _ in found], dtype=np.int64), [ids for _, _, ids in found]


class RidgeGraph(Result):
    """Ridges and umbilics of a triangle mesh, R ridges of N points in all.

    points: (N, 3) float64, units of the input. offsets: (R + 1,) int64; ridge i has the points
    offsets[i] to offsets[i + 1]; of a loop the first is not repeated.
    colour: (R,) int32: 0 blue (the larger curvature), 1 red. loop: (R,) bool.
    length: (R,) float64, units of the input. strength, sharpness, weight: (R,) float64, no unit.
    type: (N,) int32, of the segment that starts at each point: 1 elliptic (a crest where the curvature
    is extremal in absolute value), 2 hyperbolic, 3 turning, 0 flat, -1 at leads into umbilics; by
    the rule of `order`.
    k1, k2: (N,) float64, curvatures, 1/length. significance, prominence: (N,) float64.
    level: (N,) int32: 0 doubtful, 1 significant, 2 salient.
    umbilics: Umbilics.
    index_sum: float, over all umbilics. euler_characteristic: int, equal to it on closed meshes.
    """

    def __init__(self, raw: dict[str, Any], order: int):
        super().__init__(raw)
        g = self.geometry
        number = g.cell_data.get("umbilic", np.zeros(0, dtype=np.int32))
        first = int((number >= 0).sum())
        rows, lines = _polylines(g, number < 0)
        self.loop: np.ndarray = g.cell_data["loop"][rows] == 1 if len(rows) else np.zeros(0, bool)
        sizes = [len(ids) - (1 if loop else 0) for ids, loop in zip(lines, self.loop)]
        self.offsets = np.concatenate([[0], np.cumsum(sizes)]).astype(np.int64)
        self.points = g.points[first:]
        for name in ("colour", "length", "strength", "sharpness", "weight"):
            setattr(self, name, g.cell_data.get(name, np.zeros(0))[rows])
        kind = "type" if order == 4 else "type_third_order"
        self.type: np.ndarray = g.point_data.get(kind, np.zeros(0))[first:]
        for name in ("k1", "k2", "significance", "prominence", "level"):
            setattr(self, name, g.point_data.get(name, np.zeros(0))[first:])
        point = {name: g.point_data.get(name, np.zeros(0))[:first]
                 for name in ("index", "kind", "level")}
        self.umbilics = Umbilics(g.points[:first], point["index"], point["kind"],
                                 raw["umbilic_face"], point["level"])
        self.index_sum: float = raw["twice_index_sum"] / 2
        self.euler_characteristic: int = raw["euler_characteristic"]

    def lines(self) -> Iterator[np.ndarray]:
        """Each ridge's points, (n, 3); a loop ends with the point it starts with."""
        for i, loop in enumerate(self.loop):
            line = self.points[self.offsets[i]:self.offsets[i + 1]]
            yield np.concatenate([line, line[:1]]) if loop else line


def ridges(V: ArrayLike, F: ArrayLike, *, rings: int | None = None,
           scale: float | str | None = None, smooth: int = 0, order: int = 4,
           umbilic_patch: float = 3.0, min_sharpness: float = 0.0, min_strength: float = 0.0,
           min_length: float = 0.0, crest_only: bool = False, significance: float = 4.0,
           min_weight: float = 1.5, salient: bool = False, significant: bool = False,
           picture: Any = None,
           view: Sequence[float] | None = None, up: Sequence[float] | None = None,
           threads: int = 0, progress: Progress = None) -> RidgeGraph:
    """Ridges and umbilics of a triangle mesh, certified (`crest ridges`).

    V: (n, 3) numbers. F: (m, 3) integers from 0. An oriented manifold, closed or not.
    rings, scale: the support of a fit, by rings of neighbours, a radius in units of the input, or
    "auto" (chosen by what is salient: the default with picture); else as many rings as hold 30
    points.
    smooth: smoothing steps of the extremalities. order: 3 or 4, the rule that types ridges.
    umbilic_patch: size of patches in one-rings. min_sharpness, min_strength, min_length: drop what is
    below (min_length in units of the input). crest_only: keep crest lines. significance: standard errors by which a ridge stands
    out (0: do not ask). min_weight: of salient ridges. salient, significant: keep these only. What is
    dropped is dropped from the arrays: the certificate speaks of the whole graph.
    picture: a .png or .svg to draw, as the command line does; view: 3 numbers, from the eye into the
    scene; up: 3 numbers, what points up.
    threads: 0 is all. progress: called with a line of text when a step begins.
    Raises InputError for bad input, KeyboardInterrupt on Ctrl-C, and what progress raises.

    >>> import crest
    >>> V, F = crest.read_mesh("ellipsoid.off")
    >>> graph = crest.ridges(V, F)
    >>> graph.index_sum, graph.euler_characteristic
    (2.0, 2)
    >>> bool(crest.verify(graph.certificate, mesh=(V, F)))
    True
    """
    marks = check.number(significance, "significance", 0) > 0
    if rings is not None and scale is not None:
        raise InputError("scale: give it or rings, not both")
    if salient and significant:
        raise InputError("salient: give it or significant, not both")
    if not marks and (salient or significant or scale == "auto"):
        raise InputError("significance: salient, significant and scale='auto' need it above 0")
    if isinstance(scale, str) and scale != "auto":
        raise InputError(f"scale: {scale!r} is neither 'auto' nor a positive number")
    radius = 0.0 if scale is None or scale == "auto" else check.number(scale, "scale")
    if scale is not None and scale != "auto" and radius <= 0:
        raise InputError(f"scale: {scale} is neither 'auto' nor a positive number")
    check.word(order, "order", (3, 4))
    chosen = marks and scale is None and rings is None and picture is not None
    arguments = _mesh(V, F) | {
        "rings": 0 if rings is None else check.whole(rings, "rings", 1, 100),
        "scale": radius, "auto_scale": scale == "auto" or chosen,
        "smooth": check.whole(smooth, "smooth", 0, 1000),
        "umbilic_patch": check.number(umbilic_patch, "umbilic_patch", 0, 1000),
        "min_sharpness": check.number(min_sharpness, "min_sharpness", 0),
        "min_strength": check.number(min_strength, "min_strength", 0),
        "min_length": check.number(min_length, "min_length", 0),
        "crest_only": bool(crest_only), "significance": float(significance),
        "min_weight": check.number(min_weight, "min_weight", 0), "salient": bool(salient),
        "significant": bool(significant)}
    arguments |= _picture(picture, view, up) | {"order": order}
    return RidgeGraph(run("ridges", arguments, threads, progress), order)


class SmoothRidgeGraph(Result):
    """Ridges and umbilics of a smooth surface, P pieces: a ridge is cut where its type changes.

    points: (N, 3) float64. offsets: (P + 1,) int64, into `pieces`. pieces: int64, points of each.
    ridge: (P,) int32, the ridge a piece is of. colour: (P,) int32: 0 blue, 1 red. type: (P,) int32: 0
    inside an umbilic's patch, 1 elliptic, 2 hyperbolic, 3 turning. length: (P,) float64.
    umbilics: Umbilics. turning_points, purple_points: (n, 3) float64.
    certified: bool; where not, obstacles: tuple of str, a line each, undecided: int, open cells.
    stopped: bool, by `seconds`. mesh: Geometry, the triangulation that proves it.
    euler_characteristic, components, boundary_loops: int, of the surface.
    """

    def __init__(self, raw: dict[str, Any]):
        super().__init__(raw)
        g = self.geometry
        self.mesh = Geometry(raw["mesh"])
        self.certified = raw["certified"]
        self.stopped: bool = raw["stopped"]
        self.obstacles: tuple[str, ...] = tuple(raw["obstacles"])
        self.undecided: int = raw["undecided"]
        self.euler_characteristic: int = raw["euler_characteristic"]
        self.components: int = raw["components"]
        self.boundary_loops: int = raw["boundary_loops"]
        kinds = g.cell_data.get("kind", np.zeros(0, dtype=np.int32))
        rows, lines = _polylines(g, kinds == -1)
        self.points = g.points
        self.offsets = np.concatenate([[0], np.cumsum([len(ids) for ids in lines])]).astype(np.int64)
        self.pieces = np.concatenate(lines) if lines else np.zeros(0, np.int64)
        for name in ("ridge", "colour", "type", "length"):
            setattr(self, name, g.cell_data.get(name, np.zeros(0))[rows])

        def at(*wanted: int) -> np.ndarray:
            ids = [cell[0] for cell, kind in zip(g.vertices.lists(), kinds) if kind in wanted]
            return np.array(ids, dtype=np.int64)

        umbilic = at(1, 3)
        point = {name: g.point_data.get(name, np.zeros(0))[umbilic] for name in ("index", "kind")}
        self.umbilics = Umbilics(g.points[umbilic], point["index"], point["kind"], None, None)
        self.turning_points = g.points[at(4)]
        self.purple_points = g.points[at(5)]

    def lines(self) -> Iterator[np.ndarray]:
        """Each piece's points, (n, 3)."""
        for first, last in zip(self.offsets[:-1], self.offsets[1:]):
            yield self.points[self.pieces[first:last]]


def smooth_ridges(*, surface: str | None = None, box: Sequence[float] | None = None,
                  param: Sequence[str] | None = None,
                  domain: Sequence[float | str] | None = None, periodic: str = "",
                  start_faces: int | None = None, max_depth: int = 60, budget: int = 2000000,
                  seconds: float | None = None, picture: Any = None,
                  view: Sequence[float] | None = None, up: Sequence[float] | None = None,
                  threads: int = 0, progress: Progress = None) -> SmoothRidgeGraph:
    """Ridges and umbilics of a smooth surface given by expressions, their topology certified
    (`crest ridges --surface`, `--param`).

    surface: F in x, y, z, of a closed surface F = 0 in the box: lower and upper bound of all axes or
    x0, x1, y0, y1, z0, z1. Or param: three expressions in u, v, over the domain u0, u1, v0, v1
    (numbers or constants like "2*pi"), periodic in "u", "v" or "uv".
    start_faces: of the first triangulation, about. max_depth: rounds of refinement at most. budget:
    faces at most. seconds: stop after so long. What could not be proven is in the result.
    picture, view, up, threads, progress, errors: as for ridges().

    >>> import crest
    >>> graph = crest.smooth_ridges(surface="x^2 + y^2/2.25 + z^2/4 - 1", box=(-3, 3))
    >>> graph.certified, len(graph.umbilics)
    (True, 4)
    """
    if (surface is None) == (param is None):
        raise InputError("surface: give it or param, and not both")
    arguments: dict[str, Any] = {
        "start_faces": None if start_faces is None else check.whole(start_faces, "start_faces", 8,
                                                                    10**7),
        "max_depth": check.whole(max_depth, "max_depth", 0, 1000),
        "budget": check.whole(budget, "budget", 8, 10**9),
        "seconds": check.maybe_number(seconds, "seconds", 0), "periodic": ""}
    if surface is not None:
        if box is None or domain is not None or periodic:
            raise InputError("surface: goes with box, without domain and periodic")
        given = np.ravel(np.asarray(box))
        bounds = check.numbers(np.tile(given, 3) if len(given) == 2 else given, "box", 6)
        arguments |= {"surface": str(surface), "box": bounds}
    else:
        if domain is None or box is not None:
            raise InputError("param: goes with domain, without box")
        if isinstance(param, str) or len(param) != 3:  # type: ignore[arg-type]
            raise InputError("param: give three expressions x, y, z in u, v")
        if isinstance(domain, str) or len(domain) != 4:
            raise InputError("domain: give u0, u1, v0, v1")
        texts = [x if isinstance(x, str) else repr(check.number(x, "domain")) for x in domain]
        arguments |= {"param": [str(x) for x in param], "domain": texts,  # type: ignore[union-attr]
                      "periodic": check.word(periodic, "periodic", ("", "u", "v", "uv"))}
    arguments |= _picture(picture, view, up)
    return SmoothRidgeGraph(run("smooth_ridges", arguments, threads, progress))


class Curvature(Result):
    """Curvature tensors at the vertices of a mesh. Estimates: there is no certificate.

    k1, k2: (n,) float64, principal curvatures, k1 >= k2, 1/length; convex points seen from outside
    have negative ones. K, H: (n,) float64, Gaussian and mean curvature. d1, d2: (n, 3) float64, their
    directions. normals: (n, 3) float64, used. asymmetry: (n,) float64, 1/length, of np and ne.
    lowered, complex, undetermined: int, vertices whose fit lacked rank, whose mean tensor has no
    real eigenvalues, without a finite estimate (all zero there).
    """

    def __init__(self, raw: dict[str, Any]):
        super().__init__(raw)
        for name in ("k1", "k2", "K", "H", "asymmetry", "d1", "d2"):
            setattr(self, name, self.geometry.point_data[name])
        self.normals: np.ndarray = self.geometry.point_data["Normals"]
        self.lowered: int = raw["lowered"]
        self.complex: int = raw["complex"]
        self.undetermined: int = raw["undetermined"]


METHODS = ("np", "ne", "cf", "qf", "qt", "jet", "normal-cycle")


def curvature(V: ArrayLike, F: ArrayLike, *, method: str = "ne", normals: ArrayLike | None = None,
              degree: int = 4, rings: int = 1, corners: bool = False, colour: str = "H",
              picture: Any = None,
              view: Sequence[float] | None = None, up: Sequence[float] | None = None,
              threads: int = 0, progress: Progress = None) -> Curvature:
    """Curvature tensors at the vertices of a mesh by one of seven methods (`crest curvature`).

    method: "np" (normal-based, with the normals given), "ne" (with estimated ones), "cf", "qf",
    "qt", "jet", "normal-cycle". normals: (n, 3) numbers of any length but 0. degree: of jet's
    polynomial, 2 to 6. rings: of normal-cycle's region, 0 to 20. corners: the tensors at the corners of
    each triangle, too (np, ne; in what save() writes). colour: what a picture shows, "K", "H", "k1" or
    "k2".
    V, F, picture, view, up, threads, progress, errors: as for ridges().

    >>> import crest
    >>> V, F = crest.read_mesh("ellipsoid.off")
    >>> c = crest.curvature(V, F, method="cf")
    >>> bool((c.k1 >= c.k2).all()), c.d1.shape == V.shape
    (True, True)
    """
    arguments = _mesh(V, F)
    check.word(method, "method", METHODS)
    if method == "np" and normals is None:
        raise InputError("normals: np needs them; take ne to have them estimated")
    if method == "ne" and normals is not None:
        raise InputError("normals: ne estimates them; take np")
    if corners and method not in ("np", "ne"):
        raise InputError("corners: only np and ne have them; leave corners out")
    arguments |= {
        "method": method, "degree": check.whole(degree, "degree", 2, 6),
        "rings": check.whole(rings, "rings", 0, 20), "corners": bool(corners),
        "normals": None if normals is None else check.same_rows(normals, "normals", 3,
                                                                len(arguments["V"]), "vertex")}
    arguments |= _picture(picture, view, up) | {
        "colour": check.word(colour, "colour", ("K", "H", "k1", "k2"))}
    return Curvature(run("curvature", arguments, threads, progress))


class FeatureGraph(Result):
    """Feature lines along the edges of a mesh, L lines.

    vertices: int64, vertices of all lines, one line after the other. offsets: (L + 1,) int64; of a
    loop the first vertex is repeated. kind: (L,) int32: 2 arc, 3 branch, 4 loop, 5 isolated line.
    length: (L,) float64, units of the input.
    label: (n,) int32, of each vertex of the mesh: 0 patch, 1 node, 2 arc, 3 branch, 4 loop,
    5 isolated. patch: (n,) int32, -1 on lines. face_patch: (m,) int32. field: (n,) float64, what was
    thresholded. value: float, the threshold.
    """

    def __init__(self, raw: dict[str, Any]):
        super().__init__(raw)
        g = self.geometry
        rows, lines = _polylines(g, g.cell_data["kind"] >= 2)
        self.vertices = np.concatenate(lines) if lines else np.zeros(0, np.int64)
        self.offsets = np.concatenate([[0], np.cumsum([len(ids) for ids in lines])]).astype(np.int64)
        self.kind: np.ndarray = g.cell_data["kind"][rows]
        self.length: np.ndarray = g.cell_data["length"][rows]
        self.label: np.ndarray = g.point_data["label"]
        self.patch: np.ndarray = g.point_data["patch"]
        self.field: np.ndarray = g.point_data["field"]
        self.face_patch: np.ndarray = g.cell_data["patch"][-len(g.polygons):]
        self.value: float = raw["value"]

    def lines(self) -> Iterator[np.ndarray]:
        """Each line's vertices."""
        for first, last in zip(self.offsets[:-1], self.offsets[1:]):
            yield self.vertices[first:last]


def feature_lines(V: ArrayLike, F: ArrayLike, field: ArrayLike | None = None, *,
                  angle: float | str | None = None, over: int = 0, threshold: float | None = None,
                  value: float | None = None, method: str = "fit", rings: int | None = None,
                  absolute: bool = False, dilate: float = 0, erode: float = 0, open: float = 0,
                  close: float = 0, neighbourhood: str = "ring", prune: int = 0, min_patch: int = 0,
                  close_branches: int = 0, picture: Any = None,
                  view: Sequence[float] | None = None, up: Sequence[float] | None = None,
                  threads: int = 0, progress: Progress = None) -> FeatureGraph:
    """Sharp edges above an angle, or lines thinned from a region, certified (`crest features`).

    angle: degrees; the edges whose faces' normals make a larger one, compared exactly with the
    decimal given ("0.1" is a tenth, 0.1 the same by its shortest decimal). With over (rings, for
    noise), and without an angle, lines are thinned from a region of vertices: where `field`, (n,)
    numbers, or else max(|k1|, |k2|) by `method` ("fit" or one of curvature()'s but np; rings: of fit
    and normal-cycle) is at least `value`, or among the share above the quantile `threshold` (0.85,
    or a gap near it). absolute: of field's absolute values.
    dilate, erode, open, close: clean the region, in rings or as lengths by `neighbourhood` ("ring",
    "euclidean", "path", "geodesic"). prune: drop branches of up to so many vertices. min_patch:
    fill smaller patches. close_branches: join open ends so many edges apart.
    V, F, picture, view, up, threads, progress, errors: as for ridges().

    >>> import crest
    >>> V, F = crest.read_mesh("cube.off")
    >>> edges = crest.feature_lines(V, F, angle=60)
    >>> len(edges.kind), int(edges.face_patch.max()) + 1
    (12, 6)
    """
    arguments = _mesh(V, F)
    n = len(arguments["V"])
    if field is not None and (method != "fit" or rings is not None):
        raise InputError("field: goes without method and rings")
    if absolute and field is None:
        raise InputError("absolute: goes with field")
    if over and angle is None:
        raise InputError("over: goes with angle")
    if threshold is not None and value is not None:
        raise InputError("threshold: give it or value, not both")
    if angle is not None:
        others = (threshold, value, rings, field)
        if any(x is not None for x in others) or method != "fit":
            raise InputError("angle: goes without threshold, value, method, rings and field")
        region = (dilate, erode, open, close, min_patch)
        if not over and (any(region) or neighbourhood != "ring"):
            raise InputError("angle: what belongs to regions of vertices needs over, too")
        angle = angle if isinstance(angle, str) else _decimal(check.number(angle, "angle"))
    check.word(method, "method", ("fit",) + METHODS[1:])
    if rings is not None and method not in ("fit", "normal-cycle"):
        raise InputError(f"rings: belongs to fit and normal-cycle; {method} has none")
    sizes = {name: check.number(size, name, 0) for name, size in
             (("dilate", dilate), ("erode", erode), ("open", open), ("close", close))}
    check.word(neighbourhood, "neighbourhood", ("ring", "euclidean", "path", "geodesic"))
    if neighbourhood == "ring":
        for name, size in sizes.items():
            if size != int(size):
                raise InputError(f"{name}: {size} rings are not a whole number")
    arguments |= sizes | {
        "angle": angle, "over": check.whole(over, "over", 0, 100),
        "threshold": check.maybe_number(threshold, "threshold", 0, 1),
        "value": check.maybe_number(value, "value"), "method": method,
        "rings": None if rings is None else check.whole(rings, "rings", method == "fit", 100),
        "field": None if field is None else check.values(field, "field", n, "vertex"),
        "absolute": bool(absolute), "neighbourhood": neighbourhood,
        "prune": check.whole(prune, "prune", 0, 10**9),
        "min_patch": check.whole(min_patch, "min_patch", 0, 10**9),
        "close_branches": check.whole(close_branches, "close_branches", 0, 10**9)}
    arguments |= _picture(picture, view, up)
    return FeatureGraph(run("features", arguments, threads, progress))


def _decimal(x: float) -> str:
    """Its shortest decimal, without an exponent."""
    return np.format_float_positional(x, trim="-")


class ReebGraph(Result):
    """The Reeb graph of a function on a surface, N nodes and A arcs.

    node_points: (N, 3) float64. node_values: (N,) float64, ascending. node_vertex: (N,) int32, its
    number in the tessellation: vertices of the mesh come first. node_type: (N,) int32: 0 minimum,
    1 saddle, 2 maximum. node_multiplicity, node_on_boundary: (N,) int32.
    arcs: (A, 2) int64, positions of the lower and the upper node. components, loops: int.
    join_tree, split_tree, contour_tree: (T, 2) int64, arcs between numbers as in node_vertex, lower
    first; None where not asked for.
    """

    def __init__(self, raw: dict[str, Any]):
        super().__init__(raw)
        g = self.geometry
        ids = g.vertices.connectivity
        self.node_points = g.points[ids]
        self.node_values: np.ndarray = g.point_data["value"][ids]
        self.node_vertex: np.ndarray = g.point_data["node"][ids]
        self.node_type: np.ndarray = g.point_data["type"][ids]
        self.node_multiplicity: np.ndarray = g.point_data["multiplicity"][ids]
        self.node_on_boundary: np.ndarray = g.point_data["on_boundary"][ids]
        self.arcs: np.ndarray = raw["arcs"]
        self.components: int = raw["components"]
        self.loops: int = raw["loops"]
        self.join_tree: np.ndarray | None = raw.get("join_tree")
        self.split_tree: np.ndarray | None = raw.get("split_tree")
        self.contour_tree: np.ndarray | None = raw.get("contour_tree")

    def lines(self, kind: int = 1) -> Iterator[np.ndarray]:
        """Each arc's polyline along the surface, (n, 3), from its lower node; of kind 2 each level
        line's, of kinds 3 to 5 the straight arcs of join, split and contour tree."""
        g = self.geometry
        first = len(g.vertices)
        for i, ids in enumerate(g.lines.lists()):
            if g.cell_data["kind"][first + i] == kind:
                yield g.points[ids]


def reeb_graph(V: ArrayLike, F: ArrayLike, values: ArrayLike, *, midside: ArrayLike | None = None,
               contract: bool = False, persistence: float | None = None,
               cancel_loops: bool = False, join_tree: bool = False, split_tree: bool = False,
               contour_tree: bool = False, level: Sequence[float] = (),
               segmentation: bool = False, certificate: bool = True, picture: Any = None,
               view: Sequence[float] | None = None, up: Sequence[float] | None = None,
               threads: int = 0, progress: Progress = None) -> ReebGraph:
    """The Reeb graph of a function linear or quadratic on each face, certified (`crest reeb`).

    values: (n,) numbers at the vertices. midside: (m, 3) numbers, for quadratic functions: at the
    middles of a face's sides, side k joining corners k and (k + 1) % 3; both faces of an edge agree.
    The surface may be one-sided or have a boundary.
    contract: contract arcs between equal values. persistence: cancel leaves up to this difference
    of values, with cancel_loops small loops, too; the certificate speaks of the whole graph.
    join_tree, split_tree: how the parts below and above a level merge; contour_tree: of simply
    connected surfaces; all of the whole graph.
    level: values at which the geometry gets level lines. segmentation: the geometry gets the monotone
    tiles with the arc each belongs to. V, F, picture, view, up, threads, progress, errors: as for ridges().

    >>> import crest
    >>> V, F = crest.read_mesh("torus.off")
    >>> graph = crest.reeb_graph(V, F, V[:, 0], persistence=0.1)
    >>> graph.loops, len(graph.node_values), len(graph.arcs)
    (1, 4, 4)
    """
    arguments = _mesh(V, F)
    if cancel_loops and persistence is None:
        raise InputError("cancel_loops: goes with persistence")
    levels = [check.number(x, "level") for x in np.ravel(np.asarray(level, dtype=float))]
    arguments |= {
        "values": check.values(values, "values", len(arguments["V"]), "vertex"),
        "midside": None if midside is None else check.same_rows(midside, "midside", 3,
                                                                len(arguments["F"]), "face"),
        "contract": bool(contract), "persistence": check.maybe_number(persistence, "persistence", 0),
        "cancel_loops": bool(cancel_loops), "join_tree": bool(join_tree),
        "split_tree": bool(split_tree), "contour_tree": bool(contour_tree), "level": levels, "segmentation": bool(segmentation),
        "certificate": bool(certificate)}
    arguments |= _picture(picture, view, up)
    return ReebGraph(run("reeb", arguments, threads, progress))


class Drawing(Result):
    """A pen-and-ink drawing.

    svg: str, the drawing, mm. The geometry has the lines in space: cell arrays kind (0 contour,
    1 boundary, 2 rim, 3 crease, from 4 hatches), invisibility (0 visible, else so many faces in
    front), stroke. sheets: "proved" if no face goes through another, exactly: then every hatch
    stays on one sheet; else, and for contours alone, "not claimed". No certificate holds it.
    """

    def __init__(self, raw: dict[str, Any]):
        super().__init__(raw)
        self.svg: str = raw["svg"]
        self.sheets: str = raw["sheets"]

    def save(self, path: Any) -> None:
        """As of every result; .svg: the drawing."""
        if str(path).lower().endswith(".svg"):
            with open(path, "w", encoding="utf-8") as file:
                file.write(self.svg)
        else:
            super().save(path)


def lineart(V: ArrayLike, F: ArrayLike, *, style: str = "fishbone",
            view: Sequence[float] | None = None, up: Sequence[float] | None = None,
            camera: Sequence[float] | None = None, perspective: float | None = None,
            crease: float | None = 60.0, width: float = 160.0, line_width: float = 0.35,
            field: str = "line", tone: str = "width", cross_hatch: bool = False,
            spacing: float = 0.8, smooth: float = 10.0, light: Sequence[float] | None = None,
            tones: Sequence[float] | None = None, title: str = "", certificate: bool = True,
            threads: int = 0, progress: Progress = None) -> Drawing:
    """A pen-and-ink drawing: contours with proven visibility, hatches (`crest lineart`).

    style: "contours" (of any faces), "streamlines", "fishbone". view: azimuth, elevation, degrees.
    up: 3 numbers. camera: eye and target, 6 numbers. perspective: degrees the view is wide. crease:
    degrees above which edges are drawn, None for none. width: of the page, mm; line_width: of
    contours, mm. field: "line" or "cross". tone: "width", "bands", "length". cross_hatch: a second
    layer where it is dark. spacing: of hatches, mm. smooth: of the field, spacings. light: 3 numbers:
    right, up, towards the eye. tones: darkest and brightest, from 0 to 1. title: of the svg.
    V, F, threads, progress, errors: as for ridges().

    >>> import crest
    >>> V, F = crest.read_mesh("ellipsoid.off")
    >>> drawing = crest.lineart(V, F, style="contours", view=(30, 20))
    >>> drawing.svg.lstrip().startswith("<"), drawing.certified
    (True, True)
    """

    def maybe(x: Any, name: str, count: int) -> list[float] | None:
        return None if x is None else check.numbers(x, name, count)

    shades = maybe(tones, "tones", 2)
    if shades and not 0 <= shades[0] < shades[1] <= 1:
        raise InputError("tones: are two that ascend within 0 to 1")
    arguments = _mesh(V, F) | {
        "style": check.word(style, "style", ("contours", "streamlines", "fishbone")),
        "view": maybe(view, "view", 2), "up": maybe(up, "up", 3),
        "camera": maybe(camera, "camera", 6),
        "perspective": check.maybe_number(perspective, "perspective", 1, 170),
        "crease": check.maybe_number(crease, "crease", 0, 180),
        "width": check.number(width, "width", 10, 5000),
        "line_width": check.number(line_width, "line_width", 0.02, 10),
        "field": check.word(field, "field", ("line", "cross")),
        "tone": check.word(tone, "tone", ("width", "bands", "length")),
        "cross_hatch": bool(cross_hatch), "spacing": check.number(spacing, "spacing", 0.2, 20),
        "smooth": check.number(smooth, "smooth", 0, 1000), "light": maybe(light, "light", 3),
        "tones": shades, "title": str(title), "certificate": bool(certificate)}
    return Drawing(run("lineart", arguments, threads, progress))


class Strips(Result):
    """The faces of a mesh as triangle strips; there is no certificate.

    vertices: int64, of all strips. offsets: (S + 1,) int64, strip i has vertices[offsets[i]] to
    vertices[offsets[i + 1]]; a repeated vertex is a swap. swaps: int. acmr: float, vertices a face
    that a cache of 16 misses.
    """

    def __init__(self, raw: dict[str, Any]):
        super().__init__(raw)
        self.offsets, self.vertices = self.geometry.strips
        self.swaps: int = raw["swaps"]
        self.acmr: float = raw["acmr"]


def strips(V: ArrayLike, F: ArrayLike, *, effort: int = 20, tree: bool = False,
           no_swaps: bool = False, threads: int = 0, progress: Progress = None) -> Strips:
    """The faces of a mesh as few triangle strips (`crest strips`).

    effort: sweeps of annealing. tree: the strips of the strip tree as they are. no_swaps: start a
    new strip where a vertex would be sent twice. V, F, threads, progress, errors: as for ridges().

    >>> import crest
    >>> V, F = crest.read_mesh("ellipsoid.off")
    >>> len(crest.strips(V, F).vertices) < 2 * len(F)
    True
    """
    arguments = _mesh(V, F) | {
        "effort": 0 if tree else check.whole(effort, "effort", 0, 100000),
        "no_swaps": bool(no_swaps)}
    return Strips(run("strips", arguments, threads, progress))


class Stream(Result):
    """A mesh as a small stream.

    stream: bytes, as .cmc files have them. vertex_order: (n,) int64: vertex i of the decoded mesh is
    vertex_order[i] of the input. method: str. largest_error: float, how far a vertex has moved.
    connectivity_bytes, geometry_bytes, attribute_bytes: int. components, handles, boundary_loops: int.
    """

    def __init__(self, raw: dict[str, Any]):
        super().__init__(raw)
        self.stream: bytes = raw["stream"].tobytes()
        self.vertex_order: np.ndarray = raw["vertex_order"]
        self.method: str = raw["method"]
        self.largest_error: float = raw["largest_error"]
        for name in ("connectivity_bytes", "geometry_bytes", "attribute_bytes", "components",
                     "handles", "boundary_loops"):
            setattr(self, name, raw[name])

    def save(self, path: Any) -> None:
        """.cmc: the stream; .crest: its certificate."""
        name = str(path).lower()
        if name.endswith(".cmc"):
            with open(path, "wb") as file:
                file.write(self.stream)
        elif name.endswith(".crest"):
            super().save(path)
        else:
            raise ValueError(f"{path}: has an unknown extension; write .cmc or .crest")


class DecodedMesh(Mesh):
    """V, F as of every Mesh, with the numbers that the stream has at them.

    point_data, cell_data, corner_data: arrays by name, of the types that were encoded: (n,), (m,) and
    (m, 3), or with one axis more where a place has several numbers. Places without numbers are
    masked (numpy.ma).
    """

    point_data: dict[str, np.ndarray]
    cell_data: dict[str, np.ndarray]
    corner_data: dict[str, np.ndarray]


_SITES = {"point_data": "vertices", "cell_data": "faces", "corner_data": "corners"}


def _attributes(given: dict[str, Mapping[str, ArrayLike] | None],
                places: dict[str, tuple[int, ...]]) -> dict[str, Any]:
    """As coding.cpp takes them."""
    arguments: dict[str, Any] = {}
    names: list[str] = []
    sites: list[str] = []
    for data, arrays in given.items():
        for name, array in (arrays or {}).items():
            if not isinstance(name, str):
                raise TypeError(f"{data}: names are str, not {name!r}")
            numbers, gaps = check.attribute(array, f"{data}[{name!r}]", places[data])
            arguments |= {f"attribute{len(names)}": numbers, f"gaps{len(names)}": gaps}
            names.append(name)
            sites.append(_SITES[data])
    return arguments | ({"attribute_names": names, "attribute_sites": sites} if names else {})


def encode(V: ArrayLike, F: ArrayLike, *, tolerance: float | None = None,
           connectivity_only: bool = False, method: str = "auto", keep_order: bool = False,
           point_data: Mapping[str, ArrayLike] | None = None,
           cell_data: Mapping[str, ArrayLike] | None = None,
           corner_data: Mapping[str, ArrayLike] | None = None,
           certificate: bool = True, threads: int = 0, progress: Progress = None) -> Stream:
    """A triangle mesh as a small stream, decoded again before it is returned (`crest encode`).

    tolerance: places within this distance, units of the input; else bit for bit. connectivity_only:
    no places. method: "auto", "valence", "fan", "zigzag", "static". keep_order: code the order of
    vertices and faces, too.
    point_data, cell_data, corner_data: numbers at vertices, (n,) or (n, k), at faces, (m,) or (m, k),
    and at the corners of faces, (m, 3) or (m, 3, k), arrays by name; kept bit for bit in their
    types. Places masked in a numpy.ma array, with all their k numbers, have none.
    V, F, threads, progress, errors: as for ridges().

    >>> import crest
    >>> V, F = crest.read_mesh("ellipsoid.off")
    >>> coded = crest.encode(V, F)
    >>> W, G = crest.decode(coded.stream)
    >>> bool((W == V[coded.vertex_order]).all()), len(G) == len(F)
    (True, True)
    >>> coloured = crest.encode(V, F, point_data={"height": V[:, 2].astype("f4")})
    >>> crest.decode(coloured.stream).point_data["height"].dtype
    dtype('float32')
    """
    if tolerance is not None and connectivity_only:
        raise InputError("tolerance: give it or connectivity_only, not both")
    if tolerance is not None and check.number(tolerance, "tolerance", 0) == 0:
        raise InputError("tolerance: 0 is none; leave it out, or give a positive number")
    arguments = _mesh(V, F) | {
        "tolerance": check.maybe_number(tolerance, "tolerance", 0),
        "connectivity_only": bool(connectivity_only),
        "method": check.word(method, "method", ("auto", "valence", "fan", "zigzag", "static")),
        "keep_order": bool(keep_order), "certificate": bool(certificate)}
    data = {"point_data": point_data, "cell_data": cell_data, "corner_data": corner_data}
    if connectivity_only and any(data.values()):
        raise InputError("connectivity_only: leaves no place for point_data, cell_data, corner_data")
    n, m = len(arguments["V"]), len(arguments["F"])
    arguments |= _attributes(data, {"point_data": (n,), "cell_data": (m,), "corner_data": (m, 3)})
    return Stream(run("encode", arguments, threads, progress))


def decode(stream: Any, *, max_faces: int = 2**28, max_numbers: int = 2**27, threads: int = 0,
           progress: Progress = None) -> DecodedMesh:
    """The mesh of a stream: V (n, 3) float64, F (m, 3) int64, and attributes (`crest decode`).

    stream: bytes. max_faces: refuse larger ones. max_numbers: refuse streams with more numbers in
    their attributes. Where the stream has no places V is all zero. Faces may start with another
    corner. threads, progress, errors: as for ridges().

    >>> import crest
    >>> V, F = crest.read_mesh("ellipsoid.off")
    >>> W, G = crest.decode(crest.encode(V, F, keep_order=True).stream)
    >>> bool((W == V).all() and (G.min(axis=1) == F.min(axis=1)).all())
    True
    """
    raw = run("decode", {"stream": check.octets(stream, "stream"),
                         "max_faces": check.whole(max_faces, "max_faces", 1, 2**31 - 1),
                         "max_numbers": check.whole(max_numbers, "max_numbers", 0, 2**63 - 1)},
              threads, progress)
    V = raw.get("V")
    mesh = DecodedMesh(np.zeros((raw["vertices"], 3)) if V is None else V, raw["F"])
    mesh.point_data, mesh.cell_data, mesh.corner_data = {}, {}, {}
    of = {site: getattr(mesh, data) for data, site in _SITES.items()}
    for i, (name, site) in enumerate(zip(raw["attribute_names"], raw["attribute_sites"])):
        array, gaps = raw[f"attribute{i}"], raw.get(f"gaps{i}")
        if gaps is not None:
            array = np.ma.array(array, mask=np.repeat(gaps[:, None] == 1, array.shape[1], axis=1))
        shape = (len(mesh.F), 3) if site == "corners" else (len(array),)
        of[site][name] = array.reshape(shape + (array.shape[1:] if array.shape[1] > 1 else ()))
    return mesh
