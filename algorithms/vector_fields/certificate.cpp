// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/vector_fields/certificate.hpp"

#include <algorithm>

#include "algorithms/vector_fields/analysis.hpp"
#include "algorithms/vector_fields/skeleton_match.hpp"

namespace crest::vector_fields {

namespace {

certify::SkeletonZero record_of(const ZeroComponent& z) {
  const CriticalPoint& item = z.item;
  certify::SkeletonZero r;
  r.triangle = z.triangles.front();
  r.place = static_cast<certify::ZeroPlace>(item.where);
  const bool inside = item.where == ZeroPlace::triangle;
  r.kind = inside ? static_cast<certify::ZeroClass>(item.kind) : certify::ZeroClass::higher_order;
  r.focus = inside && item.focus ? 1 : 0;
  if (item.index) r.index = *item.index;
  if (item.index && item.sectors) {
    r.hyperbolic = static_cast<std::uint32_t>(item.sectors->hyperbolic);
    r.elliptic = static_cast<std::uint32_t>(item.sectors->elliptic);
  }
  return r;
}

certify::SkeletonSwitch record_of(const SwitchPoint& s) {
  return {s.side,
          static_cast<std::uint8_t>(!s.at_vertex ? 0
                                    : s.tangent  ? 2
                                                 : 1),
          static_cast<std::uint8_t>(s.inside ? 1 : 0)};
}

certify::SkeletonLoop record_of(const BoundaryLoop& l, HalfEdge first) {
  certify::SkeletonLoop r;
  r.side = first;
  if (!l.winding) {
    r.zero = 1;
    return r;
  }
  r.winding = *l.winding;
  r.turning = l.turning;
  r.interior = static_cast<std::uint32_t>(l.interior);
  r.exterior = static_cast<std::uint32_t>(l.exterior);
  r.inflow = static_cast<std::uint32_t>(l.inflow);
  r.outflow = static_cast<std::uint32_t>(l.outflow);
  return r;
}

certify::SkeletonBarrier record_of(const BarrierSetting& s) {
  return {static_cast<std::uint8_t>(s.degree), static_cast<std::uint16_t>(s.angle),
          static_cast<std::uint16_t>(s.bits), static_cast<std::int8_t>(s.shrink)};
}

std::vector<certify::Turn> turns_of(const std::vector<std::uint8_t>& turns) {
  std::vector<certify::Turn> r;
  for (const std::uint8_t t : turns) r.push_back(static_cast<certify::Turn>(t));
  return r;
}

std::vector<certify::SkeletonException> exceptions_of(
    const std::vector<std::pair<Index, BarrierSetting>>& special) {
  std::vector<certify::SkeletonException> r;
  for (const auto& [step, setting] : special) r.push_back({step, record_of(setting)});
  return r;
}

/// Two sums of as many terms, one after the other.
std::vector<double> joined(Expansion a, Expansion b) {
  const std::size_t n = std::max(a.size(), b.size());
  a.resize(n, 0);
  b.resize(n, 0);
  a.insert(a.end(), b.begin(), b.end());
  return a;
}

certify::SkeletonLeg leg_of(const Trace& t) {
  certify::SkeletonLeg leg;
  leg.turns = turns_of(t.turns);
  leg.barrier = record_of(t.setting);
  leg.exceptions = exceptions_of(t.special);
  leg.corner = t.leg.place;
  if (t.leg.kind == StartKind::ray || t.leg.kind == StartKind::fan_ray) {
    leg.kind = certify::LegKind::ray;
    leg.corner = t.first_side;
    leg.first = t.first;
    leg.second = t.second;
  } else if (t.leg.kind == StartKind::along) {
    leg.kind = certify::LegKind::along;
    leg.first = t.first;
    leg.second = joined(t.second, t.second_height);
  } else {
    leg.kind = certify::LegKind::point;
  }
  return leg;
}

certify::SkeletonEnd end_of(EndKind end) {
  switch (end) {
    case EndKind::critical_point:
    case EndKind::zero_flow:
      return certify::SkeletonEnd::zero;
    case EndKind::switch_point:
      return certify::SkeletonEnd::switch_point;
    case EndKind::boundary:
      return certify::SkeletonEnd::boundary;
    case EndKind::closed_orbit:
      return certify::SkeletonEnd::orbit;
    default:
      return certify::SkeletonEnd::undecided;
  }
}

certify::SkeletonSeparatrix record_of(const Trace& t) {
  certify::SkeletonSeparatrix r;
  r.origin = t.start.from_vertex         ? certify::SkeletonOrigin::vertex
             : t.start.from_switch_point ? certify::SkeletonOrigin::switch_point
                                         : certify::SkeletonOrigin::zero;
  r.from = t.start.from_vertex ? t.start.vertex : t.start.origin;
  r.backward = t.start.forward ? 0 : 1;
  r.end = end_of(t.end);
  if (t.end == EndKind::undecided) {
    r.reason = static_cast<certify::OpenReason>(t.reason);
    return r;
  }
  r.to = t.target;
  if (t.straight) {
    certify::SkeletonLeg& leg = r.legs.emplace_back();
    leg.kind = certify::LegKind::straight;
    leg.first = {t.straight->direction[0], t.straight->direction[1]};
    leg.elements = t.straight->elements;
    if (t.straight->vertex != kNone) leg.corner = t.straight->vertex;
  }
  if (t.leg.kind != StartKind::none) r.legs.push_back(leg_of(t));
  return r;
}

certify::SkeletonOrbit record_of(const Annulus& a) {
  certify::SkeletonOrbit r;
  r.side = a.side;
  r.backward = a.forward ? 0 : 1;
  r.left = a.left;
  r.right = a.right;
  r.turns = turns_of(a.turns);
  r.barrier = record_of(a.setting);
  r.exceptions = exceptions_of(a.special);
  return r;
}

/// Of the zeros in which separatrices end.
std::vector<certify::SkeletonTrap> traps_of(const Analysis& a) {
  std::vector<bool> used(a.zeros.size(), false);
  for (const Trace& t : a.traces)
    if (t.end == EndKind::critical_point) used[t.target] = true;
  std::vector<certify::SkeletonTrap> r;
  for (Index i = 0; i < a.zeros.size(); ++i) {
    if (!used[i]) continue;
    if (a.zeros[i].item.where == ZeroPlace::vertex) {
      const auto polygon = polygon_around(a.domain, a.zeros[i]);
      if (!polygon) continue;
      certify::SkeletonTrap& trap = r.emplace_back();
      trap.zero = i;
      for (std::size_t k = 0; k < polygon->leaving.size(); ++k)
        trap.star.push_back({polygon->leaving[k], polygon->shares[k], 0});
      continue;
    }
    const auto trap = a.traps.find(a.zeros[i].triangles.front());
    if (trap != a.traps.end() && trap->second.zero == i) r.push_back({i, trap->second.shape.p, {}});
  }
  return r;
}

}  // namespace

namespace {

certify::SkeletonCertificate record_of(const Analysis& a) {
  const PlanarField& field = a.domain.field();
  certify::SkeletonCertificate record;
  record.positions = field.points;
  record.vectors = field.vectors;
  record.triangles = field.triangles;
  for (const ZeroComponent& z : a.zeros) record.zeros.push_back(record_of(z));
  for (const SwitchPoint& s : a.boundary.switch_points) record.switches.push_back(record_of(s));
  for (std::size_t i = 0; i < a.boundary.loops.size(); ++i)
    record.loops.push_back(record_of(a.boundary.loops[i], a.boundary.half_edges[i].front()));
  record.traps = traps_of(a);
  for (const Annulus& o : a.annuli) record.orbits.push_back(record_of(o));
  for (const Trace& t : a.traces) record.separatrices.push_back(record_of(t));
  for (const ZeroComponent& z : a.zeros) record.index_sum += z.item.index.value_or(0);
  for (const auto& s : record.separatrices) ++record.ends[static_cast<std::size_t>(s.end)];
  return record;
}

/// Of a line that is undecided in the input nothing is claimed in the output.
void forget(certify::SkeletonCertificate& record, Index line, certify::OpenReason reason) {
  certify::SkeletonSeparatrix& s = record.separatrices[line];
  --record.ends[static_cast<std::size_t>(s.end)];
  s.legs.clear();
  s.end = certify::SkeletonEnd::undecided;
  s.to = 0;
  s.reason = reason;
  ++record.ends[static_cast<std::size_t>(s.end)];
}

}  // namespace

Skeleton extract_skeleton(const PlanarField& field, certify::SkeletonCertificate& record) {
  const Analysis a(field);
  record = record_of(a);
  return a.skeleton();
}

Compression compress(const PlanarField& field, const CompressionOptions& options,
                     certify::CompressionCertificate& record) {
  record = {};
  record.notion = static_cast<certify::SkeletonNotion>(options.equivalence);
  Compression result = compress(
      field, options,
      [&](const Analysis& input, const Analysis& output, const SkeletonMatch& match) {
        record.input = record_of(input);
        record.output = record_of(output);
        if (options.simplify) return;  // two skeletons
        record.zeros = match.zeros;
        record.orbits = match.orbits;
        record.separatrices = match.separatrices;
        for (Index i = 0; i < input.traces.size(); ++i)
          if (input.traces[i].end == EndKind::undecided)
            forget(record.output, match.separatrices[i], record.input.separatrices[i].reason);
      });
  record.vertices = result.vertex_of;
  return result;
}

}  // namespace crest::vector_fields
