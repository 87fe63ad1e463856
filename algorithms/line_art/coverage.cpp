// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/line_art/coverage.hpp"

#include <algorithm>
#include <cmath>

#include "kernel/geometry/parallel.hpp"

namespace crest::line_art {
namespace {

using kernel::dot, kernel::norm;
using kernel::operator+, kernel::operator-, kernel::operator*;

struct Owner {
  Index hatch = kNone, vertex = 0;
};

/// Which vertex is nearest to every pixel, grown from the vertices over open links.
class Growth {
 public:
  Growth(const Buffers& b, const std::vector<Hatch>& hatches, double reach)
      : b_(b), hatches_(hatches), owner(b.size()), reach_(reach), buckets_(kBuckets) {}

  void run() {
    for (Index h = 0; h < hatches_.size(); ++h) {
      kernel::stop_point();
      for (Index v = 0; v < hatches_[h].stroke.points.size(); ++v)
        if (const auto at = b_.at(hatches_[h].stroke.points[v])) offer(*at, {h, v});
    }
    for (std::size_t k = 0; k < buckets_.size(); ++k) {
      kernel::stop_point();
      for (std::size_t i = 0; i < buckets_[k].size(); ++i) {
        const auto [at, by] = buckets_[k][i];
        if (owner[at].hatch != by.hatch || owner[at].vertex != by.vertex) continue;
        spread(at, by);
      }
    }
  }

 private:
  static constexpr std::size_t kBuckets = 2048;
  struct Claim {
    std::size_t at;
    Owner by;
  };

  double distance(std::size_t at, const Owner& by) const {
    return norm(b_.centre(at) - hatches_[by.hatch].stroke.points[by.vertex]);
  }
  void offer(std::size_t at, const Owner& by) {
    if (b_.face[at] == kNone) return;
    const double d = distance(at, by);
    if (d > reach_) return;
    if (owner[at].hatch != kNone && distance(at, owner[at]) <= d) return;
    owner[at] = by;
    const auto bucket = static_cast<std::size_t>(d / reach_ * static_cast<double>(kBuckets - 1));
    buckets_[bucket].push_back({at, by});
  }
  void spread(std::size_t at, const Owner& by) {
    const auto w = static_cast<std::size_t>(b_.width);
    const std::size_t column = at % w;
    if (column + 1 < w && (b_.closed[at] & 1) == 0) offer(at + 1, by);
    if (column > 0 && (b_.closed[at - 1] & 1) == 0) offer(at - 1, by);
    if (at + w < b_.size() && (b_.closed[at] & 2) == 0) offer(at + w, by);
    if (at >= w && (b_.closed[at - w] & 2) == 0) offer(at - w, by);
  }

  const Buffers& b_;
  const std::vector<Hatch>& hatches_;

 public:
  std::vector<Owner> owner;

 private:
  double reach_;
  std::vector<std::vector<Claim>> buckets_;
};

/// The rows of one strip of the page: strokes are drawn into it on their own.
class Strip {
 public:
  Strip(const Buffers& b, int first, int last)
      : b_(b),
        first_(first),
        last_(last),
        own_(static_cast<std::size_t>(last - first) * static_cast<std::size_t>(b.width), 0) {}

  /// Under a hatch of these widths: take(pixel, share). Ends at contours are cut, others round.
  template <class WidthOf, class Take>
  void cover(const Hatch& hatch, WidthOf&& width_of, Take&& take) {
    const std::vector<Vec2>& p = hatch.stroke.points;
    for (std::size_t i = 1; i < p.size(); ++i)
      add(p[i - 1], p[i], width_of(i - 1), width_of(i), i == 1 && !hatch.free_start,
          i + 1 == p.size() && !hatch.free_end);
    const std::size_t begin = static_cast<std::size_t>(first_) * static_cast<std::size_t>(b_.width);
    for (const std::size_t at : touched_) {
      take(begin + at, own_[at]);
      own_[at] = 0;
    }
    touched_.clear();
  }

 private:
  void add(const Vec2& p, const Vec2& q, double w0, double w1, bool cut_p, bool cut_q) {
    const double reach = 0.5 * std::max(w0, w1) + b_.pixel;
    const auto range = [&](std::size_t k, int from, int to) {
      return std::pair{
          std::max(from, static_cast<int>((std::min(p[k], q[k]) - reach) / b_.pixel)),
          std::min(to - 1, static_cast<int>((std::max(p[k], q[k]) + reach) / b_.pixel))};
    };
    const auto [j0, j1] = range(1, first_, last_);
    if (j0 > j1) return;
    const auto [i0, i1] = range(0, 0, b_.width);
    const Vec2 d = q - p;
    const double squared = dot(d, d);
    for (int y = j0; y <= j1; ++y)
      for (int x = i0; x <= i1; ++x) {
        const Vec2 from = Vec2{(x + 0.5) * b_.pixel, (y + 0.5) * b_.pixel} - p;
        const double along = squared > 0 ? dot(from, d) / squared : 0;
        if ((cut_p && along < 0) || (cut_q && along > 1)) continue;
        const double t = std::clamp(along, 0.0, 1.0);
        // A box across the stroke: its mean over all places is the width, however thin.
        const double r = norm(from - t * d) / b_.pixel,
                     half = 0.5 * (w0 + t * (w1 - w0)) / b_.pixel;
        const double part = std::min(half, r + 0.5) - std::max(-half, r - 0.5);
        if (!(part > 0)) continue;
        const std::size_t at =
            static_cast<std::size_t>(y - first_) * static_cast<std::size_t>(b_.width) +
            static_cast<std::size_t>(x);
        if (own_[at] == 0) touched_.push_back(at);
        own_[at] = std::max(own_[at], static_cast<float>(std::min(1.0, part)));
      }
  }

  const Buffers& b_;
  int first_, last_;
  std::vector<float> own_;
  std::vector<std::size_t> touched_;
};

constexpr int kStripRows = 32;  // of a strip

/// The hatches that may reach each strip, in their order.
std::vector<std::vector<Index>> by_strip(const Buffers& b, const std::vector<Hatch>& hatches) {
  std::vector<std::vector<Index>> strips(
      static_cast<std::size_t>((b.height + kStripRows - 1) / kStripRows));
  for (Index h = 0; h < hatches.size(); ++h) {
    const Stroke& s = hatches[h].stroke;
    double low = HUGE_VAL, high = -HUGE_VAL, width = s.band;
    for (const Vec2& p : s.points) {
      low = std::min(low, p[1]);
      high = std::max(high, p[1]);
    }
    for (const double w : s.widths) width = std::max(width, w);
    const double reach = 0.5 * width + b.pixel, strip = kStripRows * b.pixel;
    const auto last = static_cast<std::ptrdiff_t>(strips.size()) - 1;
    const auto place = [&](double y) {
      return std::clamp(static_cast<std::ptrdiff_t>(y / strip), std::ptrdiff_t{0}, last);
    };
    for (std::ptrdiff_t k = place(low - reach); k <= place(high + reach); ++k)
      strips[static_cast<std::size_t>(k)].push_back(h);
  }
  return strips;
}

}  // namespace

/// Half of the adjacent segments.
std::vector<double> owned_lengths(const std::vector<Vec2>& line) {
  std::vector<double> length(line.size(), 0);
  for (std::size_t i = 1; i < line.size(); ++i) {
    const double half = 0.5 * norm(line[i] - line[i - 1]);
    length[i - 1] += half;
    length[i] += half;
  }
  return length;
}

/// Sums of `top` over sums of `bottom`, over a window of the given length along the line.
std::vector<double> mean_ratio(const std::vector<double>& top, const std::vector<double>& bottom,
                               const std::vector<double>& length, double window) {
  const std::size_t n = top.size();
  std::vector<double> at(n + 1, 0), tops(n + 1, 0), bottoms(n + 1, 0), ratio(n, 0);
  for (std::size_t i = 0; i < n; ++i) {
    at[i + 1] = at[i] + length[i];
    tops[i + 1] = tops[i] + top[i];
    bottoms[i + 1] = bottoms[i] + bottom[i];
  }
  std::size_t first = 0, last = 0;
  for (std::size_t i = 0; i < n; ++i) {
    const double middle = 0.5 * (at[i] + at[i + 1]);
    while (at[first + 1] < middle - 0.5 * window) ++first;
    while (last < n && at[last] < middle + 0.5 * window) ++last;
    const double sum = bottoms[last] - bottoms[first];
    ratio[i] = sum > 0 ? (tops[last] - tops[first]) / sum : 0;
  }
  return ratio;
}

OwnedArea owned_area(const Buffers& b, const std::vector<Hatch>& hatches, double reach) {
  Growth growth(b, hatches, reach);
  growth.run();
  OwnedArea owned;
  for (const Hatch& h : hatches) owned.area.emplace_back(h.stroke.points.size(), 0.0);
  owned.owner.assign(b.size(), {kNone, 0});
  for (std::size_t k = 0; k < b.size(); ++k) {
    const Owner& o = growth.owner[k];
    if (o.hatch == kNone) continue;
    owned.area[o.hatch][o.vertex] += b.pixel * b.pixel;
    owned.owner[k] = {o.hatch, o.vertex};
  }
  for (std::size_t h = 0; h < hatches.size(); ++h) {
    const auto length = owned_lengths(hatches[h].stroke.points);
    owned.spacing.push_back(mean_ratio(owned.area[h], length, length, 2));
  }
  return owned;
}

std::vector<float> coverage(const Buffers& b, const std::vector<Hatch>& hatches) {
  std::vector<float> covered(b.size(), 0);
  const auto strips = by_strip(b, hatches);
  // Pixels of a strip are one thread's: strokes meet them in their own order.
  kernel::parallel_for(std::size_t{0}, strips.size(), [&](std::size_t k) {
    const int first = static_cast<int>(k) * kStripRows;
    Strip strip(b, first, std::min(b.height, first + kStripRows));
    for (const Index h : strips[k]) {
      const Stroke& s = hatches[h].stroke;
      if (s.band > 0)
        strip.cover(
            hatches[h], [&](std::size_t) { return s.band; },
            [&](std::size_t at, float share) { covered[at] *= 1 - share; });
      strip.cover(
          hatches[h], [&](std::size_t i) { return s.widths[i]; },
          [&](std::size_t at, float share) { covered[at] = std::min(1.0F, covered[at] + share); });
    }
  });
  return covered;
}

}  // namespace crest::line_art
