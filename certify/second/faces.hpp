// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// SPEC.md, "Faces outside patches" (theorem 9), the chart conditions of a face, and the part of a
// patch's condition 1 that is said of its faces; their strings in "Witnesses".
#include <optional>

#include "certify/second/face_sample.hpp"

namespace crest::recheck {

/// By colour and corner or side.
template <class T>
using BySide = std::array<std::array<T, 3>, 2>;

/// What is proven of a face; all but the last three outside patches.
struct FaceOutcome {
  BySide<int> sign{};      ///< of E_j at corner i, in the frame of w; 0 for verdict 255
  BySide<bool> decided{};  ///< side i, by this face's witness
  BySide<int> slope{};     ///< of E_j along a side decided by its derivative
  int order = 3;           ///< kind 0, also in patches: of the root of its division
  int c = 0;               ///< kind 0, also in patches: of its h
  std::optional<std::array<Interval, 3>> image;  ///< kind 0, also in patches: a box around it
  bool crossed(std::size_t colour, Index side) const {
    return sign[colour][side] * sign[colour][(side + 1) % 3] < 0;
  }
};

/// The vertex that the claim marks as loose, by colour, or none.
class LooseCorners {
 public:
  explicit LooseCorners(const Problem& problem);
  bool at(std::size_t colour, std::uint32_t vertex) const;
  const std::vector<std::uint32_t>& of(std::size_t colour) const { return vertices_[colour]; }

 private:
  std::array<std::vector<std::uint32_t>, 2> vertices_;
};

/// Proves everything that is said of the face alone.
/// Throws: Rejected, Open, Undefined.
FaceOutcome check_face(const Problem& problem, const LooseCorners& loose, Index face);

/// Types of a ridge and of a crossing.
constexpr int kElliptic = 1, kHyperbolic = 2;
constexpr int kTriangleDepth = 8, kSegmentDepth = 12;
/// How much further than its witness this checker divides where its enclosures are weaker.
constexpr int kFurther = 3;

}  // namespace crest::recheck
