// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The polynomials of a level on a simplex: f, and the witnesses of SPEC.md, up to positive factors.
#include "certify/exact/tensor_field.hpp"

namespace crest::certify::modes {

/// mu = p / q.
struct Level {
  double square;   ///< mu^2, within 8 u, relatively
  Integer p2, q2;  ///< p^2, q^2
  bool neutral;    ///< mu = 0: f is det
};

/// A direction in the barycentrics of a simplex; the numbers sum to 0.
template <std::size_t n>
using Direction = std::array<std::int32_t, n>;

template <class Number, std::size_t n>
class SimplexForms {
 public:
  explicit SimplexForms(const Products<Number, n>& products)
      : products_(products), norm_(norm_form(products)), cube_(cube_form(products)) {}

  const Form<Number, n, 2>& norm() const { return norm_; }
  /// 6 det.
  const Form<Number, n, 3>& cube() const { return cube_; }

  /// 2 f of SPEC.md, with mu > 0; of the tensors, or in integers times q^2.
  Form<Number, n, 6> pair(const Level& level) const {
    const auto square = cube_ * cube_;
    const auto norms = norm_ * norm_ * norm_;
    if constexpr (kApproximate<Number>)
      return scaled(Number(3), square) - scaled(Number(2 * level.square), norms, 16 * kUnit);
    else
      return scaled(Integer(3 * level.q2), square) - scaled(Integer(2 * level.p2), norms);
  }

  /// A direction, and lambda for these tensors as doubles: as they are divided by 2^exponent.
  using Numbers = std::array<std::conditional_t<kApproximate<Number>, Number, std::int32_t>, n>;
  using Factor = std::conditional_t<kApproximate<Number>, Number, double>;

  /// 2 D_w.
  Form<Number, n, 4> plain(const Numbers& w) const { return along(w) * norm_ - cube_ * inner(w); }

  /// A multiple of D_w |T|^2 + lambda f.
  Form<Number, n, 6> witness(const Numbers& w, const Factor& lambda, const Level& level) const {
    const auto derivative = plain(w) * norm_;
    const auto f = pair(level);
    if constexpr (kApproximate<Number>) {
      return derivative + scaled(3 * lambda, f, 4 * kUnit);
    } else {
      const auto [a, b] = weights(products_.exponent, lambda);
      return scaled(Integer(level.q2 * a), derivative) + scaled(Integer(3 * b), f);
    }
  }

  /// A multiple of <T^2, W> + lambda det; lambda of the tensors as they are.
  Form<Number, n, 3> neutral_witness(const Numbers& w, const Factor& lambda) const {
    Form<Number, n, 1> sum;
    for (auto& c : sum.c) c = 1;
    const auto derivative = along(w) * sum;
    if constexpr (kApproximate<Number>) {
      return scaled(Number(3), derivative) + scaled(lambda, cube_);
    } else {
      const auto [a, b] = weights(0, lambda);
      return scaled(Integer(3 * a), derivative) + scaled(b, cube_);
    }
  }

 private:
  /// 2^exponent and lambda, times one power of two that makes integers of them.
  static std::array<Integer, 2> weights(long exponent, double lambda) {
    int power = 0;
    const double fraction = std::frexp(lambda, &power);
    const Integer mantissa = static_cast<long long>(std::ldexp(fraction, 53));
    const long of_lambda = mantissa == 0 ? exponent : power - 53L;
    const long least = std::min(exponent, of_lambda);
    return {Integer(1) << static_cast<unsigned>(exponent - least),
            mantissa << static_cast<unsigned>(of_lambda - least)};
  }

  static Bound<Number> absolute(const Numbers& w) {
    Bound<Number> sum = 0;
    for (const auto& x : w) sum += kernel::magnitude(x);
    return sum;
  }

  /// 2 <T^2, W>.
  Form<Number, n, 2> along(const Numbers& w) const {
    Form<Number, n, 2> form;
    for (std::size_t i = 0; i < n; ++i)
      for (std::size_t j = i; j < n; ++j) {
        Number x = 0;
        for (std::size_t k = 0; k < n; ++k) x += w[k] * products_.triple[i][j][k];
        Exponents<n> sum{};
        for (const auto m : {i, j}) sum[m] = static_cast<std::uint8_t>(sum[m] + 1);
        form.c[place_of<n>(sum)] = (i == j ? 1 : 2) * x;
      }
    // Entries of `triple` are below 64; n + 1 roundings.
    if constexpr (kApproximate<Number>)
      form.error = widened(2 * absolute(w) * (products_.triple_error + 64 * 6 * kUnit));
    return form;
  }

  /// <T, W>.
  Form<Number, n, 1> inner(const Numbers& w) const {
    Form<Number, n, 1> form;
    for (std::size_t i = 0; i < n; ++i) {
      Number x = 0;
      for (std::size_t k = 0; k < n; ++k) x += w[k] * products_.pair[i][k];
      form.c[i] = x;
    }
    // Entries of `pair` are below 10.
    if constexpr (kApproximate<Number>)
      form.error = widened(absolute(w) * (products_.pair_error + 10 * 6 * kUnit));
    return form;
  }

  const Products<Number, n>& products_;
  Form<Number, n, 2> norm_;
  Form<Number, n, 3> cube_;
};

}  // namespace crest::certify::modes
