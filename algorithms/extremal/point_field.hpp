// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The pair (s, T) of points with normals: sums of theta(r) = (1 - r^2/R^2)^4, R = 2 h, s = -sum
// theta, T = sum theta n n'. And what is proven of boxes.
#include <unordered_map>
#include <vector>

#include "algorithms/extremal/fields.hpp"

namespace crest::extremal {

class PointField {
 public:
  /// Farther from all points, in h, nothing is looked for: beyond the rim.
  static constexpr double kNear = 0.9;

  /// Unit normals; at least a point. Throws kernel::InputError if h is tiny beside the points'
  /// extent.
  PointField(std::vector<Vec3> points, std::vector<Vec3> normals, double h);

  double h() const { return h_; }
  const std::vector<Vec3>& points() const { return points_; }

  struct Sums {
    Local local;            ///< value: -s
    Vec3 centroid;          ///< weighted
    double nearest;         ///< distance of the nearest point, at most R
    std::size_t count = 0;  ///< points within R
  };
  Sums at(const Vec3& x) const;
  /// 0.47034 h less the part across n of (centroid - x): from 0 on inside the rim.
  double inside(const Sums& sums, const Vec3& x, const Vec3& n) const;

  /// Of all x with |x - centre| <= half in every coordinate. Passed: T passes the cone test for
  /// w, n there is within theta of w.
  struct Box {
    bool passed = false, nonzero = false;  ///< g is not zero
    bool crossed = false;                  ///< passed, and g seems to have both signs
    Vec3 w{};
    double theta = 0;
    bool near = false;       ///< a point is within kNear h of the box
    std::size_t inside = 0;  ///< points in it
  };
  Box box(const Vec3& centre, const Vec3& half) const;
  /// Points within R of a box, for the boxes in it.
  std::vector<Index> within(const Vec3& centre, const Vec3& half) const;
  /// The same from points that are within R, and perhaps others.
  Box box(const Vec3& centre, const Vec3& half, const std::vector<Index>& among) const;
  /// The same; what is not decided by parts, while they are wider than h/6.
  Box box_in_parts(const Vec3& centre, const Vec3& half, const std::vector<Index>& among) const;

 private:
  using Key = std::array<int, 2>;
  struct Hash {
    std::size_t operator()(const Key& k) const {
      return (static_cast<std::size_t>(k[0]) * 73856093U) ^
             (static_cast<std::size_t>(k[1]) * 19349663U);
    }
  };
  Key key(const Vec3& x) const;
  template <class Visit>
  void visit(const Vec3& centre, const Vec3& half, const Visit& f) const;

  double h_, radius_;
  Vec3 low_;                            ///< of the points' box
  std::vector<Vec3> points_, normals_;  ///< by column, R wide, then by z
  std::unordered_map<Key, std::pair<Index, Index>, Hash> columns_;
};

}  // namespace crest::extremal
