// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/extremal/records.hpp"

#include <tbb/parallel_sort.h>

#include <algorithm>

namespace crest::extremal {
namespace {

/// All pieces' items of one kind, by their number. Items of one number stay as they are.
template <class Item, class Number>
void join_items(std::vector<Records>& pieces, std::vector<Item> Records::*items, Number number,
                std::vector<Item>& to) {
  std::size_t count = 0;
  for (const Records& p : pieces) count += (p.*items).size();
  to.reserve(count);
  for (Records& p : pieces) {
    std::move((p.*items).begin(), (p.*items).end(), std::back_inserter(to));
    p.*items = {};
  }
  const auto before = [&](const Item& a, const Item& b) { return number(a) < number(b); };
  if (!std::is_sorted(to.begin(), to.end(), before)) std::stable_sort(to.begin(), to.end(), before);
}

BisectedEdges join_bisected(std::vector<Records>& pieces) {
  struct Source {
    Index edge;
    std::size_t piece;
    BisectedEdges::Place place;
  };
  std::vector<Source> sources;
  for (std::size_t piece = 0; piece < pieces.size(); ++piece) {
    const BisectedEdges& from = pieces[piece].bisected;
    for (BisectedEdges::Place p{}; p.edge < from.edges.size(); p = from.after(p))
      sources.push_back({from.edges[p.edge], piece, p});
  }
  std::sort(sources.begin(), sources.end(),
            [](const Source& a, const Source& b) { return a.edge < b.edge; });
  BisectedEdges to;
  for (const Source& s : sources) to.add(s.edge, pieces[s.piece].bisected, s.place);
  for (Records& p : pieces) p.bisected = {};
  return to;
}

/// A run with where its cells' numbers stand in its piece.
struct Source {
  certify::CellRun run;
  std::size_t piece, code, direction, regular;
};

std::vector<Source> sources_of(const std::vector<Records>& pieces) {
  std::vector<Source> r;
  for (std::size_t p = 0; p < pieces.size(); ++p) {
    const CellRecords& c = pieces[p].cells;
    std::size_t code = 0, direction = 0, regular = 0;
    for (const certify::CellRun& run : c.runs) {
      r.push_back({run, p, code, direction, regular});
      for (Index i = 0; i < run.length; ++i, ++code) {
        const auto s = static_cast<CellState>(c.codes[code]);
        direction += s != CellState::open ? 1 : 0;
        regular += s == CellState::regular || s == CellState::regular_extremal ? 1 : 0;
      }
    }
  }
  std::sort(r.begin(), r.end(),
            [](const Source& a, const Source& b) { return a.run.first < b.run.first; });
  return r;
}

CellRecords join_cells(std::vector<Records>& pieces) {
  CellRecords to;
  std::size_t codes = 0, directions = 0, regular = 0;
  for (const Records& p : pieces) {
    codes += p.cells.codes.size();
    directions += p.cells.directions.size();
    regular += p.cells.gradients.size();
  }
  to.codes.reserve(codes);
  to.directions.reserve(directions);
  to.gradients.reserve(regular);
  to.fit.reserve(regular);
  for (const Source& s : sources_of(pieces)) {
    if (!to.runs.empty() && to.runs.back().first + to.runs.back().length == s.run.first)
      to.runs.back().length += s.run.length;
    else
      to.runs.push_back(s.run);
    const CellRecords& from = pieces[s.piece].cells;
    std::size_t direction = s.direction, gradient = s.regular;
    for (Index i = 0; i < s.run.length; ++i) {
      const std::uint8_t code = from.codes[s.code + i];
      to.codes.push_back(code);
      const auto state = static_cast<CellState>(code);
      if (state == CellState::open) continue;
      to.directions.push_back(from.directions[direction++]);
      if (state != CellState::regular && state != CellState::regular_extremal) continue;
      to.gradients.push_back(from.gradients[gradient]);
      to.fit.push_back(from.fit[gradient++]);
    }
  }
  for (Records& p : pieces) p.cells = {};
  return to;
}

}  // namespace

Records join(std::vector<Records> pieces) {
  if (pieces.size() == 1) return std::move(pieces[0]);
  Records r;
  r.cells = join_cells(pieces);
  r.bisected = join_bisected(pieces);
  join_items(
      pieces, &Records::critical, [](const auto& x) { return x.edge; }, r.critical);
  join_items(
      pieces, &Records::undecided, [](Index x) { return x; }, r.undecided);
  join_items(
      pieces, &Records::faces, [](const auto& x) { return x.face; }, r.faces);
  for (std::size_t mesh = 0; mesh < 2; ++mesh) {
    auto& to = r.sheets[mesh];
    for (Records& p : pieces) {
      to.insert(to.end(), p.sheets[mesh].begin(), p.sheets[mesh].end());
      p.sheets[mesh] = {};
    }
    // A cell's sheets are of one piece, in their order.
    std::stable_sort(to.begin(), to.end(),
                     [](const SheetRecord& a, const SheetRecord& b) { return a.cell < b.cell; });
  }
  for (const Records& p : pieces) {
    const auto add = [](auto& sums, const auto& more) {
      for (std::size_t i = 0; i < sums.size(); ++i) sums[i] += more[i];
    };
    add(r.counts.nodes, p.counts.nodes);
    add(r.counts.cells, p.counts.cells);
    add(r.counts.depths, p.counts.depths);
    r.counts.tests += p.counts.tests;
    r.counts.sheets_split += p.counts.sheets_split;
  }
  return r;
}

}  // namespace crest::extremal
