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

/// Whether a hatch is as the claim wants it, its face included: no ties either.
std::optional<bool> reference_hatch(const certify::LineArtCertificate& drawing,
                                    const std::vector<std::array<double, 2>>& hatch,
                                    std::uint32_t face);

}  // namespace crest::tests
