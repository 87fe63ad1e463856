// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Claim 11 as bytes: all that a producer needs.
#include "certify/certificate.hpp"
#include "certify/spline_rays/records.hpp"

namespace crest::certify {

/// The file's bytes, sealed. Throws std::invalid_argument for lists whose lengths do not fit.
/// Cost: linear.
Bytes encode(const SplineRaysCertificate& certificate);

}  // namespace crest::certify
