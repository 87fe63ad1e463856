#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Proven ridges of a smooth surface.

    python3 proven_ridges.py [PICTURE]

No mesh: the surface is an expression, and the result is that of the surface itself.
"""

import sys

import crest


def main(picture="proven_ridges.png"):
    graph = crest.smooth_ridges(surface="x^2 + y^2/2.25 + z^2/4 - 1", box=(-3, 3), picture=picture)
    print("proven" if graph.certified else "not proven: " + "; ".join(graph.obstacles))
    colours = [["blue", "red"][c] for c in graph.colour]
    print(f"{len(set(graph.ridge))} ridges: {colours.count('blue')} blue pieces, "
          f"{colours.count('red')} red ones")
    for point, index in zip(graph.umbilics.points, graph.umbilics.index):
        print("umbilic of index {:+g} near ({:+.4f}, {:+.4f}, {:+.4f})".format(index, *point))
    verdict = crest.verify(graph.certificate)
    print(f"accepted, {len(verdict.claims)} claims" if verdict else "REJECTED: " + verdict.reason)


if __name__ == "__main__":
    main(*sys.argv[1:])
