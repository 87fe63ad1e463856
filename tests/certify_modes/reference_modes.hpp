// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Certificates of claim 6 made straight from SPEC.md, for small meshes: midpoints of the longest
// edge in the angle of its tensors, witnesses by the perceptron, roots by Sturm's theorem.
#include "certify/modes/records.hpp"

namespace crest::tests {

struct ModesInput {
  std::vector<std::array<double, 3>> points;
  std::vector<std::array<std::uint32_t, 4>> tets;
  std::vector<std::array<double, 6>> tensors;
};

struct MadeLevel {
  std::uint64_t numerator, denominator;
};

/// The counts are those the checker finds: what they should be is for the test to say.
/// Cells deeper than `most_depth` are left open.
certify::ModesCertificate reference_modes(const ModesInput& input,
                                          const std::vector<MadeLevel>& levels,
                                          unsigned most_depth = 30,
                                          std::vector<certify::ZeroRecord> zeros = {});

/// Each root in the middle of its enclosure, or of what is free where it has none; arcs without
/// points, or `points` of them each, at random in their faces; in each cell a vertex of each level
/// that has pieces there, on the level as doubles tell, 1e-12 off, or anywhere.
void add_positions(certify::ModesCertificate& c, unsigned points = 0, std::uint64_t seed = 1);
/// The pieces placed and not and the vertices near the level, as the checker counts them.
void count_positions(certify::ModesCertificate& c);

}  // namespace crest::tests
