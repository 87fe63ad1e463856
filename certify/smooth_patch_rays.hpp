// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// PatchProver's sectors and intervals, for the translation units that instantiate it.
#include "certify/smooth_patch_place.hpp"

namespace crest::certify::smooth {

/// Enclosures on the triangle of rays with |t - t'| in [t0, t1], opened by rho: every z* + r e(t).
template <class M>
auto PatchProver<M>::make_sector(int side, double t0, double t1) -> std::optional<Sector> {
  const Side s = side_of(side);
  const auto corner = [&](double t) {
    return std::array{patch_.centre[0] + radius_ * (s.base[0] + t * s.slope[0]),
                      patch_.centre[1] + radius_ * (s.base[1] + t * s.slope[1])};
  };
  const double error = patch_.rho + slack_;
  const auto f = forms({{patch_.centre, corner(t0), corner(t1)}, error * (1 + 0x1p-50)});
  if (!f) return std::nullopt;
  Sector r;
  const auto fixed = [](const M& x) { return constants<M>(x.range()); };
  const auto a = shape(f->second);
  const std::array entries = {a.a, a.b, a.c};
  for (std::size_t k = 0; k < 3; ++k) {
    r.fan.dda[k] = {fixed(entries[k].d(2, 0)), fixed(entries[k].d(1, 1)),
                    fixed(entries[k].d(0, 2))};
    r.fan.di[k] = {fixed(f->forms.i[k].d(1, 0)), fixed(f->forms.i[k].d(0, 1))};
  }
  const auto q = quintic(f->forms);
  for (std::size_t k = 0; k < 6; ++k) r.fan.dq[k] = {fixed(q[k].d(1, 0)), fixed(q[k].d(0, 1))};
  // w: about the direction d1 of the middle ray at r = 0.
  const double t = t0 / 2 + t1 / 2;
  const std::array e = {s.base[0] + t * s.slope[0], s.base[1] + t * s.slope[1]};
  std::array<double, 3> p{};
  for (std::size_t k = 0; k < 3; ++k) {
    const kernel::Range range = blow_up::times(centre_->da[k], e).range();
    p[k] = range.low / 2 + range.high / 2;
  }
  const double sigma = std::sqrt(std::fmax(p[0] * p[0] + p[1] * p[2], 0));
  const std::array<double, 2> w =
      p[0] > 0 ? std::array{sigma + p[0], p[2]} : std::array{p[1], sigma - p[0]};
  const double size = std::fmax(std::fabs(w[0]), std::fabs(w[1]));
  if (!(size > 0 && size < HUGE_VAL)) return std::nullopt;
  r.w = {w[0] / size, w[1] / size};
  return r;
}

template <class M>
bool PatchProver<M>::divide(int side, double t0, double t1, int depth, std::size_t sector,
                            unsigned open) {
  if (depth <= kSectorDepth)
    if (auto own = make_sector(side, t0, t1)) {
      sector = sectors_.size();
      sectors_.push_back(std::move(*own));
    }
  if (sector < sectors_.size()) {
    // The rectangle [0, R1] x [t0, t1] as two triangles.
    const Sector& s = sectors_[sector];
    const double R = radius_;
    const std::array f = {
        ray_forms(*centre_, s.fan, side, s.w, M::linear(0, R, R), M::linear(t0, t0, t1)),
        ray_forms(*centre_, s.fan, side, s.w, M::linear(0, R, 0), M::linear(t0, t1, t1))};
    const auto both = [&](auto&& quantity) -> int {
      const auto a = certain(quantity(*f[0])), b = certain(quantity(*f[1]));
      return nonzero(a) && a == b ? static_cast<int>(*a) : 0;
    };
    // One colour has no zero, or a combination that is large in the middle has none.
    const auto are_apart = [&](const auto& test) {
      if (test([](const auto& x) { return x.e[0].value(); }) != 0 ||
          test([](const auto& x) { return x.e[1].value(); }) != 0)
        return true;
      std::array<double, 2> factor{};
      for (std::size_t j = 0; j < 2; ++j) {
        const kernel::Range x = f[0]->e[j].value().range();
        factor[j] = (x.low + x.high) / ((x.high - x.low) * (x.high - x.low));
      }
      return test([&](const auto& x) {
               return x.e[0].value() * factor[0] + x.e[1].value() * factor[1];
             }) != 0;
    };
    for (std::size_t j = 0; j < 2 && f[0] && f[1]; ++j) {
      if ((open >> j & 1U) == 0) continue;
      int sign = both([&](const auto& x) { return x.e[j].value(); });
      const bool branch = sign == 0;
      if (branch && are_apart(both) && both([&](const auto& x) { return x.growth[j]; }) != 0)
        sign = both([&](const auto& x) { return x.e[j].d(0, 1); });
      if (sign == 0) continue;
      leaves_[j].push_back({side, t0, t1, sector, branch, sign});
      open &= ~(1U << j);
    }
  }
  if (open == 0) return true;
  if (depth == kDepth) return false;
  const double t = t0 / 2 + t1 / 2;
  return divide(side, t0, t, depth + 1, sector, open) &&
         divide(side, t, t1, depth + 1, sector, open);
}

}  // namespace crest::certify::smooth
