// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Ridges of a smooth surface as drawn, written and measured.
#include <algorithm>
#include <cmath>
#include <vector>

#include "algorithms/smooth_ridges/smooth_ridges_result.hpp"

namespace crest::io {

/// The types of a ridge's segments, also in patches: the piece of a ridge in a patch has no turning
/// point (certify/ridges_smooth/SPEC.md, theorem 10), so its type is the one in which the face
/// beside it ends, and types flip at faces with a turning point. none: where no face tells.
inline std::vector<smooth_ridges::RidgeType> drawn_types(const smooth_ridges::SmoothRidge& ridge) {
  using smooth_ridges::RidgeType;
  std::vector<RidgeType> types = ridge.types;
  const auto flip = [](RidgeType t) {
    return t == RidgeType::elliptic ? RidgeType::hyperbolic : RidgeType::elliptic;
  };
  const auto fill = [&](auto first, auto last) {
    if (first == last || *first != RidgeType::none) return;
    const auto outside =
        std::find_if(first, last, [](RidgeType t) { return t != RidgeType::none; });
    const auto typed = std::find_if(outside, last, [](RidgeType t) {
      return t == RidgeType::elliptic || t == RidgeType::hyperbolic;
    });
    if (typed == last || std::find(outside, typed, RidgeType::none) != typed) return;
    std::fill(first, outside, (typed - outside) % 2 == 0 ? *typed : flip(*typed));
  };
  if (ridge.loop) return types;
  fill(types.begin(), types.end());
  fill(types.rbegin(), types.rend());
  return types;
}

/// A part of a ridge of one type: numbers of the ridge's points, in order.
struct RidgeRun {
  smooth_ridges::RidgeType type;
  std::vector<std::size_t> points;
};

/// As few as possible: those of a loop start where its type changes; a loop of one type is one run
/// that ends with the point it starts with. A ridge of one point is a run of one.
inline std::vector<RidgeRun> runs_of(const smooth_ridges::SmoothRidge& ridge) {
  const std::vector<smooth_ridges::RidgeType> types = drawn_types(ridge);
  const std::size_t segments = types.size(), n = ridge.points.size();
  std::size_t start = 0;
  for (std::size_t i = 0; ridge.loop && i < segments; ++i) {
    if (types[i] == types[(i + segments - 1) % segments]) continue;
    start = i;
    break;
  }
  std::vector<RidgeRun> runs;
  if (segments == 0 && n == 1) runs.push_back({smooth_ridges::RidgeType::none, {0}});
  for (std::size_t i = 0; i < segments; ++i) {
    const std::size_t k = (start + i) % segments;
    if (runs.empty() || runs.back().type != types[k]) runs.push_back({types[k], {k}});
    runs.back().points.push_back((k + 1) % n);
  }
  return runs;
}

inline double length_of(const smooth_ridges::SmoothRidge& ridge, std::size_t p, std::size_t q) {
  const kernel::Vec3 &a = ridge.points[p], &b = ridge.points[q];
  return std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]);
}

/// What a ridge's end rests on: 0 nothing (a loop; an uncertified result also where a ridge runs
/// into a face that is not certified, or over the boundary), 1 an umbilic, 2 the boundary.
inline int end_kind(const smooth_ridges::SmoothRidges& result,
                    const smooth_ridges::SmoothRidge& ridge, std::size_t end) {
  if (ridge.ends[end] != kernel::kNone) return 1;
  return !ridge.loop && result.certified && result.boundary_loops > 0 ? 2 : 0;
}

/// Ends that are neither umbilic nor boundary.
inline std::size_t open_ends(const smooth_ridges::SmoothRidges& result) {
  std::size_t count = 0;
  for (const smooth_ridges::SmoothRidge& ridge : result.ridges)
    for (const std::size_t end : {0u, 1u})
      count += !ridge.loop && end_kind(result, ridge, end) == 0 ? 1 : 0;
  return count;
}

/// The faces of the triangulation that are not certified: those whose middle is the nearest to that
/// of an undecided cell, within its size. Shapes: F.
std::vector<bool> undecided_faces(const smooth_ridges::SmoothRidges& result);

}  // namespace crest::io
