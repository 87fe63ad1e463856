// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Claim 10 as bytes: all that a producer needs.
#include "certify/certificate.hpp"
#include "certify/compression/records.hpp"

namespace crest::certify {

/// The file's bytes, sealed. Throws std::invalid_argument for lists whose lengths do not fit, and
/// if a position or vector of the output is not that of its vertex. Cost: linear.
Bytes encode(const CompressionCertificate& certificate);

}  // namespace crest::certify
