// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Claim 9 from bytes that nobody has checked.
#include <span>

#include "certify/container/byte_reader.hpp"
#include "certify/skeleton/records.hpp"

namespace crest::certify {

/// Both sections. Throws Malformed, also for codes that mean nothing.
SkeletonCertificate decode_skeleton(std::span<const std::uint8_t> data,
                                    std::span<const std::uint8_t> claims);

/// Sections that may be followed by more, for claims about several skeletons. Throw Malformed.
void read_skeleton_data(ByteReader& reader, SkeletonCertificate& certificate);
void read_skeleton_claims(ByteReader& reader, SkeletonCertificate& certificate);

}  // namespace crest::certify
