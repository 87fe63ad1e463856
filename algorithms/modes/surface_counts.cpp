// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/modes/surface_counts.hpp"

#include <algorithm>
#include <numeric>
#include <stdexcept>

#include "kernel/geometry/disjoint_sets.hpp"

namespace crest::modes {
namespace {

using kernel::DisjointSets;
using kernel::Index;

/// A triangle's side, by its corners.
struct TriangleSide {
  Index a, b;  ///< a < b
  Index triangle;
  bool forward;  ///< the triangle goes from a to b
};

/// By a, b, triangle: by the first corner in one pass, then each corner's few.
std::vector<TriangleSide> sides_of(const ModeSurface& s) {
  std::vector<std::size_t> end(s.points.size() + 1, 0);
  const auto for_each = [&](const auto& use) {
    for (Index t = 0; t < s.triangles.size(); ++t)
      for (std::size_t k = 0; k < 3; ++k) {
        const Index a = s.triangles[t][k], b = s.triangles[t][(k + 1) % 3];
        use(TriangleSide{std::min(a, b), std::max(a, b), t, a < b});
      }
  };
  for_each([&](const TriangleSide& side) { ++end[side.a + 1]; });
  std::partial_sum(end.begin(), end.end(), end.begin());
  std::vector<TriangleSide> sides(3 * s.triangles.size());
  for_each([&](const TriangleSide& side) { sides[end[side.a]++] = side; });
  const auto at = [&](std::size_t i) { return sides.begin() + static_cast<std::ptrdiff_t>(i); };
  for (std::size_t a = 0; a < s.points.size(); ++a)
    std::sort(at(a == 0 ? 0 : end[a - 1]), at(end[a]),
              [](const TriangleSide& x, const TriangleSide& y) {
                return x.b != y.b ? x.b < y.b : x.triangle < y.triangle;
              });
  return sides;
}

/// Calls use(begin, end) with the sides of each edge. On an edge where the tensor is zero the
/// surface ends: each of its sides is an edge of its own.
template <class Use>
void for_each_edge(const ModeSurface& s, const std::vector<TriangleSide>& sides, Use&& use) {
  const std::array<double, 6> zero{};
  for (std::size_t i = 0; i < sides.size();) {
    std::size_t end = i;
    if (s.tensors[sides[i].a] == zero && s.tensors[sides[i].b] == zero) {
      use(i, i + 1);
      ++i;
      continue;
    }
    while (end < sides.size() && sides[end].a == sides[i].a && sides[end].b == sides[i].b) ++end;
    use(i, end);
    i = end;
  }
}

/// Gives every fan of triangles round a vertex a vertex of its own.
void split_fans(ModeSurface& s) {
  const auto sides = sides_of(s);
  DisjointSets corners(static_cast<Index>(3 * s.triangles.size()));
  const auto corner = [&](Index t, Index v) {
    Index k = 0;
    while (s.triangles[t][k] != v) ++k;
    return 3 * t + k;
  };
  for_each_edge(s, sides, [&](std::size_t i, std::size_t end) {
    if (end - i > 2) throw std::logic_error("modes: an edge has three triangles");
    if (end - i < 2) return;
    for (const Index v : {sides[i].a, sides[i].b})
      corners.unite(corner(sides[i].triangle, v), corner(sides[i + 1].triangle, v));
  });
  std::vector<Index> fan(s.points.size(), ~Index{0});
  std::vector<Index> name(3 * s.triangles.size(), ~Index{0});
  for (Index t = 0; t < s.triangles.size(); ++t)
    for (Index k = 0; k < 3; ++k) {
      const Index set = corners.find(3 * t + k);
      Index& v = s.triangles[t][k];
      if (name[set] == ~Index{0}) {
        const bool first = fan[v] == ~Index{0};
        if (first) {
          fan[v] = set;
          name[set] = v;
        } else {
          name[set] = static_cast<Index>(s.points.size());
          s.points.push_back(s.points[v]);
          s.tensors.push_back(s.tensors[v]);
        }
      }
      v = name[set];
    }
}

/// Leaves out points that no triangle uses.
void compact(ModeSurface& s) {
  std::vector<Index> number(s.points.size(), ~Index{0});
  Index count = 0;
  for (auto& t : s.triangles)
    for (Index& v : t) {
      if (number[v] == ~Index{0}) number[v] = count++;
      v = number[v];
    }
  std::vector<kernel::Vec3> points(count);
  std::vector<std::array<double, 6>> tensors(count);
  for (std::size_t v = 0; v < s.points.size(); ++v) {
    if (number[v] == ~Index{0}) continue;
    points[number[v]] = s.points[v];
    tensors[number[v]] = s.tensors[v];
  }
  s.points = std::move(points);
  s.tensors = std::move(tensors);
}

/// Components by their first triangle; triangles turned as that one is.
void orient(ModeSurface& s, const std::vector<TriangleSide>& sides) {
  const auto n = s.triangles.size();
  std::vector<std::array<std::pair<Index, bool>, 3>> next(n);
  std::vector<std::uint8_t> used(n, 0);
  for_each_edge(s, sides, [&](std::size_t i, std::size_t end) {
    if (end - i < 2) return;
    const bool alike = sides[i].forward != sides[i + 1].forward;
    const Index a = sides[i].triangle, b = sides[i + 1].triangle;
    next[a][used[a]++] = {b, alike};
    next[b][used[b]++] = {a, alike};
  });
  s.component_of.assign(n, ~Index{0});
  std::vector<char> turned(n, 0);
  std::vector<Index> stack;
  for (Index first = 0; first < n; ++first) {
    if (s.component_of[first] != ~Index{0}) continue;
    const auto component = static_cast<Index>(s.components.size());
    s.components.emplace_back();
    s.component_of[first] = component;
    stack.push_back(first);
    while (!stack.empty()) {
      const Index t = stack.back();
      stack.pop_back();
      for (std::size_t k = 0; k < used[t]; ++k) {
        const auto [u, alike] = next[t][k];
        const char want = static_cast<char>(alike ? turned[t] : 1 - turned[t]);
        if (s.component_of[u] == ~Index{0}) {
          s.component_of[u] = component;
          turned[u] = want;
          stack.push_back(u);
        } else if (turned[u] != want) {
          s.components[component].orientable = false;
        }
      }
    }
  }
  for (Index t = 0; t < n; ++t)
    if (turned[t] != 0) std::swap(s.triangles[t][1], s.triangles[t][2]);
}

}  // namespace

std::vector<std::array<Index, 2>> count(ModeSurface& s) {
  split_fans(s);
  compact(s);
  const auto sides = sides_of(s);
  orient(s, sides);
  std::vector<std::array<Index, 2>> boundary;
  std::vector<Index> component_of_point(s.points.size(), 0);
  DisjointSets loops(static_cast<Index>(s.points.size()));
  std::vector<char> on_boundary(s.points.size(), 0);
  for (Index t = 0; t < s.triangles.size(); ++t) {
    ++s.components[s.component_of[t]].euler_characteristic;
    for (const Index v : s.triangles[t]) component_of_point[v] = s.component_of[t];
  }
  for (const Index c : component_of_point) ++s.components[c].euler_characteristic;
  for_each_edge(s, sides, [&](std::size_t i, std::size_t end) {
    --s.components[s.component_of[sides[i].triangle]].euler_characteristic;
    if (end - i != 1) return;
    boundary.push_back({sides[i].a, sides[i].b});
    loops.unite(sides[i].a, sides[i].b);
    on_boundary[sides[i].a] = on_boundary[sides[i].b] = 1;
  });
  for (Index v = 0; v < s.points.size(); ++v)
    if (on_boundary[v] != 0 && loops.find(v) == v)
      ++s.components[component_of_point[v]].boundary_loops;
  s.euler_characteristic = 0;
  for (const auto& c : s.components) s.euler_characteristic += c.euler_characteristic;
  return boundary;
}

}  // namespace crest::modes
