// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Claim 9 as bytes: all that a producer needs.
#include "certify/certificate.hpp"
#include "certify/skeleton/records.hpp"

namespace crest::certify {

/// The file's bytes, sealed. Throws std::invalid_argument for lists whose lengths do not fit.
/// Cost: linear.
Bytes encode(const SkeletonCertificate& certificate);

class ByteWriter;
/// Its sections, for claims about several skeletons. Throws as encode().
std::size_t skeleton_data_size(const SkeletonCertificate& certificate);
void write_skeleton_data(ByteWriter& out, const SkeletonCertificate& certificate);
void write_skeleton_claims(ByteWriter& out, const SkeletonCertificate& certificate);

}  // namespace crest::certify
