// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Claim 12 as bytes: all that a producer needs.
#include "certify/certificate.hpp"
#include "certify/spline_cubic/records.hpp"

namespace crest::certify {

/// The file's bytes, sealed. Throws std::invalid_argument for lists whose lengths do not fit and
/// for numbers that are not the integers they should be. Cost: linear.
Bytes encode(const SplineCubicCertificate& certificate);

}  // namespace crest::certify
