// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// How important zeros and separatrices are (paper 001, sections 5.5.1 to 5.5.3).
//
// As v(x, t) = (1 - t) v + t v_s goes over to a smoothed field v_s, zeros move and meet: two that
// vanish at one time are partners, and that time is their weight; 1 if a zero reaches t = 1. Along
// an edge det(v_i(t), v_j(t)) is quadratic in t, so a zero crosses it at a root where both are
// opposite; between two such events it stays in one triangle. Partners follow from the order of
// roots alone, exactly. Then weights rise until they agree: partners have one weight, separatrices
// the weight of the saddle they start at (1 from switch points), and no zero weighs less than what
// ends there. These rules are monotone: their least fixed point is unique.
#include <optional>

#include "algorithms/vector_fields/skeleton_result.hpp"

namespace crest::vector_fields {

enum class Laplacian : std::uint8_t { uniform, cotan };

/// What a zero becomes.
enum class PathEnd : std::uint8_t {
  partner,  ///< meets its partner
  stays,    ///< is there at t = 1
  open      ///< not inside a triangle, or its path meets a tie: nothing is said, it weighs 1
};

/// A place on a zero's path: where it crosses an edge, and when.
struct PathPoint {
  Vec2 point;
  double time = 0;
};

struct ZeroWeight {
  PathEnd end = PathEnd::open;
  Index partner = kNone;
  double first = 1;   ///< the largest time of its path
  double weight = 1;  ///< after the rules
  std::vector<PathPoint> path = {};
};

struct Importance {
  std::vector<ZeroWeight> zeros;
  std::vector<double> separatrices;
  std::size_t pairs = 0, staying = 0, open = 0;
};

/// The field with the same vectors at the boundary (walls and zero regions, too), elsewhere each
/// the mean of its neighbours, evenly or by cotangents. Throws: std::runtime_error if the system
/// cannot be solved (cotangents of flat triangles).
std::vector<Vec2> smoothed(const PlanarField& field, Laplacian laplacian = Laplacian::uniform);

/// (1 - t) v + t v_s.
PlanarField blended(const PlanarField& field, const std::vector<Vec2>& smooth, double t);

/// Guarantees: partners are mutual, of opposite index; at each threshold the indices of the zeros
/// with at least that weight have one sum. Requires: the skeleton is that of the field.
Importance weigh(const PlanarField& field, const std::vector<Vec2>& smooth,
                 const Skeleton& skeleton);

/// The zeros and separatrices with at least this weight.
Skeleton important_part(const Skeleton& skeleton, const Importance& importance, double least);

}  // namespace crest::vector_fields
