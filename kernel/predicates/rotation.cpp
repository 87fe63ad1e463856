// SPDX-License-Identifier: GPL-3.0-or-later
#include "kernel/predicates/rotation.hpp"

#include <algorithm>
#include <array>
#include <limits>
#include <vector>

#include "kernel/arithmetic/mp_interval.hpp"
#include "kernel/arithmetic/rational.hpp"

namespace crest::kernel {
namespace {

constexpr mpfr_prec_t kBits = 256;
constexpr double kUnknown = std::numeric_limits<double>::infinity();

// (x, y) of certify/SPEC.md: the direction d1 seen from the edge e in the plane across n.
template <class T>
std::pair<T, T> seen_from(const Vector3<T>& e, const Vector3<T>& n, const Vector3<T>& d1) {
  const Vector3<T> ne = cross(n, e);
  return {dot(ne, cross(n, d1)), dot(ne, d1)};
}

Vector3<Rational> exact(const Vec3& a) {
  return lift<Rational>(a);
}

// Lengths whose fourth powers neither overflow nor underflow.
bool comfortable(double x) {
  return x > 1e-60 && x < 1e60;
}

// Angle between two edge vectors; its error is below kArgumentError + 16 u when the lengths are
// comfortable: cross and dot product err by at most 6 u times the product of the lengths.
double corner_angle(const Vec3& a, const Vec3& b) {
  const Vec3 c = cross(a, b);
  return argument(norm(c), dot(a, b));
}

// The reference neighbour of phi and its angle to d1, in double; error kUnknown if not certain.
struct Reference {
  std::size_t k = 0;
  double angle = 0, error = 0;
};
Reference triage_reference(const Star& star) {
  const Vec3 e = star.ring[0] - star.centre;
  const auto [x, y] = seen_from<double>(e, star.n, star.d1);
  const double n = norm(star.n), d = norm(star.d1);
  const double size = norm(e);
  const double length = std::sqrt(x * x + y * y);
  if (!comfortable(n) || !comfortable(d) || !comfortable(size)) return {0, 0, kUnknown};
  // x and y are sums of products of at most |n|^2 |e| |d1| and |n| |e| |d1|.
  const double slip = 64 * kUnitRoundoff * std::fmax(n * n, n) * size * d;
  if (!(length > 1e6 * slip)) return {0, 0, kUnknown};
  // A displacement of at most 2 slip at distance length turns the argument by less than 4
  // slip/length.
  return {0, argument(y, x), kArgumentError + 4 * slip / length};
}

// The first neighbour with (x, y) != (0, 0), decided exactly; ring.size() if there is none.
std::size_t exact_reference(const Star& star) {
  const Vector3<Rational> n = exact(star.n), d1 = exact(star.d1);
  for (std::size_t k = 0; k < star.ring.size(); ++k) {
    const auto [x, y] = seen_from(exact(star.ring[k]) - exact(star.centre), n, d1);
    if (x != 0 || y != 0) return k;
  }
  return star.ring.size();
}

MpInterval mp(const Rational& x) {
  return MpInterval::from(x, kBits);
}

struct MpStar {
  std::vector<MpInterval> position, corner;
  MpInterval phi{kBits};
};

MpStar mp_star(const Star& star) {
  const std::size_t n = star.ring.size(), faces = star.closed ? n : n - 1;
  MpStar result;
  MpInterval sum(0.0, kBits);
  for (std::size_t j = 0; j < faces; ++j) {
    const Vector3<Rational> a = exact(star.ring[j]) - exact(star.centre);
    const Vector3<Rational> b = exact(star.ring[(j + 1) % n]) - exact(star.centre);
    const Vector3<Rational> c = cross(a, b);
    result.corner.push_back(atan2(sqrt(mp(dot(c, c))), mp(dot(a, b))));
    sum = sum + result.corner.back();
  }
  MpInterval at(0.0, kBits);
  const MpInterval turn = MpInterval(2.0, kBits) * MpInterval::pi(kBits);
  for (std::size_t j = 0; j < n; ++j) {
    result.position.push_back(star.closed ? turn * at / sum : at);
    if (j == faces) break;
    at = at + result.corner[j];
    if (star.closed) result.corner[j] = turn * result.corner[j] / sum;
  }
  const std::size_t k = exact_reference(star);
  if (k == n) {
    const auto first =
        std::find_if(star.d1.begin(), star.d1.end(), [](double x) { return x != 0; });
    const bool backward = first != star.d1.end() && *first < 0;
    result.phi = backward ? MpInterval::pi(kBits) : MpInterval(0.0, kBits);
    return result;
  }
  const auto [x, y] =
      seen_from(exact(star.ring[k]) - exact(star.centre), exact(star.n), exact(star.d1));
  result.phi = result.position[k] + atan2(mp(y), mp(x));
  return result;
}

double middle(const MpInterval& x) {
  return (x.lower() + x.upper()) / 2;
}

StarAngles interval_star_angles(const Star& star, std::span<double> position,
                                std::span<double> corner) {
  const MpStar exact = mp_star(star);
  for (std::size_t j = 0; j < exact.position.size(); ++j) position[j] = middle(exact.position[j]);
  for (std::size_t j = 0; j < exact.corner.size(); ++j) corner[j] = middle(exact.corner[j]);
  return {middle(exact.phi), 1e-14, Stage::interval};
}

}  // namespace

StarAngles star_angles(const Star& star, std::span<double> position, std::span<double> corner) {
  const std::size_t n = star.ring.size(), faces = star.closed ? n : n - 1;
  double sum = 0, shortest = HUGE_VAL, longest = 0;
  Vec3 a = star.ring[0] - star.centre;
  const Vec3 first = a;
  for (std::size_t j = 0; j < n; ++j) {
    const Vec3 b = j + 1 < n ? star.ring[j + 1] - star.centre : first;
    const double l = dot(a, a);
    shortest = std::min(shortest, l);
    longest = std::max(longest, l);
    position[j] = sum;
    if (j < faces) {
      corner[j] = corner_angle(a, b);
      sum += corner[j];
    }
    a = b;
  }
  const double count = static_cast<double>(faces);
  const double raw_error = count * (kArgumentError + 1e-14);
  const Reference reference = triage_reference(star);
  double error = raw_error;
  if (star.closed) {
    const double scale = 2 * kPi / sum;
    for (double& x : position) x *= scale;
    for (double& x : corner) x *= scale;
    // Numerator and denominator err by raw_error each; the quotient is at most 1.
    error = sum > 4 * raw_error ? 3 * scale * raw_error + 1e-14 : kUnknown;
  }
  if (!comfortable(std::sqrt(shortest)) || !comfortable(std::sqrt(longest))) error = kUnknown;
  error = 2 * error + reference.error;
  // Nothing below needs more than a few digits, but it needs them for certain.
  if (!(error < 1e-3)) return interval_star_angles(star, position, corner);
  return {position[reference.k] + reference.angle, error, Stage::triage};
}

std::optional<double> interval_rotation(const EdgeStars& edge) {
  const MpStar v = mp_star(edge.v), w = mp_star(edge.w);
  const MpInterval pi = MpInterval::pi(kBits);
  // phi(w) - phi(v) - r(v, w) with r = a(w, v) + pi - a(v, w)
  MpInterval raw = w.phi - v.phi - w.position[edge.at_w] - pi + v.position[edge.at_v];
  if (edge.reversed) raw = raw + pi;
  const MpInterval margin(0x1p-200, kBits);  // closer is a tie by definition (certify/SPEC.md)
  const double turns = -std::floor((middle(raw) + kPi) / (2 * kPi));
  for (const double m : {turns, turns + 1, turns - 1}) {
    const MpInterval omega = raw + MpInterval(2 * m, kBits) * pi;
    if (certain_sign(omega + pi - margin) == Sign::positive &&
        certain_sign(pi - omega - margin) == Sign::positive)
      return middle(omega);
  }
  return std::nullopt;
}

}  // namespace crest::kernel
