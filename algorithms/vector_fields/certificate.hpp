// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// A skeleton as claim 9 (certify/skeleton/SPEC.md).
#include "algorithms/vector_fields/vector_fields.hpp"
#include "certify/skeleton/encode.hpp"

namespace crest::vector_fields {

/// extract_skeleton(), with the record that proves it.
Skeleton extract_skeleton(const PlanarField& field, certify::SkeletonCertificate& record);

}  // namespace crest::vector_fields
