// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The spline at the samples (SPEC.md, step 3).
#include "certify/spline_cubic/domain.hpp"

namespace crest::certify::spline_cubic {

/// Throws Reject unless every sample is in the closed domain and differs from the spline by at
/// most certificate.error. Cost: 2 microseconds a sample; rationals where doubles do not decide.
void check_errors(const SplineCubicCertificate& certificate, const Domain& domain);

}  // namespace crest::certify::spline_cubic
