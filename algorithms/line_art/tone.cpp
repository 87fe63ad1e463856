// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/line_art/tone.hpp"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>

namespace crest::line_art {
namespace {

using kernel::dot, kernel::norm;
using kernel::operator+, kernel::operator-, kernel::operator*;

constexpr double kBlur = 1.2;  // spacings: within it tone is compared

struct Owner {
  Index hatch = kNone, vertex = 0;
};

/// Which vertex is nearest to every pixel, grown from the vertices over open links.
class Growth {
 public:
  Growth(const Buffers& b, const std::vector<Hatch>& hatches, double reach)
      : b_(b), hatches_(hatches), owner(b.size()), reach_(reach), buckets_(kBuckets) {}

  void run() {
    for (Index h = 0; h < hatches_.size(); ++h)
      for (Index v = 0; v < hatches_[h].stroke.points.size(); ++v)
        if (const auto at = b_.at(hatches_[h].stroke.points[v])) offer(*at, {h, v});
    for (std::size_t k = 0; k < buckets_.size(); ++k)
      for (std::size_t i = 0; i < buckets_[k].size(); ++i) {
        const auto [at, by] = buckets_[k][i];
        if (owner[at].hatch != by.hatch || owner[at].vertex != by.vertex) continue;
        spread(at, by);
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

/// A Gaussian of a standard deviation in pixels, by three running means.
void blur(std::vector<float>& image, int width, int height, double deviation) {
  const int radius = std::max(
      1, static_cast<int>(std::lround(0.5 * (std::sqrt(4 * deviation * deviation + 1) - 1))));
  const auto pass = [&](std::size_t start, std::size_t stride, int n) {
    std::vector<float> line(static_cast<std::size_t>(n));
    for (int round = 0; round < 3; ++round) {
      double sum = 0;
      const auto value = [&](int i) {
        return i < 0 || i >= n ? 0.0F : image[start + stride * static_cast<std::size_t>(i)];
      };
      for (int i = -radius; i <= radius; ++i) sum += static_cast<double>(value(i));
      for (int i = 0; i < n; ++i) {
        line[static_cast<std::size_t>(i)] = static_cast<float>(sum / (2 * radius + 1));
        sum += static_cast<double>(value(i + radius + 1)) - static_cast<double>(value(i - radius));
      }
      for (int i = 0; i < n; ++i)
        image[start + stride * static_cast<std::size_t>(i)] = line[static_cast<std::size_t>(i)];
    }
  };
  const auto w = static_cast<std::size_t>(width);
  // Lines are on their own; columns beside each other share what the cache holds.
  using Range = tbb::blocked_range<std::size_t>;
  tbb::parallel_for(Range(0, static_cast<std::size_t>(height), 16), [&](const Range& range) {
    for (std::size_t j = range.begin(); j != range.end(); ++j) pass(j * w, 1, width);
  });
  tbb::parallel_for(Range(0, w, 16), [&](const Range& range) {
    for (std::size_t i = range.begin(); i != range.end(); ++i) pass(i, w, height);
  });
}

/// The share of every pixel under a stroke of these widths, in `own`, which was zero.
void cover(const Buffers& b, const Stroke& s, const std::vector<double>& widths,
           std::vector<float>& own, std::vector<std::size_t>& touched) {
  const auto& p = s.points;
  for (std::size_t i = 1; i < p.size(); ++i) {
    const double w0 = widths[i - 1], w1 = widths[i];
    const double reach = 0.5 * std::max(w0, w1) + b.pixel;
    const Vec2 d = p[i] - p[i - 1];
    const double squared = dot(d, d);
    const auto range = [&](std::size_t k, int limit) {
      return std::pair{
          std::max(0, static_cast<int>((std::min(p[i - 1][k], p[i][k]) - reach) / b.pixel)),
          std::min(limit - 1,
                   static_cast<int>((std::max(p[i - 1][k], p[i][k]) + reach) / b.pixel))};
    };
    const auto [i0, i1] = range(0, b.width);
    const auto [j0, j1] = range(1, b.height);
    for (int y = j0; y <= j1; ++y)
      for (int x = i0; x <= i1; ++x) {
        const std::size_t at = static_cast<std::size_t>(y) * static_cast<std::size_t>(b.width) +
                               static_cast<std::size_t>(x);
        const Vec2 q = b.centre(at) - p[i - 1];
        const double t = squared > 0 ? std::clamp(dot(q, d) / squared, 0.0, 1.0) : 0;
        // A box across the stroke: its mean over all places is the width, however thin.
        const double r = norm(q - t * d) / b.pixel, half = 0.5 * (w0 + t * (w1 - w0)) / b.pixel;
        const double part = std::min(half, r + 0.5) - std::max(-half, r - 0.5);
        if (!(part > 0)) continue;
        if (own[at] == 0) touched.push_back(at);
        own[at] = std::max(own[at], static_cast<float>(std::min(1.0, part)));
      }
  }
}

}  // namespace

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
  std::vector<float> covered(b.size(), 0), own(b.size(), 0);
  std::vector<std::size_t> touched;
  for (const Hatch& h : hatches) {
    if (h.stroke.band > 0) {
      cover(b, h.stroke, std::vector<double>(h.stroke.points.size(), h.stroke.band), own, touched);
      for (const std::size_t at : touched) {
        covered[at] *= 1 - own[at];
        own[at] = 0;
      }
      touched.clear();
    }
    cover(b, h.stroke, h.stroke.widths, own, touched);
    for (const std::size_t at : touched) {
      covered[at] = std::min(1.0F, covered[at] + own[at]);
      own[at] = 0;
    }
    touched.clear();
  }
  return covered;
}

std::vector<float> layer_ink(const Buffers& b, const ToneOptions& o) {
  std::vector<float> ink(b.size(), 0);
  for (std::size_t k = 0; k < b.size(); ++k) {
    const double c = static_cast<double>(b.luminance[k]);
    if (b.face[k] != kNone && c <= o.brightest)
      ink[k] = static_cast<float>(1 - std::max(c, o.darkest));
  }
  return ink;
}

namespace {

class Widths {
 public:
  Widths(const Buffers& b, const std::vector<float>& ink, const ToneOptions& o,
         std::vector<Hatch>& hatches, const OwnedArea& owned)
      : b_(b), ink_(ink), o_(o), hatches_(hatches), owned_(owned) {}

  void run() {
    for (std::size_t h = 0; h < hatches_.size(); ++h) start(h);
    apply();
    mask_.resize(b_.size());
    for (std::size_t k = 0; k < b_.size(); ++k) mask_[k] = b_.face[k] != kNone ? 1.0F : 0.0F;
    wanted_ = ink_;
    blur(wanted_, b_.width, b_.height, kBlur * o_.spacing / b_.pixel);
    for (int round = 0; round < o_.corrections; ++round) correct();
  }

 private:
  double ink_at(const Vec2& p) const {
    const auto at = b_.at(p);
    return at ? static_cast<double>(ink_[*at]) : 0;
  }

  void start(std::size_t h) {
    const auto& p = hatches_[h].stroke.points;
    const auto length = owned_lengths(p);
    std::vector<double> wanted(p.size());
    for (std::size_t i = 0; i < p.size(); ++i) wanted[i] = ink_at(p[i]) * length[i];
    const auto mean = mean_ratio(wanted, length, length, 1);
    std::vector<double> plain(p.size());
    for (std::size_t i = 0; i < p.size(); ++i) plain[i] = mean[i] * owned_.spacing[h][i];
    plain_.push_back(std::move(plain));
  }

  /// Bounds, and tapers where ends are free.
  void apply() {
    for (std::size_t h = 0; h < hatches_.size(); ++h) {
      Stroke& s = hatches_[h].stroke;
      const auto length = owned_lengths(s.points);
      double total = 0, at = 0;
      for (const double x : length) total += x;
      // In the dark a long taper is a white slit.
      const auto taper = [&](const Vec2& end) {
        return std::min((1.2 - 0.9 * ink_at(end)) * o_.spacing, 0.35 * total);
      };
      const double from = taper(s.points.front()), to = taper(s.points.back());
      s.widths.assign(s.points.size(), 0);
      for (std::size_t i = 0; i < s.points.size(); ++i) {
        at += 0.5 * length[i];
        double share = 1;
        if (hatches_[h].free_start) share = std::min(share, at / from);
        if (hatches_[h].free_end) share = std::min(share, (total - at) / to);
        at += 0.5 * length[i];
        const double w = std::clamp(plain_[h][i], o_.thinnest, o_.cap * o_.spacing);
        s.widths[i] = std::max(0.4 * o_.thinnest, w * std::clamp(share, 0.0, 1.0));
      }
    }
  }

  void correct() {
    std::vector<float> have = coverage(b_, hatches_);
    for (std::size_t k = 0; k < b_.size(); ++k)
      if (mask_[k] == 0) have[k] = 0;
    blur(have, b_.width, b_.height, kBlur * o_.spacing / b_.pixel);
    for (std::size_t h = 0; h < hatches_.size(); ++h)
      for (std::size_t i = 0; i < plain_[h].size(); ++i) {
        const auto at = b_.at(hatches_[h].stroke.points[i]);
        if (!at || !(have[*at] > 1e-4F)) continue;
        const double factor = static_cast<double>(wanted_[*at]) / static_cast<double>(have[*at]);
        plain_[h][i] = std::min(plain_[h][i] * std::clamp(factor, 0.8, 1.25), o_.cap * o_.spacing);
      }
    apply();
  }

  const Buffers& b_;
  const std::vector<float>& ink_;
  const ToneOptions& o_;
  std::vector<Hatch>& hatches_;
  const OwnedArea& owned_;
  std::vector<std::vector<double>> plain_;
  std::vector<float> mask_, wanted_;
};

}  // namespace

void set_widths(const Buffers& buffers, const std::vector<float>& ink, const ToneOptions& options,
                const OwnedArea& owned, std::vector<Hatch>& hatches) {
  Widths(buffers, ink, options, hatches, owned).run();
}

std::vector<Index> bit_reversed(Index n) {
  unsigned bits = 0;
  while ((Index{1} << bits) < n) ++bits;
  std::vector<Index> order;
  for (Index j = 0; j < Index{1} << bits; ++j) {
    Index reversed = 0;
    for (unsigned k = 0; k < bits; ++k) reversed |= (j >> k & 1U) << (bits - 1 - k);
    if (reversed < n) order.push_back(reversed);
  }
  return order;
}

void set_bands(const Buffers& b, const std::vector<float>& ink, const ToneOptions& o,
               std::vector<Hatch>& hatches) {
  for (Hatch& h : hatches) {
    Stroke& s = h.stroke;
    s.band = o.spacing;
    s.widths.clear();
    for (const Vec2& p : s.points) {
      const auto at = b.at(p);
      s.widths.push_back(at ? o.spacing * static_cast<double>(ink[*at]) : 0);
    }
  }
  // Runs of one segment, each in its own order.
  std::vector<Hatch> ordered;
  for (std::size_t i = 0, end = 0; i < hatches.size(); i = end) {
    for (end = i; end < hatches.size() && hatches[end].stroke.segment == hatches[i].stroke.segment;)
      ++end;
    for (const Index k : bit_reversed(static_cast<Index>(end - i))) {
      ordered.push_back(std::move(hatches[i + k]));
      ordered.back().stroke.rank = static_cast<Index>(ordered.size() - 1);
    }
  }
  hatches = std::move(ordered);
}

std::vector<float> crossing_ink(const Buffers& b, const ToneOptions& o, bool plain) {
  std::vector<float> ink(b.size(), 0);
  for (std::size_t k = 0; k < b.size(); ++k) {
    const double lack = o.darkest - static_cast<double>(b.luminance[k]);
    if (b.face[k] != kNone && lack > 0)
      ink[k] = static_cast<float>(plain ? lack : lack / o.darkest);
  }
  return ink;
}

std::vector<float> crossed(std::vector<float> a, const std::vector<float>& b) {
  for (std::size_t k = 0; k < a.size(); ++k) a[k] = 1 - (1 - a[k]) * (1 - b[k]);
  return a;
}

ToneError tone_error(const Buffers& b, const std::vector<float>& black,
                     const std::vector<float>& ink, double spacing) {
  const int cell = std::max(1, static_cast<int>(std::lround(5 * spacing / b.pixel)));
  std::vector<double> errors;
  for (int j = 0; j < b.height; j += cell)
    for (int i = 0; i < b.width; i += cell) {
      double sum = 0, count = 0;
      for (int y = j; y < std::min(b.height, j + cell); ++y)
        for (int x = i; x < std::min(b.width, i + cell); ++x) {
          const std::size_t at = static_cast<std::size_t>(y) * static_cast<std::size_t>(b.width) +
                                 static_cast<std::size_t>(x);
          if (b.face[at] == kNone) continue;
          sum += static_cast<double>(black[at] - ink[at]);
          ++count;
        }
      if (2 * count > cell * cell) errors.push_back(std::abs(sum / count));
    }
  ToneError e;
  e.cells = errors.size();
  if (errors.empty()) return e;
  std::sort(errors.begin(), errors.end());
  for (const double x : errors) e.mean += x / static_cast<double>(errors.size());
  e.p95 = errors[(errors.size() - 1) * 95 / 100];
  e.max = errors.back();
  return e;
}

}  // namespace crest::line_art
