// SPDX-License-Identifier: GPL-3.0-or-later
// A volume too large for the memory: N^3 bytes without a header, of a bright spherical sheet and a
// half plane that touches nothing, written slice by slice.
#include <tbb/parallel_for.h>

#include <cmath>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <stdexcept>
#include <vector>

#include "experiments/program.hpp"

namespace {

/// 255 on the sheet, falling off within some voxels.
std::uint8_t brightness(double distance) {
  const double x = distance / 2.5;
  return std::fabs(x) > 3 ? std::uint8_t{0}
                          : static_cast<std::uint8_t>(std::lround(255 * std::exp(-x * x)));
}

std::uint8_t sample(double x, double y, double z, double n) {
  const double r = std::hypot(x - 0.4 * n, y - 0.45 * n, z - 0.5 * n) - 0.2 * n;
  const double plane = x > 0.7 * n && x < 0.9 * n && y > 0.2 * n && y < 0.8 * n ? z - 0.31 * n : n;
  return brightness(std::fabs(r) < std::fabs(plane) ? r : plane);
}

}  // namespace

int main(int argc, char** argv) {
  int nodes = 256;
  std::filesystem::path file;
  crest::experiments::Program program("writes a large volume of bytes without a header");
  program.option("file", file, "to be written");
  program.option("--nodes", nodes, "along each axis", {8, 4096});
  return program.run(argc, argv, [&] {
    std::ofstream out(file, std::ios::binary);
    const auto n = static_cast<std::size_t>(nodes);
    std::vector<char> slice(n * n);
    for (int z = 0; z < nodes; ++z) {
      tbb::parallel_for(0, nodes, [&](int y) {
        for (int x = 0; x < nodes; ++x)
          slice[static_cast<std::size_t>(y) * n + static_cast<std::size_t>(x)] =
              static_cast<char>(sample(x, y, z, nodes));
      });
      out.write(slice.data(), static_cast<std::streamsize>(slice.size()));
    }
    if (!out) throw std::runtime_error("cannot write " + file.string());
    return 0;
  });
}
