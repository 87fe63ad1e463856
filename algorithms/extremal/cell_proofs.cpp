// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/extremal/cell_proofs.hpp"

#include <algorithm>

#include "kernel/arithmetic/wide_clones.hpp"

namespace crest::extremal {
namespace {

// Of a test's terms, and of the coefficients.
constexpr double kMargin = 1e-6, kSlack = 1e-10;

/// The bilinear form u.Tw as six factors of T's entries.
std::array<double, 6> form(const Vec3& u, const Vec3& w) {
  return {u[0] * w[0],
          u[1] * w[1],
          u[2] * w[2],
          u[0] * w[1] + u[1] * w[0],
          u[1] * w[2] + u[2] * w[1],
          u[0] * w[2] + u[2] * w[0]};
}
double apply(const std::array<double, 6>& f, const std::array<Controls, 6>& t, std::size_t i) {
  return f[0] * t[0][i] + f[1] * t[1][i] + f[2] * t[2][i] + f[3] * t[3][i] + f[4] * t[4][i] +
         f[5] * t[5][i];
}
double apply(const std::array<double, 3>& f, const std::array<Controls, 3>& v, std::size_t i) {
  return f[0] * v[0][i] + f[1] * v[1][i] + f[2] * v[2][i];
}

// In eight parts, so that the compiler may take them together.
template <class Better>
double reduce(const Controls& c, Better better) {
  std::array<double, 8> best;
  std::copy_n(c.begin(), 8, best.begin());
  for (std::size_t i = 8; i < c.size(); i += 8)
    for (std::size_t k = 0; k < 8; ++k) best[k] = better(c[i + k], best[k]);
  double r = best[0];
  for (const double x : best) r = better(x, r);
  return r;
}
double least(const Controls& c) {
  return reduce(c, [](double a, double b) { return a < b ? a : b; });
}
double largest(const Controls& c) {
  return reduce(c, [](double a, double b) { return a > b ? a : b; });
}

/// Of one control each: Frobenius' norm of a symmetric tensor.
double square_norm(const std::array<Controls, 6>& t, std::size_t i) {
  return t[0][i] * t[0][i] + t[1][i] * t[1][i] + t[2][i] * t[2][i] +
         2 * (t[3][i] * t[3][i] + t[4][i] * t[4][i] + t[5][i] * t[5][i]);
}

/// The largest |v| across w, and the least and largest w.v.
struct GradientBounds {
  double across, low, high;
};
GradientBounds gradient_bounds(const std::array<Controls, 3>& v, const Vec3& w) {
  Controls along, square;
  for (std::size_t i = 0; i < 64; ++i) {
    const double a = apply(w, v, i);
    along[i] = a;
    square[i] = v[0][i] * v[0][i] + v[1][i] * v[1][i] + v[2][i] * v[2][i] - a * a;
  }
  return {std::sqrt(std::max(0.0, largest(square))), least(along), largest(along)};
}

/// Derivatives of a cell's splines in index units; s carries its sign.
class Derivatives {
 public:
  Derivatives(const Fields& fields, const Node& v) : fields_(fields), cell_(v) {
    scalar_ = fields.coefficients(fields.scalars(), v);
    for (double& x : scalar_) x *= fields.sign();
  }
  Controls scalar(std::array<int, 3> orders) const {
    Controls c = scalar_;
    kernel::to_spline_net<double, 3>(c, orders);
    return c;
  }
  /// Of s, xx yy zz xy yz xz; raised by one derivative along `more`.
  std::array<Controls, 6> hessian(int more = 3) const {
    std::array<Controls, 6> r;
    for (std::size_t n = 0; n < 6; ++n) {
      std::array<int, 3> orders{};
      ++orders[kAxes[n][0]];
      ++orders[kAxes[n][1]];
      if (more < 3) ++orders[static_cast<std::size_t>(more)];
      r[n] = scalar(orders);
    }
    return r;
  }
  /// Of T, where it is not the Hessian.
  std::array<Coefficients, 6> tensor_coefficients() const {
    std::array<Coefficients, 6> r;
    for (std::size_t t = 0; t < fields_.tensors().size(); ++t)
      r[t] = fields_.coefficients(fields_.tensors()[t], cell_);
    return r;
  }
  /// dT along an axis, T in world units.
  std::array<Controls, 6> tensor(int axis, const std::array<Coefficients, 6>& coefficients) const {
    const Vec3& d = fields_.grid().spacing;
    std::array<Controls, 6> r{};
    if (!fields_.structure()) {
      r = hessian(axis);
      for (std::size_t n = 0; n < 6; ++n)
        for (double& x : r[n]) x /= d[kAxes[n][0]] * d[kAxes[n][1]];
      return r;
    }
    for (std::size_t t = 0; t < fields_.tensors().size(); ++t) {
      std::array<int, 3> orders{};
      orders[static_cast<std::size_t>(axis)] = 1;
      r[fields_.entry(t)] = coefficients[t];
      kernel::to_spline_net<double, 3>(r[fields_.entry(t)], orders);
    }
    return r;
  }
  static constexpr std::array<std::array<std::size_t, 2>, 6> kAxes = {
      {{0, 0}, {1, 1}, {2, 2}, {0, 1}, {1, 2}, {0, 2}}};

 private:
  const Fields& fields_;
  Node cell_;
  Coefficients scalar_;
};

/// Is grad g in one cone, and is s_nn positive?
class RegularTest {
 public:
  RegularTest(const Fields& fields, const Node& v, const Vec3& w, double gap, double theta,
              const CellNets& nets)
      : fields_(fields),
        made_(fields, v),
        w_(w),
        gap_(gap),
        theta_(theta),
        hessian_(made_.hessian()) {
    const auto& spacing = fields.grid().spacing;
    least_ = std::min({spacing[0], spacing[1], spacing[2]});
    slack_ = 4 * kSlack * nets.gradient_size;
    tensor_slack_ = kSlack * nets.tensor_size;
    // Index units to diag(d) Hess: each column over its spacing.
    const Vec3 inverse{1 / spacing[0], 1 / spacing[1], 1 / spacing[2]};
    double square = 0;
    for (std::size_t i = 0; i < 64; ++i) {
      double sum = 0;
      for (std::size_t row = 0; row < 3; ++row) {
        double h = 0, own = 0;
        for (std::size_t col = 0; col < 3; ++col) {
          const double x = hessian_[entry(row, col)][i] * inverse[col];
          h += x * w[col];
          own += x * x;
        }
        h_[row][i] = h;
        row_size_[row] = std::max(row_size_[row], own);
        sum += own;
      }
      square = std::max(square, sum);
    }
    size_ = std::sqrt(square);
    for (double& x : row_size_) x = std::sqrt(x);
  }

  /// Is grad g in one cone? Sets its axis, and whether the box test holds.
  bool regular(const GradientBounds& g, CellProof& proof) const {
    Vec3 sum{};
    for (std::size_t i = 0; i < 64; ++i) sum = sum + Vec3{h_[0][i], h_[1][i], h_[2][i]};
    if (!(kernel::norm(sum) > 0)) return false;
    proof.gradient = shortened(sum);
    const Vec3 a = unit(proof.gradient);
    double room = HUGE_VAL;
    for (std::size_t i = 0; i < 64; ++i) {
      const Vec3 h = {h_[0][i], h_[1][i], h_[2][i]};
      const double along = kernel::dot(a, h);
      room = std::min(room, along - kernel::norm(h - along * a));
    }
    // First without what turns of n add, which costs most.
    if (!(room > 0)) return false;
    const double largest = std::max(std::fabs(g.low), std::fabs(g.high));
    const double chord = 2 * std::sin(theta_ / 2), across = g.across + std::sin(theta_) * largest;
    const Vec3 turn = turns();
    const double e = chord * size_ + kernel::norm(turn) * across;
    proof.boxed = boxed((chord + kMargin) * row_size_ + across * turn +
                        (kMargin * size_ + slack_) * Vec3{1, 1, 1});
    return room > std::sqrt(2.0) * e + kMargin * size_ + slack_;
  }

  bool extremal() const {
    const Tensor factors = world_hessian({1, 1, 1, 1, 1, 1}, fields_.grid().spacing);
    double low = HUGE_VAL, square = 0;
    for (std::size_t i = 0; i < 64; ++i) {
      Tensor h;
      for (std::size_t n = 0; n < 6; ++n) h[n] = hessian_[n][i] * factors[n];
      low = std::min(low, kernel::dot(w_, product(h, w_)));
      square = std::max(square, h[0] * h[0] + h[1] * h[1] + h[2] * h[2] +
                                    2 * (h[3] * h[3] + h[4] * h[4] + h[5] * h[5]));
    }
    const double size = std::sqrt(square);
    return low > 2 * theta_ * size + kMargin * size + slack_ / least_;
  }

 private:
  /// Do any two vectors with coordinates in the ranges of h, widened by e's, have a positive
  /// product?
  bool boxed(const Vec3& e) const {
    double sum = 0, square = 0;
    for (std::size_t k = 0; k < static_cast<std::size_t>(fields_.grid().dimension()); ++k) {
      const double low = least(h_[k]) - e[k], high = largest(h_[k]) + e[k];
      sum += low > 0 ? low * low : high < 0 ? high * high : low * high;
      square += std::max(low * low, high * high);
    }
    return sum > kMargin * square;
  }
  static constexpr std::size_t entry(std::size_t a, std::size_t b) {
    return a == b ? a : a + b == 1 ? 3 : a + b == 3 ? 4 : 5;
  }
  /// Bounds how fast n turns along the axes: D_k of the specification.
  Vec3 turns() const {
    const auto [u, v] = kernel::frame_across(w_);
    const auto fu = form(u, w_), fv = form(v, w_);
    Vec3 r{};
    std::array<Coefficients, 6> coefficients;
    if (fields_.structure()) coefficients = made_.tensor_coefficients();
    for (int k = 0; k < fields_.grid().dimension(); ++k) {
      const auto dt = made_.tensor(k, coefficients);
      Controls across, norm;
      for (std::size_t i = 0; i < 64; ++i) {
        const double a = apply(fu, dt, i), b = apply(fv, dt, i);
        across[i] = a * a + b * b;
        norm[i] = square_norm(dt, i);
      }
      r[static_cast<std::size_t>(k)] =
          (std::sqrt(largest(across)) + 2 * theta_ * std::sqrt(largest(norm)) + tensor_slack_) /
          gap_;
    }
    return r;
  }

  const Fields& fields_;
  Derivatives made_;
  Vec3 w_;
  double gap_, theta_, size_ = 0, least_, slack_, tensor_slack_;
  std::array<Controls, 6> hessian_;
  std::array<Controls, 3> h_;
  Vec3 row_size_{};  ///< of diag(d) Hess s
};

/// What the cone test tells of a net: the least q - mu, the largest |b|.
struct ConeBounds {
  double gap, across;
};
ConeBounds cone_bounds(const std::array<Controls, 6>& tensor, const Vec3& w) {
  const auto [u, v] = kernel::frame_across(w);
  const auto ww = form(w, w), uw = form(u, w), vw = form(v, w), uu = form(u, u), uv = form(u, v),
             vv = form(v, v);
  Controls gap, square;
  for (std::size_t i = 0; i < 64; ++i) {
    const double q = apply(ww, tensor, i), a = apply(uu, tensor, i), b = apply(uv, tensor, i),
                 c = apply(vv, tensor, i), x = apply(uw, tensor, i), y = apply(vw, tensor, i);
    const double half = 0.5 * (a - c);
    gap[i] = q - 0.5 * (a + c) - std::sqrt(half * half + b * b);
    square[i] = x * x + y * y;
  }
  return {least(gap), std::sqrt(largest(square))};
}

CREST_WIDE_CLONES CellProof prove(const Fields& fields, const Node& v, const CellNets& nets,
                                  const Vec3& guess) {
  CellProof r;
  if (!(kernel::norm(guess) > 0)) return r;
  r.direction = shortened(guess);
  const Vec3 w = unit(r.direction);
  const ConeBounds cone = cone_bounds(nets.tensor, w);
  // The checker's bound of an image's roundings is relative to its entry zz.
  const double slack = (fields.grid().dimension() == 2 ? 16 : 1) * kSlack;
  const double gap = cone.gap * (1 - kMargin) - slack * nets.tensor_size;
  if (!(gap > 0)) return r;
  r.state = CellState::cone;
  const double theta = 0.5 * std::atan(2 * (cone.across + slack * nets.tensor_size) / gap);
  const GradientBounds g = gradient_bounds(nets.gradient, w);
  const double sine = std::sin(theta) * g.across * (1 + kMargin) + kSlack * nets.gradient_size,
               cosine = std::cos(theta) * (1 - kMargin);
  if (g.low * cosine > sine || -g.high * cosine > sine) {
    r.state = CellState::empty;
    return r;
  }
  const RegularTest test(fields, v, w, gap, theta, nets);
  if (!test.regular(g, r)) return r;
  r.state = test.extremal() ? CellState::regular_extremal : CellState::regular;
  return r;
}

}  // namespace

CellProof prove_cell(const Fields& fields, const Node& v, const CellNets& nets, const Vec3& guess) {
  return prove(fields, v, nets, guess);
}

}  // namespace crest::extremal
