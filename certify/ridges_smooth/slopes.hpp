// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Zeros of E_j without derivatives: by the slopes of the principal directions, which is cheaper.
//
// Proof. Let A = ((a, b), (c, -a)), sigma^2 = a^2 + b c, sigma > 0. Its eigenvectors are
//   (sigma + a, c) and (-b, sigma + a),  and also  (b, sigma - a) and (sigma - a, -c),
// where they are not zero: where the number in both has an inverse. Divided by it they are
// (1, s_1), (s_2, 1), or (s_1, 1), (1, s_2); so is v_j, up to a factor without zeros (lemma 5).
#include "certify/ridges_smooth/forms.hpp"

namespace crest::certify::smooth {

template <class M>
struct Slopes {
  M blue, red;
  bool steep;  ///< v_1 = (s_1, 1), v_2 = (1, s_2)
};
/// By sigma - a if `steep`, else by sigma + a.
template <class M, int K>
Slopes<M> slopes(const Shape<Local<M, K>>& shape, bool steep) {
  const Shape<M> a = values(shape);
  const M sigma = square_root(a.a * a.a + a.b * a.c);
  if (!steep) {
    const M factor = reciprocal(sigma + a.a);
    return {a.c * factor, -(a.b * factor), false};
  }
  const M factor = reciprocal(sigma - a.a);
  return {a.b * factor, -(a.c * factor), true};
}

/// E_j up to a factor without zeros.
template <class M, int K>
M extremality(const Forms<M, K>& f, const Slopes<M>& slopes, std::size_t j) {
  const M& s = j == 0 ? slopes.blue : slopes.red;
  const bool reversed = slopes.steep == (j == 0);
  const auto at = [&](const auto& form, std::size_t k) -> const M& {
    return form[reversed ? form.size() - 1 - k : k].value();
  };
  const M ivv = at(f.i, 0) + s * (at(f.i, 1) * 2.0 + s * at(f.i, 2));
  const M lvv = at(f.l, 0) + s * (at(f.l, 1) * 2.0 + s * at(f.l, 2));
  const M tvvv = at(f.t, 0) + s * (at(f.t, 1) * 3.0 + s * (at(f.t, 2) * 3.0 + s * at(f.t, 3)));
  const M c = f.graph ? (at(f.h, 0) + s * at(f.h, 1)) * lvv * f.sign
                      : at(f.c, 0) + s * (at(f.c, 1) + s * (at(f.c, 2) + s * at(f.c, 3)));
  return ivv * tvvv - lvv * c * 3.0;
}

}  // namespace crest::certify::smooth
