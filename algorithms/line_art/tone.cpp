// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/line_art/tone.hpp"

#include <tbb/blocked_range.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "kernel/geometry/parallel.hpp"

namespace crest::line_art {
namespace {

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
  kernel::parallel_for(Range(0, static_cast<std::size_t>(height), 16), [&](const Range& range) {
    for (std::size_t j = range.begin(); j != range.end(); ++j) pass(j * w, 1, width);
  });
  kernel::parallel_for(Range(0, w, 16), [&](const Range& range) {
    for (std::size_t i = range.begin(); i != range.end(); ++i) pass(i, w, height);
  });
}

}  // namespace

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

/// The widths of all layers, corrected together.
class Widths {
 public:
  Widths(const Buffers& b, const std::vector<Layer>& layers, const ToneOptions& o)
      : b_(b), layers_(layers), o_(o) {}

  void run() {
    wanted_.assign(b_.size(), 0);
    for (const Layer& layer : layers_) {
      plain_.emplace_back();
      for (std::size_t h = 0; h < layer.hatches.size(); ++h) start(layer, h);
      wanted_ = crossed(std::move(wanted_), layer.ink);
    }
    apply();
    std::array<std::vector<float>, kBlurs.size()> blurred_wanted;
    for (std::size_t k = 0; k < kBlurs.size(); ++k) blurred_wanted[k] = blurred(wanted_, kBlurs[k]);
    for (int round = 0; round < kRounds; ++round) {
      const std::size_t k = static_cast<std::size_t>(round) % kBlurs.size();
      correct(blurred_wanted[k], kBlurs[k]);
    }
  }

 private:
  /// Spacings within which tone is compared, in turn.
  static constexpr std::array kBlurs = {2.0, 1.2};
  static constexpr int kRounds = 5;
  static constexpr double kNarrowest = 0.5, kWidest = 1.3;  ///< spacings a stroke answers for

  double ink_at(const Layer& layer, const Vec2& p) const {
    const auto at = b_.at(p);
    return at ? static_cast<double>(layer.ink[*at]) : 0;
  }

  void start(const Layer& layer, std::size_t h) {
    const auto& p = layer.hatches[h].stroke.points;
    const auto length = owned_lengths(p);
    std::vector<double> wanted(p.size());
    for (std::size_t i = 0; i < p.size(); ++i) wanted[i] = ink_at(layer, p[i]) * length[i];
    const auto mean = mean_ratio(wanted, length, length, 1);
    std::vector<double> plain(p.size());
    for (std::size_t i = 0; i < p.size(); ++i)
      plain[i] = mean[i] * std::min(layer.owned.spacing[h][i], kWidest * o_.spacing);
    plain_.back().push_back(std::move(plain));
  }

  /// No wider than leaves white beside it.
  double cap(const Layer& layer, std::size_t h, std::size_t i) const {
    return o_.cap *
           std::clamp(layer.owned.spacing[h][i], kNarrowest * o_.spacing, kWidest * o_.spacing);
  }

  /// Bounds, and tapers where ends are free.
  void apply() {
    for (std::size_t l = 0; l < layers_.size(); ++l)
      for (std::size_t h = 0; h < layers_[l].hatches.size(); ++h)
        apply(layers_[l], h, plain_[l][h]);
  }
  void apply(const Layer& layer, std::size_t h, const std::vector<double>& plain) {
    Hatch& hatch = layer.hatches[h];
    Stroke& s = hatch.stroke;
    const auto length = owned_lengths(s.points);
    double total = 0, at = 0;
    for (const double x : length) total += x;
    // In the dark a long taper is a white slit.
    const auto taper = [&](const Vec2& end) {
      return std::min((1.2 - 0.9 * ink_at(layer, end)) * o_.spacing, 0.35 * total);
    };
    const double from = taper(s.points.front()), to = taper(s.points.back());
    s.widths.assign(s.points.size(), 0);
    for (std::size_t i = 0; i < s.points.size(); ++i) {
      at += 0.5 * length[i];
      double share = 1;
      if (hatch.free_start) share = std::min(share, at / from);
      if (hatch.free_end) share = std::min(share, (total - at) / to);
      // An ellipse's: a straight taper ends a wide stroke like an arrow.
      share = std::clamp(share, 0.0, 1.0);
      share = std::sqrt(share * (2 - share));
      at += 0.5 * length[i];
      const double w = std::clamp(plain[i], o_.thinnest, cap(layer, h, i));
      s.widths[i] = std::max(0.4 * o_.thinnest, w * share);
    }
  }

  /// Of the surface alone, within so many spacings.
  std::vector<float> blurred(std::vector<float> image, double reach) const {
    for (std::size_t k = 0; k < b_.size(); ++k)
      if (b_.face[k] == kNone) image[k] = 0;
    blur(image, b_.width, b_.height, reach * o_.spacing / b_.pixel);
    return image;
  }

  void correct(const std::vector<float>& wanted, double reach) {
    std::vector<float> have(b_.size(), 0);
    for (const Layer& layer : layers_) have = crossed(std::move(have), coverage(b_, layer.hatches));
    have = blurred(std::move(have), reach);
    for (std::size_t l = 0; l < layers_.size(); ++l)
      for (std::size_t h = 0; h < plain_[l].size(); ++h)
        for (std::size_t i = 0; i < plain_[l][h].size(); ++i) {
          const auto at = b_.at(layers_[l].hatches[h].stroke.points[i]);
          if (!at || !(have[*at] > 1e-4F)) continue;
          const double factor = static_cast<double>(wanted[*at]) / static_cast<double>(have[*at]);
          double& w = plain_[l][h][i];
          w = std::min(w * std::clamp(factor, 0.8, 1.25), cap(layers_[l], h, i));
        }
    apply();
  }

  const Buffers& b_;
  const std::vector<Layer>& layers_;
  const ToneOptions& o_;
  std::vector<std::vector<std::vector<double>>> plain_;  ///< by layer, hatch, point
  std::vector<float> wanted_;
};

}  // namespace

void set_widths(const Buffers& buffers, const std::vector<Layer>& layers,
                const ToneOptions& options) {
  if (!layers.empty()) Widths(buffers, layers, options).run();
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

std::vector<ToneCell> tone_cells(const Buffers& b, const std::vector<float>& black,
                                 const std::vector<float>& ink, const OwnedArea& owned,
                                 double spacing) {
  const int size = std::max(1, static_cast<int>(std::lround(5 * spacing / b.pixel)));
  std::vector<ToneCell> cells;
  for (int j = 0; j < b.height; j += size) {
    kernel::stop_point();
    for (int i = 0; i < b.width; i += size) {
      ToneCell cell{{i * b.pixel, j * b.pixel}, 0, 0, 0};
      double count = 0;
      for (int y = j; y < std::min(b.height, j + size); ++y)
        for (int x = i; x < std::min(b.width, i + size); ++x) {
          const std::size_t at = static_cast<std::size_t>(y) * static_cast<std::size_t>(b.width) +
                                 static_cast<std::size_t>(x);
          if (b.face[at] == kNone) continue;
          cell.black += static_cast<double>(black[at]);
          cell.ink += static_cast<double>(ink[at]);
          if (ink[at] > 0 && owned.owner[at].first == kNone) ++cell.bare;
          ++count;
        }
      if (2 * count <= size * size) continue;
      for (double* x : {&cell.black, &cell.ink, &cell.bare}) *x /= count;
      cells.push_back(cell);
    }
  }
  return cells;
}

ToneError tone_error(std::vector<ToneCell> cells) {
  ToneError e;
  const auto error = [](const ToneCell& c) { return std::abs(c.black - c.ink); };
  std::stable_sort(cells.begin(), cells.end(),
                   [&](const ToneCell& x, const ToneCell& y) { return error(x) > error(y); });
  e.cells = std::move(cells);
  if (e.cells.empty()) return e;
  const std::size_t n = e.cells.size();
  for (const ToneCell& c : e.cells) e.mean += error(c) / static_cast<double>(n);
  e.p95 = error(e.cells[n - 1 - (n - 1) * 95 / 100]);
  e.max = error(e.cells.front());
  return e;
}

}  // namespace crest::line_art
