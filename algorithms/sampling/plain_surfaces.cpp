// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/sampling/plain_surfaces.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numeric>
#include <random>
#include <utility>

namespace crest::sampling {

PlainSurface strip(unsigned m, unsigned n, Sides ends, Sides sides) {
  PlainSurface s;
  const unsigned columns = ends == Sides::open ? m + 1 : m;
  const unsigned rows = sides == Sides::open ? n + 1 : n;
  const auto at = [&](unsigned i, unsigned j) {
    if (sides != Sides::open && j >= n) {
      j -= n;
      if (sides == Sides::flipped) i = (2 * m - i) % m;
    }
    if (ends != Sides::open && i >= m) {
      i -= m;
      if (ends == Sides::flipped) j = sides == Sides::open ? n - j : (n - j) % n;
    }
    return i + columns * j;
  };
  for (unsigned j = 0; j < rows; ++j) {
    for (unsigned i = 0; i < columns; ++i) {
      const double u = 6.283185307179586 * i / m, v = 6.283185307179586 * j / n;
      const double r = ends == Sides::open ? 1 : 2 + std::cos(v);
      if (ends == Sides::open)
        s.points.push_back({double(i) / m, double(j) / n, 0});
      else
        s.points.push_back({r * std::cos(u), r * std::sin(u), std::sin(v)});
    }
  }
  for (unsigned j = 0; j < n; ++j) {
    for (unsigned i = 0; i < m; ++i) {
      const auto a = at(i, j), b = at(i + 1, j), c = at(i + 1, j + 1), d = at(i, j + 1);
      s.triangles.push_back({a, b, c});
      s.triangles.push_back({a, c, d});
    }
  }
  return s;
}

PlainSurface torus_surface(unsigned m, unsigned n) {
  return strip(m, n, Sides::joined, Sides::joined);
}

PlainSurface plate(unsigned n, unsigned holes, bool thick) {
  PlainSurface s;
  unsigned boxes = 1;
  while (boxes * boxes < holes) ++boxes;
  const auto in_hole = [&](unsigned i, unsigned j) {
    const unsigned bi = i * boxes / n, bj = j * boxes / n;
    if (bi + boxes * bj >= holes) return false;
    const unsigned x = i - (bi * n + boxes - 1) / boxes, y = j - (bj * n + boxes - 1) / boxes;
    const unsigned width = n / boxes;
    return 3 * x >= width && 3 * x < 2 * width && 3 * y >= width && 3 * y < 2 * width;
  };
  const auto solid = [&](long i, long j) {
    return i >= 0 && j >= 0 && i < long(n) && j < long(n) && !in_hole(unsigned(i), unsigned(j));
  };
  std::vector<kernel::Index> number(std::size_t{2} * (n + 1) * (n + 1), kernel::kNone);
  const auto at = [&](unsigned i, unsigned j, unsigned layer) {
    kernel::Index& k = number[layer + std::size_t{2} * (i + std::size_t{n + 1} * j)];
    if (k == kernel::kNone) {
      k = static_cast<kernel::Index>(s.points.size());
      s.points.push_back({double(i) / n, double(j) / n, 0.1 * layer});
    }
    return k;
  };
  const auto quad = [&](kernel::Index a, kernel::Index b, kernel::Index c, kernel::Index d) {
    s.triangles.push_back({a, b, c});
    s.triangles.push_back({a, c, d});
  };
  for (unsigned j = 0; j < n; ++j) {
    for (unsigned i = 0; i < n; ++i) {
      if (in_hole(i, j)) continue;
      const std::array<std::array<unsigned, 2>, 4> c = {
          {{i, j}, {i + 1, j}, {i + 1, j + 1}, {i, j + 1}}};
      const std::array<bool, 4> wall = {!solid(i, long(j) - 1), !solid(i + 1, j), !solid(i, j + 1),
                                        !solid(long(i) - 1, j)};
      const auto p = [&](unsigned k, unsigned layer) { return at(c[k][0], c[k][1], layer); };
      quad(p(0, 1), p(1, 1), p(2, 1), p(3, 1));
      if (!thick) continue;
      quad(p(0, 0), p(3, 0), p(2, 0), p(1, 0));
      for (unsigned k = 0; k < 4; ++k) {
        const unsigned l = (k + 1) % 4;
        if (wall[k]) quad(p(k, 0), p(l, 0), p(l, 1), p(k, 1));
      }
    }
  }
  return s;
}

PlainSurface subdivided(PlainSurface s, unsigned times) {
  for (; times > 0; --times) {
    std::map<std::pair<kernel::Index, kernel::Index>, kernel::Index> middle;
    std::vector<kernel::Triangle> out;
    const auto between = [&](kernel::Index a, kernel::Index b) {
      const auto [it, fresh] =
          middle.try_emplace(std::minmax(a, b), static_cast<kernel::Index>(s.points.size()));
      if (fresh) {
        const auto p = s.points[a], q = s.points[b];
        s.points.push_back({(p[0] + q[0]) / 2, (p[1] + q[1]) / 2, (p[2] + q[2]) / 2});
      }
      return it->second;
    };
    for (const auto& [a, b, c] : s.triangles) {
      const auto x = between(a, b), y = between(b, c), z = between(c, a);
      out.insert(out.end(), {{a, x, z}, {x, b, y}, {z, y, c}, {x, y, z}});
    }
    s.triangles = std::move(out);
  }
  return s;
}

PlainSurface icosphere(unsigned times) {
  const double g = (1 + std::sqrt(5.0)) / 2;
  PlainSurface s;
  s.points = {{-1, g, 0},  {1, g, 0},  {-1, -g, 0}, {1, -g, 0}, {0, -1, g},  {0, 1, g},
              {0, -1, -g}, {0, 1, -g}, {g, 0, -1},  {g, 0, 1},  {-g, 0, -1}, {-g, 0, 1}};
  s.triangles = {{0, 11, 5}, {0, 5, 1},  {0, 1, 7},   {0, 7, 10}, {0, 10, 11},
                 {1, 5, 9},  {5, 11, 4}, {11, 10, 2}, {10, 7, 6}, {7, 1, 8},
                 {3, 9, 4},  {3, 4, 2},  {3, 2, 6},   {3, 6, 8},  {3, 8, 9},
                 {4, 9, 5},  {2, 4, 11}, {6, 2, 10},  {8, 6, 7},  {9, 8, 1}};
  s = subdivided(std::move(s), times);
  for (auto& p : s.points) {
    const double r = std::sqrt(p[0] * p[0] + p[1] * p[1] + p[2] * p[2]);
    p = {p[0] / r, p[1] / r, p[2] / r};
  }
  return s;
}

PlainSurface projective_plane(unsigned times) {
  PlainSurface s;
  for (int k = 0; k < 6; ++k) s.points.push_back({std::cos(k * 1.3), std::sin(k * 1.3), 0.2 * k});
  s.triangles = {{0, 1, 2}, {0, 2, 3}, {0, 3, 4}, {0, 4, 5}, {0, 5, 1},
                 {1, 2, 4}, {2, 3, 5}, {3, 4, 1}, {4, 5, 2}, {5, 1, 3}};
  return subdivided(std::move(s), times);
}

PlainSurface disjoint(PlainSurface a, const PlainSurface& b) {
  const auto shift = static_cast<kernel::Index>(a.points.size());
  a.points.insert(a.points.end(), b.points.begin(), b.points.end());
  for (const auto& t : b.triangles)
    a.triangles.push_back({t[0] + shift, t[1] + shift, t[2] + shift});
  return a;
}

std::vector<double> noise_values(const PlainSurface& s, std::uint64_t seed) {
  std::mt19937_64 random(seed);
  std::uniform_real_distribution<double> uniform(0, 1);
  std::vector<double> values(s.points.size());
  for (double& v : values) v = uniform(random);
  return values;
}

std::vector<double> smooth_values(const PlainSurface& s, std::uint64_t seed, double frequency) {
  std::mt19937_64 random(seed);
  std::uniform_real_distribution<double> uniform(-1, 1);
  std::vector<std::array<double, 5>> waves(64);
  for (auto& w : waves) {
    for (int k = 0; k < 3; ++k) w[std::size_t(k)] = frequency * uniform(random);
    w[3] = 3.141592653589793 * uniform(random);
    w[4] = uniform(random);
  }
  std::vector<double> values;
  for (const auto& p : s.points) {
    double sum = 0;
    for (const auto& w : waves)
      sum += w[4] * std::cos(w[0] * p[0] + w[1] * p[1] + w[2] * p[2] + w[3]);
    values.push_back(sum);
  }
  return values;
}

std::vector<double> quantised(std::vector<double> values, double step) {
  for (double& v : values) v = step * std::floor(v / step) + 0.0;
  return values;
}

VertexOrder order_of(const std::vector<double>& values) {
  VertexOrder o;
  o.order.resize(values.size());
  o.rank.resize(values.size());
  std::iota(o.order.begin(), o.order.end(), 0u);
  std::sort(o.order.begin(), o.order.end(),
            [&](auto a, auto b) { return values[a] != values[b] ? values[a] < values[b] : a < b; });
  for (std::size_t i = 0; i < o.order.size(); ++i)
    o.rank[o.order[i]] = static_cast<kernel::Index>(i);
  return o;
}

}  // namespace crest::sampling
