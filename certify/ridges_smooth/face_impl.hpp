// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// FaceProver's statements, for the translation units that instantiate it.
#include "certify/ridges_smooth/face_signs.hpp"
#include "certify/ridges_smooth/slopes.hpp"

namespace crest::certify::smooth {

/// A colour whose verdict is a direction: verdict and type.
template <class M>
template <int K>
unsigned FaceProver<M>::prove_colour(std::size_t j, const SmoothFaceRecord& record,
                                     const Extremality<K>& e, unsigned open, unsigned& ends) {
  const auto c = direction(record.verdict[j]);
  unsigned proven = 0;
  if ((open & kVerdict << j) != 0 && has_no_zero(e.slope(c[0], c[1]))) proven |= kVerdict << j;
  if ((open & kType << j) == 0) return proven;
  // Lemma 5: elliptic where G1 < 0, where G2 > 0.
  const auto stated =
      (record.type[j] == 1) == (j == 0) ? kernel::Sign::negative : kernel::Sign::positive;
  if (record.type[j] != 3 && certain(e.growth()) == stated) return proven | kType << j;
  if constexpr (K == 2)
    if (has_no_zero(e.turn())) {
      ends |= kType << j;
      proven |= kType << j;
    }
  return proven;
}

/// A combination nearly without slope has no zero: arcs nearly parallel stay apart.
template <class M, class E>
bool are_parallel(const E& a, const E& b) {
  const auto middle = [](const M& x) {
    const kernel::Range r = x.range();
    return r.low / 2 + r.high / 2;
  };
  const double a1 = middle(a.d(1, 0)), a2 = middle(a.d(0, 1));
  const double b1 = middle(b.d(1, 0)), b2 = middle(b.d(0, 1));
  const double of_a = std::sqrt(a1 * a1 + a2 * a2), of_b = std::sqrt(b1 * b1 + b2 * b2);
  const double sign = a1 * b1 + a2 * b2 > 0 ? -1 : 1;
  return has_no_zero(a.value() * of_b + b.value() * (sign * of_a));
}

template <class M>
template <int K>
unsigned FaceProver<M>::prove_order(const Place& at, std::uint32_t face, unsigned open,
                                    FaceFindings* findings, unsigned& ends) {
  const SmoothFaceRecord& record = c_.face_records[face];
  const auto jets = this->template jets<K>(at, face, K > 0 && findings != nullptr);
  if (!jets) return open;
  const auto a = shape(jets->forms);
  const auto w = direction(record.w);
  if (!is_positive(s_of(jets->forms.i, a, w))) return open;
  unsigned proven = kRegular;
  if ((open & ~proven) == 0 && findings == nullptr) return 0;
  std::optional<Slopes<M>> slope;
  Pair<Local<M, K>> v1;
  std::array<std::optional<Extremality<K>>, 2> e;
  for (std::size_t j = 0; j < 2; ++j) {
    if (record.verdict[j] == SmoothFaceRecord::kNoZero) {
      if ((open & kVerdict << j) == 0) continue;
      if (!slope) slope = slopes(a);
      if (has_no_zero(extremality(jets->forms, *slope, j))) proven |= kVerdict << j;
    } else if constexpr (K > 0) {
      if (j == 0 || !e[0]) v1 = principal(a, w);
      const auto v = j == 0 ? v1 : turned(jets->forms.i, v1);
      e[j] = Extremality<K>{extremality(jets->forms, v), v};
      proven |= prove_colour<K>(j, record, *e[j], open, ends);
      if (findings != nullptr) find_signs<K>(j, *e[j], *jets, *findings);
    }
  }
  if constexpr (K > 0)
    if ((open & (kApart | kCross)) != 0 && e[0] && e[1]) {
      const auto &x = e[0]->e, &y = e[1]->e;
      if (has_no_common_zero(std::array{x.value(), y.value()}) || are_parallel<M>(x, y))
        proven |= kApart;
      if (has_no_zero(x.d(1, 0) * y.d(0, 1) - x.d(0, 1) * y.d(1, 0))) proven |= kCross;
    }
  return open & ~proven;
}

template <class M>
unsigned FaceProver<M>::prove(std::uint32_t face, const Piece& piece, unsigned open,
                              FaceFindings* findings, unsigned& ends) {
  const auto at = place(face, piece);
  if (!at) return open;
  if (findings != nullptr && surface_.surface().implicit)
    findings->box = {at->x[0].range(), at->x[1].range(), at->x[2].range()};
  if (!surface_.surface().implicit || ((open & kChart) != 0 && keeps_orientation(*at, face)))
    open &= ~static_cast<unsigned>(kChart);
  const unsigned chart = open & kChart;
  unsigned forms = open & ~static_cast<unsigned>(kChart);
  if (forms == 0) return chart;
  const SmoothFaceRecord& record = c_.face_records[face];
  int order = 0;
  for (std::size_t j = 0; j < 2; ++j) {
    const unsigned asked = forms & ((kVerdict | kType) << j | kApart | kCross);
    if (record.verdict[j] == SmoothFaceRecord::kNoZero || (asked == 0 && findings == nullptr))
      continue;
    order = std::max(order, (forms & kType << j) != 0 && record.type[j] == 3 ? 2 : 1);
  }
  forms = order == 0   ? prove_order<0>(*at, face, forms, findings, ends)
          : order == 1 ? prove_order<1>(*at, face, forms, findings, ends)
                       : prove_order<2>(*at, face, forms, findings, ends);
  // A sign of G_j that is not certain leaves the determinant.
  const unsigned types = forms & (kType | kType << 1);
  if (order == 1 && types != 0 && (forms & kRegular) == 0)
    forms = (forms & ~types) | prove_order<2>(*at, face, types, nullptr, ends);
  return chart | forms;
}

}  // namespace crest::certify::smooth
