// SPDX-License-Identifier: GPL-3.0-or-later
#include "kernel/predicates/enclosed_volume.hpp"

#include "kernel/arithmetic/approximate.hpp"
#include "kernel/arithmetic/interval.hpp"
#include "kernel/arithmetic/rational.hpp"

namespace crest::kernel {
namespace {

/// Differences in doubles, so each is a leaf with one factor (1 + d), |d| <= u. A term of a
/// determinant gets 3 of these, 2 of its products, 3 of its differences and sums, and at most n of
/// the sum over the faces: k = n + 8. The theorem at Approximate holds for k u <= 1/8 with 2 k u in
/// place of (k + 2) u: ((1 + u)^k - 1) / (1 - u)^k <= 1.14 k u / (7 / 8).
MaybeSign triage_volume(std::span<const Vec3> points, std::span<const FaceCorners> faces) {
  const Vec3& o = points[faces[0][0]];
  Approximate sum = 0;
  for (const auto& [a, b, c] : faces)
    sum = sum + determinant(lift<Approximate>(points[a] - o), lift<Approximate>(points[b] - o),
                            lift<Approximate>(points[c] - o));
  const double bound = 2 * (static_cast<double>(faces.size()) + 8) * kUnitRoundoff * sum.magnitude;
  if (sum.value > bound) return Sign::positive;
  if (sum.value < -bound) return Sign::negative;
  return std::nullopt;
}

template <class T>
T sum_of_determinants(std::span<const Vec3> points, std::span<const FaceCorners> faces) {
  const Vector3<T> o = lift<T>(points[faces[0][0]]);
  T sum = 0;
  for (const auto& [a, b, c] : faces)
    sum = sum + determinant(lift<T>(points[a]) - o, lift<T>(points[b]) - o, lift<T>(points[c]) - o);
  return sum;
}

MaybeSign interval_volume(std::span<const Vec3> points, std::span<const FaceCorners> faces) {
  RoundUpward guard;
  return certain_sign(sum_of_determinants<Interval>(points, faces));
}

}  // namespace

Decision enclosed_volume_decision(std::span<const Vec3> points,
                                  std::span<const FaceCorners> faces) {
  if (faces.empty()) return {Sign::zero, Stage::exact};
  if (const MaybeSign sign = triage_volume(points, faces)) return {*sign, Stage::triage};
  if (const MaybeSign sign = interval_volume(points, faces)) return {*sign, Stage::interval};
  return {sign_of(sum_of_determinants<Rational>(points, faces)), Stage::exact};
}

}  // namespace crest::kernel
