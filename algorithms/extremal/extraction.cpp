// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/extremal/extraction.hpp"

#include <tbb/blocked_range.h>

#include <algorithm>
#include <cmath>

#include "algorithms/extremal/assembly.hpp"
#include "kernel/geometry/parallel.hpp"

namespace crest::extremal {
namespace {

kernel::GridSize size_of(const Grid& g) {
  return {static_cast<Index>(g.size[0]), static_cast<Index>(g.size[1]),
          static_cast<Index>(g.size[2])};
}

/// In the piece's numbers: its own nodes, and so many beyond, as far as there are.
kernel::GridBox asked(const kernel::GridPiece& piece, Index beyond) {
  kernel::GridBox r = kernel::with_halo(piece.size, piece.owned, beyond).all;
  for (std::size_t k = 0; k < 3; ++k) {
    r.low[k] = std::max(r.low[k], piece.all.low[k]) - piece.all.low[k];
    r.high[k] = std::min(r.high[k], piece.all.high[k]) - piece.all.low[k];
  }
  return r;
}

}  // namespace

Extraction::Extraction(Fields fields, const Options& options)
    : Extraction(std::move(fields), options, std::nullopt) {}

Extraction::Extraction(Fields fields, const Options& options,
                       const std::optional<kernel::GridPiece>& piece)
    : options_(options),
      fields_(std::move(fields)),
      piece_(piece ? refined(*piece, options.refine) : kernel::whole_grid(size_of(fields_.grid()))),
      nodes_(fields_, options.min_value, asked(piece_, 4)),
      cells_(fields_, nodes_),
      edges_(fields_, nodes_, cells_, asked(piece_, 0)),
      faces_(fields_, nodes_, cells_, edges_) {}

Result Extraction::result(bool critical) const {
  const Assembly assembly(fields_.grid(), options_, records({!critical, critical}));
  return assembly.result(
      critical, [&](std::span<const Vec3> places) { return values_at(fields_, piece_, places); });
}

Node owner_of(const kernel::GridSize& size, const Vec3& place) {
  Node r;
  for (std::size_t k = 0; k < 3; ++k)
    r[k] = std::clamp(static_cast<int>(place[k]), 0, std::max(0, static_cast<int>(size[k]) - 2));
  return r;
}

std::vector<AtPlace> values_at(const Fields& fields, const kernel::GridPiece& piece,
                               std::span<const Vec3> places) {
  std::vector<AtPlace> r(places.size());
  const bool plane = fields.grid().dimension() == 2;
  kernel::parallel_for(tbb::blocked_range<std::size_t>(0, places.size(), 256),
                       [&](const auto& range) {
                         for (std::size_t i = range.begin(); i < range.end(); ++i) {
                           const Node cell = owner_of(piece.size, places[i]);
                           Node here;
                           Vec3 t;
                           for (std::size_t k = 0; k < 3; ++k) {
                             here[k] = cell[k] - static_cast<int>(piece.all.low[k]);
                             t[k] = places[i][k] - cell[k];
                           }
                           r[i] = at_place(fields.at(here, t), plane);
                         }
                       });
  return r;
}

kernel::GridPiece refined(const kernel::GridPiece& piece, int levels) {
  kernel::GridPiece r = piece;
  for (std::size_t k = 0; k < 3; ++k) {
    const auto fine = [&](Index x) {
      // The nodes behind the last one are those of no other piece.
      return x == piece.size[k] ? ((piece.size[k] - 1) << levels) + 1 : x << levels;
    };
    r.size[k] = fine(piece.size[k]);
    for (kernel::GridBox* box : {&r.owned, &r.all}) {
      box->low[k] = box->low[k] << levels;
      // A halved box ends at its last node.
      box->high[k] = box == &r.owned ? fine(box->high[k]) : ((box->high[k] - 1) << levels) + 1;
    }
  }
  return r;
}

Index halo_of(const Grid& grid, const Options& options) {
  std::size_t radius = 0;
  const double tensor = options.tensor_sigma.value_or(options.sigma);
  for (const double sigma : {options.sigma, tensor})
    for (const auto& w : smoothing_weights(grid, sigma)) radius = std::max(radius, w.size() - 1);
  // A difference, the splines' support, and cells round nodes round edges round faces round cells;
  // a mirrored end a halving.
  return static_cast<Index>(radius + 8 + static_cast<std::size_t>(options.refine));
}

}  // namespace crest::extremal
