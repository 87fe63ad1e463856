// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/line_art/streamlines.hpp"

#include <algorithm>
#include <cmath>
#include <deque>
#include <numbers>

#include "kernel/geometry/stop.hpp"

namespace crest::line_art {
namespace {

using kernel::dot, kernel::norm;
using kernel::operator+, kernel::operator-, kernel::operator*;

constexpr float kDark = 0.5F;  // luminance: more black than white
constexpr double kHug = 0.6;   // spacings
constexpr double kBrief = 5;   // spacings: shorter lines along a contour are dashes

/// How close lines come, in spacings.
struct Closeness {
  double start = 0.98, stop = 0.6;              ///< to other lines
  double contour = 0.3, contour_in_dark = 0.3;  ///< where they start
};
constexpr Closeness kFilling = {0.8, 0.5, 0.3, 0.15};

bool dark(const Buffers& b, const Vec2& p) {
  const auto at = b.at(p);
  return at && b.luminance[*at] < kDark;
}

bool hatchable(const Buffers& b, const Vec2& p, double brightest) {
  const auto at = b.at(p);
  return at && b.face[*at] != kNone && static_cast<double>(b.luminance[*at]) < brightest;
}

Vec2 page(const Buffers& b) {
  return {b.width * b.pixel, b.height * b.pixel};
}

/// Does a line come back to itself? Its own points count from half a turn on.
bool comes_round(const std::vector<Vec2>& own, const Vec2& p, double spacing, double stop) {
  const auto apart = static_cast<std::size_t>(3 * spacing / Tracer::kStep);
  for (std::size_t i = 0; i + apart < own.size(); ++i)
    if (norm(own[i] - p) < stop * spacing) return true;
  return false;
}

Hatch joined(const Trace& back, const Trace& ahead) {
  Hatch hatch;
  hatch.stroke.kind = StrokeKind::streamline;
  hatch.stroke.points.assign(back.points.rbegin(), back.points.rend());
  hatch.stroke.points.insert(hatch.stroke.points.end(), ahead.points.begin() + 1,
                             ahead.points.end());
  hatch.free_start = back.end != Trace::End::contour;
  hatch.free_end = ahead.end != Trace::End::contour;
  return hatch;
}

class EvenLines {
 public:
  EvenLines(const Tracer& tracer, double brightest, Family family, const Closeness& close,
            std::vector<Hatch>& lines)
      : tracer_(tracer),
        close_(close),
        s_(tracer.spacing()),
        brightest_(brightest),
        family_(family),
        points_(page(tracer.buffers()), tracer.spacing(), tracer.barriers()),
        lines_(lines) {
    for (Index l = 0; l < lines.size(); ++l) enter(l);
  }

  void run() {
    for (const std::size_t k : by_curvature()) {
      kernel::stop_point();
      try_seed(tracer_.buffers().centre(k));
      while (!seeds_.empty()) {
        kernel::stop_point();
        const Vec2 seed = seeds_.front();
        seeds_.pop_front();
        try_seed(seed);
      }
    }
  }

 private:
  void enter(Index line) {
    const auto& points = lines_[line].stroke.points;
    for (Index i = 0; i < points.size(); ++i) points_.add(points[i], line, i);
  }

  /// Every few pixels, the most curved first.
  std::vector<std::size_t> by_curvature() const {
    const Buffers& b = tracer_.buffers();
    const int stride = std::max(1, static_cast<int>(0.4 * s_ / b.pixel));
    std::vector<std::size_t> order;
    for (int j = 0; j < b.height; j += stride)
      for (int i = 0; i < b.width; i += stride) {
        const std::size_t k = static_cast<std::size_t>(j) * static_cast<std::size_t>(b.width) +
                              static_cast<std::size_t>(i);
        if (b.face[k] != kNone) order.push_back(k);
      }
    std::stable_sort(order.begin(), order.end(),
                     [&](std::size_t x, std::size_t y) { return b.curvature[x] > b.curvature[y]; });
    return order;
  }

  bool starts_at(const Vec2& seed) const {
    const Buffers& b = tracer_.buffers();
    if (!hatchable(b, seed, brightest_) || tracer_.near_singularity(seed)) return false;
    const double clear = dark(b, seed) ? close_.contour_in_dark : close_.contour;
    return !tracer_.barriers().nearest(seed, clear * s_) &&
           !(points_.distance(seed, s_) < close_.start * s_);
  }

  void try_seed(const Vec2& seed) {
    if (!starts_at(seed)) return;
    const auto d = tracer_.direction(seed, family_, {0, 0});
    if (!d) return;
    const auto line = static_cast<Index>(lines_.size());
    std::vector<Vec2> own;
    const double near = close_.stop * s_;
    const auto stop = [&](const Vec2& p, Index) {
      if (!hatchable(tracer_.buffers(), p, brightest_) || points_.distance(p, near) < near ||
          comes_round(own, p, s_, close_.stop))
        return true;
      own.push_back(p);
      return false;
    };
    const Trace ahead = tracer_.trace(seed, *d, family_, 2 * std::numbers::pi, stop);
    std::reverse(own.begin(), own.end());
    const Trace back = tracer_.trace(seed, -1.0 * *d, family_, 2 * std::numbers::pi, stop);
    Hatch hatch = joined(back, ahead);
    if (too_short(hatch, s_) || hugs_contour(tracer_, hatch.stroke)) return;
    hatch.stroke.rank = line;
    if (family_ == Family::backbone) hatch.stroke.kind = StrokeKind::cross;
    lines_.push_back(std::move(hatch));
    enter(line);
    add_seeds(lines_.back().stroke.points);
  }

  void add_seeds(const std::vector<Vec2>& line) {
    for (std::size_t i = 1; i + 1 < line.size(); i += 3) {
      const Vec2 along = line[i + 1] - line[i - 1];
      const double n = norm(along);
      if (!(n > 0)) continue;
      const Vec2 side = (s_ / n) * Vec2{-along[1], along[0]};
      for (const double sense : {1.0, -1.0}) seeds_.push_back(line[i] + sense * side);
    }
  }

  const Tracer& tracer_;
  Closeness close_;
  double s_, brightest_;
  Family family_;
  LinePoints points_;
  std::deque<Vec2> seeds_;
  std::vector<Hatch>& lines_;
};

/// Lets free ends go on, as near to other lines as gaps are filled.
class LongerEnds {
 public:
  LongerEnds(const Tracer& tracer, double brightest, Family family, std::vector<Hatch>& lines)
      : tracer_(tracer),
        brightest_(brightest),
        family_(family),
        points_(page(tracer.buffers()), tracer.spacing(), tracer.barriers()),
        lines_(lines) {
    for (Index l = 0; l < lines.size(); ++l)
      for (const Vec2& p : lines[l].stroke.points) points_.add(p, l, 0);
  }

  void run() {
    for (Index l = 0; l < lines_.size(); ++l) {
      kernel::stop_point();
      Hatch& h = lines_[l];
      if (h.stroke.points.size() < 2) continue;
      if (h.free_end) h.free_end = go_on(l);
      std::reverse(h.stroke.points.begin(), h.stroke.points.end());
      if (h.free_start) h.free_start = go_on(l);
      std::reverse(h.stroke.points.begin(), h.stroke.points.end());
    }
  }

 private:
  /// From the last point on; is the new end free?
  bool go_on(Index line) {
    auto& points = lines_[line].stroke.points;
    const double near = kFilling.stop * tracer_.spacing();
    std::vector<Vec2> own = points;
    const auto stop = [&](const Vec2& p, Index) {
      const auto others = [&](Index other, Index) { return other != line; };
      if (!hatchable(tracer_.buffers(), p, brightest_) ||
          points_.distance(p, near, others) < near ||
          comes_round(own, p, tracer_.spacing(), kFilling.stop))
        return true;
      own.push_back(p);
      return false;
    };
    const Vec2 end = points.back(), ahead = end - points[points.size() - 2];
    const Trace more = tracer_.trace(end, ahead, family_, std::numbers::pi, stop);
    for (std::size_t i = 1; i < more.points.size(); ++i) {
      points.push_back(more.points[i]);
      points_.add(more.points[i], line, 0);
    }
    return more.end != Trace::End::contour;
  }

  const Tracer& tracer_;
  double brightest_;
  Family family_;
  LinePoints points_;
  std::vector<Hatch>& lines_;
};

/// The same numbers everywhere (splitmix64).
struct Noise {
  std::uint64_t state = 1;
  double next() {
    state += 0x9e3779b97f4a7c15u;
    std::uint64_t h = state;
    h = (h ^ (h >> 30)) * 0xbf58476d1ce4e5b9u;
    h = (h ^ (h >> 27)) * 0x94d049bb133111ebu;
    return static_cast<double>((h ^ (h >> 31)) >> 11) * 0x1p-53;
  }
};

}  // namespace

bool too_short(const Hatch& hatch, double spacing) {
  const bool across = !hatch.free_start && !hatch.free_end;
  return hatch.stroke.length() < (across ? 0.8 : 2.5) * spacing;
}

bool hugs_contour(const Tracer& tracer, const Stroke& stroke) {
  const double s = tracer.spacing();
  const bool brief = stroke.length() < kBrief * s;
  const double reach = (brief ? 0.8 : kHug) * s, cosine = brief ? 0.9 : 0.966;
  std::size_t close = 0;
  for (std::size_t i = 1; i < stroke.points.size(); ++i) {
    // In the dark a line beside the contour is no dash: without it a white slit is seen.
    if (dark(tracer.buffers(), stroke.points[i])) continue;
    const auto near = tracer.barriers().nearest(stroke.points[i], reach);
    const Vec2 d = stroke.points[i] - stroke.points[i - 1];
    const double n = norm(d);
    if (near && n > 0 && std::abs(dot(d, near->direction)) > cosine * n) ++close;
  }
  return 2 * close > stroke.points.size();
}

void add_even_streamlines(const Tracer& tracer, double brightest, Family family,
                          std::vector<Hatch>& lines) {
  EvenLines(tracer, brightest, family, {}, lines).run();
}

void fill_gaps(const Tracer& tracer, double brightest, Family family, std::vector<Hatch>& lines) {
  const Tracer heedless = tracer.heedless();
  LongerEnds(heedless, brightest, family, lines).run();
  EvenLines(heedless, brightest, family, kFilling, lines).run();
}

std::vector<Hatch> random_streamlines(const Tracer& tracer, double brightest, double width) {
  const Buffers& b = tracer.buffers();
  struct Seed {
    std::size_t pixel;
    float facing;
  };
  std::vector<Seed> seeds;
  Noise noise;
  // Strokes of `most` mm and the width, as dense as full black needs.
  const double most = 10 * tracer.spacing();
  const auto wanted =
      static_cast<std::size_t>(static_cast<double>(b.size()) * b.pixel * b.pixel / (most * width));
  for (std::size_t i = 0; i < wanted; ++i) {
    const auto k = static_cast<std::size_t>(noise.next() * static_cast<double>(b.size()));
    if (b.face[k] != kNone && b.luminance[k] < brightest) seeds.push_back({k, b.normal[k][2]});
  }
  std::stable_sort(seeds.begin(), seeds.end(),
                   [](const Seed& x, const Seed& y) { return x.facing < y.facing; });
  std::vector<Hatch> lines;
  const auto never = [](const Vec2&, Index) { return false; };
  for (const Seed& seed : seeds) {
    const Vec2 p = b.centre(seed.pixel);
    const auto d = tracer.direction(p, Family::rib, {0, 0});
    if (!d || tracer.barriers().nearest(p, 0.1)) continue;
    const Trace ahead = tracer.trace(p, *d, Family::rib, std::numbers::pi, never);
    const Trace back = tracer.trace(p, -1.0 * *d, Family::rib, std::numbers::pi, never);
    Hatch hatch = joined(back, ahead);
    const double length = most * (1 - static_cast<double>(b.luminance[seed.pixel]));
    const auto half = static_cast<std::size_t>(0.5 * length / Tracer::kStep);
    auto& points = hatch.stroke.points;
    const std::size_t middle = back.points.size() - 1;
    if (middle + half + 1 < points.size()) {
      points.resize(middle + half + 1);
      hatch.free_end = true;
    }
    if (middle > half) {
      points.erase(points.begin(), points.begin() + static_cast<std::ptrdiff_t>(middle - half));
      hatch.free_start = true;
    }
    if (points.size() < 4) continue;
    hatch.stroke.widths.assign(points.size(), width);
    hatch.stroke.rank = static_cast<Index>(lines.size());
    lines.push_back(std::move(hatch));
  }
  return lines;
}

}  // namespace crest::line_art
