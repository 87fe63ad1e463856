// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/extremal/cells.hpp"

#include <algorithm>

#include "algorithms/extremal/cell_nets.hpp"
#include "algorithms/extremal/cell_proofs.hpp"
#include "kernel/geometry/parallel.hpp"

namespace crest::extremal {
namespace {

std::array<std::size_t, 8> corner_offsets(const Grid& g) {
  std::array<std::size_t, 8> r{};
  for (std::size_t c = 0; c < 8; ++c)
    for (std::size_t k = 0; k < 3; ++k)
      if ((c >> k & 1) != 0 && g.size[k] > 1) r[c] += g.stride[k];
  return r;
}

}  // namespace

Cells::Cells(const Fields& fields, const Nodes& nodes) : fields_(fields) {
  const Grid& g = fields.grid();
  states_.assign(g.nodes(), CellState::unlisted);
  const int layers = std::max(1, g.size[2] - 1);
  std::vector<std::vector<CellProof>> slices(static_cast<std::size_t>(layers));
  const auto corners = corner_offsets(g);
  kernel::parallel_for(0, layers, [&](int k) {
    auto& proofs = slices[static_cast<std::size_t>(k)];
    CellNets nets;
    for (int j = 0; j + 1 < g.size[1]; ++j) {
      RowNets row(fields, j, k);
      for (int i = 0; i + 1 < g.size[0]; ++i) {
        const std::size_t v = g.index({i, j, k});
        if (!std::all_of(corners.begin(), corners.end(),
                         [&](std::size_t c) { return nodes.active(v + c); })) {
          if (nodes.possible(v)) states_[v] = CellState::open;
          continue;
        }
        Vec3 w{};
        for (const std::size_t c : corners) {
          const Vec3 n = nodes.direction(v + c);
          w = kernel::dot(w, n) < 0 ? w - n : w + n;
        }
        row.make(i, nets);
        const CellProof proof = prove_cell(fields, {i, j, k}, nets, w);
        states_[v] = proof.state;
        if (proof.state == CellState::open) continue;
        proofs.push_back(proof);
      }
    }
  });
  ids_ = RankedBits(g.nodes(), [&](std::size_t v) { return decides(v); });
  std::size_t total = 0;
  for (const auto& s : slices) total += s.size();
  proofs_.reserve(total);
  for (auto& s : slices) {
    proofs_.insert(proofs_.end(), s.begin(), s.end());
    s = {};
  }
}

std::size_t Cells::count(CellState s) const {
  return static_cast<std::size_t>(std::count(states_.begin(), states_.end(), s));
}

}  // namespace crest::extremal
