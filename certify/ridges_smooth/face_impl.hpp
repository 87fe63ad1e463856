// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// FaceProver's statements, for the translation units that instantiate it.
#include <algorithm>

#include "certify/ridges_smooth/face_signs.hpp"
#include "certify/ridges_smooth/slopes.hpp"

namespace crest::certify::smooth {

template <class M>
template <int K>
bool FaceProver<M>::prove_type(std::size_t j, const SmoothFaceRecord& record,
                               const Extremality<K>& e, bool by_turn) {
  if (by_turn) {
    if constexpr (K == 2) return has_no_zero(e.turn());
    return false;
  }
  // Lemma 5: elliptic where G1 < 0, where G2 > 0. Turning points are shown by turn only.
  const auto stated =
      (record.type[j] == 1) == (j == 0) ? kernel::Sign::negative : kernel::Sign::positive;
  return record.type[j] != 3 && certain(e.growth()) == stated;
}

template <class M>
template <int K>
bool FaceProver<M>::prove_purple(const Local<M, K>& x, const Local<M, K>& y, Method& method,
                                 Advisor* advisor) {
  if (method.cross) return has_no_zero(x.d(1, 0) * y.d(0, 1) - x.d(0, 1) * y.d(1, 0));
  std::vector<std::array<double, 2>> tried = {method.combination};
  const auto ranges = [](const auto& f) {
    return std::array{f.value().range(), f.d(1, 0).range(), f.d(0, 1).range()};
  };
  if (advisor != nullptr) tried = advisor->combinations({ranges(x), ranges(y)});
  for (const auto& [a, b] : tried) {
    if (!has_no_zero(x.value() * a + y.value() * b)) continue;
    if (advisor != nullptr) method.combination = {a, b};
    return true;
  }
  return false;
}

template <class M>
template <int K>
unsigned FaceProver<M>::prove_colour(std::size_t j, const SmoothFaceRecord& record,
                                     const Extremality<K>& e, unsigned open, const Method& method) {
  const auto c = direction(record.verdict[j]);
  unsigned proven = 0;
  if ((open & kVerdict << j) != 0 && has_no_zero(e.slope(c[0], c[1]))) proven |= kVerdict << j;
  if ((open & kType << j) != 0 && prove_type<K>(j, record, e, method.turn[j])) proven |= kType << j;
  return proven;
}

template <class M>
template <int K>
unsigned FaceProver<M>::prove_order(const Place& at, std::uint32_t face, unsigned open,
                                    Method& method, FaceFindings* findings, Advisor* advisor) {
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
      if (!slope && advisor != nullptr) method.steep = advisor->steep(a.a.value().range());
      if (!slope) slope = slopes(a, method.steep);
      if (has_no_zero(extremality(jets->forms, *slope, j))) proven |= kVerdict << j;
    } else if constexpr (K > 0) {
      if (j == 0 || !e[0]) v1 = principal(a, w);
      const auto v = j == 0 ? v1 : turned(jets->forms.i, v1);
      e[j] = Extremality<K>{extremality(jets->forms, v), v};
      proven |= prove_colour<K>(j, record, *e[j], open, method);
      if (findings != nullptr) find_signs<K>(j, *e[j], jets->edge, *findings);
    }
  }
  if constexpr (K > 0)
    if ((open & kPurple) != 0 && e[0] && e[1] && prove_purple<K>(e[0]->e, e[1]->e, method, advisor))
      proven |= kPurple;
  return open & ~proven;
}

template <class M>
void FaceProver<M>::prove_chart(const Place& at, std::uint32_t face, unsigned& open,
                                FaceFindings* findings) const {
  if (findings != nullptr && surface_.surface().implicit)
    findings->box = {at.x[0].range(), at.x[1].range(), at.x[2].range()};
  if (!surface_.surface().implicit || ((open & kChart) != 0 && keeps_orientation(at, face)))
    open &= ~static_cast<unsigned>(kChart);
}

template <class M>
template <int K>
std::optional<unsigned> FaceProver<M>::prove_prepared(std::uint32_t face, unsigned open,
                                                      Method& method, FaceFindings* findings,
                                                      Advisor* advisor) {
  const auto& all = std::get<K>(prepared_);
  const auto known =
      std::find_if(all.begin(), all.end(), [&](const auto& w) { return w.face == face; });
  // Who makes witnesses may try longer fibres where there is no foot.
  if (known == all.end() || !known->placed) return std::nullopt;
  const WholeFace<K>& w = *known;
  const SmoothFaceRecord& record = c_.face_records[face];
  if (advisor != nullptr)
    method.steep = w.steep;
  else if (method.steep != w.steep)
    return std::nullopt;
  Place at;
  at.x = w.x, at.m = w.m, at.s = w.s;
  prove_chart(at, face, open, findings);
  if (!w.regular) return open;
  open &= ~static_cast<unsigned>(kRegular);
  for (std::size_t j = 0; j < 2; ++j)
    if (w.no_zero[j] && record.verdict[j] == SmoothFaceRecord::kNoZero)
      open &= ~static_cast<unsigned>(kVerdict << j);
  if constexpr (K > 0) {
    std::array<Vector2, 3> edge;
    if (findings != nullptr) edge = edges(at, face, w.gradient);
    bool both = true;
    for (std::size_t j = 0; j < 2; ++j) {
      if (record.verdict[j] == SmoothFaceRecord::kNoZero) {
        both = false;
        continue;
      }
      open &= ~prove_colour<K>(j, record, w.e[j], open, method);
      if (findings != nullptr) find_signs<K>(j, w.e[j], edge, *findings);
    }
    if ((open & kPurple) != 0 && both && prove_purple<K>(w.e[0].e, w.e[1].e, method, advisor))
      open &= ~static_cast<unsigned>(kPurple);
  }
  return open;
}

template <class M>
unsigned FaceProver<M>::prove(std::uint32_t face, const Piece& piece, unsigned open, Method& method,
                              FaceFindings* findings, Advisor* advisor) {
  const SmoothFaceRecord& record = c_.face_records[face];
  if (piece.whole && !record.in_patch && !method.turn[0] && !method.turn[1]) {
    if (const auto left = prove_prepared<0>(face, open, method, findings, advisor)) return *left;
    if (const auto left = prove_prepared<1>(face, open, method, findings, advisor)) return *left;
  }
  const auto at = place(face, piece);
  if (!at) return open;
  prove_chart(*at, face, open, findings);
  const unsigned others = open & (kChart | kInside), forms = open & ~others;
  if (forms == 0 && (findings == nullptr || record.in_patch)) return others;
  int order = 0;
  for (std::size_t j = 0; j < 2; ++j) {
    const unsigned asked = forms & ((kVerdict | kType) << j | kPurple);
    if (record.verdict[j] == SmoothFaceRecord::kNoZero || (asked == 0 && findings == nullptr))
      continue;
    order = std::max(order, (forms & kType << j) != 0 && method.turn[j] ? 2 : 1);
  }
  if (order == 0) return others | prove_order<0>(*at, face, forms, method, findings, advisor);
  if (order == 1) return others | prove_order<1>(*at, face, forms, method, findings, advisor);
  return others | prove_order<2>(*at, face, forms, method, findings, advisor);
}

}  // namespace crest::certify::smooth
