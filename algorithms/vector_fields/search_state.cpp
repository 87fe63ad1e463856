// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>

#include "algorithms/vector_fields/search.hpp"
#include "algorithms/vector_fields/walls.hpp"

namespace crest::vector_fields {

using kernel::cross;
using kernel::Sign;
using kernel::operator-;

Index SearchState::triangle_of(const SearchLine& line, std::size_t step) const {
  if (step < line.steps.size()) return line.steps[step].exit / 3;
  return line.end == EndKind::critical_point ? zeros[line.target].triangle : kNone;
}

const TrapShape* SearchState::trap_in(Index t, bool forward) const {
  const Index z = zero_in[t];
  if (z == kNone || !zeros[z].trap) return nullptr;
  return zeros[z].trap->attracting == forward ? &*zeros[z].trap : nullptr;
}

void SearchState::place_zero(Index zero, const SearchZero& at) {
  SearchZero& z = zeros[zero];
  if (z.triangle != kNone && zero_in[z.triangle] == zero) zero_in[z.triangle] = kNone;
  z = at;
  if (z.triangle == kNone) return;
  zero_in[z.triangle] = zero;
  if (z.kind != ZeroKind::sink && z.kind != ZeroKind::source) return;
  const bool attracting = z.kind == ZeroKind::sink;
  z.trap =
      ellipse_in(TriangleFrame<double>(mesh.data(z.triangle), 0, attracting, 0x1p-53), attracting);
}

std::optional<Index> SearchState::orbit_entered(bool forward, const Step& step) const {
  for (Index i = 0; i < orbits.size(); ++i) {
    const SearchOrbit& o = orbits[i];
    if (o.forward == forward && !o.exits.empty() && o.exits.front() == step.exit &&
        o.low.front() < step.share && step.share < o.high.front())
      return i;
  }
  return std::nullopt;
}

/// Lines in a triangle with two zero corners are straight, along the third one's vector.
std::optional<Index> SearchState::wall_reached(bool forward, HalfEdge entry, double share) const {
  const auto [p, v] = mesh.data(entry / 3);
  const std::size_t i = entry % 3, k = (i + 1) % 3;
  for (std::size_t c = 0; c < 3; ++c) {
    const std::size_t a = (c + 1) % 3, b = (c + 2) % 3;
    if (v[a] != Vec2{} || v[b] != Vec2{} || a == i) continue;
    Vec2 u = v[c];
    if (!forward) u = {-u[0], -u[1]};
    const Vec2 x = {p[i][0] + share * (p[k][0] - p[i][0]), p[i][1] + share * (p[k][1] - p[i][1])};
    // The wall's tail at the right, its head at the left.
    const double left = cross(u, p[b] - x), right = -cross(u, p[a] - x);
    if (cross(p[b] - p[a], u) < 0 && std::min(left, right) > kNearVertex * (left + right))
      return zero_of_triangle({input_.domain, input_.boundary, input_.zeros, input_.traps},
                              entry / 3);
  }
  return std::nullopt;
}

Index SearchState::region_left(const Step& step, bool forward) const {
  const EdgeRegions& r = mesh.boundary_edge(step.exit).regions;
  if (r.at_from == r.at_to) return r.at_from;
  const Index p = mesh.from(step.exit), q = mesh.to(step.exit);
  const Sign out = forward ? Sign::negative : Sign::positive;
  return kernel::flow_across(mesh.point(p), mesh.point(q), mesh.vector(p)) == out ? r.at_from
                                                                                  : r.at_to;
}

QuickEnd SearchState::follow(SearchLine& line, std::size_t most, EndKind& end, Index& target) {
  const bool forward = line.start.forward;
  if (line.steps.empty() && line.first) line.steps.push_back(*line.first);
  if (line.steps.empty()) {
    if (line.start.from_vertex) {
      const Start now = start_now(mesh, line.start.origin, forward);
      if (now.kind != StartKind::point) return QuickEnd::lost;
      line.start.place = now.place;
    }
    Start start = line.start;
    if (line.ordinal != kNone)
      (start.vertex == kNone ? start.place : start.vertex) = mesh.edge_of_ordinal(line.ordinal);
    const TrapShape* trap = start.vertex == kNone || !start.from_switch_point
                                ? trap_in(start.place / 3, forward)
                                : nullptr;
    Step step;
    const QuickEnd first = begin_quickly(mesh, start, trap, step);
    end = EndKind::critical_point;
    if (first == QuickEnd::trapped) target = zero_in[start.place / 3];
    if (first != QuickEnd::crossed) return first;
    line.steps.push_back(step);
  }
  for (;;) {
    const Step last = line.steps.back();
    if (const auto orbit = orbit_entered(forward, last)) {
      end = EndKind::closed_orbit;
      target = *orbit;
      return QuickEnd::trapped;
    }
    const HalfEdge entry = mesh.twin(last.exit);
    if (entry == kNone) {
      end = EndKind::boundary;
      target = region_left(last, forward);
      return QuickEnd::trapped;
    }
    if (frozen_[entry / 3] == 2)
      if (const auto wall = wall_reached(forward, entry, 1 - last.share)) {
        end = EndKind::zero_flow;
        target = *wall;
        return QuickEnd::trapped;
      }
    if (line.steps.size() > most) return QuickEnd::lost;
    Step step;
    ++crossings;
    const QuickEnd result = cross_quickly(mesh, forward, entry, 1 - last.share,
                                          trap_in(entry / 3, forward), step, &tried_);
    if (result == QuickEnd::trapped) {
      // Where it was, lines were proven to end.
      if (zeros[zero_in[entry / 3]].moved &&
          !provable(mesh, forward, entry, 1 - last.share, trap_in(entry / 3, forward)))
        return QuickEnd::lost;
      end = EndKind::critical_point;
      target = zero_in[entry / 3];
    }
    if (result != QuickEnd::crossed) return result;
    line.steps.push_back(step);
  }
}

Vec2 SearchState::place_of(Index zero) const {
  if (zeros[zero].triangle == kNone) return input_.zeros[zero].item.point;
  return zero_in_triangle(mesh.data(zeros[zero].triangle));
}

Vec2 SearchState::place(const Step& step) const {
  return place_on(mesh, step);
}

bool SearchState::close(const SearchOrbit& orbit, std::size_t k, double wider,
                        SearchOrbit& result) const {
  const double middle = (orbit.low[k] + orbit.high[k]) / 2,
               half = wider * (orbit.high[k] - orbit.low[k]) / 2;
  result = {orbit.forward, {orbit.exits[k]}, {middle - half}, {middle + half}};
  const double low = result.low[0], high = result.high[0], room = 0x1p-10 * (high - low);
  if (!(low > kNearVertex && high < 1 - kNearVertex && room > 0x1p-44)) return false;
  const std::size_t most = 2 * orbit.exits.size() + 64;
  while (result.exits.size() < most) {
    const HalfEdge entry = mesh.twin(result.exits.back());
    if (entry == kNone) return false;
    Step l, h;
    for (const auto& [from, step] : {std::pair{result.low.back(), &l}, {result.high.back(), &h}})
      if (cross_quickly(mesh, orbit.forward, entry, 1 - from, nullptr, *step, nullptr) !=
          QuickEnd::crossed)
        return false;
    if (l.exit != h.exit || l.share > h.share) return false;
    result.low.push_back(l.share);
    result.high.push_back(h.share);
    if (l.exit == result.exits.front()) {
      if (l.share > low + room && h.share < high - room) return true;
      if (l.share < high && h.share > low) return false;
    }
    result.exits.push_back(l.exit);
  }
  return false;
}

std::vector<Index> SearchState::enclosed(const SearchOrbit& orbit) const {
  if (orbit.exits.empty()) return {};
  // From the gate's return: near the orbit.
  const auto polygon =
      points_along(mesh, orbit.forward, mesh.twin(orbit.exits.front()),
                   1 - (orbit.low.back() + orbit.high.back()) / 2, orbit.exits.size());
  std::vector<Index> result;
  if (polygon.empty()) return result;
  std::array<Vec2, 2> box = {polygon[0], polygon[0]};
  for (const Vec2& p : polygon)
    for (std::size_t k = 0; k < 2; ++k) {
      box[0][k] = std::min(box[0][k], p[k]);
      box[1][k] = std::max(box[1][k], p[k]);
    }
  const auto runs_around = [&](const Vec2& x) {
    return x[0] >= box[0][0] && x[0] <= box[1][0] && x[1] >= box[0][1] && x[1] <= box[1][1] &&
           inside(polygon, x);
  };
  for (Index z = 0; z < zeros.size(); ++z)
    if (zeros[z].kept && runs_around(place_of(z))) result.push_back(z);
  for (Index i = 0; i < loop_points_.size(); ++i)
    if (runs_around(loop_points_[i])) result.push_back(static_cast<Index>(zeros.size()) + i);
  return result;
}

Index SearchState::end_of(Index line) const {
  const SearchLine& l = lines[line];
  const Index regions = slots_.count(), z = static_cast<Index>(zeros.size());
  switch (l.end) {
    case EndKind::boundary:
      return l.target;
    case EndKind::critical_point:
      // Around a vertex, or on an edge, the order is left to the checker.
      if (input_.zeros[l.target].item.where != ZeroPlace::triangle) return kNone;
      [[fallthrough]];
    case EndKind::zero_flow:
      return regions + l.target;
    case EndKind::closed_orbit: {
      const SearchOrbit& o = orbits[l.target];
      if (o.exits.empty() || l.steps.empty()) return kNone;
      // What comes from outside comes between the segment's end and its return.
      const double s = l.steps.back().share;
      if (s > o.low.back() && s < o.high.back()) return kNone;
      return regions + z + 2 * l.target + (s >= o.high.back() ? 0 : 1);
    }
    default:
      return kNone;
  }
}

bool SearchState::cyclic(Index end) const {
  return end >= slots_.count() || slots_.cyclic(end);
}

std::optional<Arrival> SearchState::arrival(Index line, Index end) const {
  const SearchLine& l = lines[line];
  if (l.steps.empty()) {
    // It starts in the zero's triangle, at the boundary.
    if (l.ordinal == kNone && !l.start.from_vertex) return std::nullopt;
    const HalfEdge side = l.start.from_vertex ? l.start.place : mesh.edge_of_ordinal(l.ordinal);
    return Arrival{line, side % 3, &l.steps, 0};
  }
  Arrival a{line, 0, &l.steps, l.steps.size() - 1};
  if (l.start.from_switch_point || l.start.from_vertex)
    a.side = l.start.place;
  else
    a.zero = place_of(l.start.origin);
  const HalfEdge exit = l.steps.back().exit;
  if (l.end == EndKind::boundary) a.slot = slots_.slot(end, mesh.boundary_edge(exit).ordinal);
  if (l.end == EndKind::critical_point) a.slot = mesh.twin(exit) % 3;
  return a;
}

SearchState::Order SearchState::order_at(Index end) {
  const auto& ids = arrivals[end];
  if (ids.size() < 2 || (ids.size() == 2 && cyclic(end))) return Order::same;
  std::vector<Arrival> all;
  for (const Index line : ids) {
    const auto a = arrival(line, end);
    if (!a) return Order::open;
    all.push_back(*a);
  }
  // Along the boundary lines at the right come first, around a triangle those at the left.
  const auto same = in_order(mesh, all, cyclic(end), end >= slots_.count(), inherited);
  if (!same) return Order::open;
  return *same ? Order::same : Order::other;
}

}  // namespace crest::vector_fields
