// SPDX-License-Identifier: GPL-3.0-or-later
// libFuzzer target of one format of volumes, images or points: any bytes give samples, all of them
// finite, or points with normals, or an InputError of one line.
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <string>

#include "io/read/point_reader.hpp"
#include "io/read/volume_reader.hpp"
#include "kernel/geometry/input_error.hpp"

namespace {

void read(const std::string& name, const std::string& bytes) {
  if (crest::io::is_point_name(name)) {
    const auto file = crest::io::read_points_bytes(name, bytes);
    if (file.points.empty() || file.points.size() != file.normals.size()) abort();
    return;
  }
  const auto grid = crest::io::read_volume_bytes(name, bytes).grid;
  if (std::visit([](const auto& x) { return x.size(); }, grid.samples) != grid.count()) abort();
  for (std::size_t i = 0; i < grid.count(); ++i)
    if (!std::isfinite(grid.at(i))) abort();
  for (std::size_t k = 0; k < 3; ++k)
    if (!(grid.spacing[k] > 0) || !std::isfinite(grid.spacing[k])) abort();
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string bytes(reinterpret_cast<const char*>(data), size);
  try {
    read("volume." CREST_FUZZ_FORMAT, bytes);
  } catch (const crest::kernel::InputError& error) {
    const std::string line = error.what();
    if (line.find('\n') != std::string::npos || line.find("; ") == std::string::npos) abort();
  }
  return 0;
}
