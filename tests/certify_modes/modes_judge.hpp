// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// What an accepted mutant of claim 6 must be: true.
#include <catch2/catch.hpp>
#include <map>
#include <string>
#include <tuple>

#include "certify/modes/encode.hpp"
#include "certify/verify.hpp"
#include "tests/certify_modes/reference_modes.hpp"

namespace crest::tests {

using namespace certify;

/// What a certificate claims about the surfaces of a level.
inline auto statement(const ModeLevel& level) {
  return std::tuple(level.numerator, level.denominator, level.positive.components,
                    level.positive.touched, level.negative.components, level.negative.touched,
                    level.placed, level.not_placed, level.near);
}

inline bool same_field(const ModesCertificate& a, const ModesCertificate& b) {
  return a.tets == b.tets && a.tensors == b.tensors;
}

/// Made anew by the reference producer, zeros as given.
inline bool is_true(const ModesCertificate& c) {
  for (const ModeLevel& level : c.levels) {
    if (level.positive.touched + level.negative.touched + level.open_tets > 0) continue;
    const auto anew = reference_modes({c.points, c.tets, c.tensors},
                                      {{level.numerator, level.denominator}}, 40, c.zeros);
    const auto surfaces = [](const ModeLevel& l) {
      return std::tuple(l.positive.components, l.negative.components);
    };
    if (anew.levels[0].open_tets == 0 && surfaces(anew.levels[0]) != surfaces(level)) return false;
  }
  return true;
}

struct Tally {
  std::uint64_t mutants = 0, accepted = 0, compared = 0;
  std::map<std::string, std::uint64_t> by_kind;

  /// Accepted mutants of the same field must state the same of the same level.
  void judge(const std::string& kind, const ModesCertificate& original,
             const ModesCertificate& mutant) {
    ++mutants;
    if (!verify(encode(mutant)).accepted) return;
    ++accepted;
    ++by_kind[kind];
    CAPTURE(kind);
    if (same_field(original, mutant) && original.levels.size() == mutant.levels.size()) {
      bool same = true;
      for (std::size_t i = 0; i < original.levels.size(); ++i)
        same &= statement(original.levels[i]) == statement(mutant.levels[i]);
      if (same) return;
    }
    ++compared;
    CHECK(is_true(mutant));
  }
};

}  // namespace crest::tests
