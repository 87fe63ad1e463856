// SPDX-License-Identifier: GPL-3.0-or-later
#include "certify/spline_rays/walk.hpp"

#include <algorithm>

#include "certify/spline_rays/zeros.hpp"

namespace crest::certify::spline_rays {
namespace {

using kernel::Rational;
using kernel::Sign;

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

class Walk {
 public:
  Walk(const Scene& scene, const std::array<double, 6>& ray, const SplineHit* hit)
      : scene_(scene),
        ray_(scene.near, scene.fine, scene.exact, ray),
        zeros_(scene, ray_),
        hit_(hit) {}

  const char* objection() {
    if (std::ranges::all_of(std::array{0, 1, 2}, [&](int d) {
          return ray_.direction(static_cast<std::size_t>(d)) == Sign::zero;
        }))
      return "has no direction";
    if (!enter()) return hit_ == nullptr ? nullptr : "does not meet the domain";
    if (ray_.compare(from_, to_) == Sign::zero) return at_point();
    find_cube(false);
    for (std::size_t d = 0; d < 3; ++d)
      if (ray_.direction(d) != Sign::zero) look_ahead(d);
    for (;;) {
      const Parameter next = next_plane();
      const bool skip = scene_.one_sided[scene_.spline.number(cube_)] != 0;
      if (!skip && pass(from_, next)) return verdict_;
      if (!step()) break;
      from_ = next;
    }
    return hit_ == nullptr ? nullptr : "meets no zero";
  }

 private:
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

  void look_ahead(std::size_t d) {
    const bool up = ray_.direction(d) == Sign::positive;
    ahead_[d] = ray_.crossing(d, 2 * (std::int64_t{cube_[d]} + (up ? 1 : 0)));
  }
  /// Where the ray leaves the cube; leaving_ holds the axes of all planes there.
  Parameter next_plane() {
    std::size_t next = 3;
    leaving_ = 0;
    for (std::size_t d = 0; d < 3; ++d) {
      if (ray_.direction(d) == Sign::zero) continue;
      const Sign order = next == 3 ? Sign::negative : ray_.compare(ahead_[d], ahead_[next]);
      if (order == Sign::negative) {
        next = d;
        leaving_ = 0;
      }
      if (order != Sign::positive) leaving_ |= 1U << d;
    }
    return ahead_[next];
  }
  /// Into the next cube; false where the domain ends.
  bool step() {
    for (std::size_t d = 0; d < 3; ++d) {
      if ((leaving_ >> d & 1U) == 0) continue;
      const bool up = ray_.direction(d) == Sign::positive;
      if (up ? cube_[d] + 1 == scene_.spline.cubes(d) : cube_[d] == 0) return false;
      cube_[d] += up ? 1 : ~0U;
      look_ahead(d);
    }
    return true;
  }

  std::int64_t centre_plane(std::size_t form_number) const {
    const std::array<std::int64_t, 3> centre = {2 * std::int64_t{cube_[0]} + 1,
                                                2 * std::int64_t{cube_[1]} + 1,
                                                2 * std::int64_t{cube_[2]} + 1};
    return form(form_number, centre);
  }

  /// The part of the ray in the cube; true if the walk ends here, with a verdict.
  bool pass(const Parameter& from, const Parameter& to);

  /// Whether the segment holds the ray's first zero: then verdict_ is the answer.
  bool decide(const Segment& segment) {
    if (!zeros_.any_on(segment, segment.from, segment.to)) return false;
    verdict_ = hit_ == nullptr ? "has a zero" : zeros_.objection(segment, *hit_);
    return true;
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

  const Scene& scene_;
  const LatticeRay ray_;
  Zeros zeros_;
  const SplineHit* hit_;
  Parameter from_, to_;
  std::array<Parameter, 3> ahead_;  ///< the next plane across each axis
  CubePosition cube_{};
  unsigned leaving_ = 0;
  const char* verdict_ = nullptr;
};

bool Walk::pass(const Parameter& from, const Parameter& to) {
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

}  // namespace

const char* objection(const Scene& scene, const std::array<double, 6>& ray, const SplineHit* hit) {
  const kernel::RoundUpward guard;
  return Walk(scene, ray, hit).objection();
}

}  // namespace crest::certify::spline_rays
