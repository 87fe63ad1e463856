// SPDX-License-Identifier: GPL-3.0-or-later
// Termination: collapses and omissions leave fewer faces. Flips keep their number, and of the faces
// of area zero either one goes or two get shorter longest sides (exactly: corners inside a
// segment).
#include "io/clean/collapse.hpp"

#include <algorithm>
#include <deque>
#include <initializer_list>

#include "io/clean/drop.hpp"
#include "io/clean/stars.hpp"
#include "kernel/predicates/collinear.hpp"

namespace crest::io {
namespace {

using kernel::Index;
using kernel::Triangle;
using kernel::Vec3;

/// Of points on one line: b lies between a and c and is none of them.
bool strictly_between(const Vec3& a, const Vec3& b, const Vec3& c) {
  if (b == a || b == c) return false;
  for (std::size_t k = 0; k < 3; ++k)
    if (b[k] < std::min(a[k], c[k]) || b[k] > std::max(a[k], c[k])) return false;
  return true;
}

bool flat(const Surface& surface, Index f) {
  const auto& [a, b, c] = surface.faces[f];
  return kernel::collinear(surface.points[a], surface.points[b], surface.points[c]);
}

std::vector<Index> flat_faces(const Surface& surface) {
  std::vector<Index> faces;
  for (Index f = 0; f < surface.face_count(); ++f)
    if (flat(surface, f)) faces.push_back(f);
  return faces;
}

class FlatFaces {
 public:
  FlatFaces(Surface& surface, CleanUp& done)
      : surface_(surface), done_(done), stars_(surface), queued_(surface.faces.size(), false) {}

  /// Those that wait for others are tried again as long as something changes.
  void run() {
    for (bool changed = true; changed;) {
      changed = false;
      for (Index f = 0; f < surface_.face_count(); ++f) push(f);
      while (!queue_.empty()) {
        const Index f = queue_.front();
        queue_.pop_front();
        queued_[f] = false;
        if (is_flat(f) && mend(f)) changed = true;
      }
    }
    std::vector<bool> kept(surface_.faces.size());
    for (Index f = 0; f < kept.size(); ++f) kept[f] = stars_.alive(f);
    keep_faces(surface_, kept);
    drop_unused(surface_);
  }

 private:
  const Vec3& place(Index v) const { return surface_.points[v]; }
  bool is_flat(Index f) const { return stars_.alive(f) && flat(surface_, f); }

  void push(Index f) {
    if (queued_[f] || !is_flat(f)) return;
    queued_[f] = true;
    queue_.push_back(f);
  }
  void push_stars(std::initializer_list<Index> vertices) {
    for (const Index v : vertices)
      for (const Index f : stars_.star(v)) push(f);
  }

  bool mend(Index f) {
    const Triangle t = surface_.faces[f];
    bool zero_edge = false;
    for (std::size_t k = 0; k < 3; ++k) {
      const auto [low, high] = std::minmax({t[k], t[(k + 1) % 3]});
      if (place(low) != place(high)) continue;
      zero_edge = true;
      if (collapse(low, high)) return true;
    }
    if (zero_edge) return false;
    for (std::size_t k = 0; k < 3; ++k) {
      const Triangle abc = {t[k], t[(k + 1) % 3], t[(k + 2) % 3]};
      if (!strictly_between(place(abc[1]), place(abc[0]), place(abc[2]))) continue;
      return flip(f, abc) || trim(f, abc) || collapse_middle(abc);
    }
    return false;
  }

  bool collapse(Index kept, Index gone) {
    if (!stars_.may_collapse(kept, gone)) return false;
    stars_.collapse(kept, gone);
    ++done_.collapsed_edges;
    push_stars({kept});
    return true;
  }

  /// In these a lies between b and c.
  bool flip(Index f, const Triangle& abc) {
    const auto& [a, b, c] = abc;
    const std::vector<Index> faces = stars_.faces_at(b, c);
    if (faces.size() != 2) return false;
    const Index other = faces[0] == f ? faces[1] : faces[0];
    const Index d = stars_.third(other, b, c);
    if (a == d || stars_.adjacent(a, d)) return false;
    if (is_flat(other) && !strictly_between(place(b), place(d), place(c))) return false;
    stars_.flip(f, other, abc, d);
    ++done_.flipped_edges;
    push_stars({a, b, c, d});
    return true;
  }

  bool trim(Index f, const Triangle& abc) {
    const auto& [a, b, c] = abc;
    if (!stars_.at_boundary(b, c)) return false;
    const int open = int{stars_.at_boundary(a, b)} + int{stars_.at_boundary(a, c)};
    if (open == 2 || (open == 0 && stars_.on_boundary(a))) return false;
    stars_.leave_out(f);
    ++done_.trimmed_faces;
    push_stars({a, b, c});
    return true;
  }

  bool collapse_middle(const Triangle& abc) {
    const Index a = abc[0];
    std::array<Index, 2> ends = {abc[1], abc[2]};
    const auto length = [&](Index v) { return kernel::distance(place(a), place(v)); };
    if (length(ends[1]) < length(ends[0])) std::swap(ends[0], ends[1]);
    for (const Index end : ends) {
      const bool stays = stars_.on_boundary(a) && !stars_.on_boundary(end);
      if (stays ? collapse(a, end) : collapse(end, a)) return true;
    }
    return false;
  }

  Surface& surface_;
  CleanUp& done_;
  Stars stars_;
  std::vector<bool> queued_;
  std::deque<Index> queue_;
};

}  // namespace

std::vector<Index> collapse_flat_faces(Surface& surface, CleanUp& done) {
  if (flat_faces(surface).empty()) return {};
  FlatFaces(surface, done).run();
  return flat_faces(surface);
}

}  // namespace crest::io
