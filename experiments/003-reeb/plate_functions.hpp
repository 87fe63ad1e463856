// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Functions on a closed surface of genus 16, a plate with holes: what the tables of times are of.
#include <cmath>
#include <random>
#include <string>
#include <vector>

#include "algorithms/sampling/plain_surfaces.hpp"
#include "experiments/003-reeb/smooth_field.hpp"

namespace crest::experiments {

struct PlateFunction {
  sampling::PlainSurface surface;
  std::vector<double> values;
  std::vector<std::array<double, 3>> midside;
};

/// Of nearly so many triangles; `kind`: smooth, noise, or 16 values (nine in ten of the nodes that
/// degree 2 adds then tie).
inline PlateFunction plate_function(double triangles, int degree, const std::string& kind) {
  const auto n = static_cast<unsigned>(std::lround(std::sqrt(triangles / (4 * (1 - 1 / 9.0)))));
  PlateFunction in{sampling::plate(n, 16, true), {}, {}};
  const auto& points = in.surface.points;
  if (kind == "smooth") {
    const SmoothField field(0.1, 1);  // the plate is one unit wide
    for (const auto& p : points) in.values.push_back(field(p));
    if (degree == 2)
      for (const auto& t : in.surface.triangles) {
        in.midside.emplace_back();
        for (std::size_t k = 0; k < 3; ++k)
          in.midside.back()[k] = field(middle(points[t[k]], points[t[(k + 1) % 3]]));
      }
    return in;
  }
  std::mt19937_64 draw(1);
  const auto value = [&] {
    const double x = static_cast<double>(draw() >> 11) * 0x1p-53;
    return kind == "noise" ? x : std::floor(16 * x) / 16;
  };
  for (std::size_t v = 0; v < points.size(); ++v) in.values.push_back(value());
  if (degree == 2) {
    const kernel::QuadraticMesh edges(points, in.surface.triangles, in.values);
    std::vector<double> at_edge(edges.edge_count());
    for (double& x : at_edge) x = value();
    for (const auto& e : edges.face_edges())
      in.midside.push_back({at_edge[e[0]], at_edge[e[1]], at_edge[e[2]]});
  }
  return in;
}

}  // namespace crest::experiments
