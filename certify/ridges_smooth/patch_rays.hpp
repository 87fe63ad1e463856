// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// PatchProver's sectors and intervals, for the translation units that instantiate it.
#include "certify/ridges_smooth/patch_place.hpp"

namespace crest::certify::smooth {

template <class M>
std::array<kernel::Range, 3> PatchProver<M>::shape_along(const RayInterval& t) const {
  const Side s = side_of(t.side);
  const std::array e = {s.base[0] + t.middle() * s.slope[0], s.base[1] + t.middle() * s.slope[1]};
  std::array<kernel::Range, 3> p{};
  for (std::size_t k = 0; k < 3; ++k) p[k] = blow_up::times(centre_->da[k], e).range();
  return p;
}

/// Enclosures on the triangle of rays with t in [t0, t1], opened by rho: every z* + r e(t).
template <class M>
bool PatchProver<M>::add_sector(const RayInterval& t, unsigned w) {
  const Side s = side_of(t.side);
  const auto corner = [&](double x) {
    return std::array{patch_.centre[0] + radius_ * (s.base[0] + x * s.slope[0]),
                      patch_.centre[1] + radius_ * (s.base[1] + x * s.slope[1])};
  };
  const auto f =
      forms({{patch_.centre, corner(t.t0), corner(t.t1)}, (patch_.rho + slack_) * (1 + 0x1p-50)});
  if (!f) return false;
  Sector r;
  r.w = direction(static_cast<int>(w));
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
  sector_ = sectors_.size();
  sectors_.push_back(std::move(r));
  return true;
}

/// The rectangle [0, R1] x [t0, t1] as two triangles of (r, t).
template <class M>
auto PatchProver<M>::interval(const RayInterval& t) const -> std::optional<Forms2> {
  if (sector_ == kNoSector) return std::nullopt;
  const Sector& s = sectors_[sector_];
  const double R = radius_;
  const auto below =
      ray_forms(*centre_, s.fan, t.side, s.w, M::linear(0, R, R), M::linear(t.t0, t.t0, t.t1));
  if (!below) return std::nullopt;
  const auto above =
      ray_forms(*centre_, s.fan, t.side, s.w, M::linear(0, R, 0), M::linear(t.t0, t.t1, t.t1));
  if (!above) return std::nullopt;
  return Forms2{*below, *above};
}

/// The one sign of a quantity on both triangles, or 0.
template <class M, class Quantity>
int common_sign(const std::array<RayForms<M>, 2>& f, Quantity&& quantity) {
  const auto a = certain(quantity(f[0])), b = certain(quantity(f[1]));
  return nonzero(a) && a == b ? static_cast<int>(*a) : 0;
}

template <class M>
int PatchProver<M>::free_sign(const Forms2& f, std::size_t j) {
  return common_sign(f, [&](const auto& x) { return x.e[j].value(); });
}
template <class M>
int PatchProver<M>::running_sign(const Forms2& f, std::size_t j,
                                 const std::array<double, 2>& combination) {
  const auto apart = [&](const auto& x) {
    return x.e[0].value() * combination[0] + x.e[1].value() * combination[1];
  };
  if (common_sign(f, apart) == 0) return 0;
  if (common_sign(f, [&](const auto& x) { return x.growth[j]; }) == 0) return 0;
  return common_sign(f, [&](const auto& x) { return x.e[j].d(0, 1); });
}

template <class M>
bool PatchProver<M>::say(const RayInterval& t, const std::optional<Forms2>& f, std::size_t j,
                         RayCode code, const std::array<double, 2>& combination, int further) {
  const int sign = !f ? 0 : code == kFree ? free_sign(*f, j) : running_sign(*f, j, combination);
  if (sign == 0) {
    if (further == 0) return false;
    for (const bool second : {false, true}) {
      const RayInterval half = t.half(second);
      if (!say(half, interval(half), j, code, combination, further - 1)) return false;
    }
    return true;
  }
  leaves_[j].push_back({t, sector_, code == kRunning, sign});
  return true;
}

template <class M>
void PatchProver<M>::divide(const RayInterval& t, int depth, unsigned open, WitnessReader& in) {
  const unsigned node = in.byte();
  const std::array<unsigned, 2> code = {node >> 1 & 3U, node >> 3 & 3U};
  in.check(node < 32, "says what no interval has");
  const std::size_t above = sector_;
  if ((node & 1U) != 0) {
    const unsigned w = in.byte();
    in.check(w < 128, "names no direction");
    if (!add_sector(t, w)) in.fail("the surface on a sector");
  }
  std::array<double, 2> combination{};
  if (code[0] == kRunning || code[1] == kRunning)
    for (double& x : combination) x = in.f32();
  const bool said =
      code[0] == kFree || code[0] == kRunning || code[1] == kFree || code[1] == kRunning;
  const auto f = said ? interval(t) : std::nullopt;
  for (std::size_t j = 0; j < 2; ++j) {
    in.check(((open >> j & 1U) == 0) == (code[j] == kSaidAbove), "says a thing twice, or never");
    if (code[j] == kOpen || code[j] == kSaidAbove) continue;
    constexpr int kFurther = MpModel<M> ? 4 : 0;
    if (!say(t, f, j, static_cast<RayCode>(code[j]), combination, kFurther))
      in.fail(j == 0 ? "blue branches" : "red branches");
    open &= ~(1U << j);
  }
  if (open != 0) {
    in.check(depth < kDepth, "divides too often");
    for (const bool second : {false, true}) divide(t.half(second), depth + 1, open, in);
  }
  sector_ = above;
}

}  // namespace crest::certify::smooth
