// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The order in which separatrices arrive at their ends. Lines do not cross, so which of two is at
// the left stays the same as long as they leave triangles by the same sides; where they are too
// near to be told apart the order is inherited from where they came together.
#include <cmath>
#include <vector>

#include "algorithms/vector_fields/boundary.hpp"
#include "algorithms/vector_fields/quick_line.hpp"

namespace crest::vector_fields {

/// So near, in shares of a side, places do not tell the order.
inline constexpr double kNearLine = 0x1p-33;

/// One line at an end: the slots stand in a row or a circle, within a slot lines leave by one
/// half-edge, the step `last`.
struct Arrival {
  Index line = kNone, slot = 0;
  const std::vector<Step>* steps = nullptr;
  std::size_t last = 0;
  /// Where it starts: at a zero, or on a side (a corner) of the boundary.
  std::optional<Vec2> zero = {};
  HalfEdge side = kNone;
};

template <class Mesh>
Vec2 place_on(const Mesh& mesh, const Step& step) {
  const Vec2 &p = mesh.point(mesh.from(step.exit)), &q = mesh.point(mesh.to(step.exit));
  return {p[0] + step.share * (q[0] - p[0]), p[1] + step.share * (q[1] - p[1])};
}

/// The same of a line a that starts in a triangle and one that enters it; `exit`: how both leave.
template <class Mesh>
int left_of_passing(const Mesh& mesh, const Arrival& a, const Step& entry, HalfEdge exit) {
  if (a.zero) {
    // Its ray is on a line that nothing crosses.
    using kernel::operator-;
    const double turn =
        kernel::cross(place_on(mesh, a.steps->front()) - *a.zero, place_on(mesh, entry) - *a.zero);
    return turn > 0 ? -1 : turn < 0 ? 1 : 0;
  }
  const Index offset = (mesh.twin(entry.exit) % 3 + 3 - exit % 3) % 3;
  if (a.side == kNone || offset == 0) return 0;
  return offset == 1 ? -1 : 1;
}

/// Whether a is at the left of b (1), at its right (-1), or too near (0). Requires: the last steps
/// leave by the same half-edge. `inherited` counts those that their last places do not decide.
template <class Mesh>
int left_of(const Mesh& mesh, const Arrival& a, const Arrival& b, std::size_t& inherited) {
  std::size_t i = a.last, k = b.last;
  if (a.steps->empty() || b.steps->empty()) return 0;
  for (bool first = true;; first = false, --i, --k) {
    const Step &s = (*a.steps)[i], &t = (*b.steps)[k];
    if (std::fabs(s.share - t.share) > kNearLine) {
      inherited += first ? 0 : 1;
      return s.share > t.share ? 1 : -1;
    }
    if (i == 0 && k == 0) return 0;
    if (i == 0) return left_of_passing(mesh, a, (*b.steps)[k - 1], s.exit);
    if (k == 0) return -left_of_passing(mesh, b, (*a.steps)[i - 1], s.exit);
    const Step &before_s = (*a.steps)[i - 1], &before_t = (*b.steps)[k - 1];
    if (before_s.exit == before_t.exit) continue;
    ++inherited;
    // From other sides: from the next one at the left, from the last one at the right, and what
    // turns back keeps all others on the other side of where it came in.
    const auto offset = [&](const Step& before) {
      return (mesh.twin(before.exit) % 3 + 3 - s.exit % 3) % 3;
    };
    const auto turned_left = [](const Step& before, const Step& now) {
      return now.share > 1 - before.share ? 1 : -1;
    };
    const Index u = offset(before_s), v = offset(before_t);
    if (u == 0) return turned_left(before_s, s);
    if (v == 0) return -turned_left(before_t, t);
    return u == 1 ? 1 : -1;
  }
}

/// Whether the lines, as they are given, stand in the order of their slots, within a slot from left
/// to right (or from right to left); cyclic: from any of them on. Nothing if two are too near.
template <class Mesh>
std::optional<bool> in_order(const Mesh& mesh, const std::vector<Arrival>& lines, bool cyclic,
                             bool leftmost_first, std::size_t& inherited) {
  const std::size_t n = lines.size();
  if (n < 2 || (cyclic && n < 3)) return true;
  std::size_t descents = 0;
  for (std::size_t i = 0; i + (cyclic ? 0 : 1) < n; ++i) {
    const Arrival &a = lines[i], &b = lines[(i + 1) % n];
    if (a.slot != b.slot) {
      descents += a.slot > b.slot ? 1 : 0;
      continue;
    }
    const int left = left_of(mesh, a, b, inherited);
    if (left == 0) return std::nullopt;
    descents += (left > 0) == leftmost_first ? 0 : 1;
  }
  return descents <= (cyclic ? 1U : 0U);
}

/// Puts the lines into that order. Nothing if two are too near.
template <class Mesh>
bool sort_arrivals(const Mesh& mesh, std::vector<Arrival>& lines, bool leftmost_first,
                   std::size_t& inherited) {
  std::vector<Arrival> sorted;
  for (const Arrival& a : lines) {
    std::size_t low = 0, high = sorted.size();
    while (low < high) {
      const std::size_t middle = (low + high) / 2;
      const Arrival& b = sorted[middle];
      bool before = a.slot < b.slot;
      if (a.slot == b.slot) {
        const int left = left_of(mesh, a, b, inherited);
        if (left == 0) return false;
        before = (left > 0) == leftmost_first;
      }
      if (before)
        high = middle;
      else
        low = middle + 1;
    }
    sorted.insert(sorted.begin() + static_cast<std::ptrdiff_t>(low), a);
  }
  lines = std::move(sorted);
  return true;
}

/// Regions of the boundary, by the ordinals of its edges along the loops.
class RegionSlots {
 public:
  explicit RegionSlots(const Boundary& boundary);
  Index count() const { return static_cast<Index>(start_.size()); }
  /// Whether the region is a whole loop.
  bool cyclic(Index region) const { return cyclic_[region] != 0; }
  /// From the region's start on.
  Index slot(Index region, Index ordinal) const {
    const Index first = first_[region], length = length_[region];
    return (ordinal - first + length - start_[region]) % length;
  }

 private:
  std::vector<Index> first_, length_, start_;  ///< of the loop; start of the region within it
  std::vector<std::uint8_t> cyclic_;
};

}  // namespace crest::vector_fields
