// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/vector_fields/collapse_mesh.hpp"

#include <algorithm>
#include <utility>

#include "kernel/predicates/planar_field.hpp"

namespace crest::vector_fields {

using kernel::Sign;

CollapseMesh::CollapseMesh(const Domain& domain, const Boundary& boundary)
    : domain_(domain),
      leaving_(domain.field().points.size(), kNone),
      alive_(domain.triangle_count(), 1),
      fixed_(domain.field().points.size(), 0),
      kept_(domain.field().points.size(), 0),
      live_(domain.triangle_count()),
      stamps_(domain.field().points.size(), 0) {
  const HalfEdge halves = 3 * domain.triangle_count();
  std::vector<std::uint8_t> fans(leaving_.size(), 0);
  for (HalfEdge h = 0; h < halves; ++h) {
    corners_.push_back(domain.from(h));
    twins_.push_back(domain.twin(h));
    Index& known = leaving_[corners_.back()];
    if (known == kNone || twins_.back() == kNone) known = h;
    // Several fans at a vertex: it stays.
    if (twins_.back() == kNone && ++fans[corners_.back()] > 1) fix(corners_.back());
  }
  boundary_edges_.resize(halves);
  for (const auto& loop : boundary.half_edges)
    for (const HalfEdge h : loop) {
      BoundaryEdge& e = boundary_edges_[h];
      e.ordinal = static_cast<Index>(by_ordinal_.size());
      by_ordinal_.push_back(h);
      if (const auto r = boundary.regions.find(h); r != boundary.regions.end())
        e.regions = r->second;
    }
}

kernel::FieldOnTriangle CollapseMesh::data(Index t, Index from, Index to) const {
  kernel::FieldOnTriangle d;
  for (HalfEdge h = 3 * t; h < 3 * t + 3; ++h) {
    const Index v = corners_[h] == from ? to : corners_[h];
    d.p[h % 3] = point(v);
    d.v[h % 3] = vector(v);
  }
  return d;
}

kernel::FieldOnTriangle CollapseMesh::data(const std::array<Index, 3>& corners) const {
  kernel::FieldOnTriangle d;
  for (std::size_t i = 0; i < 3; ++i) {
    d.p[i] = point(corners[i]);
    d.v[i] = vector(corners[i]);
  }
  return d;
}

void CollapseMesh::fan(Index vertex, std::vector<HalfEdge>& leaving) const {
  leaving.clear();
  HalfEdge start = leaving_[vertex];
  for (HalfEdge at = start; twins_[at] != kNone;) {
    at = Domain::next(twins_[at]);
    if (at == leaving_[vertex]) {
      start = at;
      break;
    }
    start = at;
  }
  for (HalfEdge at = start;;) {
    leaving.push_back(at);
    const HalfEdge g = twins_[Domain::previous(at)];
    if (g == kNone || g == start) break;
    at = g;
  }
}

bool CollapseMesh::adjacent(Index from, Index to) const {
  const HalfEdge first = leaving_[from];
  if (corners_[first] != from || !alive(first / 3)) return false;
  fan(from, fan_);
  const HalfEdge last = Domain::previous(fan_.back());
  return this->from(last) == to ||
         std::any_of(fan_.begin(), fan_.end(), [&](HalfEdge h) { return this->to(h) == to; });
}

/// The link condition: so many neighbours in common.
bool CollapseMesh::linked(Index from, Index to, std::size_t common) const {
  fan(to, other_fan_);
  ++stamp_;
  std::size_t found = 0;
  const auto each = [&](const std::vector<HalfEdge>& leaving, const auto& see) {
    for (const HalfEdge h : leaving) see(this->to(h));
    const HalfEdge last = Domain::previous(leaving.back());
    if (twins_[last] == kNone) see(this->from(last));
  };
  each(fan_, [&](Index v) { stamps_[v] = stamp_; });
  each(other_fan_, [&](Index v) { found += stamps_[v] == stamp_ && v != from ? 1 : 0; });
  return found == common;
}

bool CollapseMesh::positive(const Collapse& plan) const {
  return std::all_of(plan.star.begin(), plan.star.end(), [&](Index t) {
    if (t == plan.gone[0] || t == plan.gone[1]) return true;
    const auto [p, v] = data(t, plan.from, plan.to);
    return kernel::orientation(p[0], p[1], p[2]) == Sign::positive;
  });
}

CollapseRefusal CollapseMesh::plan(Index from, Index to, Collapse& plan) const {
  if (fixed_[from] != 0 || kept_[from] != 0 || fixed_[to] != 0) return CollapseRefusal::geometry;
  fan(from, fan_);
  plan.from = from;
  plan.to = to;
  plan.flipped = kNone;
  plan.filling.clear();
  plan.star.clear();
  if (twins_[fan_.front()] == kNone) return plan_boundary(from, to, plan);
  const auto first =
      std::find_if(fan_.begin(), fan_.end(), [&](HalfEdge h) { return this->to(h) == to; });
  std::rotate(fan_.begin(), first, fan_.end());
  for (const HalfEdge h : fan_) plan.star.push_back(h / 3);
  plan.gone = {plan.star.front(), plan.star.back()};
  return linked(from, to, 2) && positive(plan) ? CollapseRefusal::none : CollapseRefusal::geometry;
}

/// Whether the boundary is straight at the fan's vertex and the flow across it has one strict sign.
bool CollapseMesh::passes_boundary(const std::vector<HalfEdge>& fan) const {
  const Index before = from(Domain::previous(fan.back())), at = from(fan.front()),
              after = to(fan.front());
  const Vec2 &p = point(before), &q = point(at), &r = point(after);
  if (kernel::orientation(p, q, r) != Sign::zero ||
      kernel::flow_along(p, q, {r[0] - q[0], r[1] - q[1]}) != Sign::positive)
    return false;
  const Sign s = kernel::flow_across(p, q, vector(at));
  return s != Sign::zero && kernel::flow_across(p, q, vector(before)) == s &&
         kernel::flow_across(q, r, vector(at)) == s &&
         kernel::flow_across(q, r, vector(after)) == s;
}

/// Along the boundary.
CollapseRefusal CollapseMesh::plan_boundary(Index from, Index to, Collapse& plan) const {
  const HalfEdge after = fan_.front(), before = Domain::previous(fan_.back());
  const bool ahead = this->to(after) == to;
  if ((!ahead && this->from(before) != to) || !passes_boundary(fan_))
    return CollapseRefusal::boundary;
  if (fan_.size() < 2) return CollapseRefusal::geometry;
  for (const HalfEdge h : fan_) plan.star.push_back(h / 3);
  if (!ahead) std::reverse(plan.star.begin(), plan.star.end());
  plan.gone = {plan.star.front(), plan.star.front()};
  return linked(from, to, 1) && positive(plan) ? CollapseRefusal::none : CollapseRefusal::geometry;
}

/// Where the two triangles are a strictly convex quadrilateral.
bool CollapseMesh::plan_flip(HalfEdge side, Collapse& plan) const {
  const HalfEdge other = twins_[side];
  if (other == kNone) return false;
  const Index a = from(side), b = to(side), c = from(Domain::previous(side)),
              d = from(Domain::previous(other));
  for (const Index v : {a, b, c, d})
    if (fixed_[v] != 0) return false;
  plan = {kNone, kNone, {side / 3, other / 3}, {kNone, kNone}, side, {}};
  return kernel::orientation(point(a), point(d), point(c)) == Sign::positive &&
         kernel::orientation(point(d), point(b), point(c)) == Sign::positive && !adjacent(c, d);
}

bool CollapseMesh::plan_hole(Index vertex, std::vector<Index>& corners, Collapse& plan) const {
  fan(vertex, fan_);
  const bool open = twins_[fan_.front()] == kNone;
  const std::size_t least = open ? 2 : 3;
  if (fan_.size() < least || (open && !passes_boundary(fan_))) return false;
  corners.clear();
  plan = {vertex, kNone, {}, {kNone, kNone}, kNone, {}};
  for (const HalfEdge h : fan_) {
    corners.push_back(to(h));
    plan.star.push_back(h / 3);
  }
  plan.gone = {plan.star[plan.star.size() - (open ? 1 : 2)], plan.star.back()};
  if (open) corners.push_back(from(Domain::previous(fan_.back())));
  ++stamp_;
  return std::all_of(corners.begin(), corners.end(), [&](Index v) {
    return fixed_[v] == 0 && std::exchange(stamps_[v], stamp_) != stamp_;
  });
}

kernel::FieldOnTriangle CollapseMesh::data_after(const Collapse& plan, Index t) const {
  if (!plan.filling.empty()) {
    const auto k = std::find(plan.star.begin(), plan.star.end(), t) - plan.star.begin();
    return data(plan.filling[static_cast<std::size_t>(k)]);
  }
  if (plan.flipped == kNone) return data(t, plan.from, plan.to);
  const HalfEdge side = t == plan.flipped / 3 ? plan.flipped : twins_[plan.flipped];
  return data(t, to(side), from(Domain::previous(twins_[side])));
}

/// `h` takes the place of another at its neighbour, or at the boundary.
void CollapseMesh::set_twin(HalfEdge h, HalfEdge twin, const BoundaryEdge& edge) {
  journal_.twins.push_back({h, twins_[h]});
  twins_[h] = twin;
  if (twin != kNone) {
    journal_.twins.push_back({twin, twins_[twin]});
    twins_[twin] = h;
    return;
  }
  const Index ordinal = edge.ordinal;
  journal_.edges.push_back({h, boundary_edges_[h]});
  boundary_edges_[h] = edge;
  if (ordinal == kNone) return;
  journal_.ordinals.push_back({ordinal, by_ordinal_[ordinal]});
  by_ordinal_[ordinal] = h;
}

void CollapseMesh::set_leaving(Index vertex, HalfEdge h) {
  journal_.leaving.push_back({vertex, leaving_[vertex]});
  leaving_[vertex] = h;
}

/// Of a b c and b a d: a d c and b c d; c a and d b keep their half-edges.
void CollapseMesh::apply_flip(HalfEdge side) {
  const HalfEdge other = twins_[side];
  const HalfEdge bc = Domain::next(side), ad = Domain::next(other);
  const Index a = from(side), b = to(side), c = to(bc), d = to(ad);
  if (leaving_[a] == ad) set_leaving(a, side);
  if (leaving_[b] == bc) set_leaving(b, other);
  const HalfEdge beyond_ad = twins_[ad], beyond_bc = twins_[bc];
  set_twin(side, beyond_ad, boundary_edges_[ad]);
  set_twin(other, beyond_bc, boundary_edges_[bc]);
  set_twin(bc, ad, {});
  journal_.corners.push_back({bc, b});
  journal_.corners.push_back({ad, a});
  corners_[bc] = d;
  corners_[ad] = c;
}

/// Sides of the hole by their tails; diagonals meet their twins by both ends.
void CollapseMesh::apply_filling(const Collapse& plan) {
  struct Outer {
    Index tail, head;
    HalfEdge twin, old;
  };
  fan(plan.from, fan_);
  std::vector<Outer> outer;
  for (const HalfEdge h : fan_)
    outer.push_back({to(h), from(Domain::previous(h)), twins_[Domain::next(h)], Domain::next(h)});
  if (twins_[fan_.front()] == kNone)
    outer.push_back({from(Domain::previous(fan_.back())), to(fan_.front()), kNone,
                     Domain::previous(fan_.back())});
  std::vector<BoundaryEdge> edges;
  for (const Outer& o : outer) edges.push_back(boundary_edges_[o.old]);
  for (const Index t : plan.gone) {
    live_ -= alive_[t];
    alive_[t] = 0;
  }
  std::vector<HalfEdge> diagonals;
  for (std::size_t k = 0; k < plan.filling.size(); ++k)
    for (std::size_t i = 0; i < 3; ++i) {
      const HalfEdge h = 3 * plan.star[k] + static_cast<HalfEdge>(i);
      const Index tail = plan.filling[k][i], head = plan.filling[k][(i + 1) % 3];
      journal_.corners.push_back({h, corners_[h]});
      corners_[h] = tail;
      const auto side = std::find_if(outer.begin(), outer.end(), [&](const Outer& o) {
        return o.tail == tail && o.head == head;
      });
      if (side == outer.end()) {
        diagonals.push_back(h);
        continue;
      }
      set_leaving(tail, h);
      set_twin(h, side->twin, edges[static_cast<std::size_t>(side - outer.begin())]);
    }
  for (const HalfEdge h : diagonals)
    for (const HalfEdge g : diagonals)
      if (h < g && from(h) == to(g) && to(h) == from(g)) set_twin(h, g, {});
}

void CollapseMesh::apply(const Collapse& plan) {
  journal_ = {};
  if (plan.flipped != kNone) return apply_flip(plan.flipped);
  if (!plan.filling.empty()) {
    journal_.gone = plan.gone;
    return apply_filling(plan);
  }
  fan(plan.from, fan_);
  journal_.gone = plan.gone;
  const bool open = twins_[fan_.front()] == kNone;
  if (!open)
    std::rotate(
        fan_.begin(),
        std::find_if(fan_.begin(), fan_.end(), [&](HalfEdge h) { return to(h) == plan.to; }),
        fan_.end());
  const std::size_t n = fan_.size();
  // The sides of the triangles that vanish, merged.
  const bool first_goes = !open || to(fan_.front()) == plan.to, last_goes = !open || !first_goes;
  HalfEdge leaves = kNone;
  const Index a = to(Domain::next(fan_.front())), b = to(fan_.back());
  if (last_goes) {
    const HalfEdge gone = Domain::next(fan_[n - 1]), kept = Domain::previous(fan_[n - 2]);
    const HalfEdge behind = Domain::previous(fan_[n - 1]);
    set_twin(kept, twins_[gone], boundary_edges_[gone]);
    set_leaving(b, kept);
    leaves = fan_[n - 2];
    if (open) {
      // The boundary that came to `from` goes on as the one that left it.
      const HalfEdge g = fan_.front();
      journal_.edges.push_back({g, boundary_edges_[g]});
      boundary_edges_[g] = boundary_edges_[behind];
      const Index ordinal = boundary_edges_[g].ordinal;
      journal_.ordinals.push_back({ordinal, by_ordinal_[ordinal]});
      by_ordinal_[ordinal] = g;
    }
  }
  if (first_goes) {
    const HalfEdge gone = Domain::next(fan_[0]), kept = fan_[1];
    set_twin(kept, twins_[gone], boundary_edges_[gone]);
    set_leaving(a, Domain::next(fan_[1]));
    leaves = fan_[1];
  }
  set_leaving(plan.to, leaves);
  for (const HalfEdge h : fan_) {
    if (h / 3 == plan.gone[0] || h / 3 == plan.gone[1]) continue;
    journal_.corners.push_back({h, corners_[h]});
    corners_[h] = plan.to;
  }
  for (const Index t : plan.gone) {
    live_ -= alive_[t];
    alive_[t] = 0;
  }
}

void CollapseMesh::undo() {
  const auto restore = [](auto& changes, auto& values) {
    for (auto c = changes.rbegin(); c != changes.rend(); ++c) values[c->first] = c->second;
  };
  restore(journal_.corners, corners_);
  restore(journal_.twins, twins_);
  restore(journal_.edges, boundary_edges_);
  restore(journal_.leaving, leaving_);
  restore(journal_.ordinals, by_ordinal_);
  for (const Index t : journal_.gone) {
    if (t == kNone) continue;
    live_ += alive_[t] == 0 ? 1 : 0;
    alive_[t] = 1;
  }
  journal_ = {};
}

PlanarField CollapseMesh::field(std::vector<Index>& vertex_of) const {
  PlanarField result;
  std::vector<Index> number(leaving_.size(), kNone);
  for (HalfEdge h = 0; h < corners_.size(); ++h)
    if (alive(h / 3)) number[corners_[h]] = 0;
  vertex_of.clear();
  for (Index v = 0; v < number.size(); ++v) {
    if (number[v] == kNone) continue;
    number[v] = static_cast<Index>(vertex_of.size());
    vertex_of.push_back(v);
    result.points.push_back(point(v));
    result.vectors.push_back(vector(v));
  }
  for (Index t = 0; t < triangle_count(); ++t)
    if (alive(t))
      result.triangles.push_back(
          {number[corners_[3 * t]], number[corners_[3 * t + 1]], number[corners_[3 * t + 2]]});
  return result;
}

}  // namespace crest::vector_fields
