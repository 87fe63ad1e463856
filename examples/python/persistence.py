#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Persistence of a field: how many features of it are left as small ones are cancelled.

    python3 persistence.py [MESH [PICTURE]]

The field is the height above a plane with some noise: most of its extrema are the noise's.
"""

import sys

import numpy as np

import crest


def main(mesh="blend.ply", picture="persistence.svg"):
    V, F = crest.read_mesh(mesh)
    noise = np.random.default_rng(1).normal(size=len(V))
    height = V @ [0.2, 0.1, 1] + 0.02 * np.ptp(V) * noise
    span = np.ptp(height)
    print("persistence  nodes  arcs  loops")
    for share in (0, 0.02, 0.05, 0.1, 0.2, 0.4):
        graph = crest.reeb_graph(V, F, height, persistence=share * span, certificate=False)
        print(f"{share:11.0%} {len(graph.node_values):6} {len(graph.arcs):5} {graph.loops:6}")
    graph = crest.reeb_graph(V, F, height, persistence=0.02 * span, picture=picture)
    print("accepted" if crest.verify(graph.certificate) else "REJECTED")


if __name__ == "__main__":
    main(*sys.argv[1:])
