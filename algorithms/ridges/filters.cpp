// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>

#include "algorithms/ridges/measures.hpp"
#include "algorithms/ridges/ridges.hpp"

namespace crest::ridges {
namespace {

// A crest point: elliptic, and its curvature is the larger in absolute value, with the sign that
// makes it an extremum of max(|k1|, |k2|) (section 7.2).
bool on_crest(const Crossing& c, Colour colour) {
  if (c.type != RidgeType::elliptic) return false;
  return colour == Colour::blue ? c.k1 > std::fabs(c.k2) : -c.k2 > std::fabs(c.k1);
}

Ridge piece_of(const Ridge& ridge, std::size_t first, std::size_t count, double size) {
  Ridge piece;
  piece.colour = ridge.colour;
  piece.loop = false;
  const std::size_t n = ridge.crossings.size();
  for (std::size_t i = 0; i < count; ++i) {
    piece.crossings.push_back(ridge.crossings[(first + i) % n]);
    if (i + 1 < count) piece.third_order.push_back(ridge.third_order[(first + i) % n]);
  }
  if (!ridge.loop && first == 0) {
    piece.ends[0] = ridge.ends[0];
    piece.lead_in = ridge.lead_in;
  }
  if (!ridge.loop && first + count == n) {
    piece.ends[1] = ridge.ends[1];
    piece.lead_out = ridge.lead_out;
  }
  measure_ridge(piece, size);
  return piece;
}

void append_crest_pieces(const Ridge& ridge, double size, std::vector<Ridge>& out) {
  const std::size_t n = ridge.crossings.size();
  std::vector<bool> crest(n);
  for (std::size_t i = 0; i < n; ++i) crest[i] = on_crest(ridge.crossings[i], ridge.colour);
  const auto gap = std::find(crest.begin(), crest.end(), false);
  if (gap == crest.end()) {
    out.push_back(ridge);
    return;
  }
  // A loop is read from a crossing that is not on the crest, so that no piece is cut in two.
  const std::size_t start = ridge.loop ? static_cast<std::size_t>(gap - crest.begin()) : 0;
  for (std::size_t i = 0; i < n;) {
    std::size_t count = 0;
    while (i + count < n && crest[(start + i + count) % n]) ++count;
    if (count > 0) out.push_back(piece_of(ridge, (start + i) % n, count, size));
    i += count + 1;
  }
}

}  // namespace

FilterReport filter(RidgeGraph& graph, const FilterOptions& options) {
  FilterReport report;
  if (options.crest_only) {
    std::vector<Ridge> pieces;
    for (const Ridge& r : graph.ridges) {
      const std::size_t before = pieces.size();
      append_crest_pieces(r, graph.model_size, pieces);
      report.by_crest += pieces.size() == before;
    }
    graph.ridges = std::move(pieces);
  }
  auto drop = [&](Index& count, auto&& below) {
    const auto last = std::remove_if(graph.ridges.begin(), graph.ridges.end(), below);
    count = static_cast<Index>(graph.ridges.end() - last);
    graph.ridges.erase(last, graph.ridges.end());
  };
  drop(report.by_sharpness, [&](const Ridge& r) { return r.sharpness < options.min_sharpness; });
  drop(report.by_strength, [&](const Ridge& r) { return r.strength < options.min_strength; });
  drop(report.by_length, [&](const Ridge& r) { return r.length < options.min_length; });
  return report;
}

}  // namespace crest::ridges
