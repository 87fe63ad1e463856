// SPDX-License-Identifier: GPL-3.0-or-later
// Figure 5 of paper 004 as numbers: the surfaces of field 3 on both sides of mu*, where theorem A
// says that their topology changes.
#include <fmt/format.h>

#include <cmath>
#include <numeric>

#include "algorithms/modes/modes.hpp"
#include "experiments/004-modes/sphere_picture.hpp"
#include "experiments/program.hpp"

namespace crest::experiments {
namespace {

using kernel::Index;
using kernel::Vec3;

/// [-half, half]^3 in n^3 cubes, each in six tetrahedra along its diagonal from (0, 0, 0).
modes::ModeField field_3_in_box(Index n, double half) {
  std::vector<Vec3> points;
  std::vector<std::array<double, 6>> tensors;
  for (Index z = 0; z <= n; ++z)
    for (Index y = 0; y <= n; ++y)
      for (Index x = 0; x <= n; ++x) {
        const auto at = [&](Index i) { return half * (2.0 * i / n - 1); };
        points.push_back({at(x), at(y), at(z)});
        tensors.push_back(field_3_at({points.back(), {}, {}, {}})[0]);
      }
  constexpr std::size_t kOrders[6][3] = {{0, 1, 2}, {1, 2, 0}, {2, 0, 1},
                                         {0, 2, 1}, {1, 0, 2}, {2, 1, 0}};
  std::vector<kernel::TetMesh::Tet> tets;
  for (Index z = 0; z < n; ++z)
    for (Index y = 0; y < n; ++y)
      for (Index x = 0; x < n; ++x)
        for (std::size_t k = 0; k < 6; ++k) {
          std::array<Index, 3> c{x, y, z};
          kernel::TetMesh::Tet t{};
          const auto id = [&] { return (c[2] * (n + 1) + c[1]) * (n + 1) + c[0]; };
          t[0] = id();
          for (std::size_t i = 0; i < 3; ++i) {
            ++c[kOrders[k][i]];
            t[i + 1] = id();
          }
          if (k > 2) std::swap(t[2], t[3]);
          tets.push_back(t);
        }
  return {kernel::TetMesh(std::move(points), std::move(tets)), std::move(tensors)};
}

void run(Index n, double half) {
  const modes::ModeField field = field_3_in_box(n, half);
  const modes::LinearTensors f(field_3_at({Vec3{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}));
  fmt::print(
      "{} tetrahedra; theorem A: mu* = {:.6f}\n\n| mode | + level: components, Euler "
      "characteristic, loops | - level | sum | undecided |\n|---|---|---|---|---|\n",
      field.mesh.tets().size(), std::sqrt(1 - f.characteristic_mode() * f.characteristic_mode()));
  for (const std::int64_t p : {0, 100, 300, 600, 800, 900, 910, 915, 917, 920, 950}) {
    const std::int64_t q = 1000, common = std::gcd(p, q);
    const modes::Level level{p / common, q / common};
    const auto result = modes::extract(field, level);
    fmt::print("| {} | ", level.value());
    std::int64_t sum = 0;
    for (const modes::ModeSurface& s : result.surfaces) {
      std::size_t loops = 0;
      for (const auto& part : s.components) loops += part.boundary_loops;
      fmt::print("{}, {}, {} | ", s.components.size(), s.euler_characteristic, loops);
      sum += s.euler_characteristic;
    }
    fmt::print("{}{} | {} |\n", p == 0 ? "| " : "", sum, result.undecided.size());
  }
}

}  // namespace
}  // namespace crest::experiments

int main(int argc, char** argv) {
  int cubes = 8;
  double half = 60;
  crest::experiments::Program program("Mode surfaces of field 3 on both sides of mu*.");
  program.option("--cubes", cubes, "along a side", {1, 60});
  program.option("--half", half, "half the side");
  return program.run(argc, argv, [&] {
    crest::experiments::run(static_cast<crest::kernel::Index>(cubes), half);
    return 0;
  });
}
