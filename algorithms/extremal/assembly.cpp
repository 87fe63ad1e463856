// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/extremal/assembly.hpp"

#include <algorithm>
#include <cmath>

namespace crest::extremal {

Assembly::Assembly(const Grid& grid, const Options& options, Records records)
    : grid_(grid),
      options_(options),
      records_(std::move(records)),
      clusters_(grid_, records_.cells),
      counts_(record_counts()) {}

MeasuredMesh Assembly::mesh(bool critical) const {
  MeasuredMesh r;
  r.sheets = make_sheets(grid_, records_, critical);
  LevelValues values;
  if (Levels{options_.min_value, options_.min_strength}.any()) {
    for (const SheetRecord& s : records_.sheets[critical ? 1 : 0])
      values.corners.push_back(s.level);
    auto at = records_.critical.begin();
    for (const SheetPolygon& p : r.sheets.polygons) {
      while (at->edge != p.edge) ++at;
      values.centres.push_back(at->level);
    }
  }
  r.trimmed = trim(r.sheets, values);
  r.measured = measure(grid_, r.sheets, r.trimmed);
  if (options_.definition == Definition::structure)
    decide_isotopy(r.sheets, r.trimmed, clusters_, r.measured);
  return r;
}

Counts Assembly::record_counts() const {
  Counts c;
  c.critical_edges = records_.critical.size();
  for (const CriticalRecord& e : records_.critical) {
    c.extremal_edges += e.state == EdgeState::extremal ? 1 : 0;
    c.undecided_types += e.state == EdgeState::type_undecided ? 1 : 0;
  }
  c.undecided_edges = records_.undecided.size();
  for (const FaceRecord& f : records_.faces) {
    c.odd_faces += f.odd() ? 1 : 0;
    c.ambiguous_faces += f.ambiguous() ? 1 : 0;
    c.junction_edges += f.odd() && f.critical == 3 ? 1 : 0;
  }
  return c;
}

Counts Assembly::counts(const MeasuredMesh& mesh) const {
  const RecordCounts& n = records_.counts;
  const auto of = [&](CellState s) { return n.cells[static_cast<std::size_t>(s)]; };
  Counts c = counts_;
  c.nodes = grid_.nodes();
  c.active_nodes = n.nodes[static_cast<std::size_t>(NodeState::active)];
  c.flat_nodes = n.nodes[static_cast<std::size_t>(NodeState::flat)];
  c.empty = of(CellState::empty);
  c.regular = of(CellState::regular) + of(CellState::regular_extremal);
  c.cone = of(CellState::cone);
  c.open = of(CellState::open);
  c.bisections.assign(n.depths.begin(), n.depths.end());
  for (const std::size_t edges : c.bisections) c.edges += edges;
  while (c.bisections.size() > 1 && c.bisections.back() == 0) c.bisections.pop_back();
  c.cone_tests = n.tests;
  c.valence = mesh.trimmed.valence;
  c.odd_valence_unexplained = mesh.trimmed.unexplained;
  c.sheets_split = n.sheets_split;
  return c;
}

Result Assembly::result(MeasuredMesh mesh, const ValuesAt& values) const {
  Result r;
  r.counts = counts(mesh);
  r.dimension = grid_.dimension();
  const double plane = std::min(grid_.spacing[0], grid_.spacing[1]);
  const double least = r.dimension == 2 ? plane : std::min(plane, grid_.spacing[2]);
  r.h = std::sqrt(2.0) * options_.sigma * std::ldexp(least, options_.refine);
  write_mesh(grid_, mesh, values, r);
  const auto add = [&](Index e, bool type) {
    const Vec3 a = as_vector(grid_.node(e / 3));
    Vec3 b = a;
    b[e % 3] += 1;
    r.undecided.push_back({grid_.position(a), grid_.position(b), type});
  };
  for (const Index e : records_.undecided) add(e, false);
  for (const CriticalRecord& e : records_.critical)
    if (e.state == EdgeState::type_undecided) add(e.edge, true);
  return r;
}

}  // namespace crest::extremal
