// SPDX-License-Identifier: GPL-3.0-or-later
// Bytes of the connectivity by every method, bits a vertex of exact and rounded places, for every
// oriented manifold of the folders.
#include <fmt/format.h>

#include <cmath>
#include <iostream>

#include "algorithms/coding/coding.hpp"
#include "experiments/001-coding/coding_input.hpp"
#include "experiments/program.hpp"
#include "kernel/geometry/input_error.hpp"

namespace crest {
namespace {

using coding::Method;
using coding::Places;

/// The entropy of the valences, in bits a vertex.
double valence_entropy(const experiments::CodingInput& mesh) {
  std::vector<std::size_t> valence(mesh.points.size(), 0), count;
  for (const auto& f : mesh.faces)
    for (const auto v : f) ++valence[v];
  for (const std::size_t n : valence) {
    if (n >= count.size()) count.resize(n + 1, 0);
    ++count[n];
  }
  double bits = 0;
  for (const std::size_t n : count)
    if (n > 0)
      bits -= static_cast<double>(n) *
              std::log2(static_cast<double>(n) / static_cast<double>(valence.size()));
  return bits / static_cast<double>(valence.size());
}

double extent(const experiments::CodingInput& mesh) {
  double largest = 0;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const auto [least, most] =
        std::minmax_element(mesh.points.begin(), mesh.points.end(),
                            [&](const auto& p, const auto& q) { return p[axis] < q[axis]; });
    largest = std::max(largest, (*most)[axis] - (*least)[axis]);
  }
  return largest;
}

struct Sums {
  std::size_t vertices = 0, bytes = 0;
};

void row(const std::filesystem::path& path, Sums& sums) {
  const auto mesh = experiments::read_coding_input(path.string());
  const auto bytes = [&](Method method) {
    return coding::encode(mesh.vertices(), mesh.faces, {},
                          {.method = method, .places = Places::none})
        .info.sizes.connectivity;
  };
  const std::array<std::size_t, 4> sizes = {bytes(Method::valence), bytes(Method::fan),
                                            bytes(Method::zigzag), bytes(Method::fixed)};
  const std::size_t best = *std::min_element(sizes.begin(), sizes.end());
  const double per_vertex = 8.0 / mesh.vertices();
  const auto exact =
      coding::encode(mesh.vertices(), mesh.faces, mesh.points, {.method = Method::fixed});
  // The step of a grid of b bits over the largest side moves a vertex by sqrt(3) / 2 steps at most.
  const auto rounded = [&](int bits) {
    const double step = extent(mesh) / ((1 << bits) - 1);
    return best + coding::encode(mesh.vertices(), mesh.faces, mesh.points,
                                 {.method = Method::fixed,
                                  .places = Places::rounded,
                                  .tolerance = step * std::sqrt(0.75) * (1 + 1e-6)})
                      .info.sizes.geometry;
  };
  fmt::print("| {} | {} | {} | {} | {} | {} | {} | {:.3f} | {:.3f} | {:.2f} | {} | {} |\n",
             path.filename().string(), mesh.vertices(), mesh.faces.size(), sizes[0], sizes[1],
             sizes[2], sizes[3], per_vertex * static_cast<double>(best), valence_entropy(mesh),
             per_vertex * static_cast<double>(exact.info.sizes.geometry), rounded(11), rounded(14));
  std::fflush(stdout);
  sums.vertices += mesh.vertices();
  sums.bytes += best;
}

int run(const std::vector<std::string>& folders) {
  fmt::print(
      "| mesh | vertices | faces | valence | fan | zigzag | static | smallest, bits a vertex | "
      "entropy of "
      "valences | exact places, bits a vertex | connectivity and places, 11 bits | 14 bits |\n"
      "|---|---|---|---|---|---|---|---|---|---|---|---|\n");
  Sums sums;
  std::vector<std::string> skipped;
  for (const auto& path : experiments::files_of(folders)) {
    try {
      row(path, sums);
    } catch (const kernel::InputError& error) {
      skipped.push_back(error.what());
    }
  }
  if (sums.vertices > 0)
    fmt::print("\nAll together: {:.3f} bits a vertex of connectivity.\n",
               8.0 * static_cast<double>(sums.bytes) / static_cast<double>(sums.vertices));
  for (const std::string& line : skipped) std::cerr << "left out: " << line << "\n";
  return 0;
}

}  // namespace
}  // namespace crest

int main(int argc, char** argv) {
  std::vector<std::string> folders = {"../shared/data/meshes", "../shared/data/thesis-meshes"};
  crest::experiments::Program program("Sizes of coded meshes");
  program.option("--folders", folders, "with the meshes");
  return program.run(argc, argv, [&] { return crest::run(folders); });
}
