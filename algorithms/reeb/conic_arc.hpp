// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Places on the level lines of one quadratic function.
#include <array>
#include <vector>

#include "kernel/arithmetic/vec3.hpp"

namespace crest::reeb {

using kernel::dot, kernel::Vec2;
using kernel::operator+, kernel::operator-, kernel::operator*;

/// A quadratic function in a face's coordinates (s, t): along its first side and its last.
struct FaceFunction {
  double value, gs, gt;  ///< value and first derivatives at the first corner
  double hss, hst, htt;  ///< second derivatives
  double at(const Vec2& p) const;
  Vec2 gradient(const Vec2& p) const;
};

/// Corners' values and those in the middle of the sides (0 1), (1 2), (2 0).
FaceFunction face_function(const std::array<double, 3>& corner,
                           const std::array<double, 3>& middle);

/// Where a function that is a, m, b at 0, 1/2, 1 takes the value c between two parameters u < v
/// between which it is monotone.
double crossing_parameter(double a, double m, double b, double c, double u, double v);

/// Appends points of the arc of {f = c} from p to q, both ends left out. Of the two arcs of an
/// ellipse it is the one that turns by less than half. At most 2^depth - 1 points; where the arc is
/// straight, none.
/// Source: a chord's midpoint lies on the diameter conjugate to the chord.
void sample_arc(const FaceFunction& f, double c, const Vec2& p, const Vec2& q, int depth,
                std::vector<Vec2>& out);

}  // namespace crest::reeb
