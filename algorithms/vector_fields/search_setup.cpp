// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>

#include "algorithms/vector_fields/search.hpp"

namespace crest::vector_fields {

using kernel::dot;
using kernel::operator-;

namespace {

constexpr std::size_t kMostSteps = 100'000;

double from_tail(double t) {
  return t > 0 ? t : 1 + t;
}

}  // namespace

std::vector<Step> steps_of(const Domain& domain, const Trace& trace) {
  std::vector<Step> steps;
  if (trace.straight) return steps;
  const bool ray = trace.leg.kind == StartKind::ray || trace.leg.kind == StartKind::fan_ray;
  if (ray) steps.push_back({trace.first_side, 0});
  HalfEdge entry = ray ? domain.twin(trace.first_side) : trace.leg.place;
  for (const std::uint8_t turn : trace.turns) {
    const HalfEdge exit = 3 * (entry / 3) + (entry % 3 + turn + 1) % 3;
    steps.push_back({exit, 0});
    entry = domain.twin(exit);
  }
  // One place a step, the last ones of the line.
  const std::size_t before = trace.line.size() - steps.size();
  for (std::size_t k = 0; k < steps.size(); ++k) {
    const Vec2 p = domain.point(domain.from(steps[k].exit));
    const Vec2 e = domain.point(domain.to(steps[k].exit)) - p;
    steps[k].share = dot(trace.line[before + k] - p, e) / dot(e, e);
  }
  return steps;
}

SearchState::SearchState(const Analysis& input, const std::vector<bool>& pinned, const Kept& kept)
    : mesh(input.domain, input.boundary),
      zero_in(input.domain.triangle_count(), kNone),
      passing(input.domain.triangle_count()),
      input_(input),
      kept_(kept),
      slots_(input.boundary),
      frozen_(input.domain.triangle_count(), 0) {
  for (const auto& loop : input.boundary.half_edges)
    loop_points_.push_back(mesh.point(mesh.from(loop.front())));
  take_zeros();
  take_orbits();
  take_lines(pinned);
  note_passing();
  note_arrivals();
}

void SearchState::take_zeros() {
  const Domain& domain = input_.domain;
  zeros.resize(input_.zeros.size());
  for (Index z = 0; z < zeros.size(); ++z) {
    const CriticalPoint& item = input_.zeros[z].item;
    if (item.where == ZeroPlace::triangle) {
      place_zero(z, {item.kind, item.simplex, false, kept_.zeros[z]});
      continue;
    }
    for (const Index t : input_.zeros[z].triangles) frozen_[t] = 1;
  }
  for (Index t = 0; t < domain.triangle_count(); ++t) {
    int count = 0;
    for (HalfEdge h = 3 * t; h < 3 * t + 3; ++h) count += domain.is_zero(domain.from(h)) ? 1 : 0;
    if (count >= 2) frozen_[t] = count == 2 ? 2 : 1;
  }
}

void SearchState::take_orbits() {
  // Those at which nothing ends that has to stay may go.
  std::vector<bool> used(input_.annuli.size(), kept_.all());
  for (std::size_t i = 0; i < input_.traces.size(); ++i)
    if (const Trace& t = input_.traces[i]; t.end == EndKind::closed_orbit && kept_.lines[i])
      used[t.target] = true;
  for (const Annulus& a : input_.annuli) {
    if (!used[orbits.size()]) {
      orbits.emplace_back().forward = a.forward;
      continue;
    }
    SearchOrbit gate{
        a.forward, {mesh.twin(a.side)}, {1 - from_tail(a.right)}, {1 - from_tail(a.left)}};
    gate.exits.resize(a.turns.size(), kNone);
    SearchOrbit& orbit = orbits.emplace_back();
    orbit.forward = a.forward;
    if (SearchOrbit closed; close(gate, 0, 1, closed)) {
      orbit = closed;
      orbit.around = enclosed(orbit);
      continue;
    }
    HalfEdge entry = a.side;
    for (const std::uint8_t turn : a.turns) {
      if (frozen_[entry / 3] == 0) frozen_[entry / 3] = 1;
      entry = mesh.twin(3 * (entry / 3) + (entry % 3 + turn + 1) % 3);
    }
  }
}

/// Keeps all triangles that a separatrix meets.
void SearchState::freeze_way(const Trace& trace) {
  const auto freeze = [&](Index t) {
    if (frozen_[t] == 0) frozen_[t] = 1;
  };
  if (trace.straight)
    for (const Index t : trace.straight->triangles) freeze(t);
  freeze(trace.start.place == kNone ? trace.start.vertex / 3 : trace.start.place / 3);
  if (trace.leg.kind == StartKind::none) return;
  for (const Step& s : steps_of(input_.domain, trace)) {
    freeze(s.exit / 3);
    if (const HalfEdge g = mesh.twin(s.exit); g != kNone) freeze(g / 3);
  }
}

void SearchState::take_lines(const std::vector<bool>& pinned) {
  for (std::size_t i = 0; i < input_.traces.size(); ++i) {
    const Trace& trace = input_.traces[i];
    SearchLine& line = lines.emplace_back();
    line.start = trace.start;
    line.end = trace.end;
    line.target = trace.target;
    if (trace.start.from_switch_point) {
      const HalfEdge edge = trace.start.vertex == kNone ? trace.start.place : trace.start.vertex;
      line.ordinal = mesh.boundary_edge(edge).ordinal;
    }
    if (!kept_.lines[i]) line.end = EndKind::undecided;
    if (trace.start.from_vertex) mesh.keep(trace.start.origin);
    if (line.end == EndKind::undecided) continue;
    if (const auto steps = steps_of(input_.domain, trace); !trace.straight && !steps.empty())
      line.first = steps.front();
    EndKind end = EndKind::undecided;
    Index target = kNone;
    if (!trace.straight && !pinned[i] &&
        follow(line, kMostSteps, end, target) == QuickEnd::trapped && end == line.end &&
        target == line.target)
      continue;
    line.steps.clear();
    if (!trace.straight) line.steps = steps_of(input_.domain, trace);
    freeze_way(trace);
  }
}

void SearchState::note_passing() {
  for (Index i = 0; i < lines.size(); ++i)
    for (std::size_t k = 0; k <= lines[i].steps.size(); ++k)
      if (const Index t = triangle_of(lines[i], k); t != kNone) passing[t].push_back(i);
  for (Index i = 0; i < orbits.size(); ++i)
    for (const HalfEdge h : orbits[i].exits) passing[h / 3].push_back(line_count() + i);
}

void SearchState::note_arrivals() {
  arrivals.resize(slots_.count() + zeros.size() + 2 * orbits.size());
  for (Index i = 0; i < lines.size(); ++i)
    if (const Index end = end_of(i);
        end != kNone && (!lines[i].steps.empty() || lines[i].end == EndKind::critical_point))
      arrivals[end].push_back(i);
  for (Index end = 0; end < arrivals.size(); ++end) {
    std::vector<Arrival> all;
    bool known = true;
    for (const Index line : arrivals[end]) {
      const auto a = arrival(line, end);
      known = known && a;
      if (a) all.push_back(*a);
    }
    known = known && sort_arrivals(mesh, all, end >= slots_.count(), inherited);
    arrivals[end].clear();
    // Where two are too near from their starts on, no order is asked for here.
    if (known)
      for (const Arrival& a : all) {
        arrivals[end].push_back(a.line);
        lines[a.line].ordered = true;
      }
  }
}

}  // namespace crest::vector_fields
