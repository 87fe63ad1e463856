// SPDX-License-Identifier: GPL-3.0-or-later
// The ridges of a smooth surface given by its equation, proven.
#include "crest/algorithms/smooth_ridges/smooth_ridges.hpp"

#include <cstdio>

#include "crest/algorithms/smooth_ridges/surface.hpp"

int main() {
  const auto surface =
      crest::smooth_ridges::Surface::implicit("x^2 + y^2/2.25 + z^2/4 - 1", {-3, 3, -3, 3, -3, 3});
  const auto result = crest::smooth_ridges::smooth_ridges(surface, {});
  for (const std::string& why : result.obstacles) std::printf("not certified: %s\n", why.c_str());
  std::printf("%zu umbilics, %zu ridges, %zu purple points on %zu triangles\n",
              result.umbilics.size(), result.ridges.size(), result.purple_points.size(),
              result.faces.size());
  return result.certified ? 0 : 1;
}
