// SPDX-License-Identifier: GPL-3.0-or-later
#include "kernel/predicates/cone_test.hpp"

#include <cmath>

#include "kernel/predicates/stages.hpp"

namespace crest::kernel {

CREST_INSTANTIATE_STAGES(ConeTrace)
CREST_INSTANTIATE_STAGES(ConeMinor)

MaybeSign interval_cone_test(const Symmetric3<double>& t, const Vec3& w) {
  return cone_sign(interval_stage(ConeTrace{t, w}), interval_stage(ConeMinor{t, w}));
}

Sign exact_cone_test(const Symmetric3<double>& t, const Vec3& w) {
  return *cone_sign(exact_stage(ConeTrace{t, w}), exact_stage(ConeMinor{t, w}));
}

Decision cone_test(const Symmetric3<double>& t, const Vec3& w) {
  if (const MaybeSign s = triage_cone_test(t, w)) return {*s, Stage::triage};
  if (const MaybeSign s = interval_cone_test(t, w)) return {*s, Stage::interval};
  return {exact_cone_test(t, w), Stage::exact};
}

std::array<Vec3, 2> frame_across(const Vec3& w) {
  // The axis along which w is shortest.
  const double x = std::fabs(w[0]), y = std::fabs(w[1]), z = std::fabs(w[2]);
  Vec3 u = x <= y && x <= z ? Vec3{0, w[2], -w[1]}
           : y <= z         ? Vec3{-w[2], 0, w[0]}
                            : Vec3{w[1], -w[0], 0};
  u = (1 / norm(u)) * u;
  return {u, cross(w, u)};
}

double cone_margin(const Symmetric3<double>& t, double size, double error, const Vec3& w) {
  const auto [u, v] = frame_across(w);
  const Vec3 tu = product(t, u), tv = product(t, v);
  const double a = dot(u, tu), b = dot(u, tv), c = dot(v, tv);
  const double mu = 0.5 * (a + c) + std::sqrt(0.25 * (a - c) * (a - c) + b * b);
  return dot(w, product(t, w)) - mu - (32 * error + 0x1p-43 * size);
}

}  // namespace crest::kernel
