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

constexpr int kFine = 4;  // samples along a pixel
// Where samples stand in their squares, in kFine-ths: all differ along a pixel's rows and columns,
// so that a stroke along an axis is measured as finely as a slanting one.
constexpr int kPlace[kFine] = {0, 2, 3, 1};
constexpr int kStripRows = 32;  // of pixels in a strip

/// The rows of one strip of the page in samples, in black and white.
class Strip {
 public:
  /// Rows of pixels from `first` to before `last`.
  Strip(const Buffers& b, int first, int last)
      : b_(b),
        first_(kFine * first),
        width_(kFine * b.width),
        rows_(static_cast<std::size_t>(kFine * kFine * (last - first))),
        black_(rows_.size() / kFine * static_cast<std::size_t>(width_), 0) {}

  /// Paints the inside of a closed line, by winding numbers.
  void fill(const std::vector<Vec2>& polygon, bool black) {
    const double step = b_.pixel / kFine;
    low_ = rows_.size();
    high_ = 0;
    for (std::size_t i = 0; i < polygon.size(); ++i)
      add_side((1 / step) * polygon[i], (1 / step) * polygon[i + 1 < polygon.size() ? i + 1 : 0]);
    for (std::size_t j = low_; j < high_; ++j) {
      auto& row = rows_[j];
      std::sort(row.begin(), row.end());
      int winding = 0;
      for (std::size_t k = 0; k + 1 < row.size(); ++k) {
        winding += row[k].second;
        if (winding != 0) paint(j, row[k].first, row[k + 1].first, black);
      }
      row.clear();
    }
  }
  /// Adds its shares of black to those of its pixels.
  void add_to(std::vector<float>& share) const {
    const auto w = static_cast<std::size_t>(width_);
    for (std::size_t k = 0; k < black_.size(); ++k)
      if (black_[k] != 0)
        share[(static_cast<std::size_t>(first_) + k / w) / kFine *
                  static_cast<std::size_t>(b_.width) +
              k % w / kFine] += 1.0F / (kFine * kFine);
  }

 private:
  /// Where it passes the rows of samples, kFine in a square. In squares.
  void add_side(const Vec2& a, const Vec2& b) {
    const auto row = [&](double y) {
      return static_cast<std::size_t>(std::clamp(std::ceil(kFine * (y - first_) - 0.5), 0.0,
                                                 static_cast<double>(rows_.size())));
    };
    const auto [from, to] = std::minmax({row(a[1]), row(b[1])});
    if (from == to) return;
    low_ = std::min(low_, from);
    high_ = std::max(high_, to);
    const double slope = (b[0] - a[0]) / (b[1] - a[1]);
    const int sense = a[1] < b[1] ? 1 : -1;
    for (std::size_t j = from; j < to; ++j)
      rows_[j].emplace_back(a[0] + slope * ((static_cast<double>(j) + 0.5) / kFine + first_ - a[1]),
                            sense);
  }
  /// Samples of a row between two places: those of every kFine-th column.
  void paint(std::size_t row, double from, double to, bool black) {
    const std::size_t squares = row / kFine;
    const int phase = kPlace[row % kFine];
    const double offset = (kPlace[squares % kFine] + 0.5) / kFine;
    const auto index = [&](double x) {
      return static_cast<std::ptrdiff_t>(std::clamp(std::ceil((x - offset - phase) / kFine), 0.0,
                                                    static_cast<double>(width_ / kFine)));
    };
    const auto begin = black_.begin() + static_cast<std::ptrdiff_t>(squares) * width_ + phase;
    for (std::ptrdiff_t i = index(from), end = index(to); i < end; ++i)
      begin[kFine * i] = black ? 1 : 0;
  }

  const Buffers& b_;
  int first_, width_;
  std::vector<std::vector<std::pair<double, int>>> rows_;  // places of sides, and their senses
  std::size_t low_ = 0, high_ = 0;                         // rows with such
  std::vector<std::uint8_t> black_;
};

/// What a stroke paints: its band, then itself.
struct Painted {
  std::vector<Vec2> band, ink;
};

/// The hatches that may reach each strip, in their order.
std::vector<std::vector<Index>> by_strip(const Buffers& b, const std::vector<Painted>& painted) {
  std::vector<std::vector<Index>> strips(
      static_cast<std::size_t>((b.height + kStripRows - 1) / kStripRows));
  for (Index h = 0; h < painted.size(); ++h) {
    double low = HUGE_VAL, high = -HUGE_VAL;
    for (const auto* polygon : {&painted[h].band, &painted[h].ink})
      for (const Vec2& p : *polygon) {
        low = std::min(low, p[1]);
        high = std::max(high, p[1]);
      }
    if (!(low <= high)) continue;
    const double strip = kStripRows * b.pixel;
    const auto last = static_cast<std::ptrdiff_t>(strips.size()) - 1;
    const auto place = [&](double y) {
      return std::clamp(static_cast<std::ptrdiff_t>(y / strip), std::ptrdiff_t{0}, last);
    };
    for (std::ptrdiff_t k = place(low); k <= place(high); ++k)
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
  std::vector<Painted> painted(hatches.size());
  kernel::parallel_for(std::size_t{0}, hatches.size(), [&](std::size_t h) {
    const Stroke& s = hatches[h].stroke;
    painted[h] = {s.band > 0 ? band_outline(s) : std::vector<Vec2>{}, outline(s)};
  });
  std::vector<float> covered(b.size(), 0);
  const auto strips = by_strip(b, painted);
  // Pixels of a strip are one thread's: strokes meet them in their own order.
  kernel::parallel_for(std::size_t{0}, strips.size(), [&](std::size_t k) {
    const int first = static_cast<int>(k) * kStripRows;
    Strip strip(b, first, std::min(b.height, first + kStripRows));
    for (const Index h : strips[k]) {
      strip.fill(painted[h].band, false);
      strip.fill(painted[h].ink, true);
    }
    strip.add_to(covered);
  });
  return covered;
}

}  // namespace crest::line_art
