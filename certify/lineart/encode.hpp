// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Claim 15 as bytes: all that a producer needs.
#include "certify/certificate.hpp"
#include "certify/lineart/records.hpp"

namespace crest::certify {

/// The file's bytes, sealed. Cost: linear.
Bytes encode(const LineArtCertificate& certificate);

}  // namespace crest::certify
