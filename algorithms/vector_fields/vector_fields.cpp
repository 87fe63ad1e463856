// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/vector_fields/vector_fields.hpp"

#include "algorithms/vector_fields/analysis.hpp"
#include "algorithms/vector_fields/annulus.hpp"
#include "algorithms/vector_fields/starts.hpp"
#include "kernel/predicates/planar_field.hpp"

namespace crest::vector_fields {

namespace {

Separatrix separatrix_of(const Trace& t, Vec2 from) {
  Separatrix s;
  s.forward = t.start.forward;
  s.from_switch_point = t.start.from_switch_point;
  s.origin = t.start.origin;
  s.end = t.end;
  s.target = t.target;
  s.reason = t.reason;
  s.bits = t.setting.bits;
  s.width = t.width;
  s.crossings = static_cast<Index>(t.turns.size());
  s.line.push_back(from);
  s.line.insert(s.line.end(), t.line.begin(), t.line.end());
  return s;
}

/// The edges of the loops, cut at switch points.
std::vector<BoundaryPiece> pieces_of(const Domain& domain, const Boundary& boundary) {
  std::unordered_map<HalfEdge, Vec2> cuts;
  for (const SwitchPoint& s : boundary.switch_points)
    if (!s.at_vertex) cuts.emplace(s.edge, s.point);
  std::vector<BoundaryPiece> pieces;
  for (const auto& loop : boundary.half_edges)
    for (const HalfEdge h : loop) {
      const Vec2 &p = domain.point(domain.from(h)), &q = domain.point(domain.to(h));
      const auto flow = [&](Index v) {
        return static_cast<int>(kernel::flow_across(p, q, domain.vector(v)));
      };
      const int at_p = flow(domain.from(h)), at_q = flow(domain.to(h));
      const auto cut = cuts.find(h);
      if (cut == cuts.end()) {
        pieces.push_back({p, q, at_p != 0 ? at_p : at_q});
      } else {
        pieces.push_back({p, cut->second, at_p});
        pieces.push_back({cut->second, q, at_q});
      }
    }
  return pieces;
}

}  // namespace

Analysis::Analysis(const PlanarField& field) : Analysis(field, {}, nullptr) {}

Analysis::Analysis(const PlanarField& field, const std::vector<AnnulusDoor>& doors,
                   const std::vector<Witness>& given)
    : Analysis(field, doors, &given) {}

Analysis::Analysis(const PlanarField& field, const std::vector<AnnulusDoor>& doors,
                   const std::vector<Witness>* given)
    : domain(field) {
  zeros = find_zeros(domain);
  classify_fans(domain, zeros, portraits);
  boundary = examine_boundary(domain);
  traps = make_traps(domain, zeros);
  const Surroundings around{domain, boundary, zeros, traps};
  AnnulusNotes notes;
  AnnulusSearch search(around, notes);
  for (const AnnulusDoor& door : doors) search.try_door(door);
  annuli = std::move(notes.found);
  traces = trace_all(around, find_starts(domain, zeros, portraits, boundary), annuli);
  if (given == nullptr) {
    witnesses = find_witnesses(around, traces, annuli);
  } else {
    witnesses = *given;
    follow_witnesses(around, witnesses, traces, annuli);
  }
}

Skeleton Analysis::skeleton() const {
  Skeleton result;
  result.euler_characteristic = domain.euler_characteristic();
  result.components = domain.components();
  result.zero_triangles = domain.zero_triangles();
  result.zero_regions = domain.zero_regions();
  result.zero_edges = domain.zero_edges();
  for (const ZeroComponent& z : zeros) {
    result.critical_points.push_back(z.item);
    if (z.item.index) result.index_sum += *z.item.index;
  }
  result.winding_sum = winding_around(domain, boundary, zeros);
  result.switch_points = boundary.switch_points;
  result.loops = boundary.loops;
  for (const Trace& t : traces) {
    if (t.start.from_vertex) {
      result.witnesses.push_back(separatrix_of(t, domain.point(t.start.origin)));
      continue;
    }
    const Vec2 from = t.start.from_switch_point ? boundary.switch_points[t.start.origin].point
                                                : zeros[t.start.origin].item.point;
    Separatrix& s = result.separatrices.emplace_back(separatrix_of(t, from));
    if (s.end == EndKind::critical_point) {
      const CriticalPoint& end = zeros[s.target].item;
      if (end.where == ZeroPlace::triangle || !t.straight) s.line.push_back(end.point);
    }
    result.counts.crossings += s.crossings;
    if (s.end != EndKind::undecided) ++result.counts.bits[s.bits];
  }
  result.boundary = pieces_of(domain, boundary);
  for (const Annulus& a : annuli) result.orbits.push_back({a.forward, a.line});
  return result;
}

Skeleton extract_skeleton(const PlanarField& field) {
  return Analysis(field).skeleton();
}

}  // namespace crest::vector_fields
