// SPDX-License-Identifier: GPL-3.0-or-later
// Claim 6, modes: the steps of SPEC.md in order.
#include <algorithm>

#include "certify/container/checker.hpp"
#include "certify/container/prove.hpp"
#include "certify/container/reject.hpp"
#include "certify/modes/decode.hpp"

namespace crest::certify {
namespace {

std::size_t count_used(const ModesCertificate& c) {
  std::vector<std::uint8_t> used(c.points.size(), 0);
  for (const auto& cell : c.cells)
    for (const std::uint32_t v : cell) {
      require(v < used.size(), "cells: no point {}", v);
      used[v] = 1;
    }
  return static_cast<std::size_t>(std::count(used.begin(), used.end(), 1));
}

void verify_modes(std::span<const std::uint8_t> data, std::span<const std::uint8_t> claims,
                  const VerifyOptions& options, Verdict& verdict) {
  const ModesCertificate c = decode_modes(data, claims);
  const std::size_t used = count_used(c);
  prove(verdict, "data: {} points, {} cells; digests match", c.points.size(), c.cells.size());
  if (options.input) throw TieUnavailable("modes: no reader for its input is trusted");
  auto places = c.points;
  std::sort(places.begin(), places.end());
  require_equal(c.distinct, std::unique(places.begin(), places.end()) - places.begin(), "places");
  prove(verdict, "places: {}", c.distinct);
  require_equal(c.used, used, "used points");
  prove(verdict, "used points: {}", c.used);
}

}  // namespace

extern const ClaimChecker modes_claim;
const ClaimChecker modes_claim = {kModes, kModesVersion, "modes", verify_modes};

}  // namespace crest::certify
