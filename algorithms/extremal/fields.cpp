// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/extremal/fields.hpp"

#include <tbb/blocked_range.h>

#include <algorithm>
#include <cmath>
#include <functional>

#include "kernel/geometry/input_error.hpp"
#include "kernel/geometry/parallel.hpp"

namespace crest::extremal {
namespace {

/// i -> -1 - i at the border, repeated.
int reflected(int i, int n) {
  const int m = ((i % (2 * n)) + 2 * n) % (2 * n);
  return m < n ? m : 2 * n - 1 - m;
}

/// One pass: out[i] = w_0 x[i] + w_1 (x[i-1] + x[i+1]) + ..., x[i] being rows of `width` numbers.
template <class Row>
void pass(const std::vector<double>& w, int i, int n, std::size_t width, const Row& row,
          double* out) {
  const double* x = row(i);
  for (std::size_t k = 0; k < width; ++k) out[k] = w[0] * x[k];
  for (int r = 1; r < static_cast<int>(w.size()); ++r) {
    const double* a = row(reflected(i - r, n));
    const double* b = row(reflected(i + r, n));
    const double weight = w[static_cast<std::size_t>(r)];
    for (std::size_t k = 0; k < width; ++k) out[k] = out[k] + weight * (a[k] + b[k]);
  }
}

/// A slice's passes along x and y, in place.
void smooth_slice(const Grid& g, const Weights& w, double* slice, std::vector<double>& room) {
  const auto nx = static_cast<std::size_t>(g.size[0]), ny = static_cast<std::size_t>(g.size[1]);
  const int radius = static_cast<int>(w[0].size()) - 1;
  if (radius > 0) {
    room.resize(nx + 2 * static_cast<std::size_t>(radius));
    for (std::size_t j = 0; j < ny; ++j) {
      double* row = slice + j * nx;
      for (std::size_t i = 0; i < room.size(); ++i)
        room[i] = row[reflected(static_cast<int>(i) - radius, g.size[0])];
      const double* x = room.data() + radius;
      for (std::size_t i = 0; i < nx; ++i) row[i] = w[0][0] * x[i];
      for (int r = 1; r <= radius; ++r) {
        const double weight = w[0][static_cast<std::size_t>(r)];
        const double *a = x - r, *b = x + r;
        for (std::size_t i = 0; i < nx; ++i) row[i] = row[i] + weight * (a[i] + b[i]);
      }
    }
  }
  if (w[1].size() > 1) {
    room.assign(slice, slice + nx * ny);
    for (std::size_t j = 0; j < ny; ++j)
      pass(
          w[1], static_cast<int>(j), g.size[1], nx,
          [&](int k) { return room.data() + static_cast<std::size_t>(k) * nx; }, slice + j * nx);
  }
}

void check_volume(const Volume& v) {
  for (std::size_t k = 0; k < (v.dimension() == 3 ? 3U : 2U); ++k) {
    if (v.size[k] < 4)
      throw kernel::InputError("size " + std::to_string(v.size[k]) + " along axis " +
                               std::to_string(k) + ": fewer than 4 nodes; give a larger grid");
    if (!(v.spacing[k] > 0 && std::isfinite(v.spacing[k])))
      throw kernel::InputError("spacing along axis " + std::to_string(k) +
                               ": not a positive number; correct the header");
    // Beyond, second derivatives leave the range of floats, and everything would seem flat.
    if (!(v.spacing[k] >= 0x1p-60 && v.spacing[k] <= 0x1p60))
      throw kernel::InputError("spacing along axis " + std::to_string(k) +
                               ": not from 2^-60 to 2^60; choose another unit of length");
    if (!std::isfinite(v.origin[k]))
      throw kernel::InputError("origin along axis " + std::to_string(k) +
                               ": not a number; correct the header");
  }
}

void check_count(const Volume& v, std::size_t count) {
  const double nodes = 1.0 * v.size[0] * v.size[1] * v.size[2];
  if (count != static_cast<std::size_t>(nodes))
    throw kernel::InputError("size: header and number of samples differ; correct the header");
}

template <class Sample>
void check_samples(const std::vector<Sample>& samples, const Grid& grid, const Node& first) {
  const auto bad = std::find_if(samples.begin(), samples.end(),
                                [](Sample x) { return !(std::fabs(x) <= 0x1p60F); });
  if (bad == samples.end()) return;
  Node v = grid.node(static_cast<std::size_t>(bad - samples.begin()));
  for (std::size_t k = 0; k < 3; ++k) v[k] += first[k];
  throw kernel::InputError("sample (" + std::to_string(v[0]) + ", " + std::to_string(v[1]) + ", " +
                           std::to_string(v[2]) +
                           "): not a finite number, or above 2^60; replace it");
}

void check_options(const Options& o) {
  const auto bad = [](double x) { return !(x >= 0 && x <= 1000); };
  if (bad(o.sigma) || bad(o.tensor_sigma.value_or(1)))
    throw kernel::InputError("sigma: not a number from 0 to 1000; choose another");
  if (o.min_value && !std::isfinite(*o.min_value))
    throw kernel::InputError("min-value: not a number; choose another");
  if (!(o.min_strength >= 0 && std::isfinite(o.min_strength)))
    throw kernel::InputError("min-strength: not a number from 0 on; choose another");
}

void check_refinement(const Volume& v, int refine) {
  if (refine < 0 || refine > kMostRefined)
    throw kernel::InputError("refine: not from 0 to " + std::to_string(kMostRefined) +
                             "; choose another");
  double nodes = 1;
  for (std::size_t k = 0; k < 3; ++k) nodes *= std::ldexp(double(v.size[k]) - 1, refine) + 1;
  if (!(nodes <= 0x1p30))
    throw kernel::InputError("more than 2^30 nodes" + std::string(refine > 0 ? ", refined" : "") +
                             "; cut the volume into parts" +
                             (refine > 0 ? ", or refine less" : ""));
}

/// Row i of the refined coefficients from the rows on the coarse grid, mirrored at its ends.
template <class Row, class Number>
void halve(int i, int n, std::size_t width, const Row& row, Number* out) {
  const auto *a = row(std::max(i / 2 - 1, 0)), *b = row(i / 2),
             *c = row(std::min(i / 2 + 1, n - 1));
  for (std::size_t k = 0; k < width; ++k) {
    const auto x = static_cast<double>(a[k]), y = static_cast<double>(b[k]),
               z = static_cast<double>(c[k]);
    out[k] = static_cast<Number>(i % 2 == 0 ? (x + 6 * y + z) / 8 : (y + z) / 2);
  }
}

Grid halved(const Grid& g) {
  std::array<Index, 3> size;
  for (std::size_t k = 0; k < 3; ++k) size[k] = static_cast<Index>(2 * g.size[k] - 1);
  return {size, 0.5 * g.spacing, g.origin};
}

/// Knots between the old ones; fine is halved(coarse).
std::vector<float> halved(const std::vector<float>& c, const Grid& coarse, const Grid& fine) {
  std::vector<float> r(fine.nodes());
  const auto nx = static_cast<std::size_t>(coarse.size[0]);
  const auto ny = static_cast<std::size_t>(coarse.size[1]);
  kernel::parallel_for(0, fine.size[2], [&](int k) {
    std::vector<double> slice(nx * ny), line(nx);
    halve(
        k, coarse.size[2], nx * ny,
        [&](int z) { return c.data() + static_cast<std::size_t>(z) * nx * ny; }, slice.data());
    for (int j = 0; j < fine.size[1]; ++j) {
      halve(
          j, coarse.size[1], nx,
          [&](int y) { return slice.data() + static_cast<std::size_t>(y) * nx; }, line.data());
      float* out = r.data() + fine.index({0, j, k});
      for (int i = 0; i < fine.size[0]; ++i)
        halve(
            i, coarse.size[0], 1, [&](int x) { return line.data() + x; }, out + i);
    }
  });
  return r;
}

double smallest_spacing(const Grid& g) {
  const double s = std::min(g.spacing[0], g.spacing[1]);
  return g.dimension() == 3 ? std::min(s, g.spacing[2]) : s;
}

}  // namespace

Weights smoothing_weights(const Grid& grid, double sigma) {
  Weights r;
  for (std::size_t k = 0; k < 3; ++k) {
    const double sk = sigma * smallest_spacing(grid) / grid.spacing[k];
    const double v = sk * sk - 1.0 / 3;
    r[k] = {1};
    if (v <= 0 || (k == 2 && grid.dimension() == 2)) continue;
    const int radius = static_cast<int>(std::ceil(3 * std::sqrt(v)));
    double total = 1;
    for (int i = 1; i <= radius; ++i) {
      r[k].push_back(std::exp(-(double(i) * i) / (2 * v)));
      total += 2 * r[k].back();
    }
    for (double& w : r[k]) w = w / total;
  }
  return r;
}

void check_frame(const Volume& volume, const Options& options) {
  check_volume(volume);
  check_refinement(volume, options.refine);
  check_options(options);
}

Grid refined(Grid grid, int levels) {
  for (int level = 0; level < levels; ++level) grid = halved(grid);
  return grid;
}

Fields::Fields(const Volume& volume, const Options& options, const Node& first)
    : grid_(volume.size, volume.spacing, volume.origin),
      structure_(options.definition == Definition::structure),
      sign_(options.side == Side::ridge ? -1 : 1) {
  std::visit(
      [&](const auto& samples) {
        check_volume(volume);
        check_count(volume, samples.size());
        check_refinement(volume, options.refine);
        check_samples(samples, grid_, first);
        check_options(options);
        scalar_weights_ = smoothing_weights(grid_, options.sigma);
        tensor_weights_ = smoothing_weights(grid_, options.tensor_sigma.value_or(options.sigma));
        const auto nx = static_cast<std::size_t>(grid_.size[0]);
        const auto ny = static_cast<std::size_t>(grid_.size[1]);
        const auto row = [&](int j, int k) {
          return samples.data() +
                 grid_.index({0, reflected(j, grid_.size[1]), reflected(k, grid_.size[2])});
        };
        smooth(
            [&](int k, double* out) {
              const auto* from = row(0, k);
              for (std::size_t i = 0; i < nx * ny; ++i) out[i] = static_cast<double>(from[i]);
            },
            scalar_weights_, scalars_);
        if (!structure_) return;
        const auto difference = [&](std::size_t axis, int j, int k, double* out) {
          const double two = 2 * grid_.spacing[axis];
          if (axis == 0) {
            const auto* x = row(j, k);
            for (std::size_t i = 0; i < nx; ++i) {
              const auto a = static_cast<double>(x[i + 1 < nx ? i + 1 : i]);
              out[i] = (a - static_cast<double>(x[i > 0 ? i - 1 : i])) / two;
            }
            return;
          }
          const auto* a = axis == 1 ? row(j + 1, k) : row(j, k + 1);
          const auto* b = axis == 1 ? row(j - 1, k) : row(j, k - 1);
          for (std::size_t i = 0; i < nx; ++i)
            out[i] = (static_cast<double>(a[i]) - static_cast<double>(b[i])) / two;
        };
        static constexpr std::array<std::array<std::size_t, 2>, 6> kAxes = {
            {{0, 0}, {1, 1}, {2, 2}, {0, 1}, {1, 2}, {0, 2}}};
        tensors_.resize(grid_.dimension() == 3 ? 6 : 3);
        for (std::size_t t = 0; t < tensors_.size(); ++t)
          smooth(
              [&](int k, double* out) {
                const auto [a, b] = kAxes[entry(t)];
                std::vector<double> second(nx);
                for (std::size_t j = 0; j < ny; ++j, out += nx) {
                  difference(a, static_cast<int>(j), k, out);
                  if (a != b) difference(b, static_cast<int>(j), k, second.data());
                  const double* other = a == b ? out : second.data();
                  for (std::size_t i = 0; i < nx; ++i) out[i] = out[i] * other[i];
                }
              },
              tensor_weights_, tensors_[t]);
      },
      volume.samples);
  for (int level = 0; level < options.refine; ++level) halve_grid();
}

void Fields::halve_grid() {
  const Grid fine = halved(grid_);
  scalars_ = halved(scalars_, grid_, fine);
  for (auto& t : tensors_) t = halved(t, grid_, fine);
  grid_ = fine;
}

Fields::Fields(const Grid& grid, Side side, std::vector<float> scalars,
               std::vector<std::vector<float>> tensors)
    : grid_(grid),
      structure_(!tensors.empty()),
      sign_(side == Side::ridge ? -1 : 1),
      scalar_weights_{{{1}, {1}, {1}}},
      tensor_weights_{{{1}, {1}, {1}}},
      scalars_(std::move(scalars)),
      tensors_(std::move(tensors)) {}

void Fields::smooth(const std::function<void(int, double*)>& slice, const Weights& weights,
                    std::vector<float>& result) const {
  const std::size_t area = grid_.stride[2];
  const int nz = grid_.size[2], radius = static_cast<int>(weights[2].size()) - 1;
  result.resize(grid_.nodes());
  // Parts are long beside the radius: what two of them make twice is little.
  const int part = std::max(16, 4 * radius);
  kernel::parallel_for(0, (nz + part - 1) / part, [&](int p) {
    std::vector<double> room, out(area);
    std::vector<std::vector<double>> ring(static_cast<std::size_t>(2 * radius) + 1);
    std::vector<int> held(ring.size(), -1);
    const auto get = [&](int k) -> const double* {
      // Of the slices within the radius of one, no two share a place but by reflection, which
      // stays within it, too: an index has the same slice.
      const std::size_t place = static_cast<std::size_t>(k) % ring.size();
      if (held[place] != k) {
        ring[place].resize(area);
        slice(k, ring[place].data());
        smooth_slice(grid_, weights, ring[place].data(), room);
        held[place] = k;
      }
      return ring[place].data();
    };
    for (int k = p * part; k < std::min(nz, (p + 1) * part); ++k) {
      float* to = result.data() + static_cast<std::size_t>(k) * area;
      pass(weights[2], k, nz, area, get, out.data());
      for (std::size_t i = 0; i < area; ++i) to[i] = static_cast<float>(out[i]);
    }
  });
  if (!std::all_of(result.begin(), result.end(), [](float x) { return std::isfinite(x); }))
    throw kernel::InputError("samples: too large for binary32; scale them");
}

Coefficients Fields::coefficients(const std::vector<float>& spline, const Node& v) const {
  std::array<std::array<std::size_t, 4>, 3> at;
  for (std::size_t k = 0; k < 3; ++k)
    for (int i = 0; i < 4; ++i)
      at[k][static_cast<std::size_t>(i)] =
          static_cast<std::size_t>(std::clamp(v[k] - 1 + i, 0, grid_.size[k] - 1)) *
          grid_.stride[k];
  Coefficients r;
  const bool inside = v[0] > 0 && v[0] + 2 < grid_.size[0];  // four that follow one another
  for (std::size_t z = 0, n = 0; z < 4; ++z)
    for (std::size_t y = 0; y < 4; ++y, n += 4) {
      const float* const row = spline.data() + at[2][z] + at[1][y];
      if (inside)
        std::copy_n(row + at[0][0], 4, r.begin() + static_cast<std::ptrdiff_t>(n));
      else
        for (std::size_t x = 0; x < 4; ++x) r[n + x] = static_cast<double>(row[at[0][x]]);
    }
  return r;
}

double Fields::below(const Tensor& t) {
  return -2 * (std::fabs(t[0]) + std::fabs(t[1]) + std::fabs(t[3])) - 0x1p-200;
}

Tensor world_hessian(const Tensor& h, const Vec3& d) {
  return {h[0] / (d[0] * d[0]), h[1] / (d[1] * d[1]), h[2] / (d[2] * d[2]),
          h[3] / (d[0] * d[1]), h[4] / (d[1] * d[2]), h[5] / (d[0] * d[2])};
}

Local Fields::at(const Node& v, const Vec3& t) const {
  std::array<std::array<std::array<double, 4>, 3>, 3> w;
  for (std::size_t k = 0; k < 3; ++k)
    for (int order = 0; order < 3; ++order)
      w[k][static_cast<std::size_t>(order)] = kernel::spline_weights(t[k], order);
  // One axis after the other, as spline_value does; derivatives share what they have in common.
  const auto along = [&](std::size_t axis, std::size_t order, const auto& c, auto& out) {
    const auto& u = w[axis][order];
    for (std::size_t i = 0; i < out.size(); ++i)
      out[i] = u[0] * c[4 * i] + u[1] * c[4 * i + 1] + u[2] * c[4 * i + 2] + u[3] * c[4 * i + 3];
  };
  std::array<std::array<double, 16>, 3> by_x;
  std::array<std::array<std::array<double, 4>, 3>, 3> by_xy;
  const auto value = [&](std::size_t a, std::size_t b, std::size_t e) {
    std::array<double, 1> out;
    along(2, e, by_xy[a][b], out);
    return out[0];
  };
  const Coefficients l = coefficients(scalars_, v);
  for (std::size_t a = 0; a < 3; ++a) {
    along(0, a, l, by_x[a]);
    for (std::size_t b = 0; a + b < 3; ++b) along(1, b, by_x[a], by_xy[a][b]);
  }
  const Vec3& d = grid_.spacing;
  Local r;
  r.value = value(0, 0, 0);
  r.s = sign_ * r.value;
  r.gradient = {sign_ * value(1, 0, 0) / d[0], sign_ * value(0, 1, 0) / d[1],
                sign_ * value(0, 0, 1) / d[2]};
  const Tensor h = {value(2, 0, 0), value(0, 2, 0), value(0, 0, 2),
                    value(1, 1, 0), value(0, 1, 1), value(1, 0, 1)};
  r.hessian = world_hessian(h, d);
  for (double& x : r.hessian) x *= sign_;
  r.tensor = r.hessian;
  if (structure_) {
    r.tensor = {};
    for (std::size_t i = 0; i < tensors_.size(); ++i)
      r.tensor[entry(i)] = kernel::spline_value<double, 3>(coefficients(tensors_[i], v),
                                                           {w[0][0], w[1][0], w[2][0]});
  }
  if (grid_.dimension() == 2) r.tensor[2] = below(r.tensor);
  return r;
}

}  // namespace crest::extremal
