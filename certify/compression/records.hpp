// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The certificate of claim 10, compression, as plain structs (SPEC.md).
#include "certify/skeleton/records.hpp"

namespace crest::certify {

inline constexpr std::uint32_t kCompression = 10, kCompressionVersion = 1;

/// The notion of equality: what stays besides starts, ends and orders of arrivals.
enum class SkeletonNotion : std::uint8_t {
  strong,    ///< every triangle that a listed line meets
  original,  ///< zeros with the triangles around them
  relaxed    ///< zeros on vertices and edges; others as to their class
};

/// Claim compression: two fields on one domain have the same skeleton.
struct CompressionCertificate {
  SkeletonNotion notion = SkeletonNotion::original;
  SkeletonCertificate input;
  /// Triangles, in numbers of its own vertices, and what claim 9 states. Positions and vectors are
  /// not written: they are those of `vertices`.
  SkeletonCertificate output;
  std::vector<std::uint32_t> vertices;  ///< the output's, by their numbers in the input; ascending
  // The bijection: for each of the input, the number of the output's. Switch points, loops and
  // regions have none: their places tell.
  std::vector<std::uint32_t> zeros, orbits, separatrices;
};

}  // namespace crest::certify
