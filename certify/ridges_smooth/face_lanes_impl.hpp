// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// FaceLanes for the translation units that instantiate it.
#include <algorithm>
#include <bit>

#include "certify/ridges_smooth/face_lanes.hpp"
#include "certify/ridges_smooth/immersion.hpp"
#include "certify/ridges_smooth/implicit_impl.hpp"
#include "certify/ridges_smooth/slopes.hpp"
#include "certify/ridges_smooth/substitution.hpp"

namespace crest::certify::smooth {

inline bool has(kernel::LaneMask mask, std::size_t l) {
  return (mask >> l & 1) != 0;
}
inline kernel::LaneMask positive(const kernel::LaneRanges& r) {
  kernel::LaneMask mask = 0;
  for (std::size_t l = 0; l < kernel::Lanes::count; ++l)
    mask |= kernel::LaneMask{kernel::certain_sign(r[l]) == kernel::Sign::positive} << l;
  return mask;
}
/// The lanes that are not live become copies of one that is. Requires: there is one.
template <class... T>
void revive(kernel::LaneMask live, T&... values) {
  const auto from = static_cast<std::size_t>(std::countr_zero(live));
  for (std::size_t l = 0; l < kernel::Lanes::count; ++l)
    if (!has(live, l)) (copy_lane(values, from, l), ...);
}
/// b where the mask is set, else a.
template <int Order>
kernel::TaylorLanes<Order> choose(kernel::LaneMask mask, const kernel::TaylorLanes<Order>& a,
                                  const kernel::TaylorLanes<Order>& b) {
  kernel::TaylorLanes<Order> r = a;
  for (std::size_t l = 0; mask != 0 && l < kernel::Lanes::count; ++l)
    if (has(mask, l))
      for (std::size_t k = 0; k < r.rows.size(); ++k) r.rows[k].x[l] = b.rows[k].x[l];
  return r;
}
template <int Order>
std::array<kernel::TaylorModel<Order>, 3> lane_of(
    const std::array<kernel::TaylorLanes<Order>, 3>& v, std::size_t l) {
  return {v[0].lane(l), v[1].lane(l), v[2].lane(l)};
}
template <int Order, int K>
Local<kernel::TaylorModel<Order>, K> lane_of(const Local<kernel::TaylorLanes<Order>, K>& f,
                                             std::size_t l) {
  using Result = Local<kernel::TaylorModel<Order>, K>;
  typename Result::Coefficients c;
  kernel::for_each_bit(f.coefficients().mask(),
                       [&](std::size_t i) { c.put(i, f.coefficients()[i].lane(l)); });
  return Result(std::move(c));
}

/// Lane l: the frame of record(l).
template <class Record>
std::array<std::array<kernel::Lanes, 3>, 3> frames_of(const Record& record) {
  std::array<std::array<kernel::Lanes, 3>, 3> frames;
  for (std::size_t l = 0; l < kernel::Lanes::count; ++l) {
    const Frame own = frame_of(record(l));
    for (std::size_t k = 0; k < 3; ++k)
      for (std::size_t i = 0; i < 3; ++i) frames[k][i].x[l] = own[k][i];
  }
  return frames;
}

template <int Order, int K>
struct FaceLanes<Order, K>::State {
  using M = kernel::TaylorLanes<Order>;
  using Lanes = kernel::Lanes;
  using Mask = kernel::LaneMask;
  using Vector3 = std::array<M, 3>;
  using u32 = std::uint32_t;

  State(const Surface& surface, const RidgesSmoothCertificate& c) : surface_(surface), c_(c) {}

  u32 face(std::size_t l) const { return faces_[std::min(l, faces_.size() - 1)]; }
  const SmoothFaceRecord& record(std::size_t l) const { return c_.face_records[face(l)]; }
  M affine(std::size_t coordinate) const {
    std::array<Lanes, 3> at;
    for (std::size_t i = 0; i < 3; ++i)
      for (std::size_t l = 0; l < kCount; ++l)
        at[i].x[l] = c_.vertices[c_.faces[face(l)][i]][coordinate];
    return M::linear(at[0], at[1], at[2]);
  }
  /// Kind 0, find_foot() of the lanes; `live` are those with feet. False: something is undefined.
  bool find_feet(Vector3& x, Vector3& m, M& s, Mask& live) {
    Vector3 p;
    Lanes h;
    for (std::size_t k = 0; k < 3; ++k) p[k] = affine(k), m[k] = affine(k + 3);
    for (std::size_t l = 0; l < kCount; ++l) h.x[l] = fibre_length(c_, face(l));
    const auto nearby = surface_.template implicit<1>(along(p, M::around(0, h), m));
    if (!is_defined(nearby)) return false;
    M slope = dot(gradient(nearby), m);
    live = positive(slope.range());
    if (live == 0) return true;
    revive(live, slope);
    const M factor = inverse(slope), at_p = surface_.value(p);
    M t = -(at_p * factor);
    t.radius() = 0;
    s = t - surface_.value(along(p, t, m)) * factor;
    const kernel::LaneRanges of_t = t.range(), of_s = s.range();
    for (std::size_t l = 0; l < kCount; ++l)
      if (!(std::fmax(magnitude(of_t[l]), magnitude(of_s[l])) < h.x[l])) live &= ~(Mask{1} << l);
    if (live == 0) return true;
    revive(live, s);
    x = along(p, s, m);
    return true;
  }

  std::vector<Values> evaluate(std::span<const std::optional<bool>> steep) {
    std::vector<Values> values(faces_.size());
    for (std::size_t l = 0; l < faces_.size(); ++l) values[l].face = faces_[l];
    Forms<M, K> forms;
    Mask live = kernel::kAllLanes;
    if (!surface_.surface().implicit) {
      const auto x = surface_.template immersion<3 + K>(affine(0), affine(1));
      if (!are_defined(x)) return {};
      forms = surface_forms<K, 3 + K, M>(x);
      for (Values& v : values) v.placed = true;
    } else {
      Vector3 x, m;
      M s;
      if (!find_feet(x, m, s, live)) return {};
      for (std::size_t l = 0; l < faces_.size(); ++l) {
        if (!has(live, l)) continue;
        values[l].placed = true;
        values[l].x = lane_of(x, l);
        values[l].m = lane_of(m, l);
        values[l].s = s.lane(l);
      }
      if (live == 0) return values;
      revive(live, x[0], x[1], x[2]);
      auto f = in_frame(surface_.template implicit<3 + K>(x),
                        frames_of([&](std::size_t l) -> auto& { return record(l); }));
      if (!is_defined(f)) return {};
      const Vector3 slopes = gradient(f);
      live &= positive(slopes[2].range());
      if (live == 0) return values;
      revive(live, f);
      for (std::size_t l = 0; l < faces_.size(); ++l)
        if (has(live, l)) values[l].gradient = lane_of(slopes, l);
      forms = graph_forms<K, 3 + K>(graph_of<M>(implicit_function<M, 3 + K>(f, 2), 1));
    }
    measure(forms, live, steep, values);
    return values;
  }

  void measure(const Forms<M, K>& forms, Mask live, std::span<const std::optional<bool>> steep,
               std::vector<Values>& values) {
    const auto a = shape(forms);
    std::array<Lanes, 2> w;
    for (std::size_t l = 0; l < kCount; ++l)
      for (std::size_t d = 0; d < 2; ++d) w[d].x[l] = direction(record(l).w)[d];
    live &= positive(s_of(forms.i, a, w).range());
    std::array<Mask, 2> free{};
    for (std::size_t l = 0; l < faces_.size(); ++l) {
      values[l].regular = has(live, l);
      for (std::size_t j = 0; j < 2; ++j)
        if (has(live, l) && record(l).verdict[j] == SmoothFaceRecord::kNoZero)
          free[j] |= Mask{1} << l;
    }
    if ((free[0] | free[1]) != 0) without_zeros(forms, a, free, steep, values);
    if constexpr (K > 0) {
      if ((live & ~free[0]) == 0 && (live & ~free[1]) == 0) return;
      const auto v1 = principal(a, w);
      for (std::size_t j = 0; j < 2; ++j) {
        if ((live & ~free[j]) == 0) continue;
        const auto v = j == 0 ? v1 : turned(forms.i, v1);
        const auto e = extremality(forms, v);
        for (std::size_t l = 0; l < faces_.size(); ++l)
          if (has(live & ~free[j], l))
            values[l].e[j] = {lane_of(e, l), {lane_of(v[0], l), lane_of(v[1], l)}};
      }
    }
  }

  /// slopes() and extremality() of slopes.hpp, each lane by its own choice.
  void without_zeros(const Forms<M, K>& forms, const Shape<Local<M, K>>& shape,
                     const std::array<Mask, 2>& free, std::span<const std::optional<bool>> steep,
                     std::vector<Values>& values) const {
    const Shape<M> a = smooth::values(shape);
    const kernel::LaneRanges a11 = a.a.range();
    Mask by_difference = 0;
    for (std::size_t l = 0; l < faces_.size(); ++l) {
      values[l].steep =
          has(free[0] | free[1], l) && steep[l].value_or(a11.low.x[l] + a11.high.x[l] < 0);
      by_difference |= Mask{values[l].steep} << l;
    }
    const M sigma = square_root(a.a * a.a + a.b * a.c);
    const M factor = reciprocal(choose(by_difference, sigma + a.a, sigma - a.a));
    const M first = choose(by_difference, a.c, a.b) * factor;
    const M second = -(choose(by_difference, a.b, a.c) * factor);
    for (std::size_t j = 0; j < 2; ++j) {
      if (free[j] == 0) continue;
      const M& s = j == 0 ? first : second;
      const Mask reversed = j == 0 ? by_difference : kernel::kAllLanes & ~by_difference;
      const auto at = [&](const auto& form, std::size_t k) {
        return choose(reversed, form[k].value(), form[form.size() - 1 - k].value());
      };
      const M ivv = at(forms.i, 0) + s * (at(forms.i, 1) * 2.0 + s * at(forms.i, 2));
      const M lvv = at(forms.l, 0) + s * (at(forms.l, 1) * 2.0 + s * at(forms.l, 2));
      const M tvvv = at(forms.t, 0) +
                     s * (at(forms.t, 1) * 3.0 + s * (at(forms.t, 2) * 3.0 + s * at(forms.t, 3)));
      const M c =
          forms.graph
              ? (at(forms.h, 0) + s * at(forms.h, 1)) * lvv * forms.sign
              : at(forms.c, 0) + s * (at(forms.c, 1) + s * (at(forms.c, 2) + s * at(forms.c, 3)));
      const kernel::LaneRanges e = (ivv * tvvv - lvv * c * 3.0).range();
      for (std::size_t l = 0; l < faces_.size(); ++l)
        if (has(free[j], l)) values[l].no_zero[j] = nonzero(kernel::certain_sign(e[l]));
    }
  }

  SurfaceEvaluator<M> surface_;
  const RidgesSmoothCertificate& c_;
  std::span<const u32> faces_;
};

template <int Order, int K>
FaceLanes<Order, K>::FaceLanes(const Surface& surface, const RidgesSmoothCertificate& c)
    : state_(std::make_unique<State>(surface, c)) {}
template <int Order, int K>
FaceLanes<Order, K>::~FaceLanes() = default;
template <int Order, int K>
FaceLanes<Order, K>::FaceLanes(FaceLanes&&) noexcept = default;

template <int Order, int K>
auto FaceLanes<Order, K>::evaluate(std::span<const std::uint32_t> faces,
                                   std::span<const std::optional<bool>> steep)
    -> std::vector<Values> {
  state_->faces_ = faces;
  return state_->evaluate(steep);
}

}  // namespace crest::certify::smooth
