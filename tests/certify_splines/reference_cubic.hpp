// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Certificates of claim 12 straight from its SPEC.md, in rationals: nothing of the checker is used.
#include <map>

#include "certify/spline_cubic/records.hpp"
#include "tests/certify_splines/reference_volume.hpp"
#include "tests/support/random.hpp"

namespace crest::tests {

/// A vertex, centre or face centre in lattice coordinates (a cube's side is 2), and words of them.
using Letter = Int3;
using Word = std::array<Letter, 3>;

class ReferenceCubic {
 public:
  explicit ReferenceCubic(const certify::SplineCubicData& data) : data_(data) {}

  /// a(w); the letters are vertices of one tetrahedron of the cube.
  Rational coefficient(const Int3& cube, Word word) const;
  /// r(A) of a corner: signs from the centre.
  Rational residual(const Int3& cube, const Int3& corner) const;
  /// What a(CCA) has to be for r(A) = 0.
  Rational target(const Int3& cube, const Int3& corner) const;
  /// The polynomial of a tetrahedron in lattice coordinates. Its coefficients are kept: the data
  /// must not change any more.
  Rational polynomial(const Int3& cube, std::size_t tet, const Exact3& x) const;
  /// s at a point of the world.
  Rational value(const std::array<double, 3>& x) const;

 private:
  Rational vertex(const Letter& at, std::size_t k) const;
  Rational slope(const Letter& middle, std::size_t along, std::size_t across) const;
  Rational at_vertex(const Letter& a, const Exact3& x) const;
  Rational at_edge(const Letter& a, const Letter& b, const Exact3& x) const;
  Rational at_centre(const Int3& cube, const Exact3& x) const;

  const certify::SplineCubicData& data_;
  mutable std::map<std::pair<Int3, std::size_t>, std::vector<Rational>> forms_;
};

/// Random integers in units of 2^exponent, marched to C1, random samples in the box; with `doubles`
/// random numbers that are not C1.
certify::SplineCubicCertificate random_cubic(const std::array<std::uint32_t, 3>& cubes,
                                             bool doubles, Random& random);

/// The least bounds of the data.
double least_jump(const certify::SplineCubicData& data);
double least_error(const certify::SplineCubicData& data);

/// Cubes of the domain, as positions.
std::vector<Int3> domain_cubes(const certify::SplineCubicData& data);

}  // namespace crest::tests
