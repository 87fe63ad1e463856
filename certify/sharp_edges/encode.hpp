// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Claim 5 as bytes: all that a producer needs.
#include "certify/certificate.hpp"
#include "certify/sharp_edges/records.hpp"

namespace crest::certify {

/// The file's bytes, sealed. Cost: linear.
Bytes encode(const SharpEdgesCertificate& certificate);

}  // namespace crest::certify
