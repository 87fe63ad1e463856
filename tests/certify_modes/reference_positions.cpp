// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <random>

#include "certify/modes/near_vertices.hpp"
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

double mode_of(const std::array<double, 6>& d) {
  const double det = d[0] * (d[1] * d[2] - d[4] * d[4]) - d[3] * (d[3] * d[2] - d[4] * d[5]) +
                     d[5] * (d[3] * d[4] - d[1] * d[5]);
  double norm = 0;
  for (std::size_t k = 0; k < 6; ++k) norm += (k < 3 ? 1 : 2) * d[k] * d[k];
  return 3 * std::sqrt(6.0) * det / std::pow(norm, 1.5);
}

/// Weights of a point of a cell, by halving between two random ones where the mode crosses the
/// level; `off`: how far from there to the second.
std::array<double, 3> vertex_between(const Field& field, const Cell& cell, double mode, double off,
                                     Random& random) {
  std::uniform_real_distribution<double> part(0.01, 0.3);
  std::array<double, 3> low{}, high{}, middle{};
  for (unsigned i = 0; i < 3; ++i) low[i] = part(random), high[i] = part(random);
  const auto at = [&](double s) {
    for (unsigned i = 0; i < 3; ++i) middle[i] = low[i] + s * (high[i] - low[i]);
    std::array<double, 6> d{};
    for (unsigned i = 0; i < 4; ++i) {
      const double w = i < 3 ? middle[i] : 1 - middle[0] - middle[1] - middle[2];
      for (unsigned k = 0; k < 6; ++k) d[k] += w * field.approximate(cell.corners[i]).entries[k];
    }
    return mode_of(d) < mode;
  };
  const bool below = at(0);
  double from = 0, to = 1;
  for (int i = 0; i < 60; ++i) {
    const double s = (from + to) / 2;
    (at(s) == below ? from : to) = s;
  }
  at(from + off * (1 - from));
  return middle;
}

/// One for each level with pieces in each cell.
void add_inner(ModeLevel& level, const Trees& trees, const Field& field, Random& random) {
  const double mode = static_cast<double>(level.numerator) / static_cast<double>(level.denominator);
  level.inner.clear();
  for (const Cell& cell : trees.cells) {
    if (cell.code != modes_code::kGraphTet && cell.code != modes_code::kPlainTet) continue;
    for (const std::int8_t sign : {std::int8_t{1}, std::int8_t{-1}})
      if (level.tet_witnesses[cell.witness].pieces[sign > 0 ? 0 : 1] > 0) {
        const double off = std::array{0.0, 1e-12, 3e-12, 1.0}[random() % 4];
        level.inner.push_back(
            {cell.witness, sign, vertex_between(field, cell, sign * mode, off, random)});
      }
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
    add_inner(level, trees, field, random);
  }
  count_positions(c);
}

void count_positions(ModesCertificate& c) {
  Field field(c.tensors);
  const Domain domain = build_domain(c, field);
  const bool embedded = is_embedded(c, domain);
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
    const NearVertices vertices(context, positions);
    level.near = 0;
    for (const EdgeNode& edge : trees.edges) level.near += vertices.on_edge(edge, worker);
    for (u32 i = 0; i < trees.faces.size(); ++i) level.near += vertices.on_face(i, worker);
    for (const InnerVertex& vertex : level.inner) level.near += vertices.inside(vertex, worker);
    level.placed = embedded ? sum.placed : 0;
    level.not_placed = sum.placed + sum.not_placed - level.placed;
  }
}

}  // namespace crest::tests
