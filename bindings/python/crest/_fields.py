# SPDX-License-Identifier: GPL-3.0-or-later
"""Functions of tensor fields, volumes, points and plane vector fields."""

from __future__ import annotations

from typing import Any, NamedTuple, Sequence

import numpy as np
from numpy.typing import ArrayLike

from . import _arrays as check
from ._crest import InputError
from ._results import Result
from ._run import Progress, run


class ModeSurfaces(Result):
    """Mode surfaces and degenerate curves of a tensor field, m triangles.

    points: (n, 3) float64. triangles: (m, 3) int64. mode: (m,) float64, of each triangle.
    tet: (m,) int32, its tetrahedron. component: (m,) int32.
    normal, minor, medium, major: (n, 3) float64, of the surface and eigenvectors by eigenvalue; k1,
    k2: (n,) float64, curvatures; magnitude: (n,) float64, |T|. Zero at points of curves.
    curves: list of (k, 3) float64, the degenerate curves. curve_mode: float64: 1 linear, -1 planar.
    undecided: int64, tetrahedra with open cells. undecided_curves: int64, tetrahedra whose curves
    are open.
    """

    def __init__(self, raw: dict[str, Any]):
        super().__init__(raw)
        g = self.geometry
        self.points = g.points
        self.triangles = g.triangles()
        first = len(g.vertices)  # curves of one point
        rows = slice(first + len(g.lines), None)
        for name, kind in (("mode", float), ("tet", np.int32), ("component", np.int32)):
            setattr(self, name, g.cell_data.get(name, np.zeros(0, kind))[rows])
        for name in ("normal", "minor", "medium", "major", "k1", "k2", "magnitude"):
            shape = (0,) if name in ("k1", "k2", "magnitude") else (0, 3)
            setattr(self, name, g.point_data.get(name, np.zeros(shape)))
        self.curves = [g.points[ids] for ids in g.lines.lists()]
        self.curve_mode: np.ndarray = g.cell_data.get("mode", np.zeros(0))[first:first + len(g.lines)]
        self.undecided: np.ndarray = raw["undecided"]
        self.undecided_curves: np.ndarray = raw.get("undecided_curves", np.zeros(0, np.int64))


def modes(V: ArrayLike, T: ArrayLike, tensors: ArrayLike, *,
          mode: float | str | Sequence[float | str] = (), neutral: bool = False,
          degenerate: bool = False, signed: bool = False, max_depth: int = 40,
          budget: int = 100000, deviation: float = 0.0, min_magnitude: float = 0.0,
          certificate: bool = True, threads: int = 0, progress: Progress = None) -> ModeSurfaces:
    """Mode surfaces and degenerate curves of a symmetric tensor field (`crest modes`).

    V: (n, 3) numbers. T: (m, 4) integers from 0. tensors: (n, 6) numbers: xx, yy, zz, xy, yz, xz.
    mode: one or several, decimals or fractions as text ("1/3"); each gives +mu and -mu, with
    signed the one of its sign alone. neutral: mode 0. degenerate: the curves of mode 1 and -1.
    max_depth, budget: bisections and tests of a tetrahedron. deviation: refine triangles until so
    near to the surface, of the box's diagonal. min_magnitude: leave out triangles with smaller |T|.
    The certificate is about the surfaces, or with degenerate alone about the curves.
    threads, progress, errors: as for ridges().

    >>> import crest
    >>> V, T, tensors = crest.read_tensors("stress.vtu", tensor="stress")
    >>> surfaces = crest.modes(V, T, tensors, mode=0.5)
    >>> sorted(set(surfaces.mode)), surfaces.certified
    ([-0.5, 0.5], True)
    """
    given = [mode] if isinstance(mode, (str, float, int)) else list(mode)
    texts = [x if isinstance(x, str) else
             np.format_float_positional(check.number(x, "mode", -1, 1), trim="-") for x in given]
    if neutral:
        texts.append("0")
    if not texts and not degenerate:
        raise InputError("mode: give it, neutral or degenerate")
    points = check.rows(V, "V", 3)
    arguments = {
        "V": points, "T": check.cells(T, "T", 4),
        "tensors": check.same_rows(tensors, "tensors", 6, len(points), "vertex"),
        "mode": texts or None, "degenerate": bool(degenerate), "signed": bool(signed),
        "max_depth": check.whole(max_depth, "max_depth", 0, 200),
        "budget": check.whole(budget, "budget", 1, 2**31 - 1),
        "deviation": check.number(deviation, "deviation", 0),
        "min_magnitude": check.number(min_magnitude, "min_magnitude", 0),
        "certificate": bool(certificate)}
    if not np.isfinite(arguments["tensors"]).all():
        first = np.argwhere(~np.isfinite(arguments["tensors"]))[0][0]
        raise InputError(f"tensors[{first}]: a number is not finite; replace it")
    if not np.isfinite(points).all():
        first = np.argwhere(~np.isfinite(points))[0][0]
        raise InputError(f"V[{first}]: a coordinate is not a finite number; remove the vertex")
    return ModeSurfaces(run("modes", arguments, threads, progress))


class ExtremalSurface(Result):
    """An extremal surface of a volume or points, or extremal curves of an image.

    points: (n, 3) float64, world units. normal: (n, 3) float64, unit vectors up to sign.
    polygons: Cells (of an image: segments). critical_type: int32 a polygon: 1 extremal, 0 merely
    critical. component: int32. strength, s, plateness: float64 a polygon.
    rims: (r, 2) int64, edges with other than two polygons (of an image: points, twice), and reason:
    (r,) int32: 1 the direction is discontinuous, 2 inflection, 3 trimmed, 4 border, 5 undecided.
    h: float, sqrt(2) sigma in world units, or the radius. undecided: int, open edges of the grid.
    """

    def __init__(self, raw: dict[str, Any]):
        super().__init__(raw)
        g = self.geometry
        self.points = g.points
        self.normal: np.ndarray = g.point_data["normal"]
        feature = g.cell_data.get("feature", np.zeros(0, np.int32))
        self.polygons = g.polygons
        rows = feature == 0
        pairs = []
        for row, ids in enumerate(list(g.vertices.lists()) + list(g.lines.lists())):
            if feature[row] != 0:
                pairs.append((ids[0], ids[-1]))
        if len(g.polygons) == 0 and rows.any():  # of an image
            ids = [line for line, row in zip(g.lines.lists(), rows[len(g.vertices):]) if row]
            flat = np.concatenate(ids)
            self.polygons = type(g.lines)(np.arange(0, len(flat) + 1, 2), flat)
        self.rims = np.array(pairs, dtype=np.int64).reshape(-1, 2)
        self.reason: np.ndarray = feature[feature != 0]
        for name in ("critical_type", "component", "strength", "s", "plateness"):
            setattr(self, name, g.cell_data.get(name, np.zeros(0))[rows])
        self.h: float = raw["h"]
        self.undecided: int = raw["undecided"]


def _grid(volume: Any, spacing: Any, origin: Any, directions: Any) -> dict[str, Any]:
    """The arguments that describe a grid; NumPy's last index is x."""
    samples = check.volume(volume, "volume")
    axes = samples.ndim

    def three(x: Any, name: str, fill: float) -> list[float]:
        given = np.ravel(np.asarray(x))
        if len(given) == 1:
            given = np.tile(given, 3)
        if axes == 2 and len(given) == 2:
            given = np.append(given, fill)
        return check.numbers(given, name, 3)

    axis = np.eye(3) if directions is None else directions
    return {"volume": samples, "spacing": three(spacing, "spacing", 1.0),
            "origin": three(origin, "origin", 0.0),
            "directions": check.same_rows(axis, "directions", 3, 3, "axis")}


def extremal(volume: ArrayLike, *, spacing: float | Sequence[float] = 1.0,
             origin: float | Sequence[float] = 0.0, directions: ArrayLike | None = None,
             ridge: bool = False, valley: bool = False, definition: str = "structure",
             sigma: float = 1.0, tensor_sigma: float | None = None,
             min_value: float | None = None, min_strength: float = 0.0, critical: bool = False,
             refine: int = 0, certificate: bool = True, threads: int = 0,
             progress: Progress = None) -> ExtremalSurface:
    """Ridge or valley surfaces of a volume, curves of an image, certified (`crest extremal`).

    volume: (nz, ny, nx) or (ny, nx) numbers of any type, volume[k, j, i] at x = i; at least four
    along each axis. spacing, origin: of x, y, z in world units. directions: (3, 3), the axes' unit
    vectors in the world. ridge or valley: where the value is largest or least along n, the dominant
    eigenvector of the "structure" tensor or of the "hessian" (definition).
    sigma: smoothing, in smallest spacings; tensor_sigma: of the structure tensor. min_value,
    min_strength: keep what has a smoothed value, a second derivative of so much. critical: keep the
    merely critical part. refine: halve the grid so often, 0 to 3.
    threads, progress, errors: as for ridges().

    >>> import crest
    >>> volume = crest.read_volume("moebius.nrrd")
    >>> sheet = crest.extremal(*volume[:1], **volume.frame(), ridge=True, min_value=0.4)
    >>> len(sheet.polygons) > 0, sheet.certified
    (True, True)
    """
    if bool(ridge) == bool(valley):
        raise InputError("ridge: give it or valley, and not both")
    arguments = _grid(volume, spacing, origin, directions) | {
        "valley": bool(valley),
        "definition": check.word(definition, "definition", ("structure", "hessian")),
        "sigma": check.number(sigma, "sigma", 0),
        "tensor_sigma": check.maybe_number(tensor_sigma, "tensor_sigma", 0),
        "min_value": check.maybe_number(min_value, "min_value"),
        "min_strength": check.number(min_strength, "min_strength", 0),
        "critical": bool(critical), "refine": check.whole(refine, "refine", 0, 3),
        "certificate": bool(certificate)}
    return ExtremalSurface(run("extremal", arguments, threads, progress))


def extremal_points(points: ArrayLike, normals: ArrayLike, *, radius: float | None = None,
                    depth: int = 10, critical: bool = False, threads: int = 0,
                    progress: Progress = None) -> ExtremalSurface:
    """The surface of points whose normals may have any sign (`crest extremal --surface`); it has no
    certificate.

    points, normals: (n, 3) numbers. radius: H of the weights; else the median distance to the 10th
    neighbour. depth: of the octree, 1 to 16. critical: keep the merely critical part.
    threads, progress, errors: as for ridges().

    >>> import crest
    >>> points, normals = crest.read_points("strip.xyz")
    >>> len(crest.extremal_points(points, normals, radius=0.15, depth=5).polygons) > 0
    True
    """
    given = check.rows(points, "points", 3)
    arguments = {
        "points": given, "normals": check.same_rows(normals, "normals", 3, len(given), "point"),
        "radius": check.maybe_number(radius, "radius", 0), "depth": check.whole(depth, "depth", 1, 16),
        "critical": bool(critical)}
    return ExtremalSurface(run("extremal_points", arguments, threads, progress))


class Skeleton(Result):
    """The topological skeleton of a plane vector field.

    critical_points: (c, 2) float64. critical_kind, critical_index: (c,) int32.
    switch_points: (s, 2) float64. switch_inside: (s,) bool, the flow touches from inside.
    separatrices: list of (k, 2) float64. separatrix_forward: bool. separatrix_origin: int64, critical
    point or switch point. separatrix_end: int32: 0 critical point, 1 boundary, 2 closed orbit, 3 zero
    flow, 4 switch point, 5 undecided. separatrix_target: int32, -1 undecided. separatrix_bits: int32,
    the precision that decided.
    orbits: list of (k, 2) float64, closed ones. orbit_attracting: bool.
    undecided: int, separatrices without a proven end. index_sum, euler_characteristic: int.
    With simplify, what weighs as much or more is shown: critical_weight, separatrix_weight: float64,
    from 0 to 1, not certified; empty otherwise.
    """

    def __init__(self, raw: dict[str, Any]):
        super().__init__(raw)
        self.critical_weight: np.ndarray = raw.get("critical_weight", np.zeros(0))
        self.separatrix_weight: np.ndarray = raw.get("separatrix_weight", np.zeros(0))
        g = self.geometry
        cell = {name: g.cell_data.get(name, np.zeros(0, np.int32))
                for name in ("type", "kind", "index", "end", "target", "bits")}
        groups = list(g.vertices.lists()) + list(g.lines.lists())

        def rows(kind: int) -> np.ndarray:
            return np.flatnonzero(cell["type"] == kind)

        def places(kind: int) -> np.ndarray:
            ids = [groups[row][0] for row in rows(kind)]
            return g.points[np.array(ids, dtype=np.int64), :2]

        self.critical_points, self.switch_points = places(0), places(1)
        self.critical_kind: np.ndarray = cell["kind"][rows(0)]
        self.critical_index: np.ndarray = cell["index"][rows(0)]
        self.switch_inside: np.ndarray = cell["kind"][rows(1)] == 1
        self.separatrices = [g.points[groups[row], :2] for row in rows(2)]
        self.separatrix_forward: np.ndarray = cell["kind"][rows(2)] == 1
        self.separatrix_origin: np.ndarray = raw["origin"]
        self.separatrix_end: np.ndarray = cell["end"][rows(2)]
        self.separatrix_target: np.ndarray = cell["target"][rows(2)]
        self.separatrix_bits: np.ndarray = cell["bits"][rows(2)]
        self.orbits = [g.points[groups[row], :2] for row in rows(3)]
        self.orbit_attracting: np.ndarray = cell["kind"][rows(3)] == 1
        self.undecided: int = raw["undecided"]
        self.index_sum: int = raw["index_sum"]
        self.euler_characteristic: int = raw["euler_characteristic"]


def _plane(V: Any, F: Any, vectors: Any) -> dict[str, Any]:
    points = check.rows(V, "V", 2)
    return {"V": points, "F": check.cells(F, "F", 3),
            "vectors": check.same_rows(vectors, "vectors", 2, len(points), "vertex")}


def _weights(simplify: float | None, laplacian: str) -> dict[str, Any]:
    if simplify is None and laplacian != "uniform":
        raise InputError("laplacian: goes with simplify")
    return {"simplify": check.maybe_number(simplify, "simplify", 0, 1),
            "laplacian": check.word(laplacian, "laplacian", ("uniform", "cotan"))}


def skeleton(V: ArrayLike, F: ArrayLike, vectors: ArrayLike, *, simplify: float | None = None,
             laplacian: str = "uniform", certificate: bool = True,
             threads: int = 0, progress: Progress = None) -> Skeleton:
    """Zeros, switch points, separatrices and closed orbits of a plane vector field, certified
    (`crest skeleton`).

    V, vectors: (n, 2) numbers. F: (m, 3) integers from 0, counter-clockwise.
    simplify: a number from 0 to 1, shows what weighs as much or more: the time at which it vanishes
    as the field goes over to a smoothed one, by laplacian, "uniform" or "cotan". The certificate is
    that of the whole skeleton, weights are not certified.
    threads, progress, errors: as for ridges().

    >>> import crest
    >>> field = crest.read_vectors("lattice.vtu")
    >>> skeleton = crest.skeleton(*field)
    >>> len(skeleton.critical_points) > 0, skeleton.certified
    (True, True)
    >>> crest.skeleton(*field, simplify=0.1).critical_weight.min() >= 0.1
    True
    """
    arguments = _plane(V, F, vectors) | _weights(simplify, laplacian) | {
        "certificate": bool(certificate)}
    return Skeleton(run("skeleton", arguments, threads, progress))


class CompressedField(Skeleton):
    """A plane vector field on fewer triangles, with its skeleton.

    V, vectors: (n, 2) float64. F: (m, 3) int64. vertex_of: (n,) int64, the vertices' numbers in the
    input. same_skeleton: bool, proven but for undecided separatrices; else difference: str, the
    first one, and there is no certificate.
    """

    def __init__(self, raw: dict[str, Any]):
        super().__init__(raw)
        self.V: np.ndarray = raw["V"]
        self.F: np.ndarray = raw["F"]
        self.vectors: np.ndarray = raw["vectors"]
        self.vertex_of: np.ndarray = raw["vertex_of"]
        self.same_skeleton: bool = raw["same_skeleton"]
        self.difference: str = raw["difference"]


def compress(V: ArrayLike, F: ArrayLike, vectors: ArrayLike, *, equivalence: str = "original",
             test: str = "retrace", priority: str = "product", no_flips: bool = False,
             simplify: float | None = None, laplacian: str = "uniform", certificate: bool = True,
             threads: int = 0, progress: Progress = None) -> CompressedField:
    """A plane vector field on fewer triangles whose skeleton is proven to be the same
    (`crest compress`).

    equivalence: "strong" keeps all triangles that the skeleton meets, "original" those of zeros,
    "relaxed" their classes. test: "retrace" or "thesis". priority: "length", "error", "product"
    of both. no_flips: else, where nothing collapses, holes of vertices are filled
    otherwise and edges are flipped, by the same test.
    simplify, laplacian: as for skeleton(); critical points that weigh less may move and vanish in
    pairs, and the certificate is of the output's skeleton alone. Not with equivalence or test.
    V, F, vectors: as for skeleton(); threads, progress, errors: as for ridges().

    >>> import crest
    >>> field = crest.read_vectors("lattice.vtu")
    >>> small = crest.compress(*field)
    >>> small.same_skeleton, len(small.F) < len(field.F)
    (True, True)
    """
    if simplify is not None and (equivalence, test) != ("original", "retrace"):
        raise InputError("simplify: goes with neither equivalence nor test")
    arguments = _plane(V, F, vectors) | _weights(simplify, laplacian) | {
        "equivalence": check.word(equivalence, "equivalence", ("strong", "original", "relaxed")),
        "test": check.word(test, "test", ("retrace", "thesis")),
        "priority": check.word(priority, "priority", ("length", "error", "product")),
        "flips": not no_flips,
        "certificate": bool(certificate)}
    return CompressedField(run("compress", arguments, threads, progress))


class Isosurface(Result):
    """The isosurface of a quadratic spline.

    points, gradient: (n, 3) float64. triangles: (m, 3) int64. euler_characteristic, components,
    boundary_loops: int. undecided: (k, 3) float64, centres of tetrahedra where nothing is proven:
    then there is no certificate. range: two floats, of the coefficients.
    """

    def __init__(self, raw: dict[str, Any]):
        super().__init__(raw)
        self.points = self.geometry.points
        self.gradient: np.ndarray = self.geometry.point_data["gradient"]
        self.triangles = self.geometry.triangles()
        self.undecided: np.ndarray = raw["undecided"]
        self.range: tuple[float, float] = tuple(raw["range"])
        for name in ("euler_characteristic", "components", "boundary_loops"):
            setattr(self, name, raw[name])


class RayHits(Result):
    """What rays hit first.

    hit: (n,) bool. t: (n,) float64, nan without a hit. t_bracket: (n, 2) float64, which holds the
    true one. place, gradient: (n, 3) float64.
    """

    def __init__(self, raw: dict[str, Any]):
        super().__init__(raw)
        self.hit: np.ndarray = raw["hit"].astype(bool)
        for name in ("t", "t_bracket", "place", "gradient"):
            setattr(self, name, raw[name])


class SplineValues(Result):
    """A spline's values, nan outside of its domain.

    values: (n,) float64. gradients: (n, 3) float64. range: two floats, of the coefficients.
    gradient_jump: float, the largest; 0: the spline is C1.
    """

    def __init__(self, raw: dict[str, Any]):
        super().__init__(raw)
        self.values: np.ndarray = raw.get("values", np.zeros(0))
        self.gradients: np.ndarray = raw.get("gradients", np.zeros((0, 3)))
        self.range: tuple[float, float] = tuple(raw["range"])
        self.gradient_jump: float = raw["gradient_jump"]


class CubicSpline(SplineValues):
    """A cubic spline of samples, at the points asked for.

    cubes: three ints. error_mean, error_max: float, at the samples.
    """

    def __init__(self, raw: dict[str, Any]):
        super().__init__(raw)
        self.cubes: tuple[int, ...] = tuple(int(n) for n in raw["cubes"])
        self.error_mean: float = raw["error_mean"]
        self.error_max: float = raw["error_max"]


def _spline(volume: Any, spacing: Any, origin: Any, directions: Any, border: str,
            certificate: bool) -> dict[str, Any]:
    return _grid(volume, spacing, origin, directions) | {
        "border": check.word(border, "border", ("none", "extend")),
        "certificate": bool(certificate)}


def spline_isosurface(volume: ArrayLike, isovalue: float, *,
                      spacing: float | Sequence[float] = 1.0,
                      origin: float | Sequence[float] = 0.0,
                      directions: ArrayLike | None = None, border: str = "none",
                      max_depth: int = 54, certificate: bool = True, threads: int = 0,
                      progress: Progress = None) -> Isosurface:
    """The isosurface of a volume's quadratic spline, its topology proven (`crest spline --mesh`).

    border: "none", or "extend": a layer of samples is added by linear extrapolation. max_depth: of
    bisections, 0 to 54. volume, spacing, origin, directions: as for extremal(); threads, progress,
    errors: as for ridges().

    >>> import crest
    >>> volume = crest.read_volume("moebius.nrrd")
    >>> surface = crest.spline_isosurface(volume.samples, 0.4, **volume.frame())
    >>> surface.certified, len(surface.triangles) > 0
    (True, True)
    """
    arguments = _spline(volume, spacing, origin, directions, border, certificate) | {
        "what": "mesh", "isovalue": check.number(isovalue, "isovalue"),
        "max_depth": check.whole(max_depth, "max_depth", 0, 54)}
    return Isosurface(run("spline_volume", arguments, threads, progress))


def spline_rays(volume: ArrayLike, isovalue: float, rays: ArrayLike, *,
                spacing: float | Sequence[float] = 1.0, origin: float | Sequence[float] = 0.0,
                directions: ArrayLike | None = None, border: str = "none",
                certificate: bool = True, threads: int = 0, progress: Progress = None) -> RayHits:
    """Where rays first hit the isosurface of a volume's quadratic spline, proven
    (`crest spline --rays`).

    rays: (n, 6) numbers: origin and direction. The rest as for spline_isosurface().

    >>> import crest
    >>> volume = crest.read_volume("moebius.nrrd")
    >>> low = volume.origin
    >>> hits = crest.spline_rays(volume.samples, 0.4, [[*low, 1, 1, 1]], **volume.frame())
    >>> hits.hit.shape, hits.certified
    ((1,), True)
    """
    arguments = _spline(volume, spacing, origin, directions, border, certificate) | {
        "what": "rays", "isovalue": check.number(isovalue, "isovalue"),
        "rays": check.rows(rays, "rays", 6)}
    return RayHits(run("spline_volume", arguments, threads, progress))


def spline_values(volume: ArrayLike, points: ArrayLike, *,
                  spacing: float | Sequence[float] = 1.0,
                  origin: float | Sequence[float] = 0.0, directions: ArrayLike | None = None,
                  border: str = "none", threads: int = 0,
                  progress: Progress = None) -> SplineValues:
    """Values and gradients of a volume's quadratic spline (`crest spline --evaluate`).

    points: (n, 3) numbers. The rest as for spline_isosurface(); there is no certificate.

    >>> import crest, numpy
    >>> x = numpy.arange(6.0)
    >>> values = crest.spline_values(x[None, None, :] + 0 * x[:, None, None] + 0 * x[:, None],
    ...                              [[2.5, 2, 2]])
    >>> float(values.values[0]), values.gradients[0].tolist()
    (2.5, [1.0, 0.0, 0.0])
    """
    arguments = _spline(volume, spacing, origin, directions, border, False) | {
        "what": "values", "points": check.rows(points, "points", 3)}
    return SplineValues(run("spline_volume", arguments, threads, progress))


def spline_samples(points: ArrayLike, values: ArrayLike, *, evaluate: ArrayLike | None = None,
                   smoothness: str = "c1", n: int | Sequence[int] | None = None,
                   box: Sequence[float] | None = None, certificate: bool = True,
                   threads: int = 0, progress: Progress = None) -> CubicSpline:
    """A cubic spline of scattered samples, certified (`crest spline --cubic`).

    points: (n, 3) numbers. values: (n,) numbers. evaluate: (k, 3) numbers, where its values are
    wanted. smoothness: "c1" (exactly), "local", "sequential". n: cubes along each axis, one or three;
    else ten samples a cube. box: the domain, two or six numbers; else that of the samples.
    threads, progress, errors: as for ridges().

    >>> import crest, numpy
    >>> points = numpy.random.default_rng(1).random((500, 3))
    >>> spline = crest.spline_samples(points, points @ [1, 2, 3], evaluate=[[0.5, 0.5, 0.5]], n=2)
    >>> abs(float(spline.values[0]) - 3) < 1e-6, spline.certified
    (True, True)
    """
    given = check.rows(points, "points", 3)
    cubes = None
    if n is not None:
        counts = np.ravel(np.asarray(n))
        counts = np.tile(counts, 3) if len(counts) == 1 else counts
        cubes = [float(check.whole(x, "n", 1, 2**20)) for x in counts]
        if len(cubes) != 3:
            raise InputError(f"n: has {len(cubes)} numbers; give 1 or 3")
    bounds = None
    if box is not None:
        b = np.ravel(np.asarray(box))
        bounds = check.numbers(np.tile(b, 3) if len(b) == 2 else b, "box", 6)
    arguments = {
        "points": given, "values": check.values(values, "values", len(given), "point"),
        "evaluate": None if evaluate is None else check.rows(evaluate, "evaluate", 3),
        "smoothness": check.word(smoothness, "smoothness", ("c1", "local", "sequential")),
        "n": cubes, "box": bounds, "certificate": bool(certificate)}
    return CubicSpline(run("spline_samples", arguments, threads, progress))


class Mesh(NamedTuple):
    """V: (n, 3) float64, units of the file. F: (m, 3) int64."""

    V: np.ndarray
    F: np.ndarray


class Field(NamedTuple):
    """A mesh with a number a vertex, values: (n,) float64."""

    V: np.ndarray
    F: np.ndarray
    values: np.ndarray


class TensorField(NamedTuple):
    """V: (n, 3) float64. T: (m, 4) int64. tensors: (n, 6) float64: xx, yy, zz, xy, yz, xz."""

    V: np.ndarray
    T: np.ndarray
    tensors: np.ndarray


class VectorField(NamedTuple):
    """V, vectors: (n, 2) float64. F: (m, 3) int64, counter-clockwise."""

    V: np.ndarray
    F: np.ndarray
    vectors: np.ndarray


class Points(NamedTuple):
    """points, normals: (n, 3) float64."""

    points: np.ndarray
    normals: np.ndarray


class Volume(NamedTuple):
    """samples: (nz, ny, nx) or (ny, nx) in the file's type. spacing, origin: (3,) float64, of x, y, z.
    directions: (3, 3) float64, the axes' unit vectors."""

    samples: np.ndarray
    spacing: np.ndarray
    origin: np.ndarray
    directions: np.ndarray

    def frame(self) -> dict[str, np.ndarray]:
        """All but the samples, as the functions of volumes take it by name."""
        return {"spacing": self.spacing, "origin": self.origin, "directions": self.directions}


def _path(path: Any) -> str:
    import os
    return os.fsdecode(path)


def _mesh_arguments(path: Any, weld: float | None, split: bool, outward: bool) -> dict[str, Any]:
    return {"path": _path(path), "weld": check.maybe_number(weld, "weld", 0), "split": bool(split),
            "outward": bool(outward), "with_field": False, "with_normals": False}


def read_mesh(path: Any, *, weld: float | None = None, split: bool = False,
              outward: bool = False, threads: int = 0, progress: Progress = None) -> Mesh:
    """A triangle mesh from .off .obj .ply .stl .vtp .vtu .vtk .msh, cleaned as by all commands.

    weld: vertices within this distance become one. split: cut at edges of three or more faces, and
    one-sided parts open. outward: turn closed parts inside out whose volume is negative.
    threads, progress, errors: as for ridges().

    >>> import crest
    >>> V, F = crest.read_mesh("ellipsoid.off")
    >>> V.dtype, F.dtype, len(V) - len(F) // 2
    (dtype('float64'), dtype('int64'), 2)
    """
    raw = run("read_mesh", _mesh_arguments(path, weld, split, outward), threads, progress)
    return Mesh(raw["V"], raw["F"])


def read_field(path: Any, field: str = "", *, weld: float | None = None, split: bool = False,
               outward: bool = False, step: int | None = None, threads: int = 0,
               progress: Progress = None) -> Field:
    """A triangle mesh and a scalar field of its file, by name or the only one there is.

    step: the time step of a .msh file; else the last. The rest as for read_mesh().

    >>> import crest
    >>> field = crest.read_field("field.vtp", "k1")
    >>> len(field.values) == len(field.V)
    True
    """
    arguments = _mesh_arguments(path, weld, split, outward) | {
        "with_field": True, "field": str(field),
        "step": None if step is None else check.whole(step, "step", -2**31, 2**31 - 1)}
    raw = run("read_mesh", arguments, threads, progress)
    return Field(raw["V"], raw["F"], raw["values"])


def read_tensors(path: Any, tensor: str = "", *, order: str = "", step: int | None = None,
                 threads: int = 0, progress: Progress = None) -> TensorField:
    """Tetrahedra with a symmetric tensor at each vertex, from .vtu .vtk .msh .frd .mesh .nrrd.

    tensor: the array's name, or the only one of 6 or 9 numbers. order: of 6 numbers (else the
    format's). step: of time; else the last. threads, progress, errors: as for ridges().

    >>> import crest
    >>> V, T, tensors = crest.read_tensors("stress.vtu", "stress")
    >>> tensors.shape == (len(V), 6)
    True
    """
    raw = run("read_tensors", {
        "path": _path(path), "tensor": str(tensor), "order": str(order),
        "step": None if step is None else check.whole(step, "step", -2**31, 2**31 - 1)},
        threads, progress)
    return TensorField(raw["V"], raw["T"], raw["tensors"])


def read_vectors(path: Any, vectors: str = "", *, cell_to_point: bool = False,
                 diagonal: str = "up", slice: int | None = None, all: bool = False,
                 threads: int = 0, progress: Progress = None) -> VectorField:
    """A plane vector field from the files of `crest skeleton`.

    vectors: the array's name, or the only one of 2 or 3 numbers. cell_to_point: take vectors of
    cells. diagonal: of grids' cells, "up", "down" or "short". slice: the layer of a grid with
    several. all: keep points flagged as bad. threads, progress, errors: as for ridges().

    >>> import crest
    >>> V, F, vectors = crest.read_vectors("lattice.vtu")
    >>> V.shape == vectors.shape
    True
    """
    raw = run("read_vectors", {
        "path": _path(path), "vectors": str(vectors), "cell_to_point": bool(cell_to_point),
        "diagonal": check.word(diagonal, "diagonal", ("up", "down", "short")),
        "slice": None if slice is None else check.whole(slice, "slice", 0, 10**9),
        "all": bool(all)}, threads, progress)
    return VectorField(raw["V"], raw["F"], raw["vectors"])


def read_volume(path: Any, field: str = "", *, raw: str = "", threads: int = 0,
                progress: Progress = None) -> Volume:
    """A volume or an image from .nrrd .mha .mhd .vti .vtk .nii .mrc .cube .inr .png and others.

    field: of several arrays. raw: "NX,NY,NZ,TYPE" of samples without a header.
    threads, progress, errors: as for ridges().

    >>> import crest
    >>> volume = crest.read_volume("moebius.nrrd")
    >>> volume.samples.ndim, volume.spacing.shape
    (3, (3,))
    """
    got = run("read_volume", {"path": _path(path), "field": str(field), "raw": str(raw)}, threads,
              progress)
    return Volume(got["samples"], np.array(got["spacing"]), np.array(got["origin"]),
                  got["directions"])


def read_points(path: Any, *, threads: int = 0, progress: Progress = None) -> Points:
    """Points with normals from .xyz .pwn .ply .obj .off and others.

    threads, progress, errors: as for ridges().

    >>> import crest
    >>> points, normals = crest.read_points("strip.xyz")
    >>> points.shape == normals.shape
    True
    """
    raw = run("read_points", {"path": _path(path)}, threads, progress)
    return Points(raw["points"], raw["normals"])


class Verdict(NamedTuple):
    """What the checker says of a certificate; true if it is accepted.

    accepted: bool. undecided: bool, rejected only because a number could not be enclosed. claims:
    tuple of str, one each claim proved. reason: str, why not accepted. data_digest: str, of the data
    as recomputed.
    """

    accepted: bool
    undecided: bool
    claims: tuple[str, ...]
    reason: str
    data_digest: str

    def __bool__(self) -> bool:
        return self.accepted


def verify(certificate: Any, *, arithmetic: str = "double",
           mesh: tuple[ArrayLike, ArrayLike] | None = None, threads: int = 0,
           progress: Progress = None) -> Verdict:
    """Checks a certificate with the checker of `crest-verify`, which shares no code with the
    algorithms.

    certificate: bytes, or anything with a buffer of them. arithmetic: "double" (with proven bounds)
    or "mpfr". mesh: V, F that the certificate must speak of; for claims about one mesh.
    threads, progress: as for ridges(). Raises InputError where the claim is of no mesh.

    >>> import crest
    >>> verdict = crest.verify(b"no certificate")
    >>> bool(verdict), verdict.claims
    (False, ())
    """
    arguments: dict[str, Any] = {
        "certificate": check.octets(certificate, "certificate"),
        "arithmetic": check.word(arithmetic, "arithmetic", ("double", "mpfr"))}
    if mesh is not None:
        V, F = mesh
        arguments |= {"V": check.rows(V, "V", 3), "F": check.cells(F, "F", 3)}
    raw = run("verify", arguments, threads, progress)
    return Verdict(raw["accepted"], raw["undecided"], tuple(raw["claims"]), raw["reason"],
                   raw["data_digest"])
