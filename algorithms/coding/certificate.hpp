// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The certificate that a stream decodes to a mesh (certify/coding/SPEC.md).
#include "algorithms/coding/coding.hpp"
#include "certify/coding/records.hpp"

namespace crest::coding {

/// `dropped`: vertices of the file that no face uses and that are not among the points.
certify::CodingCertificate make_certificate(const Encoded& encoded, std::span<const Triangle> faces,
                                            std::span<const Point> points,
                                            const EncodeOptions& options, Index dropped);

}  // namespace crest::coding
