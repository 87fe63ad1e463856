#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Crest lines of a scan.

    python3 crest_lines.py [MESH [PICTURE]]

Fits, marks what stands out of the errors of the fit, and draws it. The certificate speaks of the
whole graph, of which most is noise on a scan.
"""

import sys

import numpy as np

import crest


def main(mesh="horse.ply", picture="crest_lines.png"):
    V, F = crest.read_mesh(mesh, outward=True)
    graph = crest.ridges(V, F, scale="auto", picture=picture)
    print(f"{len(V)} vertices, {len(F)} faces")
    print(f"{len(graph.colour)} ridges, {len(graph.umbilics)} umbilics, "
          f"whose indices sum to {graph.index_sum:g}")
    salient = crest.ridges(V, F, scale="auto", salient=True)
    longest = np.argsort(-salient.length)[:3]
    print(f"{len(salient.colour)} salient pieces; the longest: "
          + ", ".join(f"{salient.length[i]:.3g}" for i in longest))
    print("accepted" if crest.verify(graph.certificate, mesh=(V, F)) else "REJECTED")


if __name__ == "__main__":
    main(*sys.argv[1:])
