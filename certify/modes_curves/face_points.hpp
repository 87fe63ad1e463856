// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The degenerate tensors of a face, exactly (SPEC.md).
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "certify/exact/sturm.hpp"
#include "certify/exact/tensor_field.hpp"
#include "certify/modes_curves/box.hpp"

namespace crest::certify::curves {

using kernel::Rational;
using modes::Integer;

using Polynomial = std::vector<Integer>;

template <class Number>
using Triple = std::array<Number, 3>;
template <class Number>
using Matrix = std::array<Triple<Number>, 3>;

/// Numbers between two rationals.
struct Range {
  Rational low, high;

  int sign() const { return low > 0 ? 1 : high < 0 ? -1 : 0; }
};
Range operator+(const Range& a, const Range& b);
Range operator-(const Range& a, const Range& b);
Range operator*(const Range& a, const Range& b);

/// A root of a polynomial with simple roots, in (low, high) of t; the eigenvector v there is a
/// quadratic curve's point: three polynomials in u = t / (1 - t), or -t / (1 - t).
class FacePoint {
 public:
  using Curve = std::array<Polynomial, 3>;
  static constexpr unsigned kMostHalvings = 400;
  FacePoint(std::shared_ptr<const Polynomial> polynomial, modes::Place low, modes::Place high,
            bool negative, std::shared_ptr<const Curve> v);

  int type = 0;           ///< +1 linear, -1 planar
  u32 listed = 0;         ///< place among the listed points
  bool multiple = false;  ///< or not known to be a simple common point

  /// The sign at the root of a polynomial in u; empty if it may be zero, as far as these halvings
  /// of the interval tell.
  std::optional<int> sign(const Polynomial& polynomial, unsigned halvings = kMostHalvings);
  /// The same by doubles with errors: 0 where these do not tell.
  int certain_sign(const Polynomial& polynomial) const;
  /// Whether a polynomial in the variable of this one, t / (1 - t), is certainly not zero here.
  bool avoids(const Polynomial& other);
  const Curve& curve() const { return *v_; }
  /// Around v, at the present interval of u.
  Triple<Range> direction() const;
  void refine();

 private:
  Range at() const;
  std::optional<int> exact_sign(const Polynomial& list, unsigned halvings);
  bool may_vanish(const Polynomial& list) const;
  void refine_by_doubles();

  std::shared_ptr<const Polynomial> polynomial_;
  modes::Place low_, high_;
  double near_low_ = 0, near_high_ = 1;  ///< doubles around them
  bool negative_;
  std::shared_ptr<const Curve> v_;
};

/// The tensors of a simplex as matrices of integers, to one common scale.
std::vector<Matrix<Integer>> matrices(modes::ExactTensors& exact, std::span<const u32> corners);
/// B_i of SPEC.md, all times one positive number: <B_i, T_j> is that for i = j, else 0. Throws
/// Reject if the tensors are dependent.
std::vector<Matrix<Integer>> dual_basis(const std::vector<Matrix<Integer>>& tensors);
/// Traceless matrices orthogonal to all tensors, as many as there are; none if the tensors are
/// dependent.
std::vector<Matrix<Integer>> complement(const std::vector<Matrix<Integer>>& tensors);
Integer determinant(const Matrix<Integer>& m);

/// Whether the conics of independent tensors have a line in common.
bool share_line(const Matrix<Integer>& p, const Matrix<Integer>& q);

/// All points of a face, each matched with the box that holds it; nothing if the tensors are
/// dependent, no quartic but zero is found, or a point is multiple. Throws Reject if the points are
/// not those of the boxes, or one is on an edge.
std::optional<std::vector<FacePoint>> find_points(modes::ExactTensors& exact,
                                                  const std::array<u32, 3>& corners,
                                                  const std::vector<Box>& boxes);

}  // namespace crest::certify::curves
