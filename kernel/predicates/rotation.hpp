// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// How far the direction field turns along an edge: the rule behind the index of a triangle
// (paper 002, section 8.2, made exact; definitions and proofs in certify/SPEC.md, "Index of a
// face").
//
// Directions at a vertex are angles in its fan, scaled to 2 pi at interior vertices (the rescaled
// Levi-Civita connection of Knoeppel, Crane, Pinkall and Schroeder 2013). The rotation along v ->
// w,
//   omega(v, w) = phi(w) - phi(v) - r(v, w) + (0 or pi by the acute rule), taken in (-pi, pi],
// is the field's turn against parallel transport. Only the choice of the multiple of 2 pi is a
// decision; it is certain when the unwrapped number is further from the odd multiples of pi than
// its error.
//
// Laws. (1) omega(w, v) = -omega(v, w). (2) independent of the frames' signs
// (if d1 is parallel to n, phi is 0 or pi by the sign of d1's first non-zero coordinate). (3)
// around a triangle omega and the scaled corner angles sum to pi (1 + twice the index): exactly, so
// a sum known to less than pi gives the index. (4) twice the index is odd iff the product of the
// three acute-rule signs is negative. (5) the indices of a closed mesh sum to its Euler
// characteristic. Not true: that omega is less than 90 degrees (a sharp fold separates the acute
// rule, which is measured in space, from the rotation in the surface).
#include <optional>
#include <span>

#include "kernel/arithmetic/angle.hpp"
#include "kernel/arithmetic/vec3.hpp"
#include "kernel/predicates/ladder.hpp"

namespace crest::kernel {

/// A vertex, its neighbours counter-clockwise, its frame. Interior fans are closed.
struct Star {
  Vec3 centre;
  std::span<const Vec3> ring;
  bool closed;
  Vec3 d1, n;
};

/// The fan's angles in double with a bound on their error.
struct StarAngles {
  double phi = 0;    ///< angle of d1 in the fan, modulo 2 pi
  double error = 0;  ///< bound on the error of phi plus that of any position or scaled corner
  Stage stage = Stage::triage;  ///< interval: double could not bound them, MPFR computed them
};
/// position[k]: angle of neighbour k, from 0; corner[j]: scaled angle of face j.
/// Shapes: position ring.size(), corner ring.size() (one less at the boundary).
StarAngles star_angles(const Star& star, std::span<double> position, std::span<double> corner);

/// omega in (-pi, pi], off by at most the given errors, and who chose the multiple of 2 pi.
struct Rotation {
  double omega;
  Stage stage;
};
/// raw + 2 pi m in (-pi, pi]. Nothing when that is within error of an odd multiple of pi.
inline std::optional<double> triage_rotation(double raw, double error) {
  const double omega = raw - 2 * kPi * std::floor((raw + kPi) / (2 * kPi));
  if (!(std::fabs(omega) < kPi - (error + 1e-12))) return std::nullopt;
  return omega;
}

/// An edge v -> w from its lower to its higher vertex: w is neighbour at_v of v's star, v neighbour
/// at_w of w's. reversed: the acute rule is negative.
struct EdgeStars {
  Star v, w;
  std::size_t at_v, at_w;
  bool reversed;
};
/// MPFR intervals of 256 bits. Nothing within 2^-200 of an odd multiple of pi: a tie.
std::optional<double> interval_rotation(const EdgeStars& edge);
/// The tie: +pi for the edge from its lower to its higher vertex.
inline double symbolic_rotation() {
  return kPi;
}

}  // namespace crest::kernel
