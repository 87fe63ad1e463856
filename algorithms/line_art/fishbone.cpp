// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/line_art/fishbone.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>

#include "algorithms/line_art/free_room.hpp"
#include "algorithms/line_art/tone.hpp"
#include "kernel/geometry/stop.hpp"

namespace crest::line_art {
namespace {

using kernel::cross, kernel::dot, kernel::norm;
using kernel::operator+, kernel::operator-, kernel::operator*;
using std::numbers::pi;

constexpr double kTurn = 2.2;       // radians, of a backbone
constexpr double kLeaves = 0.25;    // radians between a blended rib and the field
constexpr double kDeviation = 0.9;  // spacings between a blended rib and the traced one
constexpr double kApart = 0.6;      // spacings between ribs
constexpr std::size_t kParts = 24;  // key ribs to begin with, less one

double turn_between(const Vec2& a, const Vec2& b) {
  return std::atan2(cross(a, b), dot(a, b));
}

struct Rib {
  RibSide ahead, back;
};

/// Where a rib starts: on the backbone, at an arc length, in a direction.
struct Sample {
  Vec2 p, rib;
  double arc;
};

/// Ribs of one backbone. `Blocked` says of a point and a rib's number that other lines are there.
class RibMaker {
 public:
  using Blocked = std::function<bool(const Vec2&, Index)>;
  RibMaker(const Tracer& tracer, Blocked blocked)
      : tracer_(tracer), s_(tracer.spacing()), blocked_(std::move(blocked)) {}

  /// Every spacing across the ribs.
  std::vector<Sample> samples(const std::vector<Vec2>& line) const {
    std::vector<Sample> found;
    double arc = 0, across = 0, next = 0;
    Vec2 before{0, 0};
    for (std::size_t i = 1; i < line.size(); ++i) {
      const Vec2 d = line[i] - line[i - 1];
      const double length = norm(d);
      if (i == 1) before = {-d[1], d[0]};
      const auto rib = tracer_.direction(line[i - 1], Family::rib, before);
      if (rib && length > 0) {
        // All to the same side of the backbone.
        before = cross(d, *rib) < 0 ? -1.0 * *rib : *rib;
        if (across >= next) {
          found.push_back({line[i - 1], before, arc});
          next += s_;
        }
        across += std::abs(cross(d, *rib));
      }
      arc += length;
    }
    return found;
  }

  Rib traced(const Sample& sample, Index rib) const {
    const auto stop = [&](const Vec2& p, Index) { return blocked_(p, rib); };
    const auto side = [&](const Vec2& d) {
      return side_of(tracer_.trace(sample.p, d, Family::rib, pi, stop).points, Tracer::kStep);
    };
    return {side(sample.rib), side(-1.0 * sample.rib)};
  }

  static Rib blended(const Rib& a, const Rib& b, double t) {
    return {blend(a.ahead, b.ahead, t), blend(a.back, b.back, t)};
  }

  double deviation(const Vec2& p, const Rib& a, const Rib& b) const {
    double most = 0;
    for (const auto side : {&Rib::ahead, &Rib::back}) {
      const auto x = rib_points(p, a.*side, Tracer::kStep),
                 y = rib_points(p, b.*side, Tracer::kStep);
      for (std::size_t k = 0; k < std::min(x.size(), y.size()); ++k)
        most = std::max(most, norm(x[k] - y[k]));
    }
    return most;
  }

  /// Keys between two keys wherever the blended middle rib leaves the traced one.
  void bisect(const std::vector<Sample>& at, std::size_t i, std::size_t j,
              std::vector<std::optional<Rib>>& keys) const {
    if (j - i < 2) return;
    const std::size_t m = (i + j) / 2;
    const double t = (at[m].arc - at[i].arc) / (at[j].arc - at[i].arc);
    const Rib own = traced(at[m], kNone);
    if (deviation(at[m].p, own, blended(*keys[i], *keys[j], t)) <= kDeviation * s_) return;
    keys[m] = own;
    bisect(at, i, m, keys);
    bisect(at, m, j, keys);
  }

  std::vector<std::optional<Rib>> key_ribs(const std::vector<Sample>& at) const {
    std::vector<std::optional<Rib>> keys(at.size());
    const std::size_t step = std::max<std::size_t>(1, (at.size() + kParts - 1) / kParts);
    std::size_t last = 0;
    keys[0] = traced(at[0], kNone);
    for (std::size_t i = std::min(step, at.size() - 1); last + 1 < at.size();
         i = std::min(i + step, at.size() - 1)) {
      keys[i] = traced(at[i], kNone);
      bisect(at, last, i, keys);
      last = i;
    }
    return keys;
  }

  /// Follows a blended side as long as it agrees with the field, then the field itself.
  Trace follow(const Vec2& start, const RibSide& side, Index rib) const {
    Trace line;
    line.points.push_back(start);
    const std::vector<Vec2> wanted = rib_points(start, side, Tracer::kStep);
    for (std::size_t k = 1; k < wanted.size(); ++k) {
      const Vec2 &p = line.points.back(), &q = wanted[k];
      const Vec2 d = q - p;
      const double share = tracer_.barriers().free_share(p, q, Tracer::kClearance);
      if (share < 1) {
        line.end = Trace::End::contour;
        if (share > 0.1) line.points.push_back(p + share * d);
        return line;
      }
      const auto field = tracer_.direction(q, Family::rib, d);
      if (!field || tracer_.near_singularity(q)) return line;
      if (std::abs(turn_between(d, *field)) > kLeaves) break;
      if (blocked_(q, rib)) {
        line.end = Trace::End::line;
        return line;
      }
      line.points.push_back(q);
    }
    const Vec2 ahead = line.points.size() > 1
                           ? line.points.back() - line.points[line.points.size() - 2]
                           : Vec2{std::cos(side.angle), std::sin(side.angle)};
    const Trace rest = tracer_.trace(line.points.back(), ahead, Family::rib, pi,
                                     [&](const Vec2& p, Index) { return blocked_(p, rib); });
    line.points.insert(line.points.end(), rest.points.begin() + 1, rest.points.end());
    line.end = rest.end;
    return line;
  }

  /// The samples nearest to these arc lengths, and both ends.
  std::vector<std::optional<Rib>> keys_at(const std::vector<Sample>& at,
                                          const std::vector<double>& arcs) const {
    std::vector<std::optional<Rib>> keys(at.size());
    const auto set = [&](std::size_t i) {
      if (!keys[i]) keys[i] = traced(at[i], kNone);
    };
    set(0);
    for (const double arc : arcs) {
      std::size_t best = 0;
      for (std::size_t i = 1; i < at.size(); ++i)
        if (std::abs(at[i].arc - arc) < std::abs(at[best].arc - arc)) best = i;
      set(best);
    }
    set(at.size() - 1);
    return keys;
  }

 private:
  const Tracer& tracer_;
  double s_;
  Blocked blocked_;
};

class Boner {
 public:
  Boner(const Tracer& tracer, double brightest)
      : tracer_(tracer),
        s_(tracer.spacing()),
        brightest_(brightest),
        ribs_(tracer, [this](const Vec2& p, Index rib) { return blocked(p, rib); }),
        room_(tracer, brightest),
        points_({tracer.buffers().width * tracer.buffers().pixel,
                 tracer.buffers().height * tracer.buffers().pixel},
                tracer.spacing(), tracer.barriers()) {}

  Fishbones run(const std::vector<Segment>& given) {
    for (const Segment& segment : given) add_ribs(segment.backbone, segment.key_ribs);
    if (!given.empty()) return std::move(result_);
    while (const auto seed = room_.farthest(0.6 * s_)) {
      kernel::stop_point();
      add_segment(*seed);
      room_.take(*seed, 0.6 * s_);
    }
    return std::move(result_);
  }

 private:
  bool hatchable(const Vec2& p) const {
    const auto at = tracer_.buffers().at(p);
    return at && tracer_.buffers().face[*at] != kNone &&
           tracer_.buffers().luminance[*at] < brightest_;
  }
  bool blocked(const Vec2& p, Index rib) const {
    if (!hatchable(p)) return true;
    return points_.distance(p, kApart * s_, [&](Index line, Index) { return line != rib; }) <
           kApart * s_;
  }

  void add_rib(const Sample& sample, const Rib& rib, Index segment, Index rank) {
    const auto number = static_cast<Index>(result_.ribs.size());
    if (blocked(sample.p, number)) return;
    const Trace back = ribs_.follow(sample.p, rib.back, number),
                ahead = ribs_.follow(sample.p, rib.ahead, number);
    Hatch hatch;
    hatch.stroke.kind = StrokeKind::rib;
    hatch.stroke.segment = segment;
    hatch.stroke.rank = rank;
    hatch.stroke.points.assign(back.points.rbegin(), back.points.rend());
    hatch.stroke.points.insert(hatch.stroke.points.end(), ahead.points.begin() + 1,
                               ahead.points.end());
    hatch.free_start = back.end != Trace::End::contour;
    hatch.free_end = ahead.end != Trace::End::contour;
    if (too_short(hatch, s_) || hugs_contour(tracer_, hatch.stroke)) return;
    for (Index i = 0; i < hatch.stroke.points.size(); ++i) {
      points_.add(hatch.stroke.points[i], number, i);
      if (i % 2 == 0) room_.take(hatch.stroke.points[i], 0.6 * s_);
    }
    result_.ribs.push_back(std::move(hatch));
  }

  void add_segment(const Vec2& seed) {
    first_rib_ = static_cast<Index>(result_.ribs.size());
    const auto d = tracer_.direction(seed, Family::backbone, {0, 0});
    if (!d || blocked(seed, kNone)) return;
    const auto stop = [&](const Vec2& p, Index) { return blocked(p, kNone); };
    const Trace back = tracer_.trace(seed, -1.0 * *d, Family::backbone, kTurn, stop);
    const Trace ahead = tracer_.trace(seed, *d, Family::backbone, kTurn, stop);
    std::vector<Vec2> backbone(back.points.rbegin(), back.points.rend());
    backbone.insert(backbone.end(), ahead.points.begin() + 1, ahead.points.end());
    add_ribs(std::move(backbone), {});
  }

  /// Key ribs at these arc lengths; none: found by bisection.
  void add_ribs(std::vector<Vec2> backbone, const std::vector<double>& given) {
    first_rib_ = static_cast<Index>(result_.ribs.size());
    const std::vector<Sample> at = ribs_.samples(backbone);
    if (at.empty()) return;
    const auto keys = given.empty() ? ribs_.key_ribs(at) : ribs_.keys_at(at, given);
    Segment bone{std::move(backbone), {}};
    const auto segment = static_cast<Index>(result_.segments.size());
    // In bit-reversed order: where ribs run together, evenly distributed ones go on.
    for (const Index i : bit_reversed(static_cast<Index>(at.size()))) {
      std::size_t last = i, next = i;
      while (!keys[last]) --last;
      while (!keys[next]) ++next;
      const double span = at[next].arc - at[last].arc;
      const double t = span > 0 ? (at[i].arc - at[last].arc) / span : 0;
      add_rib(at[i], keys[i] ? *keys[i] : RibMaker::blended(*keys[last], *keys[next], t), segment,
              i);
    }
    for (std::size_t i = 0; i < at.size(); ++i)
      if (keys[i]) bone.key_ribs.push_back(at[i].arc);
    std::sort(result_.ribs.begin() + first_rib_, result_.ribs.end(),
              [](const Hatch& x, const Hatch& y) { return x.stroke.rank < y.stroke.rank; });
    if (result_.ribs.size() == first_rib_) return;
    result_.key_ribs += bone.key_ribs.size();
    result_.blended += at.size() - bone.key_ribs.size();
    result_.segments.push_back(std::move(bone));
  }

  const Tracer& tracer_;
  double s_, brightest_;
  RibMaker ribs_;
  FreeRoom room_;
  LinePoints points_;
  Index first_rib_ = 0;
  Fishbones result_;
};

}  // namespace

RibSide blend(const RibSide& a, const RibSide& b, double t) {
  RibSide g;
  const double turn = std::remainder(b.angle - a.angle, 2 * pi);
  g.angle = a.angle + t * turn;
  for (std::size_t i = 0; i < std::max(a.turns.size(), b.turns.size()); ++i) {
    const double x = i < a.turns.size() ? a.turns[i] : b.turns[i];
    const double y = i < b.turns.size() ? b.turns[i] : a.turns[i];
    g.turns.push_back((1 - t) * x + t * y);
  }
  return g;
}

std::vector<Vec2> rib_points(const Vec2& start, const RibSide& side, double h) {
  std::vector<Vec2> points = {start};
  double angle = side.angle;
  for (std::size_t i = 0; i <= side.turns.size(); ++i) {
    points.push_back(points.back() + h * Vec2{std::cos(angle), std::sin(angle)});
    if (i < side.turns.size()) angle += side.turns[i];
  }
  return points;
}

RibSide side_of(const std::vector<Vec2>& points, double h) {
  RibSide side;
  Vec2 before{0, 0};
  for (std::size_t i = 1; i < points.size(); ++i) {
    const Vec2 d = points[i] - points[i - 1];
    if (norm(d) < 0.99 * h) break;
    if (i == 1)
      side.angle = std::atan2(d[1], d[0]);
    else
      side.turns.push_back(turn_between(before, d));
    before = d;
  }
  return side;
}

Fishbones make_fishbones(const Tracer& tracer, double brightest,
                         const std::vector<Segment>& given) {
  return Boner(tracer, brightest).run(given);
}

}  // namespace crest::line_art
