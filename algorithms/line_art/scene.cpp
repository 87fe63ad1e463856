// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/line_art/scene.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <string>

#include "kernel/geometry/input_error.hpp"

namespace crest::line_art {
namespace {

/// Equal for equal points; -0 equals 0. The constants are those of splitmix64.
std::uint64_t hash_of(const Vec3& p) {
  std::uint64_t h = 0;
  for (const double x : p) {
    h += std::bit_cast<std::uint64_t>(x + 0.0) + 0x9e3779b97f4a7c15u;
    h = (h ^ (h >> 30)) * 0xbf58476d1ce4e5b9u;
    h = (h ^ (h >> 27)) * 0x94d049bb133111ebu;
    h ^= h >> 31;
  }
  return h;
}

/// For every used point the first used one that equals it.
std::vector<Index> first_equal(const std::vector<Vec3>& points, const std::vector<bool>& used) {
  const std::size_t places = std::bit_ceil(2 * points.size() + 1);
  std::vector<Index> table(places, kNone), first(points.size(), kNone);
  for (Index v = 0; v < points.size(); ++v) {
    if (!used[v]) continue;
    std::size_t at = hash_of(points[v]) & (places - 1);
    while (table[at] != kNone && points[table[at]] != points[v]) at = (at + 1) & (places - 1);
    if (table[at] == kNone) table[at] = v;
    first[v] = table[at];
  }
  return first;
}

}  // namespace

Scene weld(const std::vector<Vec3>& points, const std::vector<Triangle>& faces) {
  std::vector<bool> used(points.size());
  for (const Triangle& f : faces)
    for (const Index v : f) used[v] = true;
  for (Index v = 0; v < points.size(); ++v)
    for (const double x : points[v])
      if (used[v] && !std::isfinite(x))
        throw kernel::InputError("vertex " + std::to_string(v) +
                                 ": a coordinate is not finite; export the mesh again");
  const std::vector<Index> first = first_equal(points, used);
  Scene scene;
  std::vector<Index> number(points.size(), kNone);
  for (Index v = 0; v < points.size(); ++v) {
    if (first[v] != v) continue;
    number[v] = static_cast<Index>(scene.points.size());
    scene.points.push_back({points[v][0] + 0.0, points[v][1] + 0.0, points[v][2] + 0.0});
    scene.input_vertex.push_back(v);
  }
  for (Index f = 0; f < faces.size(); ++f) {
    Triangle t;
    for (std::size_t k = 0; k < 3; ++k) t[k] = number[first[faces[f][k]]];
    if (t[0] == t[1] || t[1] == t[2] || t[2] == t[0]) continue;
    scene.faces.push_back(t);
    scene.input_face.push_back(f);
  }
  if (scene.faces.empty())
    throw kernel::InputError("faces: none has three corners apart; export the mesh with its faces");
  return scene;
}

SceneEdges edges_of(const Scene& scene) {
  struct Half {
    Index high, face, opposite;
  };
  std::vector<Index> begin(scene.points.size() + 1, 0);
  const auto for_each_half = [&](auto&& take) {
    for (Index f = 0; f < scene.faces.size(); ++f)
      for (std::size_t k = 0; k < 3; ++k) {
        const Index a = scene.faces[f][k], b = scene.faces[f][(k + 1) % 3];
        take(std::min(a, b), Half{std::max(a, b), f, scene.faces[f][(k + 2) % 3]});
      }
  };
  for_each_half([&](Index low, const Half&) { ++begin[low + 1]; });
  for (std::size_t v = 1; v < begin.size(); ++v) begin[v] += begin[v - 1];
  std::vector<Half> halves(begin.back());
  std::vector<Index> next(begin.begin(), begin.end() - 1);
  for_each_half([&](Index low, const Half& half) { halves[next[low]++] = half; });
  SceneEdges result;
  result.sides.reserve(halves.size());
  result.edges.reserve(halves.size() / 2 + 1);
  for (Index low = 0; low < scene.points.size(); ++low) {
    const auto from = halves.begin() + begin[low], to = halves.begin() + begin[low + 1];
    std::sort(from, to, [](const Half& x, const Half& y) {
      return x.high != y.high ? x.high < y.high : x.face < y.face;
    });
    for (auto h = from; h != to; ++h) {
      const auto at = static_cast<Index>(result.sides.size());
      if (h == from || (h - 1)->high != h->high) result.edges.push_back({low, h->high, at, at});
      result.sides.push_back({h->face, h->opposite});
      result.edges.back().end = at + 1;
    }
  }
  return result;
}

}  // namespace crest::line_art
