# SPDX-License-Identifier: GPL-3.0-or-later
"""Ctrl-C in long steps: the work itself ends, not only the wait for it."""

import signal
import threading
import time

import numpy as np
import pytest

import crest
from crest import _crest


def torus(n):
    """A bumpy torus of 2 n n faces."""
    u, v = np.meshgrid(*2 * [2 * np.pi * np.arange(n) / n], indexing="ij")
    r = 1 + 0.1 * np.sin(5 * u) * np.cos(7 * v)
    V = np.stack([(3 + r * np.cos(v)) * np.cos(u), (3 + r * np.cos(v)) * np.sin(u), r * np.sin(v)],
                 axis=-1).reshape(-1, 3)
    i, j = np.meshgrid(np.arange(n), np.arange(n), indexing="ij")
    a, b = i * n + j, (i + 1) % n * n + j
    c, d = (i + 1) % n * n + (j + 1) % n, i * n + (j + 1) % n
    return V, np.concatenate([np.stack([a, b, c], -1).reshape(-1, 3),
                              np.stack([a, c, d], -1).reshape(-1, 3)])


def plane(n):
    """A grid with random vectors."""
    x, y = np.meshgrid(np.arange(n), np.arange(n), indexing="ij")
    V = np.stack([x, y], -1).reshape(-1, 2).astype(float)
    i, j = np.meshgrid(np.arange(n - 1), np.arange(n - 1), indexing="ij")
    a, b, c, d = i * n + j, (i + 1) * n + j, (i + 1) * n + j + 1, i * n + j + 1
    F = np.concatenate([np.stack([a, b, c], -1).reshape(-1, 3), np.stack([a, c, d], -1).reshape(-1, 3)])
    return V, F, np.random.default_rng(1).normal(size=(n * n, 2))


def block(n):
    """Tetrahedra on a grid of n nodes an axis, with random tensors."""
    ids = np.arange(n**3).reshape(n, n, n)
    corner = {(x, y, z): ids[x:n - 1 + x, y:n - 1 + y, z:n - 1 + z].ravel()
              for x in (0, 1) for y in (0, 1) for z in (0, 1)}
    T = []
    for p in ((0, 1, 2), (1, 2, 0), (2, 0, 1), (1, 0, 2), (0, 2, 1), (2, 1, 0)):
        at, path = [0, 0, 0], [corner[0, 0, 0]]
        for axis in p:
            at[axis] = 1
            path.append(corner[tuple(at)])
        T.append(np.stack(path, -1))
    V = np.stack(np.meshgrid(*3 * [np.arange(n)], indexing="ij"), -1).reshape(-1, 3).astype(float)
    return V, np.concatenate(T), np.random.default_rng(2).normal(size=(n**3, 6))


def noise(n):
    return np.random.default_rng(3).random((n, n, n))


def scattered(n):
    points = np.random.default_rng(4).random((n, 3))
    return points, np.sin(9 * points).sum(axis=1)


def rays(n):
    return np.concatenate([np.tile([-1.0, 20, 20], (n, 1)),
                           np.random.default_rng(5).normal([1, 0, 0], 0.3, (n, 3))], axis=1)


def rough(n):
    V, F = torus(n)
    return V + np.random.default_rng(6).normal(0, 0.01, V.shape), F


# Input and call. Each goes on for many seconds after it is interrupted; most in one step. Where a third is
# given it is interrupted as soon as this step has begun, else a second after the first one.
LONG = {
    "ridges": (lambda: torus(400), lambda x, go: crest.ridges(*x, rings=30, progress=go)),
    "ridges of noise": (lambda: rough(700), lambda x, go: crest.ridges(*x, progress=go)),
    "smooth_ridges": (lambda: "(x^4+y^4+z^4-1)*(x^4+y^4+z^4-1) + 0.3*x*y*z*x*y - 0.01",
                      lambda x, go: crest.smooth_ridges(surface=x, box=(-3, 3), progress=go)),
    "curvature": (lambda: torus(600),
                  lambda x, go: crest.curvature(*x, method="normal-cycle", rings=20, progress=go)),
    "feature_lines": (lambda: torus(700), lambda x, go: crest.feature_lines(
        *x, threshold=0.5, neighbourhood="geodesic", dilate=3, erode=3, progress=go)),
    "reeb_graph": (lambda: rough(1400),
                   lambda x, go: crest.reeb_graph(*x, x[0][:, 2], progress=go)),
    "modes": (lambda: block(26), lambda x, go: crest.modes(*x, mode=0.5, progress=go)),
    "degenerate curves": (lambda: block(40),
                          lambda x, go: crest.modes(*x, degenerate=True, progress=go)),
    "extremal": (lambda: noise(96), lambda x, go: crest.extremal(x, ridge=True, progress=go)),
    "skeleton": (lambda: plane(500), lambda x, go: crest.skeleton(*x, progress=go)),
    "compress": (lambda: plane(40), lambda x, go: crest.compress(*x, progress=go)),
    "spline_isosurface": (lambda: noise(200),
                          lambda x, go: crest.spline_isosurface(x, 0.5, progress=go)),
    "spline_rays": (lambda: (noise(40), rays(3000000)),
                    lambda x, go: crest.spline_rays(x[0], 0.99, x[1], progress=go)),
    "spline_samples": (lambda: scattered(4000000),
                       lambda x, go: crest.spline_samples(*x, progress=go)),
    "lineart": (lambda: torus(200),
                lambda x, go: crest.lineart(*x, width=300, spacing=0.2, progress=go)),
    # The page has 6250 x 6250 pixels: 1.8 GB, which take 0.3 s of processor time to fill.
    "lineart's buffers": (lambda: torus(20), lambda x, go: crest.lineart(
        *x, view=(0, 90), width=750, spacing=8, progress=go), "buffers"),
    "encode": (lambda: torus(1400), lambda x, go: crest.encode(*x, progress=go)),
    "strips": (lambda: torus(100), lambda x, go: crest.strips(*x, effort=100000, progress=go)),
}


@pytest.mark.parametrize("name", LONG)
def test_the_work_ends(name):
    make, call, *rest = LONG[name]
    given, step_wanted = make(), rest[0] if rest else None
    begun = threading.Event()

    def interrupt():
        begun.wait()
        time.sleep(0 if step_wanted else 1)
        signal.raise_signal(signal.SIGINT)

    threading.Thread(target=interrupt, daemon=True).start()
    steps = []

    def go(step):
        steps.append(step)
        if step_wanted in (None, step):
            begun.set()

    with pytest.raises(KeyboardInterrupt):
        call(given, go)
    start = time.process_time()
    assert _crest.wait_for_stopped(30)
    assert time.process_time() - start < (0.1 if step_wanted else 3), steps
