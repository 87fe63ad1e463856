// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Claim 8 as bytes: all that a producer needs.
#include "certify/certificate.hpp"
#include "certify/extremal/records.hpp"

namespace crest::certify {

/// The first bytes, which depend on the data alone. Throws std::invalid_argument for lists whose
/// lengths do not fit.
EncodedData encode_data(const ExtremalData& data);
/// The file's bytes, sealed; `data` is of the same data. Directions are rounded to 16384ths of
/// their largest number, and each w is turned to be positive there, its a with it. Throws
/// std::invalid_argument for lists whose lengths do not fit, and for a direction that is zero.
/// Cost: linear.
Bytes encode(EncodedData data, const ExtremalCertificate& certificate);
Bytes encode(const ExtremalCertificate& certificate);

}  // namespace crest::certify
