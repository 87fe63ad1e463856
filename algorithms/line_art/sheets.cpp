// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/line_art/sheets.hpp"

#include <tbb/blocked_range.h>

#include <algorithm>
#include <cmath>

#include "kernel/geometry/parallel.hpp"

namespace crest::line_art {
namespace {

using kernel::Sign, kernel::Sight;

bool has(const Triangle& f, Index v) {
  return f[0] == v || f[1] == v || f[2] == v;
}

/// Exact answers about the faces of a scene.
class Meeting {
 public:
  explicit Meeting(const Scene& scene)
      : scene_(scene),
        along_{Sight({{1, 0, 0}}, scene.points), Sight({{0, 1, 0}}, scene.points),
               Sight({{0, 0, 1}}, scene.points)} {
    for (const Triangle& f : scene.faces) {
      std::uint8_t k = 0;
      while (k < 3 && along_[k].flat_side(f[0], f[1], f[2]) == Sign::zero) ++k;
      axis_.push_back(k);
    }
  }

  /// Has it no area.
  bool flat(Index face) const { return axis_[face] == 3; }

  /// Requires: neither is flat.
  bool meet(Index face, Index other) const {
    const Triangle &f = scene_.faces[face], &g = scene_.faces[other];
    std::array<Index, 3> common{};
    std::size_t shared = 0;
    for (const Index v : f)
      if (has(g, v)) common[shared++] = v;
    if (shared == 3) return true;
    if (shared == 2) return folded(common[0], common[1], face, g);
    if (shared == 0 && (beside(f, g) || beside(g, f))) return false;
    // If they meet elsewhere, a side of one that does not have the common vertex meets the other.
    return sides_meet(f, other) || sides_meet(g, face);
  }

 private:
  Sign volume(const Triangle& f, Index v) const {
    return along_[0].flat_volume(f[0], f[1], f[2], v);
  }

  /// Seen along it the face has an area.
  const Sight& axis_of(Index face) const { return along_[axis_[face]]; }

  /// Are all corners of g strictly on one side of f.
  bool beside(const Triangle& f, const Triangle& g) const {
    const Sign first = volume(f, g[0]);
    return first != Sign::zero && volume(f, g[1]) == first && volume(f, g[2]) == first;
  }

  /// Two faces at an edge: in one plane, on one side of it.
  bool folded(Index a, Index b, Index face, const Triangle& g) const {
    const Triangle& f = scene_.faces[face];
    const auto apex = [&](const Triangle& t) {
      return *std::find_if(t.begin(), t.end(), [&](Index v) { return v != a && v != b; });
    };
    if (volume(f, apex(g)) != Sign::zero) return false;
    const Sight& axis = axis_of(face);
    return axis.flat_side(a, b, apex(f)) == axis.flat_side(a, b, apex(g));
  }

  bool sides_meet(const Triangle& f, Index face) const {
    for (std::size_t k = 0; k < 3; ++k) {
      const Index p = f[k], q = f[(k + 1) % 3];
      const Triangle& g = scene_.faces[face];
      if (!has(g, p) && !has(g, q) && side_meets(p, q, face)) return true;
    }
    return false;
  }

  /// A segment and a triangle, both closed, without a common vertex.
  bool side_meets(Index p, Index q, Index face) const {
    const Triangle& f = scene_.faces[face];
    const Sign at_p = volume(f, p), at_q = volume(f, q);
    if (at_p == Sign::zero && at_q == Sign::zero) return meets_in_plane(p, q, face);
    if (at_p == at_q) return false;
    bool positive = false, negative = false;
    for (std::size_t k = 0; k < 3; ++k) {
      const Sign turn = along_[0].flat_volume(p, q, f[k], f[(k + 1) % 3]);
      positive = positive || turn == Sign::positive;
      negative = negative || turn == Sign::negative;
    }
    return !(positive && negative);
  }

  /// Convex sets of a plane are apart iff a line along a side of one lies strictly between them.
  bool meets_in_plane(Index p, Index q, Index face) const {
    const Triangle& f = scene_.faces[face];
    const Sight& axis = axis_of(face);
    const Sign first = axis.flat_side(p, q, f[0]);
    if (first != Sign::zero && axis.flat_side(p, q, f[1]) == first &&
        axis.flat_side(p, q, f[2]) == first)
      return false;
    for (std::size_t k = 0; k < 3; ++k) {
      const Index a = f[k], b = f[(k + 1) % 3];
      const Sign outside = -axis.flat_side(a, b, f[(k + 2) % 3]);
      if (axis.flat_side(a, b, p) == outside && axis.flat_side(a, b, q) == outside) return false;
    }
    return true;
  }

  const Scene& scene_;
  std::array<Sight, 3> along_;      ///< seen along the axes: orientations of projections
  std::vector<std::uint8_t> axis_;  ///< along which a face has an area; 3: none
};

struct Box {
  Vec3 low, high;
  void add(const Vec3& p) {
    for (std::size_t k = 0; k < 3; ++k) {
      low[k] = std::min(low[k], p[k]);
      high[k] = std::max(high[k], p[k]);
    }
  }
  bool meets(const Box& o) const {
    for (std::size_t k = 0; k < 3; ++k)
      if (low[k] > o.high[k] || o.low[k] > high[k]) return false;
    return true;
  }
};

/// Faces by cubes that their boxes reach.
class CubeLists {
 public:
  explicit CubeLists(const Scene& scene) {
    Box all{scene.points.front(), scene.points.front()};
    double size = 0;
    for (const Triangle& f : scene.faces) {
      Box box{scene.points[f[0]], scene.points[f[0]]};
      for (const Index v : f) box.add(scene.points[v]);
      for (const Vec3& p : {box.low, box.high}) all.add(p);
      for (std::size_t k = 0; k < 3; ++k)
        size += (box.high[k] / 3 - box.low[k] / 3) / static_cast<double>(scene.faces.size());
      boxes.push_back(box);
    }
    low_ = all.low;
    for (std::size_t k = 0; k < 3; ++k) size = std::max(size, all.high[k] / 256 - all.low[k] / 256);
    cell_ = size > 0 ? size : 1;
    // Large faces among small ones would fill too many cubes.
    double filled = HUGE_VAL;
    while (filled > 32 * static_cast<double>(boxes.size())) {
      cell_ *= 2;
      filled = 0;
      for (const Box& box : boxes) {
        double cubes = 1;
        for (std::size_t k = 0; k < 3; ++k)
          cubes *= static_cast<double>(place(box.high[k], k) - place(box.low[k], k) + 1);
        filled += cubes;
      }
    }
    for (std::size_t k = 0; k < 3; ++k) count_[k] = place(all.high[k], k) + 1;
    begin_.assign(count_[0] * count_[1] * count_[2] + 1, 0);
    for (const Box& box : boxes) visit(box, [&](std::size_t cube) { ++begin_[cube + 1]; });
    for (std::size_t c = 1; c < begin_.size(); ++c) begin_[c] += begin_[c - 1];
    items_.resize(begin_.back());
    std::vector<std::size_t> next(begin_.begin(), begin_.end() - 1);
    for (Index f = 0; f < boxes.size(); ++f)
      visit(boxes[f], [&](std::size_t cube) { items_[next[cube]++] = f; });
  }

  /// Faces with a higher number whose boxes meet that of f, ascending.
  void above(Index f, std::vector<Index>& found) const {
    found.clear();
    visit(boxes[f], [&](std::size_t cube) {
      for (std::size_t i = begin_[cube + 1]; i-- > begin_[cube] && items_[i] > f;)
        if (boxes[items_[i]].meets(boxes[f])) found.push_back(items_[i]);
    });
    std::sort(found.begin(), found.end());
    found.erase(std::unique(found.begin(), found.end()), found.end());
  }

  std::vector<Box> boxes;

 private:
  std::size_t place(double x, std::size_t k) const {
    return static_cast<std::size_t>(x / cell_ - low_[k] / cell_);
  }
  template <class Take>
  void visit(const Box& box, Take&& take) const {
    for (std::size_t z = place(box.low[2], 2); z <= place(box.high[2], 2); ++z)
      for (std::size_t y = place(box.low[1], 1); y <= place(box.high[1], 1); ++y)
        for (std::size_t x = place(box.low[0], 0); x <= place(box.high[0], 0); ++x)
          take((z * count_[1] + y) * count_[0] + x);
  }

  Vec3 low_{};
  double cell_ = 1;
  std::array<std::size_t, 3> count_{};
  std::vector<std::size_t> begin_;
  std::vector<Index> items_;
};

}  // namespace

std::optional<std::pair<Index, Index>> meeting_faces(const Scene& scene) {
  const Meeting meeting(scene);
  const CubeLists cubes(scene);
  const auto faces = static_cast<Index>(scene.faces.size());
  constexpr Index kPart = 1024;
  std::vector<std::optional<std::pair<Index, Index>>> parts((faces + kPart - 1) / kPart);
  kernel::parallel_for(Index{0}, static_cast<Index>(parts.size()), [&](Index part) {
    std::vector<Index> found;
    for (Index f = part * kPart; f < std::min(faces, (part + 1) * kPart) && !parts[part]; ++f) {
      if (meeting.flat(f)) {
        parts[part] = {f, f};
        break;
      }
      cubes.above(f, found);
      for (const Index g : found)
        if (!meeting.flat(g) && meeting.meet(f, g)) {
          parts[part] = {f, g};
          break;
        }
    }
  });
  for (const auto& part : parts)
    if (part) return part;
  return std::nullopt;
}

}  // namespace crest::line_art
