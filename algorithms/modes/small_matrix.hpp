// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Symmetric 3 x 3 matrices in plain doubles, for what places points and decides nothing.
#include <array>
#include <vector>

#include "algorithms/modes/degenerate_result.hpp"
#include "kernel/arithmetic/vec3.hpp"

namespace crest::modes {

using Matrix3 = std::array<kernel::Vec3, 3>;  ///< rows

Matrix3 deviator(const Tensor& t);
Matrix3 product(const Matrix3& a, const Matrix3& b);
kernel::Vec3 product(const Matrix3& a, const kernel::Vec3& v);
double inner(const Matrix3& a, const Matrix3& b);
double determinant(const Matrix3& a);
/// a + s b.
Matrix3 sum(const Matrix3& a, double s, const Matrix3& b);
/// s v v^T.
Matrix3 square(double s, const kernel::Vec3& v);
/// A unit vector across the unit vector v.
kernel::Vec3 across(const kernel::Vec3& v);

/// Descending eigenvalues, eigenvectors as rows of a rotation (Jacobi's method).
struct Eigensystem {
  kernel::Vec3 values;
  Matrix3 vectors;
};
Eigensystem eigensystem(const Matrix3& symmetric);

/// Solves n equations by elimination with row pivots; rows have n + 1 numbers. Nothing useful (not
/// finite) where they are dependent.
std::vector<double> solved(std::vector<std::vector<double>> rows);

}  // namespace crest::modes
