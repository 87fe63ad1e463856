// SPDX-License-Identifier: GPL-3.0-or-later
// Random triangulations of the sphere, stacked and flipped, by all methods against the proven bound
// of 5 log2(phi) = 3.4713 bits a vertex.
#include <fmt/format.h>

#include "algorithms/coding/coding.hpp"
#include "algorithms/sampling/random_triangulations.hpp"
#include "experiments/program.hpp"

namespace crest {
namespace {

using coding::Method;

void row(kernel::Index vertices, unsigned flips) {
  std::mt19937_64 random(vertices + flips);
  std::vector<kernel::Triangle> faces = sampling::stacked_sphere(vertices, random);
  sampling::flip_edges(faces, vertices, flips * faces.size(), random);
  const auto rate = [&](Method method) {
    return 8.0 / vertices *
           static_cast<double>(coding::encode(vertices, faces, {},
                                              {.method = method, .places = coding::Places::none})
                                   .info.sizes.connectivity);
  };
  fmt::print("| {} | {} | {:.3f} | {:.3f} | {:.3f} | {:.3f} |\n", vertices, flips,
             rate(Method::valence), rate(Method::fan), rate(Method::zigzag), rate(Method::fixed));
  std::fflush(stdout);
}

int run(unsigned most) {
  fmt::print(
      "| vertices | flips a face | valence | fan | zigzag | static |\n|---|---|---|---|---|---|\n");
  for (const unsigned vertices : {100u, 1000u, 10000u, 50000u})
    for (const unsigned flips : {0u, 1u, 10u, 100u})
      if (vertices <= most) row(vertices, flips);
  return 0;
}

}  // namespace
}  // namespace crest

int main(int argc, char** argv) {
  unsigned most = 50000;
  crest::experiments::Program program("Random triangulations by all methods");
  program.option("--most", most, "vertices", {100, 50000});
  return program.run(argc, argv, [&] { return crest::run(most); });
}
