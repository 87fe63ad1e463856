// SPDX-License-Identifier: GPL-3.0-or-later
#include "kernel/predicates/dihedral_angle.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <stdexcept>
#include <utility>

#include "kernel/arithmetic/mp_interval.hpp"
#include "kernel/predicates/stages.hpp"

namespace crest::kernel {

CREST_INSTANTIATE_STAGES(NormalProduct)
CREST_INSTANTIATE_STAGES(SquaredCosineGap)

namespace {

constexpr std::size_t kLongest = 100;

/// Requires: a decimal.
Rational rational_of(std::string text) {
  const std::size_t point = std::min(text.find('.'), text.size());
  const std::size_t decimals = point == text.size() ? 0 : text.size() - point - 1;
  if (point < text.size()) text.erase(point, 1);
  // A leading zero would make it octal.
  const std::size_t first = text.find_first_not_of('0');
  if (first == text.npos) return 0;
  std::string unit(decimals + 1, '0');
  unit[0] = '1';
  return Rational(text.substr(first)) / Rational(unit);
}

void require_decimal(const std::string& text) {
  const auto digit = [](char c) { return c >= '0' && c <= '9'; };
  const auto points = std::count(text.begin(), text.end(), '.');
  const auto digits = std::count_if(text.begin(), text.end(), digit);
  if (points > 1 || digits == 0 || points + digits != static_cast<std::ptrdiff_t>(text.size()))
    throw std::invalid_argument("is no decimal number of degrees; write it like 60 or 22.5");
  if (text.size() > kLongest) throw std::invalid_argument("has more than 100 characters");
}

/// Requires: degrees is none of the nine angles with a rational squared cosine.
MpInterval squared_cosine(const Rational& degrees, mpfr_prec_t bits) {
  const MpInterval c = cos(MpInterval::pi(bits) * MpInterval::from(degrees / Rational(180), bits));
  return c * c;
}

/// The sign of cos^2 A - cos^2 of the edge's angle, where they differ.
Sign narrowing_gap(const DihedralEdge& e, const DecimalAngle& angle) {
  const Vector3<Rational> left = e.left_normal<Rational>(), right = e.right_normal<Rational>();
  const Rational s = dot(left, right);
  const Rational edge = s * s / (dot(left, left) * dot(right, right));
  const Rational degrees = rational_of(angle.text());
  for (mpfr_prec_t bits = 128;; bits *= 2) {
    const MpInterval gap = squared_cosine(degrees, bits) - MpInterval::from(edge, bits);
    if (const MaybeSign sign = certain_sign(gap)) return *sign;
  }
}

/// The edge's angle against A, given the signs of its cosine and of cos^2 A - its square.
Sign against(Sign cosine, Sign gap) {
  return cosine == Sign::positive ? gap : -gap;
}

/// The same without the squares: the cosines' signs differ, or both are zero.
MaybeSign by_cosines(Sign edge, Sign angle) {
  if (edge != angle) return edge < angle ? Sign::positive : Sign::negative;
  return edge == Sign::zero ? MaybeSign(Sign::zero) : std::nullopt;
}

/// The sign of cos^2 A - cos^2 of the edge's angle from the same with the doubles around cos^2 A.
template <class Stage>
MaybeSign gap_between(const DihedralEdge& e, const DecimalAngle& angle, Stage&& stage) {
  const MaybeSign low = stage(SquaredCosineGap{e, angle.low()});
  if (angle.low() == angle.high()) return low;
  if (low && *low != Sign::negative) return Sign::positive;
  const MaybeSign high = stage(SquaredCosineGap{e, angle.high()});
  if (high && *high != Sign::positive) return Sign::negative;
  return std::nullopt;
}

template <class Stage>
MaybeSign by_stage(const DihedralEdge& e, const DecimalAngle& angle, Stage&& stage) {
  const MaybeSign cosine = stage(NormalProduct{e});
  if (!cosine) return std::nullopt;
  if (const MaybeSign s = by_cosines(*cosine, angle.cosine())) return s;
  const MaybeSign gap = gap_between(e, angle, stage);
  return gap ? MaybeSign(against(*cosine, *gap)) : std::nullopt;
}

}  // namespace

DecimalAngle::DecimalAngle(std::string text) : text_(std::move(text)) {
  require_decimal(text_);
  const Rational degrees = rational_of(text_);
  if (degrees > 180) throw std::invalid_argument("is more than 180 degrees");
  std::from_chars(text_.data(), text_.data() + text_.size(), degrees_);
  cosine_ = sign_of(Rational(90) - degrees);
  constexpr std::array<std::pair<int, double>, 9> squares = {{{0, 1},
                                                              {30, 0.75},
                                                              {45, 0.5},
                                                              {60, 0.25},
                                                              {90, 0},
                                                              {120, 0.25},
                                                              {135, 0.5},
                                                              {150, 0.75},
                                                              {180, 1}}};
  for (const auto& [special, square] : squares) {
    if (degrees != special) continue;
    low_ = high_ = square;
    return;
  }
  const MpInterval square = squared_cosine(degrees, 256);
  low_ = std::max(0.0, square.lower());
  high_ = std::min(1.0, square.upper());
}

MaybeSign triage_dihedral_angle(const DihedralEdge& e, const DecimalAngle& angle) {
  return by_stage(e, angle, [](const auto& formula) { return triage(formula); });
}
MaybeSign interval_dihedral_angle(const DihedralEdge& e, const DecimalAngle& angle) {
  return by_stage(e, angle, [](const auto& formula) { return interval_stage(formula); });
}
Sign exact_dihedral_angle(const DihedralEdge& e, const DecimalAngle& angle) {
  const auto exact = [](const auto& formula) { return MaybeSign(exact_stage(formula)); };
  if (const MaybeSign s = by_stage(e, angle, exact)) return *s;
  return against(exact_stage(NormalProduct{e}), narrowing_gap(e, angle));
}

Decision dihedral_angle(const DihedralEdge& e, const DecimalAngle& angle) {
  if (const MaybeSign s = triage_dihedral_angle(e, angle)) return {*s, Stage::triage};
  if (const MaybeSign s = interval_dihedral_angle(e, angle)) return {*s, Stage::interval};
  return {exact_dihedral_angle(e, angle), Stage::exact};
}

}  // namespace crest::kernel
