// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Focal surfaces x + s |q| n for q = K or H (paper 001, section 3.2.3 and figures 3.2 to 3.14).
#include "algorithms/curvature/curvature.hpp"

namespace crest::curvature {

enum class Quantity : std::uint8_t { gaussian, mean };

/// Triangles of the focal surface and the polylines of its boundary curves. Points of faces are not
/// shared: over independent triangles the surface is torn at their edges.
struct FocalSurface {
  Quantity quantity = Quantity::mean;
  double scale = 0;  ///< s: length^3 for K, length^2 for H
  std::vector<Vec3> points;
  std::vector<double> values;  ///< q, one a point; the thesis draws q > 0 green, q < 0 red
  std::vector<kernel::Triangle> triangles;
  std::vector<std::vector<Index>> curves;  ///< one closed polyline a face
  std::vector<Index> faces;                ///< the mesh's face behind a triangle
};

/// s such that the 95 % quantile of |q| over the values is displaced by `share` of the bounding
/// box's diagonal; 0 where all values are.
double focal_scale(const kernel::TriangleMesh& mesh, const std::vector<double>& values,
                   double share);

/// Over independent triangles, by the normal-based tensor: each face subdivided `steps` times a
/// side. Where the tensor is not finite the surface touches the mesh (value 0).
FocalSurface focal_of_triangles(const kernel::TriangleMesh& mesh, const std::vector<Vec3>& normals,
                                Quantity quantity, double share, int steps = 4);

/// Over vertex estimates: one triangle a face.
FocalSurface focal_of_vertices(const kernel::TriangleMesh& mesh, const Result& result,
                               Quantity quantity, double share);

/// q of a tensor.
inline double value_of(const PointCurvature& c, Quantity quantity) {
  return quantity == Quantity::gaussian ? c.K : c.H;
}

}  // namespace crest::curvature
