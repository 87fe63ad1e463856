// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Surfaces with known answers, by name.
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "algorithms/sampling/implicit_surface.hpp"

namespace crest::sampling {

/// What is known about the whole surface (a patch with boundary: its mesh).
struct KnownFacts {
  int euler_characteristic = 0;
  int boundary_loops = 0;
  /// Umbilics of index +1/2 and -1/2; nothing where they are not isolated or not known.
  struct Umbilics {
    int plus, minus;
  };
  std::optional<Umbilics> umbilics;
};

/// A surface in its pose: world = rotation * body. Points and forms are in world coordinates.
class Surface {
 public:
  /// How it is meshed: rays from one centre, rays from a core circle, or a patch over a square.
  enum class Shape { star, torus, patch };
  using Rotation = std::array<Point, 3>;  ///< rows

  std::string name;
  KnownFacts known;
  Shape shape = Shape::star;
  std::shared_ptr<const ImplicitSurface> implicit;
  Rotation rotation{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
  Point centre{};        ///< body; the surface is star-shaped from it (star)
  Real size = 1;         ///< radius of the core circle (torus)
  Point reach{1, 1, 1};  ///< rough semi-axes along x, y, z: they share out the points (star)
  Real tube = 0;         ///< mean radius of the tube (torus)
  /// Patch: body point over (u, v) in [-1, 1]^2, on the surface or above the foot of its ray.
  std::function<Point(Real u, Real v)> chart;
  /// Where the ray through a body point starts: inside the surface.
  std::function<Point(const Point& body)> ray_origin;
  /// Replaces what rounding would blur by what symmetry makes exact; may be empty.
  std::function<void(const Point& body, kernel::MongeForm&)> exact;

  Point to_body(const Point& world) const;
  Point to_world(const Point& body) const;
  /// F and grad F (world).
  ValueAndGradient gradient(const Point& world) const;
  /// Onto the surface along the ray through the point.
  Point project(const Point& world) const;
  kernel::MongeForm monge_form(const Vec3& world) const;
};

/// Missing parameters take the defaults of list_surfaces(). With rotate the pose is a fixed generic
/// rotation, else body and world agree.
/// Throws: std::invalid_argument for an unknown name or parameters outside their range.
Surface make_surface(const std::string& name, const std::vector<double>& parameters, bool rotate);

/// One line each: name, parameters with defaults, what it is.
std::vector<std::string> list_surfaces();

/// Three generic rotations that share no symmetry: of the pose, of the mesh, of either in tests.
Surface::Rotation generic_rotation(int which);
Point operator*(const Surface::Rotation& r, const Point& p);

}  // namespace crest::sampling
