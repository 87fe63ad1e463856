// SPDX-License-Identifier: GPL-3.0-or-later
#include "certify/spline_rays/zeros.hpp"

namespace crest::certify::spline_rays {

using kernel::Interval;
using kernel::Rational;
using kernel::Sign;

Scene::Scene(const SplineVolume& v)
    : volume(v),
      spline(v),
      one_sided(spline.one_sided()),
      exact(exact_frame(v)),
      fine(fine_frame(exact)) {
  const kernel::RoundUpward guard;
  near = frame_enclosure(v);
  for (unsigned signs = 0; signs < 64; ++signs)
    tetrahedra[signs] = static_cast<std::uint8_t>(tetrahedron_by_signs(signs));
}

const char* Zeros::objection(const Segment& segment, const SplineHit& hit) {
  constexpr const char* kEarlier = "has a zero before its hit, or in another tetrahedron";
  if (hit.cube != scene_.spline.number(segment.cube) || hit.tetrahedron != segment.tetrahedron)
    return kEarlier;
  const Parameter low = ray_.at(hit.low), high = ray_.at(hit.high);
  const bool later = ray_.compare(low, segment.from) == Sign::positive;
  if (later &&
      (ray_.compare(low, segment.to) == Sign::positive || any_before(segment, segment.from, low)))
    return kEarlier;
  const Parameter from = later ? low : segment.from;
  const Parameter to = ray_.compare(high, segment.to) == Sign::negative ? high : segment.to;
  if (ray_.compare(from, to) == Sign::positive || !any_on(segment, from, to))
    return "has no zero where it is said to be hit";
  return nullptr;
}

template <class Question>
bool Zeros::ask(const Segment& segment, const Parameter& from, const Parameter& to,
                const Question& question) {
  if (const auto answer = question(along(segment, ray_.near(from), ray_.near(to)))) return *answer;
  if (const auto answer = question(along(segment, ray_.fine(from), ray_.fine(to)))) return *answer;
  return *question(along(segment, ray_.exact(from), ray_.exact(to)));
}

bool Zeros::any_on(const Segment& segment, const Parameter& from, const Parameter& to) {
  return ask(segment, from, to, [](const auto& b) { return has_zero(b); });
}
bool Zeros::any_before(const Segment& segment, const Parameter& from, const Parameter& to) {
  return ask(segment, from, to, [](const auto& b) { return has_zero_before_end(b); });
}

template <class Number>
Along<Number> Zeros::along(const Segment& segment, std::array<Number, 3> from,
                           std::array<Number, 3> to) {
  for (std::size_t d = 0; d < 3; ++d) {
    const Number centre(static_cast<double>(2 * std::int64_t{segment.cube[d]} + 1));
    from[d] = from[d] - centre;
    to[d] = to[d] - centre;
  }
  const Tetrahedron tet = tetrahedron(segment.tetrahedron);
  auto q = quadratic_on(segment.cube, tet, Number(0));
  const auto a = barycentrics(tet, from), b = barycentrics(tet, to);
  // Before the blossom: errors of barycentrics count by the coefficients' size.
  const Number c(scene_.volume.level);
  for (auto& row : q)
    for (Number& x : row) x = x - c;
  return {blossom(q, a, a), blossom(q, a, b), blossom(q, b, b)};
}

template <class Number>
Quadratic<Number> Zeros::quadratic_on(const CubePosition& cube, const Tetrahedron& tet,
                                      const Number&) {
  const auto near = quadratic_on(cube, tet, Interval(0));
  Quadratic<Number> exact;
  for (std::size_t i = 0; i < 4; ++i)
    for (std::size_t j = 0; j < 4; ++j) {
      if (!is_defined(near[i][j]) || near[i][j].inf() != near[i][j].sup())
        return quadratic(scene_.spline.neighbourhood<Number>(cube), tet);
      exact[i][j] = Number(near[i][j].inf());
    }
  return exact;
}

Quadratic<Interval> Zeros::quadratic_on(const CubePosition& cube, const Tetrahedron& tet,
                                        const Interval&) {
  if (!near_ || near_cube_ != cube) near_.emplace(scene_.spline.neighbourhood<Interval>(cube));
  near_cube_ = cube;
  return quadratic<Interval>(tet, *near_);
}

}  // namespace crest::certify::spline_rays
