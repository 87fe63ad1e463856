// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Tensors at vertices, exactly and as doubles with an error; the polynomials of a simplex.
#include <span>
#include <unordered_map>
#include <vector>

#include "certify/exact/simplex_forms.hpp"

namespace crest::certify::modes {

using u32 = std::uint32_t;
inline constexpr u32 kNone = 0xffffffffU;

/// 3 T - tr(T) I: xx yy zz xy yz xz.
template <class Number>
using Tensor = std::array<Number, 6>;

/// An exact tensor: integers times 2^exponent.
struct ExactTensor {
  Tensor<Integer> entries;
  long exponent = 0;
};

/// A vertex that a split puts at ((64 - n) first + n second) / 64.
struct SplitVertex {
  u32 first, second;
  std::uint8_t n, generation;
};
/// Splits of splits: more are refused, so that exact numbers stay short.
inline constexpr unsigned kMostGenerations = 64;

/// All vertices: V given ones, those put where the tensor is zero, those of splits.
class Field {
 public:
  explicit Field(std::span<const std::array<double, 6>> tensors);

  std::size_t vertices() const { return approximate_.size(); }
  std::size_t fixed() const { return fixed_; }
  /// Requires: before any split.
  u32 add_zero();
  u32 split(u32 first, u32 second, unsigned n);
  /// Drops the vertices of splits.
  void drop_splits();
  /// Of a vertex that is no split: the deviator is exactly 0.
  bool zero(u32 v) const { return zero_[v] != 0; }

  /// Requires: of a split.
  const SplitVertex& parts(u32 v) const { return splits_[v - fixed_]; }

  struct Approximate {
    Tensor<double> entries;
    double error;    ///< of each entry; infinite where that is not known
    double largest;  ///< of the entries' absolute values
  };
  const Approximate& approximate(u32 v) const { return approximate_[v]; }

 private:
  friend class ExactTensors;
  std::span<const std::array<double, 6>> tensors_;
  std::size_t fixed_;
  std::vector<Approximate> approximate_;
  std::vector<std::uint8_t> zero_;
  std::vector<SplitVertex> splits_;
};

/// Exact tensors on demand; one object a thread.
class ExactTensors {
 public:
  explicit ExactTensors(const Field& field) : field_(field) {}
  ExactTensor operator()(u32 v);

 private:
  const Field& field_;
  std::unordered_map<u32, ExactTensor> known_;
};

/// <T_i, T_j> and 2 tr(T_i T_j T_k) of a simplex' corners, hence |T|^2 and 6 det as forms.
template <class Number, std::size_t n>
struct Products {
  std::array<std::array<Number, n>, n> pair;
  std::array<std::array<std::array<Number, n>, n>, n> triple;
  Bound<Number> pair_error = 0, triple_error = 0;
  /// The tensors were divided by 2^exponent.
  std::conditional_t<std::is_same_v<Number, Lanes>, std::array<int, Lanes::count>, long> exponent{};
};

/// In doubles: divided by a power of two, so that all entries are at most 1.
template <std::size_t n>
Products<double, n> approximate_products(const Field& field, const std::array<u32, n>& corners);
/// The same of up to eight simplices; lanes that are left over repeat the last. The same bits.
Products<Lanes, 3> approximate_products(const Field& field,
                                        std::span<const std::array<u32, 3>> simplices);
Products<Lanes, 4> approximate_products(const Field& field,
                                        std::span<const std::array<u32, 4>> simplices);
template <std::size_t n>
Products<Integer, n> exact_products(ExactTensors& exact, const std::array<u32, n>& corners);

/// |T|^2.
template <class Number, std::size_t n>
Form<Number, n, 2> norm_form(const Products<Number, n>& p) {
  Form<Number, n, 2> form;
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t j = i; j < n; ++j) {
      Exponents<n> sum{};
      for (const auto m : {i, j}) sum[m] = static_cast<std::uint8_t>(sum[m] + 1);
      form.c[place_of<n>(sum)] = (i == j ? 1 : 2) * p.pair[i][j];
    }
  form.error = 2 * p.pair_error;
  return form;
}

/// 2 tr(T^3) = 6 det.
template <class Number, std::size_t n>
Form<Number, n, 3> cube_form(const Products<Number, n>& p) {
  Form<Number, n, 3> form;
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t j = i; j < n; ++j)
      for (std::size_t k = j; k < n; ++k) {
        Exponents<n> sum{};
        for (const auto m : {i, j, k}) sum[m] = static_cast<std::uint8_t>(sum[m] + 1);
        const int times = i == k ? 1 : i == j || j == k ? 3 : 6;
        form.c[place_of<n>(sum)] = times * p.triple[i][j][k];
      }
  form.error = 6 * p.triple_error;
  if constexpr (kApproximate<Number>) form.error = widened(form.error + kUnit * largest(form));
  return form;
}

}  // namespace crest::certify::modes
