// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// A skeleton as claim 9 (certify/skeleton/SPEC.md), a compressed field as claim 10
// (certify/compression/SPEC.md).
#include "algorithms/vector_fields/compression.hpp"
#include "algorithms/vector_fields/vector_fields.hpp"
#include "certify/compression/encode.hpp"
#include "certify/skeleton/encode.hpp"

namespace crest::vector_fields {

/// extract_skeleton(), with the record that proves it.
Skeleton extract_skeleton(const PlanarField& field, certify::SkeletonCertificate& record);

/// compress(), with the record that proves it. Requires: the same skeleton, before it is written.
/// With `simplify` the skeletons differ: only those of the input and of the output are there.
Compression compress(const PlanarField& field, const CompressionOptions& options,
                     certify::CompressionCertificate& record);

}  // namespace crest::vector_fields
