// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// A field on fewer triangles with the same topological skeleton (theory and limits: README.md).
#include "algorithms/vector_fields/compression_result.hpp"

namespace crest::vector_fields {

/// Collapses half-edges; the skeletons of both fields are proven and compared at the end.
/// Guarantees: the result's vertices are some of the input's, with their vectors; deterministic.
/// Throws: kernel::InputError as extract_skeleton() does.
Compression compress(const PlanarField& field, const CompressionOptions& options);

}  // namespace crest::vector_fields
