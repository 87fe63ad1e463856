// SPDX-License-Identifier: GPL-3.0-or-later
// Mean curvature of a sphere by every method that needs no normals: estimates, without certificate.
#include "crest/algorithms/curvature/curvature.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "crest/algorithms/sampling/plain_surfaces.hpp"

int main() {
  const auto [points, triangles] = crest::sampling::icosphere(4);
  const crest::kernel::TriangleMesh mesh(points, triangles);
  double worst = 0;
  for (const auto method : crest::curvature::kMethods) {
    if (method == crest::curvature::Method::np) continue;
    crest::curvature::Options options;
    options.method = method;
    double error = 0;
    for (const auto& at : crest::curvature::estimate(mesh, options).vertices)
      error = std::max(error, std::fabs(at.H + 1));  // convex, seen from outside
    std::printf("%s: |H + 1| <= %.2g\n", crest::curvature::name_of(method), error);
    worst = std::max(worst, error);
  }
  return worst < 0.1 ? 0 : 1;
}
