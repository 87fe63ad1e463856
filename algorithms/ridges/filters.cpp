// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>

#include "algorithms/ridges/measures.hpp"
#include "algorithms/ridges/prominence.hpp"
#include "algorithms/ridges/ridges.hpp"

namespace crest::ridges {
namespace {

Ridge piece_of(const Ridge& ridge, std::size_t first, std::size_t count, double size) {
  Ridge piece;
  piece.colour = ridge.colour;
  piece.loop = false;
  piece.weight = ridge.weight;
  piece.ends[0].kind = piece.ends[1].kind = EndKind::cut;
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

/// The maximal pieces whose crossings are all kept; the whole ridge if all are.
template <class Kept>
void append_pieces(const Ridge& ridge, double size, const Kept& kept, std::vector<Ridge>& out) {
  const std::size_t n = ridge.crossings.size();
  const auto gap = std::find_if_not(ridge.crossings.begin(), ridge.crossings.end(), kept);
  if (gap == ridge.crossings.end()) {
    out.push_back(ridge);
    return;
  }
  // A loop is read from a crossing that is not kept, so that no piece is cut in two.
  const auto start = static_cast<std::size_t>(ridge.loop ? gap - ridge.crossings.begin() : 0);
  for (std::size_t i = 0; i < n;) {
    std::size_t count = 0;
    while (i + count < n && kept(ridge.crossings[(start + i + count) % n])) ++count;
    if (count > 0) out.push_back(piece_of(ridge, (start + i) % n, count, size));
    i += count + 1;
  }
}

/// Cuts all ridges to the crossings for which kept(crossing, colour); returns how many have none.
template <class Kept>
Index cut(RidgeGraph& graph, const Kept& kept) {
  Index dropped = 0;
  std::vector<Ridge> pieces;
  for (const Ridge& r : graph.ridges) {
    const std::size_t before = pieces.size();
    append_pieces(
        r, graph.model_size, [&](const Crossing& c) { return kept(c, r.colour); }, pieces);
    dropped += pieces.size() == before;
  }
  graph.ridges = std::move(pieces);
  return dropped;
}

}  // namespace

FilterReport filter(RidgeGraph& graph, const FilterOptions& options) {
  FilterReport report;
  if (options.min_level > 0) {
    report.by_level =
        cut(graph, [&](const Crossing& c, Colour) { return c.level >= options.min_level; });
  }
  if (options.crest_only) {
    report.by_crest = cut(graph, [](const Crossing& c, Colour colour) {
      return c.type == RidgeType::elliptic && on_crest(c, colour);
    });
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
