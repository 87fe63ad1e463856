// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Where ridges of one colour seem to cross, touch or be degenerate: zeros of an extremality E at
// which its gradient vanishes, too. There is none on a generic surface, but a plane of symmetry is
// enough for one: it cuts the surface in a ridge, which other ridges cross where its type changes.
// Nothing is proven here; what is found is only left alone and named, as no refinement would do.
#include <memory>
#include <optional>

#include "algorithms/smooth_ridges/surface_point.hpp"
#include "kernel/geometry/ridge_words.hpp"

namespace crest::smooth_ridges {

struct RidgeSingularity {
  Vec3 place;
  kernel::Colour colour;
  double reach;  ///< faces this near are not refined
};

/// Not for two threads at a time.
class SingularityFinder {
 public:
  explicit SingularityFinder(const Surface& surface);
  ~SingularityFinder();
  SingularityFinder(SingularityFinder&&) noexcept;

  /// The common zero of E and grad E to rounding that Newton's method for least squares reaches
  /// from `start` within `size` in space.
  std::optional<SurfacePoint> near(SurfacePoint start, kernel::Colour colour, double size);

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace crest::smooth_ridges
