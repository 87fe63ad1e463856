// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/vector_fields/skeleton_match.hpp"

#include <algorithm>
#include <cmath>
#include <map>

namespace crest::vector_fields {

namespace {

double area(const std::vector<Vec2>& polygon) {
  double sum = 0;
  for (std::size_t i = 0; i < polygon.size(); ++i)
    sum += kernel::cross(polygon[i], polygon[(i + 1) % polygon.size()]);
  return std::fabs(sum);
}

/// One skeleton with what is needed to compare it, in the input's names.
class Named {
 public:
  /// mesh: the same triangles, by the numbers in `triangles`.
  /// Loops are named from `first_loop` on; zeros named kNone are left out.
  Named(const Analysis& a, const CollapseMesh& mesh, const std::vector<Index>& triangles,
        const std::vector<Index>& zero_names, const std::vector<Index>& loop_names,
        Index first_loop)
      : a_(a), slots_(a.boundary) {
    Index ordinal = 0;
    for (const auto& loop : a.boundary.half_edges)
      for (const HalfEdge h : loop) ordinals_[h] = ordinal++;
    for (const Trace& t : a.traces) {
      const bool corridor = t.end != EndKind::undecided && !t.straight;
      steps_.push_back(corridor ? steps_of(a.domain, t) : std::vector<Step>{});
    }
    for (const Annulus& o : a.annuli) {
      auto& around = enclosed_.emplace_back();
      const auto from_tail = [](double x) { return x > 0 ? x : 1 + x; };
      const auto& line = lines_.emplace_back(
          points_along(mesh, o.forward, 3 * triangles[o.side / 3] + o.side % 3,
                       (from_tail(o.back_left) + from_tail(o.back_right)) / 2, o.turns.size()));
      for (std::size_t z = 0; z < a.zeros.size(); ++z)
        if (zero_names[z] != kNone && inside(line, a.zeros[z].item.point))
          around.push_back(zero_names[z]);
      for (std::size_t i = 0; i < a.boundary.half_edges.size(); ++i)
        if (inside(line, a.domain.point(a.domain.from(a.boundary.half_edges[i].front()))))
          around.push_back(first_loop + loop_names[i]);
      std::sort(around.begin(), around.end());
      around.push_back(o.forward ? 1 : 0);
    }
  }
  /// Those of the orbits by what they enclose, then from inside.
  std::vector<Index> orbits(const std::vector<bool>& used) const {
    std::vector<Index> order;
    for (Index i = 0; i < a_.annuli.size(); ++i)
      if (used[i]) order.push_back(i);
    std::sort(order.begin(), order.end(), [&](Index i, Index k) {
      if (enclosed_[i] != enclosed_[k]) return enclosed_[i] < enclosed_[k];
      return area(lines_[i]) < area(lines_[k]);
    });
    return order;
  }
  const std::vector<Index>& enclosed(Index orbit) const { return enclosed_[orbit]; }
  const Domain& domain() const { return a_.domain; }

  /// 0, but 1 for what comes to an orbit from the other side; none: no order is asked for.
  std::optional<Index> side(Index line) const {
    const Trace& t = a_.traces[line];
    if (t.end == EndKind::undecided || t.straight) return std::nullopt;
    if (t.end == EndKind::critical_point && a_.zeros[t.target].item.where != ZeroPlace::triangle)
      return std::nullopt;
    if (t.end != EndKind::closed_orbit) return 0;
    return side_of(a_.domain, a_.annuli[t.target], t);
  }
  std::optional<Arrival> arrival(Index line) const {
    const Trace& t = a_.traces[line];
    const auto& steps = steps_[line];
    if (steps.empty()) {
      if (!t.start.from_switch_point && !t.start.from_vertex) return std::nullopt;
      return Arrival{line, t.leg.place % 3, &steps, 0};
    }
    Arrival r{line, 0, &steps, steps.size() - 1};
    if (t.start.from_switch_point || t.start.from_vertex)
      r.side = t.start.place;
    else
      r.zero = a_.zeros[t.start.origin].item.point;
    if (t.end == EndKind::boundary) r.slot = slots_.slot(t.target, ordinals_.at(steps.back().exit));
    if (t.end == EndKind::critical_point) r.slot = a_.domain.twin(steps.back().exit) % 3;
    return r;
  }
  bool cyclic(EndKind end, Index target) const {
    return end != EndKind::boundary || slots_.cyclic(target);
  }

 private:
  const Analysis& a_;
  RegionSlots slots_;
  std::unordered_map<HalfEdge, Index> ordinals_;
  std::vector<std::vector<Step>> steps_;
  std::vector<std::vector<Vec2>> lines_;  ///< along orbits
  std::vector<std::vector<Index>> enclosed_;
};

class Matcher {
 public:
  Matcher(const Analysis& input, const Analysis& output, const SearchState& found, const Kept& kept)
      : in_(input), out_(output), found_(found), kept_(kept), all_(kept.all()) {
    for (Index t = 0; t < found.mesh.triangle_count(); ++t)
      if (found.mesh.alive(t)) old_triangle_.push_back(t);
    for (const auto& loop : input.boundary.half_edges)
      by_ordinal_.insert(by_ordinal_.end(), loop.begin(), loop.end());
  }

  SkeletonMatch run() {
    if (zeros() && boundary() && starts()) {
      orbits();
      if (ends()) orders();
    }
    result_.same = result_.difference.empty();
    return std::move(result_);
  }

 private:
  bool differ(const std::string& what) {
    if (result_.difference.empty()) result_.difference = what;
    return false;
  }
  bool differ(Index line, const std::string& what) {
    result_.differing.push_back(line);
    return differ("separatrix " + std::to_string(line) + ": " + what);
  }
  /// The input's half-edge that a boundary half-edge of the output takes up.
  HalfEdge old_edge(HalfEdge h) const {
    return by_ordinal_[found_.mesh.boundary_edge(3 * old_triangle_[h / 3] + h % 3).ordinal];
  }

  bool zeros();
  bool boundary();
  void orbits();
  bool starts();
  bool ends();
  void compare_end(Index i);
  void orders();
  bool same_order(EndKind end, Index target, const std::vector<Index>& lines);
  const Analysis &in_, &out_;
  const SearchState& found_;
  const Kept& kept_;
  const bool all_;                   ///< are kept
  std::vector<Index> old_triangle_;  ///< of the output's
  std::vector<HalfEdge> by_ordinal_;
  std::vector<Index> old_zero_, loop_names_, switches_;
  std::unordered_map<Index, Index> regions_;
  std::optional<Named> a_, b_;
  SkeletonMatch result_;
};

bool Matcher::zeros() {
  std::map<Index, Index> by_triangle;
  for (Index z = 0; z < out_.zeros.size(); ++z)
    by_triangle[old_triangle_[out_.zeros[z].triangles.front()]] = z;
  if (all_ && by_triangle.size() != in_.zeros.size()) return differ("another number of zeros");
  old_zero_.assign(out_.zeros.size(), kNone);
  for (Index z = 0; z < in_.zeros.size(); ++z) {
    if (!kept_.zeros[z]) {
      result_.zeros.push_back(kNone);
      continue;
    }
    const Index moved = found_.zeros[z].triangle;
    const auto at = by_triangle.find(moved == kNone ? in_.zeros[z].triangles.front() : moved);
    if (at == by_triangle.end()) return differ("zero " + std::to_string(z) + ": is gone");
    const CriticalPoint &a = in_.zeros[z].item, &b = out_.zeros[at->second].item;
    if (a.kind != b.kind || a.index != b.index || a.where != b.where)
      return differ("zero " + std::to_string(z) + ": is of another class");
    result_.zeros.push_back(at->second);
    old_zero_[at->second] = z;
  }
  return true;
}

bool Matcher::boundary() {
  const Boundary &a = in_.boundary, &b = out_.boundary;
  if (a.switch_points.size() != b.switch_points.size() || a.loops.size() != b.loops.size())
    return differ("another number of switch points");
  std::map<std::pair<HalfEdge, bool>, Index> known;
  for (Index i = 0; i < a.switch_points.size(); ++i)
    known[{a.switch_points[i].edge, a.switch_points[i].at_vertex}] = i;
  switches_.assign(known.size(), kNone);
  for (Index i = 0; i < b.switch_points.size(); ++i) {
    const SwitchPoint& s = b.switch_points[i];
    const auto at = known.find({old_edge(s.edge), s.at_vertex});
    if (at == known.end() || a.switch_points[at->second].inside != s.inside ||
        a.switch_points[at->second].inflow_after != s.inflow_after)
      return differ("another switch point");
    switches_[at->second] = i;
  }
  // A region may have only the rest of an edge, behind a switch point in it.
  const auto corresponds = [&](Index before, Index now) {
    if (before == kNone || now == kNone) return before == now;
    return regions_.try_emplace(before, now).first->second == now;
  };
  for (const auto& [h, r] : b.regions) {
    const auto old = a.regions.find(old_edge(h));
    if (old == a.regions.end() || !corresponds(old->second.at_from, r.at_from) ||
        !corresponds(old->second.at_to, r.at_to))
      return differ("another region of the boundary");
  }
  loop_names_.assign(b.half_edges.size(), kNone);
  std::unordered_map<HalfEdge, Index> loop_of;
  for (Index i = 0; i < a.half_edges.size(); ++i)
    for (const HalfEdge h : a.half_edges[i]) loop_of[h] = i;
  for (Index i = 0; i < b.half_edges.size(); ++i)
    loop_names_[i] = loop_of.at(old_edge(b.half_edges[i].front()));
  return true;
}

void Matcher::orbits() {
  std::vector<Index> same;
  for (Index i = 0; i < std::max<std::size_t>(found_.mesh.triangle_count(), in_.zeros.size()); ++i)
    same.push_back(i);
  std::vector<Index> names = same;
  for (Index z = 0; z < in_.zeros.size(); ++z)
    if (!kept_.zeros[z]) names[z] = kNone;
  const auto loops = static_cast<Index>(in_.zeros.size());
  a_.emplace(in_, CollapseMesh(in_.domain, in_.boundary), same, names, same, loops);
  b_.emplace(out_, found_.mesh, old_triangle_, old_zero_, loop_names_, loops);
  std::vector<bool> used(in_.annuli.size(), all_), used_after(out_.annuli.size(), all_);
  for (Index i = 0; i < in_.traces.size(); ++i) {
    if (!kept_.lines[i]) continue;
    const Trace &s = in_.traces[i], &t = out_.traces[result_.separatrices[i]];
    if (s.end == EndKind::closed_orbit) used[s.target] = true;
    if (s.end != EndKind::undecided && t.end == EndKind::closed_orbit) used_after[t.target] = true;
  }
  const auto a = a_->orbits(used), b = b_->orbits(used_after);
  result_.orbits.assign(in_.annuli.size(), kNone);
  std::size_t i = 0, k = 0;
  while (i < a.size() && k < b.size()) {
    const auto &x = a_->enclosed(a[i]), &y = b_->enclosed(b[k]);
    if (x == y) result_.orbits[a[i]] = b[k];
    i += x <= y ? 1 : 0;
    k += y <= x ? 1 : 0;
  }
  if (a.size() != b.size() ||
      std::any_of(a.begin(), a.end(), [&](Index o) { return result_.orbits[o] == kNone; }))
    differ("other closed orbits");
}

bool Matcher::starts() {
  std::map<std::array<Index, 4>, Index> starts;
  std::map<std::pair<bool, Index>, Index> counts;
  const auto key = [&](const Start& s, const Start& named, Index origin) {
    const bool ray = s.kind == StartKind::ray;
    Index which = ray ? static_cast<Index>(2 + named.sense) : s.forward ? 1 : 0;
    if (!ray && !s.from_switch_point) which = counts[{s.from_switch_point, origin}]++;
    return std::array<Index, 4>{s.from_switch_point ? 1U : 0U, origin, s.forward ? 1U : 0U, which};
  };
  for (Index i = 0; i < out_.traces.size(); ++i) {
    const Start& s = out_.traces[i].start;
    if (!s.from_vertex) starts[key(s, s, s.origin)] = i;
  }
  counts.clear();
  if (all_ && out_.traces.size() != in_.traces.size())
    return differ("another number of separatrices");
  // Witnesses stand last, in their order.
  const std::size_t witnesses = in_.traces.size() - in_.witnesses.size();
  for (Index i = 0; i < in_.traces.size(); ++i) {
    if (!kept_.lines[i]) {
      result_.separatrices.push_back(kNone);
      continue;
    }
    if (i >= witnesses) {
      result_.separatrices.push_back(static_cast<Index>(out_.traces.size() - in_.traces.size()) +
                                     i);
      continue;
    }
    const Start& s = in_.traces[i].start;
    const Index origin = s.from_switch_point ? switches_[s.origin] : result_.zeros[s.origin];
    const auto at = starts.find(key(s, found_.lines[i].start, origin));
    if (at == starts.end()) return differ("separatrix " + std::to_string(i) + ": is gone");
    result_.separatrices.push_back(at->second);
  }
  return true;
}

bool Matcher::ends() {
  for (Index i = 0; i < in_.traces.size(); ++i)
    if (kept_.lines[i]) compare_end(i);
  return result_.differing.empty();
}

void Matcher::compare_end(Index i) {
  const Trace &s = in_.traces[i], &t = out_.traces[result_.separatrices[i]];
  // Of an undecided line nothing is claimed.
  if (s.end == EndKind::undecided) return;
  if (t.end == EndKind::undecided) {
    differ(i, "is undecided in the output");
    return;
  }
  Index target = s.target;
  if (s.end == EndKind::critical_point || s.end == EndKind::zero_flow)
    target = result_.zeros[s.target];
  if (s.end == EndKind::switch_point) target = switches_[s.target];
  if (s.end == EndKind::closed_orbit) target = result_.orbits[s.target];
  if (s.end == EndKind::boundary) {
    const auto r = regions_.find(s.target);
    target = r == regions_.end() ? kNone : r->second;
  }
  if (s.end != t.end || target != t.target) differ(i, "ends elsewhere");
}

void Matcher::orders() {
  std::map<std::array<Index, 3>, std::vector<Index>> groups;
  for (Index i = 0; i < in_.traces.size(); ++i) {
    if (!kept_.lines[i] || in_.traces[i].end == EndKind::undecided) continue;
    const auto a = a_->side(i), b = b_->side(result_.separatrices[i]);
    if (!a || !b) continue;
    if (a != b) {
      differ(i, "comes to its orbit from the other side");
      continue;
    }
    groups[{static_cast<Index>(in_.traces[i].end), in_.traces[i].target, *a}].push_back(i);
  }
  for (const auto& [end, lines] : groups)
    if (!same_order(static_cast<EndKind>(end[0]), end[1], lines))
      for (const Index i : lines) differ(i, "arrives in another order");
}

bool Matcher::same_order(EndKind end, Index target, const std::vector<Index>& lines) {
  const bool leftmost = end != EndKind::boundary;
  std::vector<Arrival> a, b;
  for (const Index i : lines) {
    const auto x = a_->arrival(i);
    if (!x) return true;
    a.push_back(*x);
  }
  if (!sort_arrivals(a_->domain(), a, leftmost, result_.inherited)) return false;
  for (const Arrival& x : a) {
    const auto y = b_->arrival(result_.separatrices[x.line]);
    if (!y) return false;
    b.push_back(*y);
  }
  return in_order(b_->domain(), b, a_->cyclic(end, target), leftmost, result_.inherited)
      .value_or(false);
}

}  // namespace

SkeletonMatch match_skeletons(const Analysis& input, const Analysis& output,
                              const SearchState& found, const Kept& kept) {
  return Matcher(input, output, found, kept).run();
}

}  // namespace crest::vector_fields
