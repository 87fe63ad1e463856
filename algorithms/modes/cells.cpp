// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/modes/cells.hpp"

#include <tbb/blocked_range.h>

#include <algorithm>
#include <numeric>

#include "algorithms/modes/test_all.hpp"
#include "kernel/geometry/parallel.hpp"

namespace crest::modes {
namespace {

/// The edge k of a tetrahedron: 01 02 03 12 13 23.
constexpr std::uint8_t kEdges[6][2] = {{0, 1}, {0, 2}, {0, 3}, {1, 2}, {1, 3}, {2, 3}};

/// The corners that are neither i nor j, ascending.
constexpr std::array<std::size_t, 2> others(std::size_t i, std::size_t j) {
  std::array<std::size_t, 2> r{};
  std::size_t n = 0;
  for (std::size_t k = 0; k < 4; ++k)
    if (k != i && k != j) r[n++] = k;
  return r;
}

}  // namespace

KnownTests::KnownTests(std::vector<CellTest> tests, const std::vector<std::uint32_t>& counts)
    : tests_(std::move(tests)) {
  std::size_t first = 0;
  for (const std::uint32_t count : counts) {
    next_.push_back(first);
    end_.push_back(first += count);
  }
}

const CellTest* KnownTests::next(Index tet) {
  if (next_.empty() || next_[tet] == end_[tet]) return nullptr;
  return &tests_[next_[tet]++];
}

void KnownTests::drop(Index tet) {
  next_[tet] = end_[tet];
}

Index Cells::edge(const Cell& cell, std::size_t i, std::size_t j) const {
  return faces_.edge_of(cell.faces[others(i, j)[0]], cell.corners[i], cell.corners[j]);
}

Index Cells::add(Index tet, const std::array<Index, 4>& corners,
                 const std::array<Index, 4>& faces) {
  cells_.push_back({corners, faces, tet, faces_.add_account()});
  return static_cast<Index>(cells_.size() - 1);
}

void Cells::refine(Index c, std::vector<Index>& next) {
  const bool spent = faces_.is_spent(cells_[c].account);
  exhausted_ = exhausted_ || spent;
  if (spent || cells_[c].depth >= limits_.depth) {
    cells_[c].state = State::open;
    return;
  }
  cells_[c].state = State::unknown;
  split(c);
  for (const Index part : cells_[c].part) next.push_back(part);
}

void Cells::take(Index c, const CellResult<3>& r, std::vector<Index>& next) {
  ++counters_.tests;
  faces_.spend(cells_[c].account);
  counters_.depth = std::max<int>(counters_.depth, cells_[c].depth);
  counters_.exact_tests += r.exact ? 1 : 0;
  uniform_ += r.finding == Finding::uniform ? 1 : 0;
  if (r.finding == Finding::graph) {
    cells_[c].witness = r.witness;
    cells_[c].state = State::graph;
    graphs_.push_back(c);
  } else if (r.finding == Finding::none) {
    refine(c, next);
  } else {
    cells_[c].state = State::rejected;
  }
}

/// Tests of cells: those that are known, and of the others their results.
std::vector<Cells::Found> Cells::find(const std::vector<Index>& asked) {
  std::vector<Found> r(asked.size());
  std::vector<std::size_t> unknown;
  std::vector<std::array<Index, 4>> corners;
  for (std::size_t i = 0; i < asked.size(); ++i) {
    const Cell& cell = cells_[asked[i]];
    if (const CellTest* test = known_.next(cell.tet)) {
      r[i] = {test->result, test};
      continue;
    }
    unknown.push_back(i);
    corners.push_back(cell.corners);
  }
  const auto results = test_all<3>(faces_.vertices(), corners, level_);
  for (std::size_t k = 0; k < unknown.size(); ++k) r[unknown[k]].result = results[k];
  return r;
}

void Cells::test(std::vector<Index> asked) {
  std::vector<Index> next;
  while (!asked.empty()) {
    const auto found = find(asked);
    next.clear();
    for (std::size_t i = 0; i < asked.size(); ++i) {
      take(asked[i], found[i].result, next);
      const Cell& cell = cells_[asked[i]];
      if (found[i].known && found[i].known->split != cell.split) known_.drop(cell.tet);
      if (keeps_) made_.push_back({cell.tet, {found[i].result, cell.split}});
    }
    asked.swap(next);
  }
}

std::vector<std::pair<Index, CellTest>> Cells::test_trees() {
  std::vector<Index> asked(cells_.size());
  std::iota(asked.begin(), asked.end(), Index{0});
  keeps_ = true;
  test(std::move(asked));
  keeps_ = false;
  return std::move(made_);
}

void Cells::close_facets() {
  std::vector<Index> facets;
  for (const Index c : graphs_)
    if (cells_[c].state == State::graph)
      facets.insert(facets.end(), cells_[c].faces.begin(), cells_[c].faces.end());
  faces_.close(facets);
}

void Cells::decide(KnownTests known) {
  known_ = std::move(known);
  std::vector<Index> asked(cells_.size());
  std::iota(asked.begin(), asked.end(), Index{0});
  while (!asked.empty()) {
    test(std::move(asked));
    close_facets();
    asked.clear();
    settle_all(asked);
  }
  // Other cells may have cut the facets of those that were settled.
  close_facets();
  for (const Index c : graphs_)
    for (const Index f : cells_[c].faces)
      if (cells_[c].state == State::graph && !faces_.is_closed(f)) cells_[c].state = State::open;
}

/// Counts the pieces of the cells that got witnesses; the parts of those where that does not tell.
void Cells::settle_all(std::vector<Index>& next) {
  for (std::size_t i = settled_; i < graphs_.size(); ++i)
    for (const Index f : cells_[graphs_[i]].faces) faces_.is_closed(f);
  // Where loops tell, which is nearly everywhere, the trees are only read.
  std::vector<char> simple(graphs_.size() - settled_);
  kernel::parallel_for(tbb::blocked_range<std::size_t>(settled_, graphs_.size(), 256),
                       [&](const auto& range) {
                         for (std::size_t i = range.begin(); i < range.end(); ++i)
                           simple[i - settled_] = settle(cells_[graphs_[i]], true) ? 1 : 0;
                       });
  for (std::size_t i = settled_; i < graphs_.size(); ++i)
    if (simple[i - settled_] == 0 && !settle(cells_[graphs_[i]], false)) refine(graphs_[i], next);
  settled_ = graphs_.size();
}

/// Counts the pieces of a cell with a witness, by its loops alone or not; false if that does not
/// tell.
bool Cells::settle(Cell& cell, bool by_loops) {
  for (const Index f : cell.faces)
    if (!faces_.face(f).closed) return false;
  CellTopology topology(faces_, cell.faces, cell.witness.w);
  for (const Side side : {Side::minus, Side::neutral, Side::plus}) {
    if (level_.neutral() != (side == Side::neutral)) continue;
    const auto pieces = by_loops ? topology.count_by_loops(side) : topology.count(side);
    if (!pieces || *pieces > 255) return false;
    cell.pieces[static_cast<std::size_t>(static_cast<int>(side) + 1)] =
        static_cast<std::uint8_t>(*pieces);
  }
  return true;
}

void Cells::split(Index c) {
  const Cell cell = cells_[c];
  std::size_t best = 0;
  for (std::size_t k = 1; k < 6; ++k)
    if (faces_.cut_before(edge(cell, kEdges[k][0], kEdges[k][1]),
                          edge(cell, kEdges[best][0], kEdges[best][1])))
      best = k;
  const std::size_t i = kEdges[best][0], j = kEdges[best][1];
  const auto [k, l] = others(i, j);
  const Index cut = edge(cell, i, j), opposite = edge(cell, k, l);
  // Facets l and k hold the edge: they contain corners k and l, in this order.
  faces_.split(cell.faces[l]);
  faces_.split(cell.faces[k]);
  const Index m = faces_.edge(cut).middle;
  const Index inner = faces_.add_face(
      {cell.corners[k], cell.corners[l], m},
      {opposite, faces_.face(cell.faces[k]).inner, faces_.face(cell.faces[l]).inner},
      cell.depth + 1, cell.account);
  Cell near = cell, far = cell;
  near.depth = far.depth = static_cast<std::uint8_t>(cell.depth + 1);
  near.corners[j] = m;
  far.corners[i] = m;
  near.faces[i] = inner;
  far.faces[j] = inner;
  for (const std::size_t f : {k, l}) {
    near.faces[f] = faces_.part_with(cell.faces[f], cell.corners[i]);
    far.faces[f] = faces_.part_with(cell.faces[f], cell.corners[j]);
  }
  near.state = far.state = State::unknown;
  near.witness = far.witness = {};
  near.pieces = far.pieces = {};
  const auto first = static_cast<Index>(cells_.size());
  cells_.push_back(near);
  cells_.push_back(far);
  Cell& whole = cells_[c];
  whole.split = {static_cast<std::uint8_t>(i), static_cast<std::uint8_t>(j)};
  whole.inner = inner;
  whole.part[0] = first;
  whole.part[1] = first + 1;
}

}  // namespace crest::modes
