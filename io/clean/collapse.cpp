// SPDX-License-Identifier: GPL-3.0-or-later
// Termination: collapses and omissions leave fewer faces. Flips keep their number, and of the faces
// of area zero either one goes or two get shorter longest sides (exactly: corners inside a
// segment).
#include "io/clean/collapse.hpp"

#include <algorithm>
#include <deque>
#include <optional>

#include "io/clean/drop.hpp"
#include "kernel/predicates/collinear.hpp"

namespace crest::io {
namespace {

using kernel::Index;
using kernel::kNone;
using kernel::Triangle;
using kernel::Vec3;

/// Of points on one line: b lies between a and c and is none of them.
bool strictly_between(const Vec3& a, const Vec3& b, const Vec3& c) {
  if (b == a || b == c) return false;
  for (std::size_t k = 0; k < 3; ++k)
    if (b[k] < std::min(a[k], c[k]) || b[k] > std::max(a[k], c[k])) return false;
  return true;
}

/// Of three points on one line; a corner and the two after it.
struct Spike {
  Index middle, next, last;
};

class FlatFaces {
 public:
  FlatFaces(Surface& surface, CleanUp& done) : surface_(surface), done_(done) {}

  std::vector<Index> run() {
    std::vector<Index> flat = flat_faces();
    if (flat.empty()) return flat;
    build_stars();
    // Those that wait for others are tried again as long as something changes.
    for (bool changed = true; changed;) {
      changed = false;
      for (const Index f : flat) push(f);
      while (!queue_.empty()) {
        const Index f = queue_.front();
        queue_.pop_front();
        queued_[f] = false;
        if (is_flat(f) && mend(f)) changed = true;
      }
      flat = flat_faces();
    }
    std::vector<bool> kept(alive_.begin(), alive_.end());
    keep_faces(surface_, kept);
    drop_unused(surface_);
    return flat_in(surface_);
  }

 private:
  static std::vector<Index> flat_in(const Surface& surface) {
    std::vector<Index> flat;
    for (Index f = 0; f < surface.faces.size(); ++f) {
      const auto& [a, b, c] = surface.faces[f];
      if (kernel::collinear(surface.points[a], surface.points[b], surface.points[c]))
        flat.push_back(f);
    }
    return flat;
  }

  std::vector<Index> flat_faces() const {
    std::vector<Index> flat = flat_in(surface_);
    if (!alive_.empty()) std::erase_if(flat, [&](Index f) { return !alive_[f]; });
    return flat;
  }

  bool is_flat(Index f) const {
    const auto& [a, b, c] = surface_.faces[f];
    return alive_[f] && kernel::collinear(place(a), place(b), place(c));
  }
  const Vec3& place(Index v) const { return surface_.points[v]; }

  void build_stars() {
    alive_.assign(surface_.faces.size(), true);
    queued_.assign(surface_.faces.size(), false);
    star_.resize(surface_.points.size());
    for (Index f = 0; f < surface_.faces.size(); ++f)
      for (const Index v : surface_.faces[f]) star_[v].push_back(f);
  }

  void push(Index f) {
    if (queued_[f] || !is_flat(f)) return;
    queued_[f] = true;
    queue_.push_back(f);
  }
  void push_star(Index v) {
    for (const Index f : star_[v]) push(f);
  }

  bool has(Index f, Index v) const {
    const Triangle& t = surface_.faces[f];
    return t[0] == v || t[1] == v || t[2] == v;
  }
  Index third(Index f, Index u, Index v) const {
    const Triangle& t = surface_.faces[f];
    return t[0] ^ t[1] ^ t[2] ^ u ^ v;
  }
  std::vector<Index> faces_at(Index u, Index v) const {
    std::vector<Index> faces;
    for (const Index f : star_[u])
      if (has(f, v)) faces.push_back(f);
    return faces;
  }
  std::vector<Index> neighbours(Index v) const {
    std::vector<Index> list;
    for (const Index f : star_[v])
      for (const Index w : surface_.faces[f])
        if (w != v) list.push_back(w);
    std::sort(list.begin(), list.end());
    list.erase(std::unique(list.begin(), list.end()), list.end());
    return list;
  }
  bool adjacent(Index u, Index v) const { return !faces_at(u, v).empty(); }
  bool at_boundary(Index u, Index v) const { return faces_at(u, v).size() == 1; }
  /// A fan that is open has a corner more than faces.
  bool on_boundary(Index v) const { return neighbours(v).size() > star_[v].size(); }

  void leave_star(Index v, Index f) { std::erase(star_[v], f); }
  void leave_out(Index f) {
    alive_[f] = false;
    for (const Index v : surface_.faces[f]) leave_star(v, f);
  }

  /// Whether the links of u and v meet in the link of their edge alone.
  bool may_collapse(Index u, Index v) const {
    const std::vector<Index> faces = faces_at(u, v), nu = neighbours(u), nv = neighbours(v);
    std::vector<Index> common;
    std::set_intersection(nu.begin(), nu.end(), nv.begin(), nv.end(), std::back_inserter(common));
    if (common.size() != faces.size()) return false;
    if (faces.size() == 1) {
      const Index x = common[0];
      return !(at_boundary(u, x) && at_boundary(v, x));
    }
    if (on_boundary(u) && on_boundary(v)) return false;
    const Index x = common[0], y = common[1];
    const auto has_face = [&](Index w) {
      return std::any_of(star_[w].begin(), star_[w].end(),
                         [&](Index f) { return has(f, x) && has(f, y); });
    };
    return !(has_face(u) && has_face(v));
  }

  bool collapse(Index kept, Index gone) {
    if (!may_collapse(kept, gone)) return false;
    for (const Index f : faces_at(kept, gone)) leave_out(f);
    for (const Index f : star_[gone]) {
      for (Index& v : surface_.faces[f])
        if (v == gone) v = kept;
      star_[kept].push_back(f);
    }
    star_[gone].clear();
    ++done_.collapsed_edges;
    push_star(kept);
    return true;
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
      const Spike spike = {t[k], t[(k + 1) % 3], t[(k + 2) % 3]};
      if (!strictly_between(place(spike.next), place(spike.middle), place(spike.last))) continue;
      return flip(f, spike) || trim(f, spike) || collapse_middle(spike);
    }
    return false;
  }

  bool flip(Index f, const Spike& s) {
    const std::vector<Index> faces = faces_at(s.next, s.last);
    if (faces.size() != 2) return false;
    const Index other = faces[0] == f ? faces[1] : faces[0];
    const Index across = third(other, s.next, s.last);
    if (across == s.middle || adjacent(s.middle, across)) return false;
    if (is_flat(other) && !strictly_between(place(s.next), place(across), place(s.last)))
      return false;
    surface_.faces[f] = {s.middle, s.next, across};
    surface_.faces[other] = {s.middle, across, s.last};
    leave_star(s.last, f);
    leave_star(s.next, other);
    star_[across].push_back(f);
    star_[s.middle].push_back(other);
    ++done_.flipped_edges;
    for (const Index v : {s.middle, s.next, s.last, across}) push_star(v);
    return true;
  }

  bool trim(Index f, const Spike& s) {
    if (!at_boundary(s.next, s.last)) return false;
    const int open = int{at_boundary(s.middle, s.next)} + int{at_boundary(s.middle, s.last)};
    if (open == 2 || (open == 0 && on_boundary(s.middle))) return false;
    leave_out(f);
    ++done_.trimmed_faces;
    for (const Index v : {s.middle, s.next, s.last}) push_star(v);
    return true;
  }

  bool collapse_middle(const Spike& s) {
    std::array<Index, 2> ends = {s.next, s.last};
    const auto length = [&](Index v) { return kernel::distance(place(s.middle), place(v)); };
    if (length(ends[1]) < length(ends[0])) std::swap(ends[0], ends[1]);
    for (const Index end : ends) {
      const bool stays = on_boundary(s.middle) && !on_boundary(end);
      if (stays ? collapse(s.middle, end) : collapse(end, s.middle)) return true;
    }
    return false;
  }

  Surface& surface_;
  CleanUp& done_;
  std::vector<bool> alive_, queued_;
  std::vector<std::vector<Index>> star_;  ///< faces around each vertex
  std::deque<Index> queue_;
};

}  // namespace

std::vector<Index> collapse_flat_faces(Surface& surface, CleanUp& done) {
  return FlatFaces(surface, done).run();
}

}  // namespace crest::io
