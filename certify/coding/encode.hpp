// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Claim 14 as bytes: all that a producer needs.
#include "certify/certificate.hpp"
#include "certify/coding/records.hpp"

namespace crest::certify {

/// The file's bytes, sealed. Cost: linear.
Bytes encode(const CodingCertificate& certificate);

}  // namespace crest::certify
