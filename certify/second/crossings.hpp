// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// SPEC.md, "Faces outside patches": types by turn, purple by cross, and what several faces share:
// edges and loose corners.
#include "certify/second/faces.hpp"

namespace crest::recheck {

/// Reads and proves what is said of the crossings of one face, after its signs are known.
class Crossings {
 public:
  Crossings(const Problem& problem, Index face, Reader& in, const FaceOutcome& outcome,
            const BySide<bool>& loose)
      : record_(problem.certificate.records[face]),
        sampler_(problem, face),
        in_(in),
        outcome_(outcome),
        loose_(loose) {}

  void type(std::size_t colour, bool by_turn);
  void purple(bool by_cross);

 private:
  double parameter();
  int sign_at(Index side, double t, std::size_t colour) const;
  int growth(std::size_t colour, Index side);

  const FaceRecord& record_;
  Sampler sampler_;
  Reader& in_;
  const FaceOutcome& outcome_;
  const BySide<bool>& loose_;
};

/// Proves that every edge is decided, and the conditions of loose corners.
/// Guarantees: whether an edge is crossed in a colour; false inside patches.
std::array<std::vector<bool>, 2> crossed_edges(const Problem& problem, const LooseCorners& loose,
                                               const std::vector<FaceOutcome>& outcomes);

}  // namespace crest::recheck
