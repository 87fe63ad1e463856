// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// A slow producer of claim 10, written from SPEC.md: vertices go at random, the checker says what
// may stay.
#include "certify/compression/records.hpp"
#include "tests/certify_skeleton/reference_skeleton.hpp"
#include "tests/support/random.hpp"

namespace crest::tests {

/// A part of a field's vertices and triangles between them, in the field's numbers.
using Triangles = std::vector<std::array<std::uint32_t, 3>>;

/// The vertex `from` moved onto its neighbour `to`; empty if a triangle would not stay positive or
/// the surface would change. A boundary vertex goes along a straight boundary only.
Triangles collapsed(const PlaneField& field, const Triangles& triangles, std::uint32_t from,
                    std::uint32_t to);

/// The edge between two vertices made the other diagonal of its triangles, wherever that is; empty
/// if it has not two.
Triangles flipped(const Triangles& triangles, std::uint32_t a, std::uint32_t b);
/// Are all triangles positive, exactly?
bool are_positive(const PlaneField& field, const Triangles& triangles);

/// The claim that triangles on vertices of the field have its skeleton; zeros and lines are matched
/// by where they start. Not a true one if their skeletons differ.
certify::CompressionCertificate claim_of(const PlaneField& field,
                                         const certify::SkeletonCertificate& skeleton,
                                         const Triangles& triangles,
                                         certify::SkeletonNotion notion);

/// Tries collapses until `tries` are made; the last one that the checker accepts.
certify::CompressionCertificate reference_compression(const PlaneField& field,
                                                      certify::SkeletonNotion notion,
                                                      std::size_t tries, Random& random);

}  // namespace crest::tests
