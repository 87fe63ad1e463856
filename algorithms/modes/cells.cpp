// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/modes/cells.hpp"

#include <algorithm>

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

Index Cells::edge(const Cell& cell, std::size_t i, std::size_t j) const {
  return faces_.edge_of(cell.faces[others(i, j)[0]], cell.corners[i], cell.corners[j]);
}

Index Cells::decide(Index tet, const std::array<Index, 4>& corners,
                    const std::array<Index, 4>& faces, const CellResult<3>& whole) {
  const auto root = static_cast<Index>(cells_.size());
  cells_.push_back({corners, faces, tet});
  budget_ = counters_.tests + faces_.counters().tests + limits_.tests;
  faces_.allow(limits_.tests);
  decide(root, whole);
  return root;
}

CellResult<3> Cells::test(Index c) const {
  const auto corners = cells_[c].corners;
  std::array<Tensor, 4> tensors;
  for (std::size_t i = 0; i < 4; ++i) tensors[i] = faces_.vertices().tensor(corners[i]);
  return test_cell<3>(
      tensors, [&] { return faces_.vertices().exact(corners); }, level_);
}

void Cells::take(Index c, const CellResult<3>& r) {
  ++counters_.tests;
  counters_.depth = std::max<int>(counters_.depth, cells_[c].depth);
  counters_.exact_tests += r.exact ? 1 : 0;
  uniform_ += r.finding == Finding::uniform ? 1 : 0;
  if (r.finding == Finding::graph) {
    cells_[c].witness = r.witness;
    cells_[c].state = State::graph;
  } else if (r.finding != Finding::none) {
    cells_[c].state = State::rejected;
  }
}

/// Closes the facets of a cell with a witness and counts its pieces.
bool Cells::settle(Index c) {
  bool closed = true;
  for (const Index f : cells_[c].faces) closed = faces_.close(f) && closed;
  if (!closed) return false;
  CellTopology topology(faces_, cells_[c].faces, cells_[c].witness.w);
  for (const Side side : {Side::minus, Side::neutral, Side::plus}) {
    if (level_.neutral() != (side == Side::neutral)) continue;
    const auto pieces = topology.pieces(side);
    if (!pieces || pieces->size() > 255) return false;
    cells_[c].pieces[static_cast<std::size_t>(static_cast<int>(side) + 1)] =
        static_cast<std::uint8_t>(pieces->size());
  }
  return true;
}

void Cells::decide(Index c, const CellResult<3>& result) {
  take(c, result);
  if (cells_[c].state == State::rejected) return;
  if (cells_[c].state == State::graph) {
    if (settle(c)) return;
    cells_[c].state = State::unknown;
  }
  const bool spent = counters_.tests + faces_.counters().tests >= budget_;
  exhausted_ = exhausted_ || spent;
  if (spent || cells_[c].depth >= limits_.depth) {
    cells_[c].state = State::open;
    return;
  }
  split(c);
  for (int k = 0; k < 2; ++k) {
    const Index part = cells_[c].part[k];
    decide(part, test(part));
  }
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
      cell.depth + 1);
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
