// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/splines/active_cubes.hpp"

#include <tbb/blocked_range2d.h>
#include <tbb/enumerable_thread_specific.h>

#include <algorithm>
#include <atomic>
#include <bit>
#include <cmath>

#include "kernel/arithmetic/wide_clones.hpp"
#include "kernel/geometry/parallel.hpp"

namespace crest::splines {
namespace {

constexpr std::size_t kBatch = 256;  ///< cubes of a row at once: what is in between stays in cache

using Row = std::array<float, kBatch + 2>;

/// Nine rows of samples less c, by y + 3 z.
using Rows = std::array<const float*, 9>;

/// Least and greatest of a cube's a_v, a_e, a_c: these span the others.
CREST_WIDE_CLONES void hull(const Rows& f, std::size_t count, float* lows, float* highs) {
  std::array<float, kBatch> low_of, high_of;  // which no row may overlap
  std::array<std::array<Row, 2>, 2> sum;      // over {y, y + 1} x {z, z + 1}
  std::array<Row, 2> along_y, along_z;        // over {z, z + 1} at y = 1; over {y, y + 1} at z = 1
  for (std::size_t i = 0; i < count + 2; ++i) {
    float pair[3][2];
    for (std::size_t z = 0; z < 3; ++z)
      for (std::size_t s = 0; s < 2; ++s) pair[z][s] = f[s + 3 * z][i] + f[s + 1 + 3 * z][i];
    for (std::size_t s = 0; s < 2; ++s) {
      for (std::size_t u = 0; u < 2; ++u) sum[s][u][i] = pair[u][s] + pair[u + 1][s];
      along_z[s][i] = pair[1][s];
      along_y[s][i] = f[1 + 3 * s][i] + f[4 + 3 * s][i];
    }
  }
  for (std::size_t i = 0; i < count; ++i) {
    float low = HUGE_VALF, high = -HUGE_VALF;
    const auto take = [&](float x) {
      low = x < low ? x : low;
      high = x > high ? x : high;
    };
    for (std::size_t x = 0; x < 2; ++x)
      for (std::size_t s = 0; s < 2; ++s) {
        const float ey = 0.25F * (along_y[s][i + x] + along_y[s][i + x + 1]);
        take(ey);
        take(0.25F * (along_z[s][i + x] + along_z[s][i + x + 1]));
        for (std::size_t u = 0; u < 2; ++u) {
          const float ez = 0.25F * (along_z[u][i + x] + along_z[u][i + x + 1]);
          const float ex = 0.25F * sum[u][s][i + 1];
          const float v = 0.125F * (sum[u][s][i + x] + sum[u][s][i + x + 1]);
          take(ex);
          take(v);
          take(0.5F * ((ex + ey) + (ez - v)));
        }
      }
    low_of[i] = low;
    high_of[i] = high;
  }
  std::copy_n(low_of.begin(), count, lows);
  std::copy_n(high_of.begin(), count, highs);
}

/// What floats hold of samples.
struct Shown {
  double level, scale;
  float operator()(double x) const { return static_cast<float>((x - level) * scale); }
};

/// One sample row, at indices that may lie one beyond the volume.
template <class Native>
void load_row(const QuadraticSpline& spline, const std::vector<Native>& samples, const Shown& shown,
              int from, std::size_t count, int y, int z, float* row) {
  const auto& size = spline.grid().size;
  const auto weight_of = [](int v, std::size_t n, int k) {
    const bool beyond = v < 0 || v >= static_cast<int>(n);
    return beyond ? (k == 0 ? 2 : -1) : 1 - k;
  };
  const auto place_of = [](int v, std::size_t n, int k) {
    if (v < 0) return static_cast<std::size_t>(k);
    if (v >= static_cast<int>(n)) return n - 1 - static_cast<std::size_t>(k);
    return static_cast<std::size_t>(v);
  };
  const auto sample = [&](int x) {
    double sum = 0;
    for (int k = 0; k < 8; ++k) {
      const int w = weight_of(x, size[0], k & 1) * weight_of(y, size[1], k >> 1 & 1) *
                    weight_of(z, size[2], k >> 2);
      if (w != 0)
        sum += w * static_cast<double>(samples[place_of(x, size[0], k & 1) +
                                               size[0] * (place_of(y, size[1], k >> 1 & 1) +
                                                          size[1] * place_of(z, size[2], k >> 2))]);
    }
    return shown(sum);
  };
  const auto inside = [](int v, std::size_t n) { return v >= 0 && v < static_cast<int>(n); };
  if (!inside(y, size[1]) || !inside(z, size[2])) {
    for (std::size_t i = 0; i < count; ++i) row[i] = sample(from + static_cast<int>(i));
    return;
  }
  const Native* p = samples.data() +
                    size[0] * (static_cast<std::size_t>(y) + size[1] * static_cast<std::size_t>(z));
  std::size_t begin = 0, end = count;
  if (from < 0) row[begin++] = sample(from);
  if (from + static_cast<int>(count) > static_cast<int>(size[0])) {
    --end;
    row[end] = sample(from + static_cast<int>(end));
  }
  for (std::size_t i = begin; i < end; ++i)
    row[i] = shown(static_cast<double>(p[from + static_cast<int>(i)]));
}

std::size_t word_count(const std::array<int, 3>& size) {
  return static_cast<std::size_t>(size[0]) * static_cast<std::size_t>(size[1]) *
         static_cast<std::size_t>(size[2]);
}

}  // namespace

double scale_to_one(double largest) {
  if (!(largest > 0 && largest < HUGE_VAL)) return 1;
  return std::ldexp(1.0, -std::clamp(std::ilogb(largest), -1000, 1000));
}

void for_each_row_hull(const QuadraticSpline& spline, double c, double scale, const RowWork& work) {
  const Shown shown{c, scale};
  const Cube n = spline.cubes();
  const int from = spline.frame().first() - 1;
  const auto size = static_cast<std::size_t>(n[0]);
  struct Buffer {
    std::array<std::vector<float>, 9> samples;  ///< y % 3 + 3 z: from row to row six stay
    std::vector<float> low, high;
  };
  tbb::enumerable_thread_specific<Buffer> buffers;
  kernel::parallel_for(tbb::blocked_range2d<int>(0, n[2], 4, 0, n[1], 64), [&](const auto& range) {
    Buffer& buffer = buffers.local();
    for (auto& row : buffer.samples) row.resize(size + 2);
    buffer.low.resize(size);
    buffer.high.resize(size);
    const int first = range.cols().begin();
    for (int z = range.rows().begin(); z < range.rows().end(); ++z)
      for (int y = first; y < range.cols().end(); ++y) {
        Rows rows;
        for (int k = 0; k < 9; ++k) {
          auto& row = buffer.samples[static_cast<std::size_t>((y + k % 3) % 3 + k / 3 * 3)];
          rows[static_cast<std::size_t>(k)] = row.data();
          if (y > first && k % 3 < 2) continue;
          std::visit(
              [&](const auto& samples) {
                load_row(spline, samples, shown, from, size + 2, y + from + k % 3, z + from + k / 3,
                         row.data());
              },
              spline.grid().samples);
        }
        for (std::size_t x = 0; x < size; x += kBatch) {
          Rows here;
          for (std::size_t k = 0; k < 9; ++k) here[k] = rows[k] + x;
          hull(here, std::min(kBatch, size - x), buffer.low.data() + x, buffer.high.data() + x);
        }
        work(y, z, buffer.low, buffer.high);
      }
  });
}

ActiveCubes::ActiveCubes(const QuadraticSpline& spline, double c) {
  const Cube n = spline.cubes();
  Level cubes{};
  for (std::size_t k = 0; k < 3; ++k) cubes.size[k] = (n[k] + 3) / 4;
  // A bound of |coefficient - c|: no more than 9/8 of the largest sample.
  largest_ = 1.25 * spline.largest_sample() + std::fabs(c);
  margin_ = 0x1p-18 * largest_;
  // Floats have no digits to spare below 2^-126, and end at 2^128.
  const double scale = scale_to_one(largest_);
  const auto margin = static_cast<float>(margin_ * scale * (1 + 0x1p-20));
  cubes.words.assign(word_count(cubes.size), 0);
  std::atomic<std::size_t> count{0};
  tbb::enumerable_thread_specific<std::array<float, 2>> extremes(
      std::array<float, 2>{HUGE_VALF, -HUGE_VALF});
  for_each_row_hull(
      spline, c, scale, [&](int y, int z, std::span<const float> low, std::span<const float> high) {
        auto& extreme = extremes.local();
        std::uint64_t* row =
            cubes.words.data() + static_cast<std::size_t>(cubes.size[0]) *
                                     static_cast<std::size_t>(y / 4 + cubes.size[1] * (z / 4));
        const int shift = bit(0, y, z);
        std::size_t here = 0;
        for (std::size_t i = 0; i < low.size(); i += 4) {
          std::uint64_t bits = 0;
          for (std::size_t k = i; k < std::min(i + 4, low.size()); ++k) {
            // Not: beyond the margin. So NaN counts as active.
            bits |= std::uint64_t{!(low[k] > margin || high[k] < -margin)} << (k & 3);
            extreme[0] = low[k] < extreme[0] ? low[k] : extreme[0];
            extreme[1] = high[k] > extreme[1] ? high[k] : extreme[1];
          }
          if (bits == 0) continue;
          here += static_cast<std::size_t>(std::popcount(bits));
          std::atomic_ref(row[i / 4]).fetch_or(bits << shift, std::memory_order_relaxed);
        }
        count.fetch_add(here, std::memory_order_relaxed);
      });
  count_ = count;
  float lowest = HUGE_VALF, highest = -HUGE_VALF;
  for (const auto& e : extremes) {
    lowest = std::fmin(lowest, e[0]);
    highest = std::fmax(highest, e[1]);
  }
  range_ = (static_cast<double>(highest) - static_cast<double>(lowest)) / scale + margin_;
  levels_.push_back(std::move(cubes));
  while (levels_.back().words.size() > 1) {
    const Level& low = levels_.back();
    Level high{};
    for (std::size_t k = 0; k < 3; ++k) high.size[k] = (low.size[k] + 3) / 4;
    high.words.assign(word_count(high.size), 0);
    std::size_t i = 0;
    for (int z = 0; z < low.size[2]; ++z)
      for (int y = 0; y < low.size[1]; ++y)
        for (int x = 0; x < low.size[0]; ++x, ++i)
          if (low.words[i] != 0)
            high.words[static_cast<std::size_t>(x / 4 +
                                                high.size[0] * (y / 4 + high.size[1] * (z / 4)))] |=
                std::uint64_t{1} << bit(x, y, z);
    levels_.push_back(std::move(high));
  }
}

}  // namespace crest::splines
