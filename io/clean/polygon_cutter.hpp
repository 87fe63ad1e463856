// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Polygons cut into triangles by one rule for all formats. Own code: a rule that can be stated in a
// few sentences, does not depend on where a polygon begins, and never fails (CGAL's refuse corners
// that are not plane, straight or cross themselves, or leave the choice among equals to their
// algorithm).
#include <array>
#include <set>
#include <span>
#include <tuple>
#include <vector>

#include "io/clean/edge_set.hpp"
#include "kernel/arithmetic/vec3.hpp"

namespace crest::io {

/// The rule: of all ears the one with the shortest diagonal is cut off, again and again; of equal
/// ones (as doubles) that of the lower-numbered tip. A tip with its two neighbours is an ear if,
/// seen along the coordinate axis closest to the polygon's normal (Newell's), it turns left and no
/// corner lies in the triangle or on it, those at the triangle's corners excepted; both are decided
/// exactly. An ear whose diagonal is an edge of the surface already waits until there is no other,
/// lest two polygons with two common corners make an edge of four faces. Without an ear (the
/// polygon crosses itself, or is straight) every tip counts as one. For four corners that is: the
/// shorter diagonal, unless it folds the quadrilateral.
class PolygonCutter {
 public:
  using Local = std::array<std::size_t, 3>;  ///< positions in the polygon, as it runs

  /// Shapes: n corners, their numbers in the file; n - 2 triangles, none for n < 3. The diagonals
  /// join `edges`. Requires: finite corners. Cost: O(n log n) but for corners that are close to
  /// many triangles; O(n^2) at worst.
  const std::vector<Local>& cut(std::span<const kernel::Vec3> corners,
                                std::span<const kernel::Index> numbers, EdgeSet& edges);

 private:
  enum Rank : int { kEar, kEarOnEdge, kNoEar };
  using Key = std::tuple<int, double, kernel::Index, std::size_t>;  ///< rank, diagonal, number, tip

  void project();
  int turn(std::size_t a, std::size_t b, std::size_t c) const;
  Key key(std::size_t tip) const;
  int rank_of_ear(std::size_t tip) const;
  bool covers(const Local& triangle, std::size_t w) const;
  void cut_quadrilateral();
  void start();
  void judge(std::size_t tip);
  std::size_t blocker(std::size_t tip) const;
  void remove(std::size_t tip);

  std::span<const kernel::Vec3> corners_;
  std::span<const kernel::Index> numbers_;
  const EdgeSet* edges_ = nullptr;
  std::array<std::size_t, 2> axes_{};  ///< the plane seen, counter-clockwise
  std::vector<Local> triangles_;
  std::vector<std::size_t> next_, before_;
  std::vector<std::vector<std::size_t>> blocked_;      ///< tips that wait for this corner
  std::set<std::pair<double, std::size_t>> not_left_;  ///< corners that do not turn left, by place
  std::vector<int> rank_;
  std::set<Key> tips_;
};

}  // namespace crest::io
