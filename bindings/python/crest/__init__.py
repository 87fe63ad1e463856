# SPDX-License-Identifier: GPL-3.0-or-later
"""Crest: features of surfaces and fields, extracted exactly, with proofs.

Functions take NumPy arrays and return results with named arrays; the proof is in `certificate`,
the same bytes that the program `crest` writes, for `verify()` and `crest-verify`. Names of options
and their defaults are the command line's.
"""

from ._crest import InputError
from ._fields import (CompressedField, CubicSpline, ExtremalSurface, Field, Isosurface, Mesh,
                      ModeSurfaces, Points, RayHits, Skeleton, SplineValues, TensorField,
                      VectorField, Verdict, Volume, compress, extremal, extremal_points, modes,
                      read_field, read_mesh, read_points, read_tensors, read_vectors, read_volume,
                      skeleton, spline_isosurface, spline_rays, spline_samples, spline_values,
                      verify)
from ._results import Cells, Geometry, Result
from ._surfaces import (Curvature, DecodedMesh, Drawing, FeatureGraph, ReebGraph, RidgeGraph, SmoothRidgeGraph,
                        Stream, Strips, Umbilics, curvature, decode, encode, feature_lines, lineart,
                        reeb_graph, ridges, smooth_ridges, strips)
from ._version import __version__

InputError.__module__ = __name__

__all__ = [name for name in dir() if not name.startswith("_")]
