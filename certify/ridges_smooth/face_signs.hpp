// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// FaceProver's signs at corners, on edges, segments and points, for the translation units that
// instantiate it.
#include "certify/ridges_smooth/face_place.hpp"

namespace crest::certify::smooth {

template <class M>
template <int K>
M FaceProver<M>::Extremality<K>::growth() const {
  return v[0].value() * e.d(1, 0) + v[1].value() * e.d(0, 1);
}
template <class M>
template <int K>
M FaceProver<M>::Extremality<K>::slope(double x, double y) const {
  return e.d(1, 0) * x + e.d(0, 1) * y;
}
template <class M>
template <int K>
M FaceProver<M>::Extremality<K>::turn() const {
  const auto g =
      v[0].template truncated<1>() * e.slope(0) + v[1].template truncated<1>() * e.slope(1);
  return e.d(1, 0) * g.d(0, 1) - e.d(0, 1) * g.d(1, 0);
}

template <class M>
template <int K>
void FaceProver<M>::find_signs(std::size_t j, const Extremality<K>& e,
                               const std::array<Vector2, 3>& edge, FaceFindings& findings) {
  for (int i = 0; i < 3; ++i) {
    const auto k = static_cast<std::size_t>(i);
    const M value = e.e.value();
    findings.corner[j][k] = kernel::certain_sign(value.at_corner(i));
    if ((findings.ask_value[j] >> i & 1U) != 0)
      findings.value[j][k] = kernel::certain_sign(value.range_on_edge(i));
    if ((findings.ask_slope[j] >> i & 1U) == 0) continue;
    const M along = e.e.d(1, 0) * edge[k][0] + e.e.d(0, 1) * edge[k][1];
    findings.slope[j][k] = kernel::certain_sign(along.range_on_edge(i));
  }
}

template <class M>
template <int K>
kernel::MaybeSign FaceProver<M>::sign_order(const Question& q, const Place& at) {
  const auto jets = this->template jets<K>(at, q.face, q.quantity == Quantity::along_edge);
  if (!jets) return std::nullopt;
  const auto a = shape(jets->forms);
  const auto w = direction(c_.face_records[q.face].w);
  if (!is_positive(s_of(jets->forms.i, a, w))) return std::nullopt;
  auto v = principal(a, w);
  if (q.colour == 1) v = turned(jets->forms.i, v);
  const Extremality<K> e{extremality(jets->forms, v), v};
  if constexpr (K == 0) {
    return certain(e.e.value());
  } else {
    if (q.quantity == Quantity::growth) return certain(e.growth());
    const Vector2& t = jets->edge[q.edge];
    return certain(e.e.d(1, 0) * t[0] + e.e.d(0, 1) * t[1]);
  }
}

template <class M>
kernel::MaybeSign FaceProver<M>::sign(const Question& q, const Piece& piece) {
  const auto at = place(q.face, piece);
  if (!at) return std::nullopt;
  return q.quantity == Quantity::value ? sign_order<0>(q, *at) : sign_order<1>(q, *at);
}

}  // namespace crest::certify::smooth
