// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The region of the sphere of medium eigenvectors that is a tet's mode surfaces (paper 004, section
// 5.2), bounded by the curves of the tet's faces and by arcs of the complex domain's boundary.
#include <array>
#include <optional>
#include <vector>

#include "algorithms/modes/modes.hpp"
#include "algorithms/modes/sphere.hpp"

namespace crest::experiments {

using kernel::Vec3;

/// One tet with a linear field on it.
struct TetField {
  std::array<Vec3, 4> corners;
  modes::LinearTensors field;
  double mu;

  Vec3 at(const std::array<double, 4>& weights) const;
  /// Which of the two points of +-v a point of the sphere stands for: the one whose dominant
  /// eigenvector is turned anticlockwise about v. Nothing in the complex domain.
  std::optional<modes::ModePoint> point(const Vec3& v) const;
  /// The same where it lies in the tet.
  std::optional<modes::ModePoint> point_inside(const Vec3& v) const;
  /// Of a point of the surface, by its tensor and the sign of its mode.
  Vec3 on_sphere(const modes::Tensor& tensor, int sign) const;
};

struct SphereRegion {
  static constexpr std::size_t kNone = ~std::size_t{0};
  struct Point {
    Vec3 v, place;
    int sign;                  ///< of the mode
    std::size_t twin = kNone;  ///< the antipode that stands for the same point of the surface
  };
  using Edge = std::array<std::size_t, 2>;
  std::vector<Point> points;
  std::vector<Edge> face_curves, arcs;  ///< between points
  std::size_t crossings = 0;            ///< of the curves with the complex domain

  /// Points of closed lines that curves and arcs make; empty if they make none.
  std::vector<std::vector<std::size_t>> loops() const;
};

/// Nothing if an arc's end is not where a curve ends. Requires: a mode below mu*, so that each part
/// of the complex domain's boundary goes around one irregular point.
std::optional<SphereRegion> sphere_region(const TetField& tet,
                                          const std::vector<modes::ModeSurface>& surfaces);

struct Tessellation {
  std::vector<SphereRegion::Point> points;
  std::vector<std::array<std::size_t, 3>> triangles;
  std::size_t grid_points = 0;
};

/// The constrained Delaunay triangulation of the region in a stereographic projection, with the
/// points of a `steps` x `steps` quad grid (equation 14 corrected) that lie in it. Nothing if its
/// loops are not simple or not nested.
std::optional<Tessellation> tessellate(const TetField& tet, const SphereRegion& region, int steps);

/// Of the tessellation with twins glued.
long euler_characteristic(const Tessellation& t);

}  // namespace crest::experiments
