# SPDX-License-Identifier: GPL-3.0-or-later
"""What no user should give, and what users do to results."""

import gc
import pickle
import signal
import subprocess
import sys
import threading
import time

import numpy as np
import pytest

import crest

V = np.array([[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]], dtype=float)
F = np.array([[0, 2, 1], [0, 1, 3], [1, 2, 3], [2, 0, 3]])

SURFACES = [crest.ridges, crest.curvature, crest.feature_lines, crest.strips, crest.encode,
            crest.lineart, lambda V, F: crest.reeb_graph(V, F, np.arange(4.0))]


def replaced(array, index, value, kind=None):
    changed = array.astype(kind or array.dtype)
    changed[index] = value
    return changed


BAD = {
    "no points": (np.zeros((0, 3)), F, "V: is empty"),
    "no faces": (V, np.zeros((0, 3), int), "F: is empty"),
    "flat": (V.ravel(), F, "V: has the shape"),
    "two columns": (V[:, :2], F, "V: has the shape"),
    "quadrilaterals": (V, np.zeros((4, 4), int), "F: has the shape"),
    "negative": (V, replaced(F, (2, 1), -1), "F[2]: names vertex -1"),
    "too large": (V, replaced(F, (1, 0), 4), "F[1]: names vertex 4"),
    "huge": (V, replaced(F, (3, 2), 2**32 + 1), "F[3]: names vertex 4294967297"),
    "largest": (V, replaced(F, (3, 2), 2**64 - 1, np.uint64), "F[3]: names vertex"),
    "float faces": (V, F.astype(float), "F: has the type float64"),
    "bool faces": (V, F > 1, "F: has the type bool"),
    "complex": (V + 0j, F, "V: has the type complex128"),
    "words": (V.astype(str), F, "V: has the type"),
    "objects": (V.astype(object), F, "V: has the type object"),
    "long double": (V.astype(np.longdouble), F, "V: has the type float128"),
    "masked": (np.ma.masked_values(V, 1), F, "V: is a masked array"),
    "int64": (replaced(V, (1, 0), 2**60 + 1, np.int64), F, "V[1]"),
    "ragged": ([[0, 0, 0], [1]], F, None),
    "nothing": (None, F, "V: has the type object"),
}


@pytest.mark.parametrize("name", BAD)
@pytest.mark.parametrize("call", SURFACES)
def test_bad_meshes(name, call):
    points, faces, message = BAD[name]
    with pytest.raises((crest.InputError, ValueError)) as error:
        call(points, faces)
    if message:
        assert isinstance(error.value, crest.InputError)
        assert str(error.value).startswith(message) and "\n" not in str(error.value)


@pytest.mark.parametrize("value", [np.nan, np.inf, -np.inf])
@pytest.mark.parametrize("call", SURFACES)
def test_not_finite(value, call):
    with pytest.raises(crest.InputError):
        call(replaced(V, (1, 2), value), F)


def test_not_manifold():
    for faces in (np.vstack([F, F[:1]]), np.vstack([F, F[:1, ::-1]]), replaced(F, (0, 0), 1)):
        for call in (crest.ridges, crest.curvature, crest.feature_lines):
            with pytest.raises(crest.InputError):
                call(V, faces)


def test_options():
    for keywords in ({"rings": 0}, {"rings": 101}, {"scale": -1}, {"scale": "wide"},
                     {"scale": np.nan}, {"smooth": -1}, {"order": 5}, {"umbilic_patch": np.inf},
                     {"rings": 2, "scale": 1}, {"salient": True, "significant": True},
                     {"salient": True, "significance": 0}, {"threads": -1}, {"threads": 10**6},
                     {"min_length": -1}):
        with pytest.raises(crest.InputError):
            crest.ridges(V, F, **keywords)
    for keywords in ({"smooth": 1.5}, {"smooth": True}, {"scale": object()}, {"threads": "two"},
                     {"progress": 3}, {"smoothing": 1}):
        with pytest.raises(TypeError):
            crest.ridges(V, F, **keywords)
    for keywords in ({"angle": 181}, {"angle": "x"}, {"angle": 60, "threshold": 0.5},
                     {"angle": 60, "dilate": 1}, {"over": 2}, {"dilate": 0.5}, {"method": "np"},
                     {"method": "cf", "rings": 2}, {"absolute": True}, {"threshold": 2}):
        with pytest.raises(crest.InputError):
            crest.feature_lines(V, F, **keywords)
    for keywords in ({}, {"surface": "x", "param": ("u", "v", "u")}, {"surface": "x^2 +"},
                     {"surface": "x*x+y*y+z*z-1", "box": (1, -1)}, {"surface": "x", "box": (1, 2, 3)},
                     {"param": ("u", "v"), "domain": (0, 1, 0, 1)},
                     {"param": ("u", "v", "w"), "domain": (0, 1, 0, 1)}):
        with pytest.raises(crest.InputError):
            crest.smooth_ridges(**keywords)
    tensors = np.zeros((4, 6))
    T = [[0, 1, 2, 3]]
    for mode in ((), 1, 2, "1/0", "nan", "1/2/3", "", [0.1, "x"]):
        with pytest.raises(crest.InputError):
            crest.modes(V, T, tensors, mode=mode)
    with pytest.raises(crest.InputError):
        crest.modes(V, T, replaced(tensors, (1, 1), np.nan), neutral=True)
    with pytest.raises(crest.InputError):
        crest.modes(V, [[0, 1, 2, 2]], tensors, neutral=True)
    with pytest.raises(crest.InputError):
        crest.reeb_graph(V, F, [0, 1, 2])
    with pytest.raises(crest.InputError):
        crest.reeb_graph(V, F, [0, 1, 2, np.nan])
    with pytest.raises(crest.InputError):
        crest.reeb_graph(V, F, V[:, 0], midside=np.arange(12.0).reshape(4, 3))


def test_volumes():
    good = np.random.default_rng(2).random((6, 5, 4))
    for volume in (good[:3], np.zeros((4, 4)) + np.nan, np.zeros(64), np.zeros((2, 2, 2, 2)),
                   np.full((4, 4, 4), 2**53 + 1, np.int64), np.full((4, 4, 4), np.inf)):
        with pytest.raises(crest.InputError):
            crest.extremal(volume, ridge=True)
    for keywords in ({"spacing": 0}, {"spacing": (1, 1)}, {"directions": np.eye(2)}, {"refine": 4},
                     {"valley": True}, {"sigma": -1}):
        with pytest.raises(crest.InputError):
            crest.extremal(good, **{"ridge": True, **keywords})
    a = crest.extremal(np.asfortranarray(good), ridge=True)
    assert a.certificate == crest.extremal(good, ridge=True).certificate
    for ray in ([0, 0, 0, 0, 0, 0], [0, 0, 0, np.nan, 0, 0], [np.inf, 0, 0, 1, 0, 0]):
        with pytest.raises(crest.InputError):
            crest.spline_rays(good, 0.5, [ray])
    with pytest.raises(crest.InputError):
        crest.spline_isosurface(good, np.nan)


def test_plane_fields():
    points, faces = [[0, 0], [1, 0], [0, 1]], [[0, 1, 2]]
    for given in ((points, [[0, 2, 1]], [[1, 0]] * 3), (points, faces, [[0, 0]] * 3),
                  (points, faces, [[1, 0]] * 2), (points, faces, [[np.nan, 0]] * 3),
                  ([[0, 0, 0]] * 3, faces, [[1, 0]] * 3)):
        for call in (crest.skeleton, crest.compress):
            with pytest.raises(crest.InputError):
                call(*given)
    good = points, faces, [[1, 0]] * 3
    for given in ({"simplify": 1.5}, {"simplify": -0.1}, {"simplify": np.nan}, {"laplacian": "cotan"},
                  {"simplify": 0.5, "laplacian": "mean"}):
        for call in (crest.skeleton, crest.compress):
            with pytest.raises(crest.InputError):
                call(*good, **given)
    for other in ({"equivalence": "relaxed"}, {"test": "thesis"}):
        with pytest.raises(crest.InputError):
            crest.compress(*good, simplify=0.5, **other)


def test_files(tmp_path):
    for read in (crest.read_mesh, crest.read_field, crest.read_volume, crest.read_tensors,
                 crest.read_vectors, crest.read_points):
        for name in ("none.off", "none.nrrd", "none.xyz", "", "a\nb.off"):
            with pytest.raises(crest.InputError) as error:
                read(tmp_path / name if name else "")
    with pytest.raises(crest.InputError):
        crest.decode(b"")
    with pytest.raises(crest.InputError):
        crest.decode(crest.encode(V, F).stream[:-1])
    with pytest.raises(TypeError):
        crest.decode("words")
    with pytest.raises(TypeError):
        crest.verify(None)
    with pytest.raises(crest.InputError):
        crest.ridges(V, F).save(tmp_path / "no" / "such.vtp")
    with pytest.raises(ValueError):
        crest.curvature(V, F).save(tmp_path / "none.crest")


def test_the_input_may_change(here):
    points, faces = crest.read_mesh("blend.ply")
    expected = crest.ridges(points, faces).certificate
    changing = points.copy(), faces.copy()

    def spoil(_):
        changing[0][:] = np.nan
        changing[1][:] = -1

    assert crest.ridges(*changing, progress=spoil).certificate == expected
    graph = crest.curvature(points, faces)
    points[:] = 0
    assert np.abs(graph.k1).max() > 0


def test_arrays_outlive_results(here):
    graph = crest.ridges(*crest.read_mesh("ellipsoid.off"))
    points, copy = graph.points, graph.points.copy()
    colour = graph.geometry.cell_data["colour"]
    kept = colour.copy()
    del graph
    gc.collect()
    np.random.default_rng(1).random(10**6)
    assert (points == copy).all() and (colour == kept).all()
    points[:] = 1  # theirs to change


def test_pickling(here):
    for result in (crest.ridges(*crest.read_mesh("ellipsoid.off")), crest.encode(V, F),
                   crest.feature_lines(V, F, angle=10), crest.verify(b"")):
        again = pickle.loads(pickle.dumps(result))
        assert type(again) is type(result) and repr(again) == repr(result)
        if hasattr(result, "certificate"):
            assert again.certificate == result.certificate
    with pytest.raises(crest.InputError) as error:
        crest.ridges(V, F[:0])
    assert str(pickle.loads(pickle.dumps(error.value))) == str(error.value)


def test_progress(here):
    mesh = crest.read_mesh("ellipsoid.off")
    steps = []
    crest.ridges(*mesh, progress=steps.append)
    assert "fitting Monge forms" in steps and len(steps) > 2

    class Enough(Exception):
        pass

    def refuse(_):
        raise Enough

    for _ in range(5):
        with pytest.raises(Enough):
            crest.ridges(*mesh, progress=refuse)
    assert crest.ridges(*mesh).certified


def test_other_threads_go_on(here):
    mesh = crest.read_mesh("blend.ply")
    rounds = 0
    done = threading.Event()

    def count():
        nonlocal rounds
        while not done.is_set():
            rounds += 1
            time.sleep(0.001)

    counter = threading.Thread(target=count)
    counter.start()
    crest.ridges(*mesh, scale="auto")
    done.set()
    counter.join()
    assert rounds > 10


INTERRUPTED = """
import crest
V, F = crest.read_mesh("blend.ply")
def begin(_):
    print("go", flush=True)
try:
    {call}
except KeyboardInterrupt:
    print("interrupted", flush=True)
    if {again}:
        raise
"""


SURFACE = "(x^4+y^4+z^4-1)*(x^4+y^4+z^4-1) + 0.3*x*y*z*x*y - 0.01"
LONG = [f"crest.smooth_ridges(surface='{SURFACE}', box=(-3, 3), progress=begin)",  # asks often
        "crest.strips(V, F, effort=100000, progress=begin)"]  # does not


@pytest.mark.parametrize("call", LONG)
@pytest.mark.parametrize("again", [False, True])
def test_interrupt(call, again, here):
    """Of a run of minutes, within a second; caught or not, the process ends soon."""
    child = subprocess.Popen([sys.executable, "-c", INTERRUPTED.format(call=call, again=again)],
                             stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
    assert child.stdout.readline() == "go\n"
    time.sleep(0.5)
    start = time.monotonic()
    child.send_signal(signal.SIGINT)
    while "interrupted" not in (line := child.stdout.readline()):
        assert line, child.stderr.read()
    assert time.monotonic() - start < 1
    child.communicate(timeout=30)
    assert child.returncode == (-signal.SIGINT if again else 0)
