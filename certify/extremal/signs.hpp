// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// n at a point, and the signs of n . v and of n^T H n there: doubles, then rationals (SPEC.md,
// "Signs").
#include <functional>

#include "certify/extremal/edge_net.hpp"

namespace crest::certify::extremal {

/// A vector near n of this matrix (xx yy zz xy yz xz), or any other: a guess.
Vec likely_direction(const std::array<double, 6>& t);

/// A representative of n, known up to a small angle.
struct Direction {
  Frame frame;
  Cone cone;
};
/// Throws Undecided if lambda1 is not certainly simple.
Direction direction_at(const Matrices<1>& t);

/// 1 or -1: n oriented by that vector, which is no further from it than the chord, points like n
/// oriented by w, or not. Requires: w is within 45 degrees of +-n. Throws Undecided.
int orientation(const Vec& near, double chord, const Vec& w);

/// A symmetric matrix, exactly: xx yy zz xy yz xz.
using ExactMatrix = std::array<kernel::Rational, 6>;
using ExactVector = std::array<kernel::Rational, 3>;

/// Is n . v zero? Requires: lambda1 of T is simple.
bool vanishes(const ExactMatrix& t, const ExactVector& v);
/// Is n^T M n zero? Requires: the cone test holds for w.
bool vanishes(const ExactMatrix& t, const ExactVector& w, const ExactMatrix& m);
/// The sign of the trace of adj(lambda1 I - T) M, a positive multiple of n^T M n, which must not be
/// zero. Requires: the cone test holds for w. Throws Undecided after 2^-1000.
int sign_at(const ExactMatrix& t, const ExactVector& w, const ExactMatrix& m);

/// The sign of n . grad (s + e x + e^2 y + e^3 z), n oriented by the direction's w; never 0.
/// `exact` makes the same point's fields, where doubles do not decide.
struct ExactPoint {
  ExactMatrix t;
  ExactVector v;
};
int perturbed_sign(const Direction& direction, const Vectors<1>& v,
                   const std::function<ExactPoint()>& exact);

}  // namespace crest::certify::extremal
