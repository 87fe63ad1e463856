// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Claim 15 from its statement: points of the page with a nearness, all pairs, in rationals. It
// knows no perturbation and gives nothing where a tie would need one.
#include <optional>

#include "certify/lineart/records.hpp"
#include "kernel/arithmetic/rational.hpp"

namespace crest::tests {

/// Data with claims but for hatches. Nothing if two things coincide on the page.
std::optional<certify::LineArtCertificate> reference_drawing(certify::LineArtCertificate data);

/// A hatch from the middle of a face on the page towards one of its corners, `reach` of the way.
std::vector<std::array<double, 2>> hatch_on(const certify::LineArtCertificate& drawing,
                                            std::uint32_t face, std::size_t corner, double reach);

/// What is so of a hatch.
struct HatchTruth {
  bool crosses = false;              ///< a visible contour
  std::vector<std::uint32_t> faces;  ///< the nearest at its first point: one, or none
};

/// Nothing where there is a tie.
std::optional<HatchTruth> reference_hatch(const certify::LineArtCertificate& drawing,
                                          const std::vector<std::array<double, 2>>& hatch);

}  // namespace crest::tests
