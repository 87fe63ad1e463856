// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <random>

#include "certify/modes/positions.hpp"
#include "tests/certify_modes/reference_modes.hpp"
#include "tests/support/random.hpp"

namespace crest::tests {
namespace {

using namespace certify;
using namespace certify::modes;

/// Places of an edge's roots, ascending: equal steps in an enclosure for a pair, and between an end
/// and the next enclosure for a root without a width.
void place_roots(const ModeLevel& level, const EdgeNode& edge, std::vector<double>& places) {
  const auto* roots = level.roots.data() + edge.root;
  for (unsigned i = 0; i < edge.roots; ++i) {
    double low = roots[i].low, high = roots[i].high;
    if (low == high) {
      if (low == 0) high = i + 1 < edge.roots ? roots[i + 1].low : 1;
      if (high == 1 && low == 1) low = i > 0 ? roots[i - 1].high : 0;
    }
    const bool second = i > 0 && roots[i - 1].low == roots[i].low && low < high &&
                        roots[i - 1].high == roots[i].high;
    const bool first = i + 1 < edge.roots && roots[i + 1].low == roots[i].low &&
                       roots[i + 1].high == roots[i].high && low < high;
    places[edge.root + i] = low + (high - low) * (second ? 0.75 : first ? 0.25 : 0.5);
  }
}

}  // namespace

void add_positions(ModesCertificate& c, unsigned points, std::uint64_t seed) {
  Random random(seed);
  Field field(c.tensors);
  const Domain domain = build_domain(c, field);
  for (ModeLevel& level : c.levels) {
    field.drop_splits();
    const Trees trees = read_trees(level, domain, field);
    level.root_places.assign(level.roots.size(), 0);
    for (const EdgeNode& edge : trees.edges)
      if (edge.leaf()) place_roots(level, edge, level.root_places);
    level.arc_points.assign(level.arcs.size(), static_cast<std::uint16_t>(points));
    level.points.clear();
    for (std::size_t i = 0; i < points * level.arcs.size(); ++i) {
      std::uniform_real_distribution<double> part(0.05, 0.45);
      const double a = part(random), b = part(random);
      level.points.push_back({a, b});
    }
  }
  count_positions(c);
}

void count_positions(ModesCertificate& c) {
  const bool embedded = is_embedded(c);
  Field field(c.tensors);
  const Domain domain = build_domain(c, field);
  for (ModeLevel& level : c.levels) {
    field.drop_splits();
    Trees trees = read_trees(level, domain, field);
    trees.mark_needed(domain, field);
    const LevelContext context(level, field, trees);
    Worker worker(field);
    const Positions positions(context);
    PlacedPieces sum;
    const auto add = [&](const PlacedPieces& found) {
      sum.placed += found.placed, sum.not_placed += found.not_placed;
    };
    std::vector<CellPieces> pieces(trees.cells.size());
    check_cells(context, trees.cells, pieces, worker);
    for (std::size_t i = 0; i < pieces.size(); ++i)
      if (!pieces[i].levels.empty()) add(positions.place_cell(trees.cells[i], pieces[i]));
    for (u32 t = 0; t < domain.tets.size(); ++t) {
      const auto corners = nonzero_corners(field, domain.tets[t]);
      if (corners.size() == 3 && std::ranges::find(trees.open_tets, t) == trees.open_tets.end())
        add(positions.place_cones(trees.face({corners[0], corners[1], corners[2]})));
    }
    level.placed = embedded ? sum.placed : 0;
    level.not_placed = sum.placed + sum.not_placed - level.placed;
  }
}

}  // namespace crest::tests
