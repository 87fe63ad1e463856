// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/line_art/scene.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include "kernel/geometry/equal_points.hpp"
#include "kernel/geometry/input_error.hpp"

namespace crest::line_art {

Scene weld(const std::vector<Vec3>& points, const std::vector<Triangle>& faces) {
  std::vector<bool> is_used(points.size());
  for (const Triangle& f : faces)
    for (const Index v : f) is_used[v] = true;
  std::vector<Index> input, number(points.size(), kNone);
  std::vector<Vec3> used;
  for (Index v = 0; v < points.size(); ++v) {
    if (!is_used[v]) continue;
    for (const double x : points[v])
      if (!std::isfinite(x))
        throw kernel::InputError("vertex " + std::to_string(v) +
                                 ": a coordinate is not finite; export the mesh again");
    input.push_back(v);
    used.push_back({points[v][0] + 0.0, points[v][1] + 0.0, points[v][2] + 0.0});
  }
  const std::vector<Index> first = kernel::first_equal(used);
  Scene scene;
  for (Index i = 0; i < used.size(); ++i) {
    if (first[i] == i) {
      number[input[i]] = static_cast<Index>(scene.points.size());
      scene.points.push_back(used[i]);
      scene.input_vertex.push_back(input[i]);
    } else {
      number[input[i]] = number[input[first[i]]];
    }
  }
  for (Index f = 0; f < faces.size(); ++f) {
    Triangle t;
    for (std::size_t k = 0; k < 3; ++k) t[k] = number[faces[f][k]];
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
