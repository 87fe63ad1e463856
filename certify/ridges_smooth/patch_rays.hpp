// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// PatchProver's sectors and intervals, for the translation units that instantiate it.
#include "certify/ridges_smooth/patch_place.hpp"

namespace crest::certify::smooth {

/// Enclosures on the triangle of rays with t in [t0, t1], opened by rho: every z* + r e(t); and a
/// direction w about d1 on the middle ray at r = 0.
template <class M>
auto PatchProver<M>::make_sector(int side, double t0, double t1) -> std::optional<Sector> {
  const Side s = side_of(side);
  const auto corner = [&](double t) {
    return std::array{patch_.centre[0] + radius_ * (s.base[0] + t * s.slope[0]),
                      patch_.centre[1] + radius_ * (s.base[1] + t * s.slope[1])};
  };
  const auto f =
      forms({{patch_.centre, corner(t0), corner(t1)}, (patch_.rho + slack_) * (1 + 0x1p-50)});
  if (!f) return std::nullopt;
  Sector r;
  const auto fixed = [](const M& x) { return constants<M>(x.range()); };
  const auto second = [&](const auto& x) {
    return std::array{fixed(x.d(2, 0)), fixed(x.d(1, 1)), fixed(x.d(0, 2))};
  };
  const auto a = shape(f->second);
  const std::array entries = {a.a, a.b, a.c};
  for (std::size_t k = 0; k < 3; ++k) {
    for (int i = 0; i < 4; ++i)
      r.fan.ddda[k][static_cast<std::size_t>(i)] = fixed(entries[k].d(3 - i, i));
    r.fan.ddi[k] = second(f->forms.i[k]);
  }
  const auto q = quintic(f->forms);
  for (std::size_t k = 0; k < 6; ++k) r.fan.ddq[k] = second(q[k]);
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

/// The one sign of a quantity on both halves of a rectangle, or 0.
template <class M, class Quantity>
int common_sign(const std::array<std::optional<RayForms<M>>, 2>& f, Quantity&& quantity) {
  const auto a = certain(quantity(*f[0])), b = certain(quantity(*f[1]));
  return nonzero(a) && a == b ? static_cast<int>(*a) : 0;
}

template <class M>
bool PatchProver<M>::divide(int side, double t0, double t1, int depth, std::size_t sector,
                            unsigned open) {
  if (depth <= kSectorDepth && (depth - kFirstDepth) % kSectorStep == 0)
    if (auto own = make_sector(side, t0, t1)) {
      sector = sectors_.size();
      sectors_.push_back(std::move(*own));
    }
  std::array<std::optional<RayForms<M>>, 2> f;
  if (sector < sectors_.size()) {
    // The rectangle [0, R1] x [t0, t1] as two triangles of (r, t).
    const Sector& s = sectors_[sector];
    const double R = radius_;
    f[0] = ray_forms(*centre_, s.fan, side, s.w, M::linear(0, R, R), M::linear(t0, t0, t1));
    f[1] = ray_forms(*centre_, s.fan, side, s.w, M::linear(0, R, 0), M::linear(t0, t1, t1));
  }
  for (std::size_t j = 0; j < 2 && f[0] && f[1]; ++j) {
    if ((open >> j & 1U) == 0) continue;
    int sign = common_sign(f, [&](const auto& x) { return x.e[j].value(); });
    const bool branch = sign == 0;
    const auto apart = [](const auto& x) {
      return has_no_common_zero(std::array{x->e[0].value(), x->e[1].value()});
    };
    if (branch && apart(f[0]) && apart(f[1]) &&
        common_sign(f, [&](const auto& x) { return x.growth[j]; }) != 0)
      sign = common_sign(f, [&](const auto& x) { return x.e[j].d(0, 1); });
    if (sign == 0) continue;
    leaves_[j].push_back({side, t0, t1, sector, branch, sign});
    open &= ~(1U << j);
  }
  if (open == 0) return true;
  if (depth == kDepth) return false;
  const double t = t0 / 2 + t1 / 2;
  return divide(side, t0, t, depth + 1, sector, open) &&
         divide(side, t, t1, depth + 1, sector, open);
}

}  // namespace crest::certify::smooth
