// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Claim 1 from bytes that nobody has checked.
#include <span>

#include "certify/ridges_mesh/records.hpp"

namespace crest::certify {

/// The data section alone, and the claim section into `certificate` (data untouched). Every length
/// is compared with the bytes left before anything is allocated.
/// Throws Malformed: counts that do not fit, numbers not finite or -0, bytes left over.
MeshData decode_data(std::span<const std::uint8_t> data);
void decode_claims(std::span<const std::uint8_t> claims, RidgesMeshCertificate& certificate);

}  // namespace crest::certify
