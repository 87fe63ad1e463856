// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/modes/sphere.hpp"

#include <cmath>
#include <numbers>

#include "algorithms/modes/degenerate_conic.hpp"

namespace crest::modes {

using kernel::Vec3;
using kernel::operator+;
using kernel::operator*;

namespace {

Matrix3 matrix(const Conic<Ball>& f) {
  const auto& c = f.c;
  return {Vec3{c[0].mid, c[3].mid, c[5].mid}, Vec3{c[3].mid, c[1].mid, c[4].mid},
          Vec3{c[5].mid, c[4].mid, c[2].mid}};
}

/// Tbar across v.
struct Across {
  double alpha, beta, rho;
  Vec3 major, minor;

  Across(const LinearTensors& field, const Vec3& v) {
    const Matrix3& bar = field.characteristic();
    const Vec3 image = product(bar, v), p = across(v), q = kernel::cross(v, p);
    alpha = kernel::dot(v, image);
    beta = kernel::dot(image, image);
    const double half = (kernel::dot(p, product(bar, p)) - kernel::dot(q, product(bar, q))) / 2;
    const double mixed = kernel::dot(p, product(bar, q));
    rho = std::hypot(half, mixed);
    const double turn = std::atan2(mixed, half) / 2;
    major = std::cos(turn) * p + std::sin(turn) * q;
    minor = kernel::cross(v, major);
  }
};

}  // namespace

LinearTensors::LinearTensors(const std::array<Tensor, 4>& corners) {
  Elimination<4> e(corner_rows<Ball, 4>({&corners[0], &corners[1], &corners[2], &corners[3]}));
  e.run();
  const auto forms = e.forms();
  const Matrix3 bar = matrix(forms.vanishing[0]);
  const double norm = std::sqrt(inner(bar, bar));
  bar_ = sum({}, determinant(bar) > 0 ? -1 / norm : 1 / norm, bar);
  bar_mode_ = 3 * std::sqrt(6.0) * determinant(bar_);
  for (std::size_t k = 0; k < 4; ++k) dual_[k] = matrix(forms.coordinates[k]);
  const Eigensystem axes = eigensystem(bar_);
  frame_ = axes.vectors;
  eigenvalues_ = axes.values;
}

LinearTensors::Place LinearTensors::place(const Matrix3& u) const {
  Place p{};
  double sum = 0;
  for (std::size_t k = 0; k < 4; ++k) {
    p.weights[k] = inner(dual_[k], u);
    sum += p.weights[k];
  }
  if (sum == 0) return p;
  p.s = 1 / sum;
  for (double& w : p.weights) w *= p.s;
  return p;
}

double sine_of_theta(double mu) {
  return std::numbers::sqrt3 * std::tan(std::asin(std::fabs(mu)) / 3);
}

double real_domain(const LinearTensors& field, const Vec3& v, double mu) {
  const Across c(field, v);
  const double s = c.alpha * sine_of_theta(mu);
  return c.rho * c.rho - s * s / 4;
}

std::optional<std::array<ModePoint, 2>> mode_points(const LinearTensors& field, const Vec3& v,
                                                    double mu) {
  const Across c(field, v);
  const double cosine = c.alpha * sine_of_theta(mu) / (2 * c.rho);
  if (!(std::fabs(cosine) <= 1)) return std::nullopt;
  const double a = std::asin(std::fabs(mu)) / 3, unit = std::sqrt(2.0 / 3);
  const double upper = unit * std::sin(2 * std::numbers::pi / 3 - a), middle = -unit * std::sin(a);
  std::array<ModePoint, 2> result;
  double turn = std::acos(cosine) / 2;
  for (ModePoint& p : result) {
    p.dominant = std::cos(turn) * c.major + std::sin(turn) * c.minor;
    p.tensor = sum(sum(square(middle, v), 1, square(upper, p.dominant)), -(middle + upper),
                   square(1, kernel::cross(v, p.dominant)));
    const auto place = field.place(p.tensor);
    p.weights = place.weights;
    p.sign = place.s > 0 ? 1 : place.s < 0 ? -1 : 0;
    turn = -turn;
  }
  return result;
}

IrregularPoints irregular_points(const LinearTensors& field) {
  const Vec3& l = field.eigenvalues();
  return {std::sqrt((l[0] - l[1]) / (l[0] - l[2])), std::sqrt((l[1] - l[2]) / (l[0] - l[2]))};
}

std::optional<Vec3> boundary_point(const LinearTensors& field, double alpha, double mu) {
  const Vec3& l = field.eigenvalues();
  const double sine = sine_of_theta(mu);
  const double beta = (1 + (1 - sine * sine) * alpha * alpha / 2) / 2;
  // sum x_i^2 = 1, sum l_i x_i^2 = alpha, sum l_i^2 x_i^2 = beta.
  Vec3 x;
  for (std::size_t i = 0; i < 3; ++i) {
    const double j = l[(i + 1) % 3], k = l[(i + 2) % 3];
    const double square = (beta - (j + k) * alpha + j * k) / ((l[i] - j) * (l[i] - k));
    if (!(square >= 0)) return std::nullopt;
    x[i] = std::sqrt(square);
  }
  return x;
}

Vec3 quad_grid(const IrregularPoints& p, double theta, double eta) {
  const double f = p.a * p.a / (p.c * p.c) - 1, cosine = std::cos(eta);
  const Vec3 v{std::cos(theta) * std::sqrt(f * cosine * cosine + 1),
               std::sin(theta) * std::sin(eta), cosine};
  return (1 / kernel::norm(v)) * v;
}

Vec3 spheroconal_grid(const IrregularPoints& p, double theta, double eta) {
  const double ct = std::cos(theta), ce = std::cos(eta);
  return {ct * std::sqrt(1 - p.c * p.c * ce * ce), std::sin(theta) * std::sin(eta),
          ce * std::sqrt(1 - p.a * p.a * ct * ct)};
}

}  // namespace crest::modes
