// SPDX-License-Identifier: GPL-3.0-or-later
#include "certify/extremal/fields.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>

#include "certify/container/byte_reader.hpp"
#include "certify/container/reject.hpp"
#include "kernel/arithmetic/interval.hpp"

namespace crest::certify::extremal {
namespace {

using kernel::Interval;

template <class Bits, class Sample>
void read_samples(const ExtremalData& data, Buffer<double>& out) {
  ByteReader reader(data.samples);
  for (double& x : out) {
    const auto sample = std::bit_cast<Sample>(reader.integer<Bits>());
    x = static_cast<double>(sample);
    if constexpr (sizeof(Sample) == 8 && std::is_integral_v<Sample>)
      require(std::cmp_less_equal(sample, std::int64_t{1} << 53) &&
                  std::cmp_greater_equal(sample, -(std::int64_t{1} << 53)),
              "samples: an integer is larger than 2^53");
  }
}

Buffer<double> read_samples(const ExtremalData& data, size_t count) {
  Buffer<double> out(count);
  switch (data.type) {
    case 0:
      read_samples<std::uint8_t, std::int8_t>(data, out);
      break;
    case 1:
      read_samples<std::uint8_t, std::uint8_t>(data, out);
      break;
    case 2:
      read_samples<std::uint16_t, std::int16_t>(data, out);
      break;
    case 3:
      read_samples<std::uint16_t, std::uint16_t>(data, out);
      break;
    case 4:
      read_samples<std::uint32_t, std::int32_t>(data, out);
      break;
    case 5:
      read_samples<std::uint32_t, std::uint32_t>(data, out);
      break;
    case 6:
      read_samples<std::uint64_t, std::int64_t>(data, out);
      break;
    case 7:
      read_samples<std::uint64_t, std::uint64_t>(data, out);
      break;
    case 8:
      read_samples<std::uint32_t, float>(data, out);
      break;
    default:
      read_samples<std::uint64_t, double>(data, out);
  }
  return out;
}

/// Of a row that is mirrored at its ends.
size_t reflect(std::int64_t i, std::int64_t n) {
  std::int64_t m = i % (2 * n);
  if (m < 0) m += 2 * n;
  return static_cast<size_t>(m < n ? m : 2 * n - 1 - m);
}

size_t layer_size(const Grid& grid) {
  return grid.stride[grid.dimension - 1];
}

/// One pass along an axis but the last, on blocks of rows that lie side by side in a layer: all
/// nodes with one last coordinate.
void smooth_along(double* layer, const Grid& grid, unsigned axis,
                  const std::vector<double>& weights) {
  if (weights.size() == 1) return;
  const size_t n = grid.nodes[axis], stride = grid.stride[axis];
  const size_t block = std::min<size_t>(stride, 64);
  const auto radius = static_cast<std::int64_t>(weights.size()) - 1;
  std::vector<double> padded((n + 2 * static_cast<size_t>(radius)) * block);
  for (size_t slab = 0; slab < layer_size(grid); slab += n * stride)
    for (size_t first = 0; first < stride; first += block) {
      const size_t width = std::min(block, stride - first);
      double* const base = layer + slab + first;
      for (std::int64_t i = -radius; i < static_cast<std::int64_t>(n) + radius; ++i)
        std::copy_n(base + reflect(i, static_cast<std::int64_t>(n)) * stride, width,
                    padded.data() + static_cast<size_t>(i + radius) * width);
      for (size_t i = 0; i < n; ++i) {
        double* const out = base + i * stride;
        const double* const centre = padded.data() + (i + static_cast<size_t>(radius)) * width;
        for (size_t j = 0; j < width; ++j) out[j] = weights[0] * centre[j];
        for (size_t r = 1; r < weights.size(); ++r) {
          const double *low = centre - r * width, *high = centre + r * width;
          for (size_t j = 0; j < width; ++j) out[j] = out[j] + weights[r] * (low[j] + high[j]);
        }
      }
    }
}

/// Smooths along all axes what `make(k, layer)` writes for the k-th layer, asked in turn; no more
/// layers are held than the weights reach.
template <class Make>
Buffer<float> smooth(const Make& make, const Grid& grid,
                     const std::array<std::vector<double>, 3>& weights) {
  const unsigned last = grid.dimension - 1;
  const std::vector<double>& w = weights[last];
  const size_t n = grid.nodes[last], size = layer_size(grid), radius = w.size() - 1;
  const size_t held = std::min(n, 2 * radius + 1);
  Buffer<double> ring(held * size);
  std::vector<double> sum(size);
  const auto layer = [&](std::int64_t k) {
    return ring.data() + reflect(k, static_cast<std::int64_t>(n)) % held * size;
  };
  Buffer<float> out(grid.count);
  bool finite = true;
  for (size_t k = 0, made = 0; k < n; ++k) {
    for (; made < std::min(n, k + radius + 1); ++made) {
      double* const at = layer(static_cast<std::int64_t>(made));
      make(made, at);
      for (unsigned axis = 0; axis < last; ++axis) smooth_along(at, grid, axis, weights[axis]);
    }
    const auto here = static_cast<std::int64_t>(k);
    const double* const centre = layer(here);
    for (size_t j = 0; j < size; ++j) sum[j] = w[0] * centre[j];
    for (size_t r = 1; r <= radius; ++r) {
      const auto step = static_cast<std::int64_t>(r);
      const double *low = layer(here - step), *high = layer(here + step);
      for (size_t j = 0; j < size; ++j) sum[j] = sum[j] + w[r] * (low[j] + high[j]);
    }
    for (size_t j = 0; j < size; ++j) {
      const float x = out[k * size + j] = static_cast<float>(sum[j]);
      finite = (std::fabs(x) < HUGE_VALF) & finite;
    }
  }
  require(finite, "coefficients: one is not finite");
  return out;
}

/// One row of n blocks of that size, mirrored at its ends, with a knot more between any two.
void insert_knots(const double* in, size_t n, size_t block, double* out) {
  const auto at = [&](size_t i, size_t j) { return in[i * block + j]; };
  for (size_t i = 0; i < n; ++i)
    for (size_t j = 0; j < block; ++j) {
      const double low = at(i == 0 ? 0 : i - 1, j), here = at(i, j);
      const double high = at(i + 1 == n ? i : i + 1, j);
      out[2 * i * block + j] = ((low + 6 * here) + high) / 8;
      if (i + 1 < n) out[(2 * i + 1) * block + j] = (here + high) / 2;
    }
}

Place halved(const Grid& grid) {
  Place nodes = grid.nodes;
  for (unsigned k = 0; k < grid.dimension; ++k) nodes[k] = 2 * nodes[k] - 1;
  return nodes;
}

/// The same spline on the grid of half the spacing (SPEC.md, "Coefficients").
Buffer<float> halve_grid(const Buffer<float>& coefficients, const Grid& grid) {
  Buffer<double> values(coefficients.size());
  std::copy(coefficients.begin(), coefficients.end(), values.begin());
  Place nodes = grid.nodes;
  for (unsigned axis = grid.dimension; axis-- > 0;) {
    const size_t n = nodes[axis], block = grid.stride[axis], row = n * block;
    nodes[axis] = 2 * nodes[axis] - 1;
    const size_t wide = nodes[axis] * block, rows = values.size() / row;
    Buffer<double> out(rows * wide);
    for (size_t r = 0; r < rows; ++r)
      insert_knots(values.data() + r * row, n, block, out.data() + r * wide);
    values = std::move(out);
  }
  Buffer<float> out(values.size());
  for (size_t i = 0; i < out.size(); ++i) out[i] = static_cast<float>(values[i]);
  return out;
}

/// Central differences along an axis in one layer.
void differences(const Buffer<double>& samples, const Grid& grid, unsigned axis, double spacing,
                 size_t layer, double* out) {
  const size_t n = grid.nodes[axis], stride = grid.stride[axis];
  const size_t size = layer_size(grid), first = layer * size;
  const double twice = 2 * spacing;
  const auto row = [&](size_t i, size_t base, size_t width, size_t at) {
    const double* const low = samples.data() + base + (i == 0 ? 0 : i - 1) * stride;
    const double* const high = samples.data() + base + (i + 1 == n ? n - 1 : i + 1) * stride;
    for (size_t j = 0; j < width; ++j) out[at + j] = (high[j] - low[j]) / twice;
  };
  if (axis == grid.dimension - 1) return row(layer, 0, size, 0);
  for (size_t slab = 0; slab < size; slab += n * stride)
    for (size_t i = 0; i < n; ++i) row(i, first + slab, stride, slab + i * stride);
}

/// The smoothed products of two differences.
Buffer<float> smooth_product(const Buffer<double>& samples, const Fields& fields, unsigned i,
                             unsigned j, const ExtremalData& data) {
  const Grid& grid = fields.grid;
  std::vector<double> other(layer_size(grid));
  const auto product = [&](size_t k, double* layer) {
    differences(samples, grid, i, fields.spacing[i], k, layer);
    differences(samples, grid, j, fields.spacing[j], k, other.data());
    for (size_t n = 0; n < other.size(); ++n) layer[n] = layer[n] * other[n];
  };
  return smooth(product, grid, data.tensor_weights);
}

/// The weights of offsets 0 to R, normalised.
std::vector<Interval> enclose_weights(const Interval& variance, size_t count) {
  std::vector<Interval> weights;
  Interval total(0.0);
  for (size_t r = 0; r < count; ++r) {
    const double offset = static_cast<double>(r);
    weights.push_back(exp(Interval(-offset * offset) / (Interval(2.0) * variance)));
    total = total + (r == 0 ? Interval(1.0) : Interval(2.0)) * weights.back();
  }
  for (Interval& w : weights) w = w / total;
  return weights;
}

/// SPEC.md, "Weights". Relative error 2^-40: exp differs in its last digits from machine to
/// machine.
void check_weights(const std::vector<double>& weights, double sigma, double least, double spacing) {
  const kernel::RoundUpward guard;
  const Interval scaled = Interval(sigma) * Interval(least) / Interval(spacing);
  const Interval variance = scaled * scaled - Interval(1.0) / Interval(3.0);
  if (weights.size() == 1) {
    require(weights[0] == 1 && variance.inf() <= 0x1p-40, "weights: smoothing is missing");
    return;
  }
  // R = ceil(3 sqrt v); either, where v is next to a step.
  const double radius = static_cast<double>(weights.size()) - 1;
  const Interval nine = Interval(9.0) * variance;
  require(variance.inf() > 0 && nine.sup() * (1 + 0x1p-40) >= (radius - 1) * (radius - 1) &&
              nine.inf() * (1 - 0x1p-40) <= radius * radius,
          "weights: the radius {} is not that of sigma {}", weights.size() - 1, sigma);
  const auto exact = enclose_weights(variance, weights.size());
  for (size_t r = 0; r < weights.size(); ++r)
    require(weights[r] >= exact[r].inf() * (1 - 0x1p-40) &&
                weights[r] <= exact[r].sup() * (1 + 0x1p-40),
            "weights: one is not that of sigma {}", sigma);
}

}  // namespace

Grid::Grid(unsigned dimension, const Place& nodes) : dimension(dimension), nodes(nodes) {
  stride = {1, nodes[0], nodes[0] * nodes[1]};
  count = stride[2] * nodes[2];
}

void check_weights(const ExtremalData& data) {
  double least = data.spacing[0];
  for (unsigned k = 1; k < data.dimension; ++k) least = std::min(least, data.spacing[k]);
  for (unsigned k = 0; k < data.dimension; ++k) {
    check_weights(data.weights[k], data.sigma, least, data.spacing[k]);
    if (data.hessian)
      require(data.tensor_weights[k] == std::vector<double>{1}, "weights: of no tensor field");
    else
      check_weights(data.tensor_weights[k], data.tensor_sigma, least, data.spacing[k]);
  }
}

Fields make_fields(const ExtremalData& data) {
  Fields fields{
      Grid(data.dimension, data.nodes), data.hessian, data.valley, data.spacing, {}, {}, {}};
  const Grid& grid = fields.grid;
  const Buffer<double> samples = read_samples(data, grid.count);
  if (!data.hessian)
    for (unsigned i = 0; i < grid.dimension; ++i)
      for (unsigned j = i; j < grid.dimension; ++j)
        fields.t[kComponent[i][j]] = smooth_product(samples, fields, i, j, data);
  const auto as_it_is = [&](size_t k, double* layer) {
    std::copy_n(samples.data() + k * layer_size(grid), layer_size(grid), layer);
  };
  fields.l = smooth(as_it_is, grid, data.weights);
  for (unsigned k = 0; k < 3; ++k)
    fields.inverse_spacing[k] = k < data.dimension ? 1 / fields.spacing[k] : 0;
  return fields;
}

void halve_grid(Fields& fields) {
  fields.l = halve_grid(fields.l, fields.grid);
  for (auto& t : fields.t)
    if (!t.empty()) t = halve_grid(t, fields.grid);
  fields.grid = Grid(fields.grid.dimension, halved(fields.grid));
  for (unsigned k = 0; k < fields.grid.dimension; ++k) {
    fields.spacing[k] /= 2;
    fields.inverse_spacing[k] = 1 / fields.spacing[k];
  }
}

}  // namespace crest::certify::extremal
