// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/extremal/extraction.hpp"

#include <algorithm>

namespace crest::extremal {

Extraction::Extraction(Fields fields, const Options& options)
    : options_(options),
      fields_(std::move(fields)),
      nodes_(fields_, options.min_value),
      cells_(fields_, nodes_),
      edges_(fields_, nodes_, cells_),
      faces_(fields_, nodes_, cells_, edges_),
      clusters_(fields_, cells_, edges_, faces_) {}

MeasuredMesh Extraction::mesh(bool critical) const {
  MeasuredMesh r;
  r.sheets = make_sheets(fields_, cells_, edges_, faces_, critical);
  r.trimmed =
      trim(r.sheets, level_values(fields_, r.sheets, {options_.min_value, options_.min_strength}));
  r.measured = measure(fields_.grid(), r.sheets, r.trimmed);
  if (fields_.structure()) decide_isotopy(r.sheets, r.trimmed, clusters_, r.measured);
  return r;
}

Counts Extraction::counts(const MeasuredMesh& mesh) const {
  Counts c;
  c.nodes = fields_.grid().nodes();
  c.active_nodes = nodes_.count(NodeState::active);
  c.flat_nodes = nodes_.count(NodeState::flat);
  c.empty = cells_.count(CellState::empty);
  c.regular = cells_.count(CellState::regular) + cells_.count(CellState::regular_extremal);
  c.cone = cells_.count(CellState::cone);
  c.open = cells_.count(CellState::open);
  c.edges = edges_.count();
  c.critical_edges = edges_.critical_edges().size();
  for (const CriticalEdge& e : edges_.critical_edges()) {
    c.extremal_edges += edges_.state(e.edge) == EdgeState::extremal ? 1 : 0;
    c.undecided_types += edges_.state(e.edge) == EdgeState::type_undecided ? 1 : 0;
  }
  c.undecided_edges = edges_.undecided().size();
  c.valence = mesh.trimmed.valence;
  c.odd_valence_unexplained = mesh.trimmed.unexplained;
  c.bisections = edges_.depths();
  c.cone_tests = edges_.tests();
  count_crossings(fields_, edges_, faces_, c);
  return c;
}

Result Extraction::result(const MeasuredMesh& mesh) const {
  const Grid& g = fields_.grid();
  Result r;
  r.dimension = g.dimension();
  const double plane = std::min(g.spacing[0], g.spacing[1]);
  const double least = r.dimension == 2 ? plane : std::min(plane, g.spacing[2]);
  r.h = std::sqrt(2.0) * options_.sigma * std::ldexp(least, options_.refine);
  write_mesh(
      g, mesh,
      [&](const Vec3& x) {
        Node cell;
        Vec3 t;
        for (std::size_t k = 0; k < 3; ++k) {
          cell[k] = std::clamp(static_cast<int>(x[k]), 0, std::max(0, g.size[k] - 2));
          t[k] = x[k] - cell[k];
        }
        return fields_.at(cell, t);
      },
      r);
  const auto add = [&](Index e, bool type) {
    const Node v = g.node(e / 3);
    Vec3 a = {double(v[0]), double(v[1]), double(v[2])}, b = a;
    b[e % 3] += 1;
    r.undecided.push_back({g.position(a), g.position(b), type});
  };
  for (const Index e : edges_.undecided()) add(e, false);
  for (const CriticalEdge& e : edges_.critical_edges())
    if (edges_.state(e.edge) == EdgeState::type_undecided) add(e.edge, true);
  r.counts = counts(mesh);
  return r;
}

}  // namespace crest::extremal
