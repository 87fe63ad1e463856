// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Claim 2 from bytes that nobody has checked.
#include <span>

#include "certify/features_mesh/records.hpp"

namespace crest::certify {

/// Both sections. Throws Malformed, also for marks other than 0 and 1.
FeaturesMeshCertificate decode_features_mesh(std::span<const std::uint8_t> data,
                                             std::span<const std::uint8_t> claims);

}  // namespace crest::certify
