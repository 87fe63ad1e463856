// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Determinants of the eye and of vertices as polynomials in an infinitely small eps (SPEC.md, "The
// perturbation"): their signs, where one vanishes on an edge, and the sign at a point of an edge.
#include <array>
#include <atomic>
#include <cstdint>
#include <optional>

#include "certify/lineart/records.hpp"
#include "kernel/arithmetic/rational.hpp"
#include "kernel/arithmetic/sign.hpp"

namespace crest::certify {

/// Rank of a point in the perturbation: the eye, then the vertices.
using PointId = std::uint32_t;
inline constexpr PointId kEye = 0;
inline PointId id_of(std::uint32_t vertex) {
  return vertex + 1;
}

/// The open edge from a to b, and what is on it.
struct EdgeEnds {
  PointId a, b;
};

/// The point (1 - t) a + t b of an edge, 0 < t < 1.
struct EdgePoint {
  explicit EdgePoint(const kernel::Rational& at);
  kernel::Rational t;
  /// t and 1 - t as doubles, if they are doubles.
  bool short_enough = false;
  double share_b = 0, share_a = 0;
};

class Orientation {
 public:
  explicit Orientation(const LineArtCertificate& c) : c_(c) {}

  /// The 4 x 4 determinant with these rows, perturbed; never zero. Requires: four different points.
  kernel::Sign sign(PointId p, PointId q, PointId r, PointId s) const;
  /// Before perturbation.
  kernel::Sign plain_sign(PointId p, PointId q, PointId r, PointId s) const;

  /// Where on the edge the plane of p, q, r is met in the limit of eps -> 0, from 0 at a to 1 at b.
  /// Requires: a and b on different sides, perturbed.
  kernel::Rational limit(PointId p, PointId q, PointId r, EdgeEnds edge) const;

  /// The side of the plane of p, q, r on which a point of the edge is, perturbed. Nothing if the
  /// first power of eps at which either end's determinant has a coefficient vanishes there.
  std::optional<kernel::Sign> sign_at(PointId p, PointId q, PointId r, EdgeEnds edge,
                                      const EdgePoint& point) const;

  /// Whether the points are seen as one point, before perturbation.
  bool end_on(EdgeEnds edge) const;

  /// Signs that only the perturbation gave.
  std::uint64_t symbolic() const { return symbolic_; }

  const std::array<double, 3>& place(PointId p) const {
    return p == kEye ? c_.eye : c_.points[p - 1];
  }
  /// The last column: 0 for a direction.
  int weight(PointId p) const { return p == kEye && c_.parallel ? 0 : 1; }

 private:
  const LineArtCertificate& c_;
  mutable std::atomic<std::uint64_t> symbolic_{0};
};

}  // namespace crest::certify
