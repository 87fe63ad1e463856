// SPDX-License-Identifier: GPL-3.0-or-later
// libFuzzer target of one format of plane vector fields: any bytes give finite points and vectors
// and triangles between them, or an InputError of one line.
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>

#include "io/read/planar_field_reader.hpp"
#include "kernel/geometry/input_error.hpp"

namespace {

/// In memory: VTK and NetCDF want files.
std::string file_of(const std::uint8_t* data, std::size_t size) {
  static const std::string path = [] {
    std::string folder = "/dev/shm/crest-fuzz-XXXXXX";
    if (mkdtemp(folder.data()) == nullptr) abort();
    return folder + "/field." CREST_FUZZ_FORMAT;
  }();
  std::ofstream(path, std::ios::binary)
      .write(reinterpret_cast<const char*>(data), static_cast<std::streamsize>(size));
  return path;
}

void check(const crest::io::PlanarFieldFile& file) {
  if (file.triangles.empty() || file.points.size() != file.vectors.size() ||
      file.cell_of.size() != file.triangles.size())
    abort();
  for (const auto* list : {&file.points, &file.vectors})
    for (const auto& x : *list)
      if (!std::isfinite(x[0]) || !std::isfinite(x[1])) abort();
  for (const auto& t : file.triangles)
    for (const auto v : t)
      if (v >= file.points.size()) abort();
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string path = file_of(data, size);
  for (const bool other : {false, true}) {
    crest::io::VectorRequest request;
    if (other) {
      request.slice = 0;
      request.cell_to_point = request.all = true;
      request.diagonal = crest::io::Diagonal::shorter;
    }
    try {
      check(crest::io::read_planar_field(path, request));
    } catch (const crest::kernel::InputError& error) {
      const std::string line = error.what();
      if (line.find('\n') != std::string::npos || line.find("; ") == std::string::npos) abort();
    }
  }
  return 0;
}
