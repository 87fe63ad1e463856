// SPDX-License-Identifier: GPL-3.0-or-later
// Theorem 7.1 and table 7.1: dimensions of S^0 and S^1, counted and by the rank of the C1
// conditions modulo 2^31 - 1.
#include <fmt/format.h>

#include "algorithms/splines/dimension.hpp"
#include "experiments/program.hpp"

namespace crest::experiments {
namespace {

std::size_t formula(std::size_t q, std::size_t n) {
  if (q == 2) return 3 * n * n + 9 * n + 4;
  return (4 * q * q * q + 53 * q - 24 * q * q - 45) * n * n * n +
         6 * (2 * q * q + 7 - 7 * q) * n * n + 9 * (q - 1) * n + 4;
}

template <int q>
int row(int most_cubes) {
  int wrong = 0;
  for (int n = 1; n <= most_cubes; ++n) {
    const auto m = static_cast<std::size_t>(n);
    const splines::Dimensions d = splines::dimensions<q>({n, n, n});
    const std::size_t continuous = (4 * q * q + 1) * std::size_t{q} * m * m * m +
                                   6 * std::size_t{q * q} * m * m + 3 * q * m + 1;
    const bool agrees = d.continuous == continuous && d.smooth == formula(q, m);
    wrong += agrees ? 0 : 1;
    fmt::print("| {} | {} | {} | {} | {} | {} | {} |\n", q, n, d.continuous, continuous, d.smooth,
               formula(q, m), agrees ? "yes" : "NO");
    std::fflush(stdout);
  }
  return wrong;
}

int work(int most_cubes) {
  fmt::print("| q | n | dim S^0 counted | (7.8) | dim S^1 by rank | theorem 7.1 | agree |\n");
  fmt::print("|---|---|---|---|---|---|---|\n");
  return row<2>(most_cubes) + row<3>(most_cubes) + row<4>(most_cubes) + row<5>(most_cubes) +
         row<6>(most_cubes) + row<7>(most_cubes) + row<8>(most_cubes) + row<9>(most_cubes);
}

}  // namespace
}  // namespace crest::experiments

int main(int argc, char** argv) {
  int most_cubes = 4;
  crest::experiments::Program program("Table 7.1 by ranks");
  program.option("-n", most_cubes, "cubes along each axis, at most (4)");
  return program.run(argc, argv, [&] { return crest::experiments::work(most_cubes); });
}
