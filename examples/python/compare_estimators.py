#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Compare estimators of curvature where the answer is known.

    python3 compare_estimators.py [MESH [PICTURE]]

The mesh is one of `crest sample ellipsoid --parameters 1,1.5,2`; the exact curvatures of the ellipsoid
at its vertices come from its equation.
"""

import sys

import numpy as np

import crest


def exact(V, axes=(1, 1.5, 2)):
    """Mean and Gaussian curvature of x^2/a^2 + y^2/b^2 + z^2/c^2 = 1 at points of it, convex ones
    negative."""
    squares = np.square(axes)
    h = 1 / np.sqrt((V**2 / squares**2).sum(axis=1))
    K = h**4 / squares.prod()
    H = -h**3 * (squares.sum() - (V**2).sum(axis=1)) / (2 * squares.prod())
    return H, K


def main(mesh="ellipsoid.off", picture="compare_estimators.png"):
    V, F = crest.read_mesh(mesh)
    H, K = exact(V)
    print("method        |H error|, median   worst     |K error|, median   worst")
    for method in ("ne", "cf", "qf", "qt", "jet", "normal-cycle"):
        c = crest.curvature(V, F, method=method)
        errors = [np.abs(c.H - H) / np.abs(H), np.abs(c.K - K) / K]
        numbers = [f(e) for e in errors for f in (np.median, np.max)]
        print("{:13} {:16.2%} {:8.2%} {:18.2%} {:8.2%}".format(method, *numbers))
    crest.curvature(V, F, method="jet", colour="K", picture=picture)


if __name__ == "__main__":
    main(*sys.argv[1:])
