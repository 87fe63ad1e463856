// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/modes/degenerate_face.hpp"

#include <algorithm>
#include <numbers>

namespace crest::modes {

namespace {

using kernel::MaybeSign;
using kernel::Sign;

double dot(const std::array<double, 5>& a, const std::array<double, 5>& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2] + a[3] * b[3] + a[4] * b[4];
}

double determinant(const std::array<double, 5>& u) {
  constexpr double h = std::numbers::sqrt2 / 2, g = h * std::numbers::inv_sqrt3;
  const double xx = h * u[1] - g * u[0], yy = -h * u[1] - g * u[0], zz = 2 * g * u[0];
  const double xy = h * u[2], yz = h * u[3], xz = h * u[4];
  return xx * (yy * zz - yz * yz) - xy * (xy * zz - yz * xz) + xz * (xy * yz - yy * xz);
}

/// The real roots x : y of f[0] y^4 + ... + f[4] x^4, in plain doubles (Ferrari): guesses.
struct Guesses {
  std::array<std::array<double, 2>, 4> root;
  std::size_t count = 0;

  explicit Guesses(const std::array<Ball, 5>& ball) {
    std::array<double, 5> f;
    const bool turned = std::fabs(ball[0].mid) > std::fabs(ball[4].mid);
    for (std::size_t k = 0; k < 5; ++k) f[k] = ball[turned ? 4 - k : k].mid;
    const double a = f[3] / f[4], b = f[2] / f[4], c = f[1] / f[4], d = f[0] / f[4];
    // t = s - a/4: s^4 + p s^2 + q s + r
    const double a2 = a * a, p = b - 3 * a2 / 8, q = c - a * b / 2 + a2 * a / 8;
    const double r = d - a * c / 4 + a2 * b / 16 - 3 * a2 * a2 / 256;
    const double z = largest_root(2 * p, p * p - 4 * r, -q * q);
    const double w = std::sqrt(std::max(z, 0.0));
    const double part = w > 0 ? q / w : 0;
    const double rest = w > 0 ? 0 : std::sqrt(std::max(p * p - 4 * r, 0.0));
    add(w, (p + z - part - rest) / 2, a / 4, turned);
    add(-w, (p + z + part + rest) / 2, a / 4, turned);
  }

 private:
  /// Of z^3 + a z^2 + b z + c.
  static double largest_root(double a, double b, double c) {
    const double q = (a * a - 3 * b) / 9, r = (2 * a * a * a - 9 * a * b + 27 * c) / 54;
    if (r * r < q * q * q) {
      const double root = std::sqrt(q), angle = std::acos(r / (q * root));
      return -2 * root * std::cos((angle + 2 * std::numbers::pi) / 3) - a / 3;
    }
    const double s = -std::copysign(std::cbrt(std::fabs(r) + std::sqrt(r * r - q * q * q)), r);
    return s + (s == 0 ? 0 : q / s) - a / 3;
  }
  /// The roots of s^2 + w s + e.
  void add(double w, double e, double shift, bool turned) {
    const double disc = w * w - 4 * e;
    if (!(disc >= 0)) return;
    const double far = -(w + std::copysign(std::sqrt(disc), w)) / 2;
    for (const double s : {far, far == 0 ? 0 : e / far}) {
      const double t = s - shift;
      root[count++] = turned ? std::array<double, 2>{1, t} : std::array<double, 2>{t, 1};
    }
  }
};

/// A root proven by a sign change, as x : y with one of them 1.
struct ProvenRoot {
  Ball x, y;
};

Ball value_at(const std::array<Ball, 5>& f, bool turned, double t) {
  Ball sum = f[turned ? 0 : 4];
  for (std::size_t k = 1; k < 5; ++k) sum = sum * Ball(t) + f[turned ? k : 4 - k];
  return sum;
}

std::optional<ProvenRoot> prove(const std::array<Ball, 5>& f, const std::array<double, 2>& guess) {
  const bool turned = std::fabs(guess[0]) > std::fabs(guess[1]);
  double t = turned ? guess[1] / guess[0] : guess[0] / guess[1], slope = 0;
  const auto c = [&](std::size_t k) { return f[turned ? 4 - k : k].mid; };
  for (int step = 0; step < 4; ++step) {
    slope = c(1) + t * (2 * c(2) + t * (3 * c(3) + t * 4 * c(4)));
    const double move = (c(0) + t * (c(1) + t * (c(2) + t * (c(3) + t * c(4))))) / slope;
    t -= move;
    if (std::fabs(move) < 1e-15) break;
  }
  if (!(std::fabs(t) <= 2)) return std::nullopt;
  const double reach = 2 * value_at(f, turned, t).rad / std::fabs(slope) + 0x1p-51;
  const MaybeSign low = certain_sign(value_at(f, turned, t - reach));
  const MaybeSign high = certain_sign(value_at(f, turned, t + reach));
  if (!low || !high || *low == *high) return std::nullopt;
  const Ball place(t, reach * Ball::kSlack + 0x1p-52);
  return turned ? ProvenRoot{1, place} : ProvenRoot{place, 1};
}

/// x, y, z -> the place after `axis` twice, axis.
Conic<Ball> turned_to(const Conic<Ball>& p, std::size_t axis) {
  const std::size_t x = (axis + 1) % 3, y = (axis + 2) % 3, z = axis;
  const auto at = [&](std::size_t i, std::size_t j) {
    return p.c[i == j ? i : i + j == 1 ? 3 : i + j == 3 ? 4 : 5];
  };
  return {{at(x, x), at(y, y), at(z, z), at(x, y), at(y, z), at(x, z)}};
}

/// 4 or 2 real roots, of two traceless conics' quartic; 0: not decided.
std::size_t number_of_roots(const std::array<Ball, 5>& f) {
  const Ball i = Ball(12) * (f[4] * f[0]) - Ball(3) * (f[3] * f[1]) + f[2] * f[2];
  const Ball j =
      f[2] * (Ball(72) * (f[4] * f[0]) + Ball(9) * (f[3] * f[1]) - (f[2] * f[2] + f[2] * f[2])) -
      Ball(27) * (f[4] * (f[1] * f[1]) + f[0] * (f[3] * f[3]));
  const MaybeSign s = certain_sign(Ball(4) * (i * i * i) - j * j);
  if (!s || *s == Sign::zero) return 0;
  return *s == Sign::positive ? 4 : 2;
}

}  // namespace

Direction direction(const Tensor& t) {
  constexpr double h = std::numbers::sqrt2 / 2, g = h * std::numbers::inv_sqrt3;
  double largest = 0;
  for (const double x : t) largest = std::max(largest, std::fabs(x));
  // Far from overflow and underflow of squares.
  if (!(largest > 0x1p-400 && largest < 0x1p400)) return {};
  std::array<double, 5> d{g * ((t[2] - t[0]) + (t[2] - t[1])), h * (t[0] - t[1]),
                          std::numbers::sqrt2 * t[3], std::numbers::sqrt2 * t[4],
                          std::numbers::sqrt2 * t[5]};
  const double norm = std::sqrt(dot(d, d));
  if (!(norm > 0x1p-10 * largest)) return {};
  for (double& x : d) x /= norm;
  return {d, true, 64 * kernel::kUnitRoundoff * largest / norm};
}

bool cone_excludes(std::span<const Direction> u) {
  std::array<double, 5> sum{};
  for (const Direction& d : u) {
    if (!d.usable) return false;
    for (std::size_t k = 0; k < 5; ++k) sum[k] += d.x[k];
  }
  const double square = dot(sum, sum), norm = std::sqrt(square);
  if (!(norm > 0.5)) return false;
  double c = 1e300, error = 0;
  for (const Direction& d : u) {
    c = std::min(c, dot(d.x, sum));
    error = std::max(error, d.error);
  }
  c /= norm;
  const double mode = std::fabs(determinant(sum)) / (square * norm) * (3 * 2.449489742783178);
  return c > 0.5 && c * (4 * c * c - 3) > mode + 9 * error + 2000 * kernel::kUnitRoundoff;
}

bool cones_exclude(std::span<const Direction> u, int depth) {
  if (cone_excludes(u)) return true;
  if (depth == 0 || u.size() < 2) return false;
  std::size_t a = 0, b = 1;
  double least = 2;
  for (std::size_t i = 0; i < u.size(); ++i)
    for (std::size_t j = i + 1; j < u.size(); ++j)
      if (const double c = dot(u[i].x, u[j].x); c < least) least = c, a = i, b = j;
  Direction middle;
  for (std::size_t k = 0; k < 5; ++k) middle.x[k] = u[a].x[k] + u[b].x[k];
  const double norm = std::sqrt(dot(middle.x, middle.x));
  const double ends = u[a].error + u[b].error;
  if (!(norm > 0.1 + ends) || !u[a].usable || !u[b].usable) return false;
  for (double& x : middle.x) x /= norm;
  middle.usable = true;
  middle.error = (ends + 16 * kernel::kUnitRoundoff) / (norm - ends);
  std::array<Direction, 4> part;
  for (const std::size_t end : {a, b}) {
    std::copy(u.begin(), u.end(), part.begin());
    part[end] = middle;
    if (!cones_exclude({part.data(), u.size()}, depth - 1)) return false;
  }
  return true;
}

std::optional<FaceRoots> triage_face_roots(const std::array<const Tensor*, 3>& corners) {
  const auto forms = triage_forms<3>(corners);
  if (!forms) return std::nullopt;
  const auto& [p, q] = forms->vanishing;
  std::size_t axis = 0;
  double largest = 0;
  bool second = false;
  for (std::size_t k = 0; k < 3; ++k) {
    if (const double w = std::fabs(p.c[k].mid); w > largest) largest = w, axis = k, second = false;
    if (const double w = std::fabs(q.c[k].mid); w > largest) largest = w, axis = k, second = true;
  }
  const PencilQuartic<Ball> pencil(turned_to(second ? q : p, axis),
                                   turned_to(second ? p : q, axis));
  const std::size_t expected = number_of_roots(pencil.f);
  if (expected == 0) return std::nullopt;
  const Guesses guesses(pencil.f);
  if (guesses.count != expected) return std::nullopt;
  std::array<ProvenRoot, 4> proven;
  FaceRoots result;
  result.stage = FaceStage::triage;
  for (std::size_t i = 0; i < expected; ++i) {
    const auto root = prove(pencil.f, guesses.root[i]);
    if (!root) return std::nullopt;
    proven[i] = *root;
    for (std::size_t j = 0; j < i; ++j)
      if (!certain_sign(root->x * proven[j].y - root->y * proven[j].x)) return std::nullopt;
    const kernel::Vector3<Ball> w = pencil.point(root->x, root->y);
    kernel::Vector3<Ball> v;
    for (std::size_t k = 0; k < 3; ++k) v[(axis + 1 + k) % 3] = w[k];
    std::array<MaybeSign, 3> sign;
    std::array<Ball, 3> b;
    bool up = false, down = false;
    for (std::size_t k = 0; k < 3; ++k) {
      const Ball value = forms->coordinates[k].at(v);
      sign[k] = certain_sign(value);
      b[k] = value;
      up = up || sign[k] == Sign::positive;
      down = down || sign[k] == Sign::negative;
    }
    if (up && down) continue;
    if (!sign[0] || !sign[1] || !sign[2] || !(up || down)) return std::nullopt;
    const Ball sum = b[0] + b[1] + b[2];
    result.root[result.count++] = {up ? DegenerateType::linear : DegenerateType::planar,
                                   v,
                                   {b[0] / sum, b[1] / sum, b[2] / sum}};
  }
  return result;
}

FaceRoots face_roots(const std::array<const Tensor*, 3>& corners) {
  std::array<Direction, 3> u;
  for (std::size_t k = 0; k < 3; ++k) u[k] = direction(*corners[k]);
  if (cone_excludes(u)) return {{}, 0, FaceStage::cone, {}};
  if (auto result = triage_face_roots(corners)) return *result;
  if (cones_exclude(u, 8)) return {{}, 0, FaceStage::cone, {}};
  return exact_face_roots(corners);
}

}  // namespace crest::modes
