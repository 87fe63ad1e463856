// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Marching tets on the mode as a scalar, each tet in n^3 parts: what users do today.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <numeric>
#include <unordered_map>
#include <vector>

#include "kernel/arithmetic/vec3.hpp"

namespace crest::experiments {

using Tensor = std::array<double, 6>;
using Tet = std::array<std::uint32_t, 4>;

inline double mode_of(const Tensor& a) {
  const double m = (a[0] + a[1] + a[2]) / 3, x = a[0] - m, y = a[1] - m, z = a[2] - m;
  const double det =
      x * (y * z - a[4] * a[4]) - a[3] * (a[3] * z - a[4] * a[5]) + a[5] * (a[3] * a[4] - y * a[5]);
  const double n = x * x + y * y + z * z + 2 * (a[3] * a[3] + a[4] * a[4] + a[5] * a[5]);
  return n > 0 ? 3 * std::sqrt(6.0) * det / (n * std::sqrt(n)) : 0;
}

/// A tet's lattice: its points by four numbers with sum n, and the tets of the cut into n^3.
struct Lattice {
  std::vector<std::array<int, 4>> points;
  std::vector<Tet> tets;

  explicit Lattice(int n) {
    // The tet 0 <= z <= y <= x <= n of the cubic grid, cubes in six: its parts are n^3.
    std::unordered_map<int, std::uint32_t> number;
    const auto point = [&](const std::array<int, 3>& p) {
      const auto [at, made] = number.emplace((p[0] * 8 + p[1]) * 8 + p[2], points.size());
      if (made) points.push_back({n - p[0], p[0] - p[1], p[1] - p[2], p[2]});
      return at->second;
    };
    std::array<int, 3> order{0, 1, 2};
    for (int c = 0; c < n * n * n; ++c) {
      const std::array<int, 3> cube{c % n, c / n % n, c / n / n};
      std::sort(order.begin(), order.end());
      do {
        Tet tet;
        std::array<int, 3> p = cube;
        bool inside = true;
        for (std::size_t s = 0; s < 4; ++s) {
          if (s) ++p[static_cast<std::size_t>(order[s - 1])];
          inside = inside && p[0] >= p[1] && p[1] >= p[2];
          if (inside) tet[s] = point(p);
        }
        if (inside) tets.push_back(tet);
      } while (std::next_permutation(order.begin(), order.end()));
    }
  }
};

inline std::uint64_t mixed(std::uint64_t x) {
  x ^= x >> 31;
  x *= 0x9e3779b97f4a7c15;
  return x ^ x >> 29;
}

/// The surface as marching tets make it: vertices are cut edges of the lattice, named by hashes.
class Marching {
 public:
  /// points: of the vertices, or none: then the surface has no places.
  Marching(const std::vector<Tensor>& tensors, const std::vector<kernel::Vec3>& points,
           double level)
      : tensors_(tensors), points_(points), level_(level) {}

  /// Whether the surface passes the tet, as far as its lattice tells.
  bool add(const Tet& tet, const Lattice& lattice, int n) {
    std::array<std::size_t, 4> order{0, 1, 2, 3};
    std::sort(order.begin(), order.end(), [&](auto a, auto b) { return tet[a] < tet[b]; });
    nodes_.resize(lattice.points.size());
    bool up = false, down = false;
    for (std::size_t i = 0; i < nodes_.size(); ++i) {
      Node& node = nodes_[i];
      node = {};
      for (const std::size_t c : order) {
        const int w = lattice.points[i][c];
        if (w == 0) continue;
        node.key = mixed(node.key + mixed((std::uint64_t{tet[c]} << 8) + static_cast<unsigned>(w)));
        for (std::size_t k = 0; k < 6; ++k)
          node.tensor[k] += static_cast<double>(w) / n * tensors_[tet[c]][k];
        for (std::size_t k = 0; k < 3 && !points_.empty(); ++k)
          node.place[k] += static_cast<double>(w) / n * points_[tet[c]][k];
      }
      node.mode = mode_of(node.tensor);
      (node.mode >= level_ ? up : down) = true;
    }
    if (!up || !down) return false;
    for (const Tet& part : lattice.tets) march(part);
    return true;
  }
  const std::vector<kernel::Vec3>& places() const { return places_; }
  const std::vector<std::array<std::uint32_t, 3>>& triangles() const { return triangles_; }

  struct Count {
    long components = 0, euler = 0, loops = 0;
    std::size_t triangles = 0;
    double error = 0;
  };
  Count count() {
    Count c;
    c.triangles = triangles_.size();
    c.error = error_;
    std::unordered_map<std::uint64_t, int> edges;
    std::vector<std::uint32_t> parent(numbers_.size()), rim(numbers_.size());
    std::iota(parent.begin(), parent.end(), 0u);
    std::iota(rim.begin(), rim.end(), 0u);
    const auto key = [](std::uint32_t a, std::uint32_t b) {
      return std::uint64_t{std::min(a, b)} << 32 | std::max(a, b);
    };
    const auto find = [](std::vector<std::uint32_t>& p, std::uint32_t x) {
      while (p[x] != x) x = p[x] = p[p[x]];
      return x;
    };
    for (const auto& t : triangles_)
      for (std::size_t k = 0; k < 3; ++k) {
        ++edges[key(t[k], t[(k + 1) % 3])];
        parent[find(parent, t[k])] = find(parent, t[(k + 1) % 3]);
      }
    std::vector<bool> on_rim(numbers_.size());
    for (const auto& [edge, n] : edges)
      if (n == 1) {
        const auto a = static_cast<std::uint32_t>(edge >> 32), b = static_cast<std::uint32_t>(edge);
        on_rim[a] = on_rim[b] = true;
        rim[find(rim, a)] = find(rim, b);
      }
    for (std::uint32_t v = 0; v < parent.size(); ++v) {
      c.components += find(parent, v) == v;
      c.loops += on_rim[v] && find(rim, v) == v;
    }
    c.euler = static_cast<long>(numbers_.size()) - static_cast<long>(edges.size()) +
              static_cast<long>(triangles_.size());
    return c;
  }

 private:
  struct Node {
    std::uint64_t key = 0;
    Tensor tensor{};
    kernel::Vec3 place{};
    double mode = 0;
  };
  struct Cut {
    std::uint32_t number;
    Tensor tensor;
  };
  Cut cut(const Node& a, const Node& b) {
    const Node &low = a.key < b.key ? a : b, &high = a.key < b.key ? b : a;
    const auto made = numbers_.emplace(mixed(low.key + mixed(high.key)), numbers_.size());
    Cut c{made.first->second, {}};
    const double t = (level_ - low.mode) / (high.mode - low.mode);
    for (std::size_t k = 0; k < 6; ++k) c.tensor[k] = (1 - t) * low.tensor[k] + t * high.tensor[k];
    if (made.second) {
      auto& p = places_.emplace_back();
      for (std::size_t k = 0; k < 3; ++k) p[k] = (1 - t) * low.place[k] + t * high.place[k];
    }
    return c;
  }
  void march(const Tet& part) {
    std::vector<const Node*> up, down;
    for (const std::uint32_t i : part) (nodes_[i].mode >= level_ ? up : down).push_back(&nodes_[i]);
    if (up.empty() || down.empty()) return;
    using kernel::operator-;
    upwards_ = up[0]->place - down[0]->place;
    if (up.size() == 2) {
      const Cut a = cut(*up[0], *down[0]), b = cut(*up[0], *down[1]), c = cut(*up[1], *down[1]),
                d = cut(*up[1], *down[0]);
      triangle(a, b, c);
      triangle(a, c, d);
      return;
    }
    const auto& one = up.size() == 1 ? up : down;
    const auto& three = up.size() == 1 ? down : up;
    triangle(cut(*one[0], *three[0]), cut(*one[0], *three[1]), cut(*one[0], *three[2]));
  }
  void triangle(const Cut& a, const Cut& b, const Cut& c) {
    triangles_.push_back({a.number, b.number, c.number});
    if (!points_.empty()) turn(triangles_.back());
    Tensor centre;
    for (std::size_t k = 0; k < 6; ++k) centre[k] = (a.tensor[k] + b.tensor[k] + c.tensor[k]) / 3;
    error_ = std::max(error_, std::fabs(mode_of(centre) - level_));
  }

  /// Anticlockwise seen from above the level.
  void turn(std::array<std::uint32_t, 3>& t) const {
    using kernel::operator-;
    const auto &a = places_[t[0]], &b = places_[t[1]], &c = places_[t[2]];
    if (kernel::dot(kernel::cross(b - a, c - a), upwards_) < 0) std::swap(t[1], t[2]);
  }

  const std::vector<Tensor>& tensors_;
  const std::vector<kernel::Vec3> points_;
  double level_, error_ = 0;
  kernel::Vec3 upwards_{};  // of the part at hand
  std::vector<Node> nodes_;
  std::unordered_map<std::uint64_t, std::uint32_t> numbers_;
  std::vector<kernel::Vec3> places_;
  std::vector<std::array<std::uint32_t, 3>> triangles_;
};

}  // namespace crest::experiments
