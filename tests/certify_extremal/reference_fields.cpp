// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/certify_extremal/reference_fields.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>

namespace crest::tests {
namespace {

using certify::ExtremalData;
using Orders = std::array<int, 3>;

long reflect(long i, long n) {
  const long m = ((i % (2 * n)) + 2 * n) % (2 * n);
  return m < n ? m : 2 * n - 1 - m;
}

struct Strides {
  std::array<long, 3> n, stride;
  explicit Strides(const ExtremalData& data)
      : n{data.nodes[0], data.nodes[1], data.nodes[2]}, stride{1, n[0], n[0] * n[1]} {}
  long total() const { return n[0] * n[1] * n[2]; }
  /// The node that many steps away along an axis, mirrored.
  long step(long node, unsigned axis, long by) const {
    const long here = node / stride[axis] % n[axis];
    return node + (reflect(here + by, n[axis]) - here) * stride[axis];
  }
};

double sample(const ExtremalData& data, std::size_t i) {
  const auto read = [&](auto x) {
    std::memcpy(&x, data.samples.data() + i * sizeof x, sizeof x);
    return static_cast<double>(x);
  };
  switch (data.type) {
    case 0:
      return read(std::int8_t{});
    case 1:
      return read(std::uint8_t{});
    case 2:
      return read(std::int16_t{});
    case 3:
      return read(std::uint16_t{});
    case 4:
      return read(std::int32_t{});
    case 5:
      return read(std::uint32_t{});
    case 6:
      return read(std::int64_t{});
    case 7:
      return read(std::uint64_t{});
    case 8:
      return read(float{});
    default:
      return read(double{});
  }
}

std::vector<float> smooth(std::vector<double> field, const ExtremalData& data,
                          const std::array<std::vector<double>, 3>& weights) {
  const Strides grid(data);
  for (unsigned axis = 0; axis < data.dimension; ++axis) {
    if (weights[axis].size() == 1) continue;
    const auto before = field;
    const auto at = [&](long node) { return before[static_cast<std::size_t>(node)]; };
    for (long node = 0; node < grid.total(); ++node) {
      double sum = weights[axis][0] * at(node);
      for (std::size_t r = 1; r < weights[axis].size(); ++r)
        sum = sum + weights[axis][r] * (at(grid.step(node, axis, -static_cast<long>(r))) +
                                        at(grid.step(node, axis, static_cast<long>(r))));
      field[static_cast<std::size_t>(node)] = sum;
    }
  }
  return {field.begin(), field.end()};
}

std::array<double, 4> basis(int order, double t) {
  const double s = 1 - t;
  if (order == 0)
    return {s * s * s / 6, (3 * t * t * t - 6 * t * t + 4) / 6,
            (-3 * t * t * t + 3 * t * t + 3 * t + 1) / 6, t * t * t / 6};
  if (order == 1)
    return {-s * s / 2, (3 * t * t - 4 * t) / 2, (-3 * t * t + 2 * t + 1) / 2, t * t / 2};
  return {s, 3 * t - 2, 1 - 3 * t, t};
}

/// Bezier values from coefficients, by order.
std::array<double, 4> bezier(int order, const std::array<double, 4>& c) {
  if (order == 0)
    return {(c[0] + 4 * c[1] + c[2]) / 6, (2 * c[1] + c[2]) / 3, (c[1] + 2 * c[2]) / 3,
            (c[1] + 4 * c[2] + c[3]) / 6};
  if (order == 1) {
    const double b0 = (c[2] - c[0]) / 2, b1 = c[2] - c[1], b2 = (c[3] - c[1]) / 2;
    return {b0, (b0 + 2 * b1) / 3, (2 * b1 + b2) / 3, b2};
  }
  const double d0 = c[0] - 2 * c[1] + c[2], d1 = c[1] - 2 * c[2] + c[3];
  return {d0, (2 * d0 + d1) / 3, (d0 + 2 * d1) / 3, d1};
}

}  // namespace

double dot(const Vec& a, const Vec& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}
Vec image(const Sym& m, const Vec& a) {
  return {dot(m[0], a), dot(m[1], a), dot(m[2], a)};
}
Vec unit(const Vec& a) {
  const double n = std::sqrt(dot(a, a));
  return {a[0] / n, a[1] / n, a[2] / n};
}

Eigen3 eigen(Sym m) {
  Sym v{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
  for (int sweep = 0; sweep < 8; ++sweep)
    for (std::size_t p = 0; p < 3; ++p)
      for (std::size_t q = p + 1; q < 3; ++q) {
        if (std::fabs(m[p][q]) < 1e-17 * (std::fabs(m[p][p]) + std::fabs(m[q][q]))) continue;
        const double angle = 0.5 * std::atan2(2 * m[p][q], m[q][q] - m[p][p]);
        const double c = std::cos(angle), s = std::sin(angle);
        for (auto& row : m) {
          const double x = row[p], y = row[q];
          row[p] = c * x - s * y;
          row[q] = s * x + c * y;
        }
        for (std::size_t k = 0; k < 3; ++k) {
          const double x = m[p][k], y = m[q][k];
          m[p][k] = c * x - s * y;
          m[q][k] = s * x + c * y;
          const double a = v[p][k], b = v[q][k];
          v[p][k] = c * a - s * b;
          v[q][k] = s * a + c * b;
        }
      }
  std::array<std::size_t, 3> order{0, 1, 2};
  std::ranges::sort(order, [&](auto a, auto b) { return m[a][a] > m[b][b]; });
  Eigen3 out;
  for (std::size_t i = 0; i < 3; ++i) {
    out.values[i] = m[order[i]][order[i]];
    out.vectors[i] = v[order[i]];
  }
  return out;
}

ReferenceFields::ReferenceFields(const ExtremalData& d)
    : data(d), nodes(d.nodes[0] * d.nodes[1] * d.nodes[2]) {
  const Strides grid(data);
  std::vector<double> samples(nodes);
  for (std::size_t i = 0; i < nodes; ++i) samples[i] = sample(data, i);
  l_ = smooth(samples, data, data.weights);
  for (unsigned i = 0; i < 3; ++i)
    for (unsigned j = 0; j < 3; ++j) {
      std::vector<double> product(nodes, 0);
      const auto difference = [&](long node, unsigned k) {
        const auto value = [&](long step) {
          return samples[static_cast<std::size_t>(grid.step(node, k, step))];
        };
        return (value(1) - value(-1)) / (2 * data.spacing[k]);
      };
      if (!data.hessian && std::max(i, j) < data.dimension)
        for (long node = 0; node < grid.total(); ++node)
          product[static_cast<std::size_t>(node)] = difference(node, i) * difference(node, j);
      t_[i][j] = smooth(product, data, data.tensor_weights);
    }
}

Vec ReferenceFields::place(std::uint32_t node) const {
  return {static_cast<double>(node % data.nodes[0]),
          static_cast<double>(node / data.nodes[0] % data.nodes[1]),
          static_cast<double>(node / data.nodes[0] / data.nodes[1])};
}

double ReferenceFields::value(const std::vector<float>& c, const Vec& at,
                              const Orders& order) const {
  const Strides grid(data);
  std::array<std::array<double, 4>, 3> weights;
  long base = 0;
  for (unsigned k = 0; k < 3; ++k) {
    const long most = std::max(0L, grid.n[k] - 2);
    const long low = std::min(static_cast<long>(std::floor(at[k])), most);
    weights[k] = basis(order[k], at[k] - static_cast<double>(low));
    base += low * grid.stride[k];
  }
  double sum = 0;
  for (long i = 0; i < 64; ++i) {
    const std::array<long, 3> step = {i % 4, i / 4 % 4, i / 16};
    long node = base;
    double weight = 1;
    for (unsigned k = 0; k < 3; ++k) {
      node = grid.step(node, k, step[k] - 1);
      weight *= weights[k][static_cast<std::size_t>(step[k])];
    }
    sum += weight * static_cast<double>(c[static_cast<std::size_t>(node)]);
  }
  return sum;
}

PointFields ReferenceFields::at(const Vec& place) const {
  PointFields out{};
  const double sign = data.valley ? 1 : -1;
  out.l = value(l_, place, {0, 0, 0});
  for (unsigned i = 0; i < 3; ++i) {
    Orders order{};
    order[i] = 1;
    out.gradient[i] = i < data.dimension ? sign * value(l_, place, order) / data.spacing[i] : 0;
    for (unsigned j = 0; j < 3; ++j) {
      Orders orders{};
      ++orders[i];
      ++orders[j];
      out.hessian[i][j] = std::max(i, j) < data.dimension ? sign * value(l_, place, orders) /
                                                                (data.spacing[i] * data.spacing[j])
                                                          : 0;
      out.tensor[i][j] = data.hessian ? out.hessian[i][j] : value(t_[i][j], place, {0, 0, 0});
    }
  }
  if (data.dimension == 2) out.tensor[2][2] = -1e9;
  return out;
}

std::vector<double> ReferenceFields::controls(const std::vector<float>& c, std::uint32_t cell,
                                              const Orders& order) const {
  if (cell != near_cell_) {
    const Strides grid(data);
    near_cell_ = cell;
    for (long i = 0; i < 64; ++i) {
      long node = grid.step(cell, 0, i % 4 - 1);
      node = grid.step(node, 1, i / 4 % 4 - 1);
      near_[static_cast<std::size_t>(i)] = static_cast<std::size_t>(grid.step(node, 2, i / 16 - 1));
    }
  }
  std::vector<double> at(64);
  for (std::size_t i = 0; i < 64; ++i) at[i] = static_cast<double>(c[near_[i]]);
  std::size_t stride = 1;
  for (unsigned axis = 0; axis < 3; ++axis, stride *= 4)
    for (std::size_t i = 0; i < 64; ++i) {
      if (i / stride % 4 != 0) continue;
      const auto row =
          bezier(order[axis], {at[i], at[i + stride], at[i + 2 * stride], at[i + 3 * stride]});
      for (std::size_t k = 0; k < 4; ++k) at[i + k * stride] = row[k];
    }
  return at;
}

std::vector<double> ReferenceFields::l_controls(std::uint32_t cell, const Orders& order) const {
  return controls(l_, cell, order);
}
std::vector<double> ReferenceFields::t_controls(std::uint32_t cell, unsigned i, unsigned j,
                                                const Orders& order) const {
  return controls(t_[i][j], cell, order);
}

std::vector<PointFields> ReferenceFields::controls(std::uint32_t cell) const {
  std::vector<PointFields> out(64, PointFields{});
  const double sign = data.valley ? 1 : -1;
  for (unsigned i = 0; i < data.dimension; ++i) {
    Orders order{};
    order[i] = 1;
    const auto v = l_controls(cell, order);
    for (std::size_t n = 0; n < 64; ++n) out[n].gradient[i] = sign * v[n] / data.spacing[i];
    for (unsigned j = i; j < data.dimension; ++j) {
      Orders orders{};
      ++orders[i];
      ++orders[j];
      const auto h = l_controls(cell, orders);
      const auto t = data.hessian ? h : t_controls(cell, i, j, {0, 0, 0});
      for (std::size_t n = 0; n < 64; ++n) {
        const double second = sign * h[n] / (data.spacing[i] * data.spacing[j]);
        out[n].hessian[i][j] = out[n].hessian[j][i] = second;
        out[n].tensor[i][j] = out[n].tensor[j][i] = data.hessian ? second : t[n];
      }
    }
  }
  const auto l = l_controls(cell, {0, 0, 0});
  for (std::size_t n = 0; n < 64; ++n) {
    out[n].l = l[n];
    if (data.dimension == 2) out[n].tensor[2][2] = -1e9;
  }
  return out;
}

std::array<PointFields, 4> ReferenceFields::edge(std::uint32_t node, unsigned axis) const {
  const auto all = controls(node);
  std::array<PointFields, 4> out;
  for (std::size_t i = 0; i < 4; ++i) out[i] = all[i << (2 * axis)];
  return out;
}

PointFields on_edge(const std::array<PointFields, 4>& net, double t) {
  const double s = 1 - t;
  const std::array<double, 4> weights = {s * s * s, 3 * s * s * t, 3 * s * t * t, t * t * t};
  PointFields out{};
  for (std::size_t k = 0; k < 4; ++k) {
    out.l += weights[k] * net[k].l;
    for (std::size_t i = 0; i < 3; ++i) {
      out.gradient[i] += weights[k] * net[k].gradient[i];
      for (std::size_t j = 0; j < 3; ++j) {
        out.hessian[i][j] += weights[k] * net[k].hessian[i][j];
        out.tensor[i][j] += weights[k] * net[k].tensor[i][j];
      }
    }
  }
  return out;
}

std::vector<double> smoothing_weights(double sigma) {
  const double variance = sigma * sigma - 1.0 / 3;
  if (variance <= 0) return {1};
  std::vector<double> weights;
  double total = 0;
  for (int r = 0; r <= static_cast<int>(std::ceil(3 * std::sqrt(variance))); ++r) {
    weights.push_back(std::exp(-(r * r) / (2 * variance)));
    total += r == 0 ? weights.back() : 2 * weights.back();
  }
  for (double& w : weights) w /= total;
  return weights;
}

ExtremalData make_data(std::array<std::uint32_t, 3> nodes, const std::vector<float>& samples,
                       Vec spacing, double sigma) {
  ExtremalData data;
  data.dimension = nodes[2] == 1 ? 2 : 3;
  data.nodes = nodes;
  data.spacing = spacing;
  data.sigma = data.tensor_sigma = sigma;
  const double least = data.dimension == 2 ? std::min(spacing[0], spacing[1])
                                           : std::min({spacing[0], spacing[1], spacing[2]});
  for (unsigned k = 0; k < 3; ++k)
    data.weights[k] = data.tensor_weights[k] = k < data.dimension
                                                   ? smoothing_weights(sigma * (least / spacing[k]))
                                                   : std::vector<double>{1};
  data.samples.resize(samples.size() * sizeof(float));
  std::memcpy(data.samples.data(), samples.data(), data.samples.size());
  return data;
}

}  // namespace crest::tests
