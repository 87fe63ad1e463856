// SPDX-License-Identifier: GPL-3.0-or-later
#include "certify/spline_rays/walk.hpp"

#include <algorithm>

#include "certify/spline_rays/segment.hpp"

namespace crest::certify::spline_rays {
namespace {

using kernel::Interval;
using kernel::Rational;
using kernel::Sign;

constexpr const char* kEarlier = "has a zero before its hit, or in another tetrahedron";

/// A tetrahedron of a cube, and the part of the ray in it.
struct Segment {
  CubePosition cube;
  unsigned tetrahedron;
  Parameter from, to;
};

class Walk {
 public:
  Walk(const Scene& scene, const std::array<double, 6>& ray, const SplineHit* hit)
      : scene_(scene), ray_(scene.near, scene.exact, ray), hit_(hit) {}

  const char* objection() {
    if (std::ranges::all_of(std::array{0, 1, 2}, [&](int d) {
          return ray_.direction(static_cast<std::size_t>(d)) == Sign::zero;
        }))
      return "has no direction";
    if (!enter()) return hit_ == nullptr ? nullptr : "does not meet the domain";
    if (ray_.compare(from_, to_) == Sign::zero) return at_point();
    find_cube(false);
    for (;;) {
      const Parameter next = next_plane();
      const bool skip = scene_.one_sided[number_of(cube_)] != 0;
      if (!skip && pass(from_, next)) return verdict_;
      if (!step()) break;
      from_ = next;
    }
    return hit_ == nullptr ? nullptr : "meets no zero";
  }

 private:
  std::size_t number_of(const CubePosition& cube) const {
    const QuadraticSpline& s = scene_.spline;
    return cube[0] + std::size_t{s.cubes(0)} * (cube[1] + std::size_t{s.cubes(1)} * cube[2]);
  }

  /// From and to where the ray is in the closed domain; false if nowhere.
  bool enter() {
    from_ = ray_.at(0);
    bool bounded = false;
    for (std::size_t d = 0; d < 3; ++d) {
      const std::int64_t end = 2 * std::int64_t{scene_.spline.cubes(d)};
      const Sign direction = ray_.direction(d);
      if (direction == Sign::zero) {
        if (ray_.start(d, 0) == Sign::negative || ray_.start(d, end) == Sign::positive)
          return false;
        continue;
      }
      const bool up = direction == Sign::positive;
      const Parameter in = ray_.crossing(d, up ? 0 : end), out = ray_.crossing(d, up ? end : 0);
      if (ray_.compare(in, from_) == Sign::positive) from_ = in;
      if (!bounded || ray_.compare(out, to_) == Sign::negative) to_ = out;
      bounded = true;
    }
    return ray_.compare(from_, to_) != Sign::positive;
  }

  /// The cube in which the ray is after `from_`, or that the point there has by the rule for signs.
  void find_cube(bool point) {
    for (std::size_t d = 0; d < 3; ++d) {
      const bool down = !point && ray_.direction(d) == Sign::negative;
      std::int64_t i = 0;
      if (from_.form == d) {
        i = from_.plane / 2 - (down ? 1 : 0);
      } else {
        const auto floor = ray_.half_floor(d, from_);
        i = floor.value - (down && floor.equal ? 1 : 0);
      }
      const std::int64_t last = std::int64_t{scene_.spline.cubes(d)} - 1;
      cube_[d] = static_cast<std::uint32_t>(std::clamp<std::int64_t>(i, 0, last));
    }
  }

  Parameter plane_ahead(std::size_t d) const {
    const bool up = ray_.direction(d) == Sign::positive;
    return ray_.crossing(d, 2 * (std::int64_t{cube_[d]} + (up ? 1 : 0)));
  }
  /// Where the ray leaves the cube; leaving_ holds the axes of all planes there.
  Parameter next_plane() {
    Parameter next;
    leaving_ = 0;
    for (std::size_t d = 0; d < 3; ++d) {
      if (ray_.direction(d) == Sign::zero) continue;
      const Parameter plane = plane_ahead(d);
      const Sign order = leaving_ == 0 ? Sign::negative : ray_.compare(plane, next);
      if (order == Sign::negative) {
        next = plane;
        leaving_ = 0;
      }
      if (order != Sign::positive) leaving_ |= 1U << d;
    }
    return next;
  }
  /// Into the next cube; false where the domain ends.
  bool step() {
    for (std::size_t d = 0; d < 3; ++d) {
      if ((leaving_ >> d & 1U) == 0) continue;
      const bool up = ray_.direction(d) == Sign::positive;
      if (up ? cube_[d] + 1 == scene_.spline.cubes(d) : cube_[d] == 0) return false;
      cube_[d] += up ? 1 : ~0U;
    }
    return true;
  }

  std::int64_t centre_plane(std::size_t form_number) const {
    const std::array<std::int64_t, 3> centre = {2 * std::int64_t{cube_[0]} + 1,
                                                2 * std::int64_t{cube_[1]} + 1,
                                                2 * std::int64_t{cube_[2]} + 1};
    return form(form_number, centre);
  }

  /// Cuts in a cube, ascending, each with the form whose sign changes there.
  class Cuts {
   public:
    void insert(const LatticeRay& ray, const Parameter& at, unsigned form) {
      std::size_t i = size_++;
      for (; i > 0 && ray.compare(at, list_[i - 1].at) == Sign::negative; --i)
        list_[i] = list_[i - 1];
      list_[i] = {at, form};
    }
    std::size_t size() const { return size_; }
    const Parameter& at(std::size_t i) const { return list_[i].at; }
    unsigned form(std::size_t i) const { return list_[i].form; }

   private:
    struct Cut {
      Parameter at;
      unsigned form;
    };
    std::array<Cut, 6> list_;
    std::size_t size_ = 0;
  };

  /// The part of the ray in the cube; true if the walk ends here, with a verdict.
  bool pass(const Parameter& from, const Parameter& to) {
    unsigned signs = 0;  // before all cuts
    Cuts cuts;
    for (unsigned i = 0; i < 6; ++i) {
      const std::size_t number = 3 + i;
      const std::int64_t plane = centre_plane(number);
      const Sign direction = ray_.direction(number);
      bool positive = false;
      if (direction == Sign::zero) {
        positive = ray_.start(number, plane) != Sign::negative;
      } else {
        const Parameter cut = ray_.crossing(number, plane);
        const bool ahead = ray_.compare(cut, from) == Sign::positive;
        positive = (direction == Sign::positive) != ahead;
        if (ahead && ray_.compare(cut, to) == Sign::negative) cuts.insert(ray_, cut, i);
      }
      if (positive) signs |= 1U << i;
    }
    Segment segment{cube_, 0, from, to};
    for (std::size_t i = 0; i < cuts.size();) {
      segment.tetrahedron = scene_.tetrahedra[signs];
      segment.to = cuts.at(i);
      if (decide(segment)) return true;
      segment.from = segment.to;
      // All planes that meet there at once.
      for (; i < cuts.size() && ray_.compare(cuts.at(i), segment.from) == Sign::zero; ++i)
        signs ^= 1U << cuts.form(i);
    }
    segment.tetrahedron = scene_.tetrahedra[signs];
    segment.to = to;
    return decide(segment);
  }

  /// Whether the segment holds the ray's first zero: then verdict_ is the answer.
  bool decide(const Segment& segment) {
    if (!zero_on(segment, segment.from, segment.to)) return false;
    verdict_ = hit_ == nullptr ? "has a zero" : at_hit(segment);
    return true;
  }
  const char* at_hit(const Segment& segment) const {
    if (hit_->cube != number_of(segment.cube) || hit_->tetrahedron != segment.tetrahedron)
      return kEarlier;
    const Parameter low = ray_.at(hit_->low), high = ray_.at(hit_->high);
    const bool later = ray_.compare(low, segment.from) == Sign::positive;
    if (later && (ray_.compare(low, segment.to) == Sign::positive ||
                  zero_before(segment, segment.from, low)))
      return kEarlier;
    const Parameter from = later ? low : segment.from;
    const Parameter to = ray_.compare(high, segment.to) == Sign::negative ? high : segment.to;
    if (ray_.compare(from, to) == Sign::positive || !zero_on(segment, from, to))
      return "has no zero where it is said to be hit";
    return nullptr;
  }

  /// The ray meets the domain in one point.
  const char* at_point() {
    find_cube(true);
    unsigned signs = 0;
    const auto point = ray_.exact(from_);
    for (unsigned i = 0; i < 6; ++i)
      if (form(std::size_t{3} + i, point) >= Rational(static_cast<double>(centre_plane(3 + i))))
        signs |= 1U << i;
    Segment segment{cube_, scene_.tetrahedra[signs], from_, from_};
    if (decide(segment)) return verdict_;
    return hit_ == nullptr ? nullptr : "meets no zero";
  }

  bool zero_on(const Segment& segment, const Parameter& from, const Parameter& to) const {
    return ask(segment, from, to, [](const auto& b) { return has_zero(b); });
  }
  bool zero_before(const Segment& segment, const Parameter& from, const Parameter& to) const {
    return ask(segment, from, to, [](const auto& b) { return has_zero_before_end(b); });
  }
  template <class Question>
  bool ask(const Segment& segment, const Parameter& from, const Parameter& to,
           const Question& question) const {
    if (const auto answer = question(along(segment, ray_.near(from), ray_.near(to))))
      return *answer;
    return *question(along(segment, ray_.exact(from), ray_.exact(to)));
  }
  template <class Number>
  Along<Number> along(const Segment& segment, std::array<Number, 3> from,
                      std::array<Number, 3> to) const {
    for (std::size_t d = 0; d < 3; ++d) {
      const Number centre(static_cast<double>(2 * std::int64_t{segment.cube[d]} + 1));
      from[d] = from[d] - centre;
      to[d] = to[d] - centre;
    }
    const Tetrahedron tet = tetrahedron(segment.tetrahedron);
    const auto q = quadratic(scene_.spline.neighbourhood<Number>(segment.cube), tet);
    const auto a = barycentrics(tet, from), b = barycentrics(tet, to);
    const Number c(scene_.volume.level);
    return {blossom(q, a, a) - c, blossom(q, a, b) - c, blossom(q, b, b) - c};
  }

  const Scene& scene_;
  const LatticeRay ray_;
  const SplineHit* hit_;
  Parameter from_, to_;
  CubePosition cube_{};
  unsigned leaving_ = 0;
  const char* verdict_ = nullptr;
};

}  // namespace

Scene::Scene(const SplineVolume& v)
    : volume(v), spline(v), one_sided(spline.one_sided()), exact(exact_frame(v)) {
  const kernel::RoundUpward guard;
  near = frame_enclosure(v);
  for (unsigned signs = 0; signs < 64; ++signs)
    tetrahedra[signs] = static_cast<std::uint8_t>(tetrahedron_by_signs(signs));
}

const char* objection(const Scene& scene, const std::array<double, 6>& ray, const SplineHit* hit) {
  const kernel::RoundUpward guard;
  return Walk(scene, ray, hit).objection();
}

}  // namespace crest::certify::spline_rays
