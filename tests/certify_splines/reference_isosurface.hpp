// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Certificates of claim 13 straight from its SPEC.md, for small volumes: values and gradients at
// points, in rationals; nothing of the checker is used.
#include <optional>

#include "certify/spline_isosurface/records.hpp"
#include "tests/certify_splines/reference_volume.hpp"

namespace crest::tests {

/// Lattice coordinates times 2^24.
using LatticePoint = std::array<std::int64_t, 3>;

/// A part of a tetrahedron: from its root '0' and '1' say which half was taken.
struct ReferenceLeaf {
  std::uint32_t root;
  std::string path;
  std::array<LatticePoint, 4> corners;
  unsigned tag;
};

struct IsosurfaceOptions {
  std::size_t depth = 60;
  /// Conditions of "simple" that are left out, to see what they are for.
  bool faces = true, empty_faces = true;
  /// Bisected before anything is tested: roots and trees.
  std::vector<std::uint32_t> roots = {};
  std::vector<std::uint8_t> trees = {};
};

/// Nothing if a leaf at that depth is neither empty nor simple.
std::optional<certify::SplineIsosurfaceCertificate> reference_isosurface(
    const SplineVolume& volume, const IsosurfaceOptions& options = {});

/// Of a quadratic on a tetrahedron, given by its values at corners and middles of edges.
struct ReferenceForm {
  std::array<Exact3, 4> corners;
  std::array<std::array<Rational, 4>, 4> b;  ///< Bernstein coefficients less the level
  bool is_empty(const std::vector<std::size_t>& which) const;
  bool is_simple(const IsosurfaceOptions& options) const;
};
ReferenceForm reference_form(const std::array<Exact3, 4>& corners,
                             const std::function<Rational(const Exact3&)>& f);

}  // namespace crest::tests
