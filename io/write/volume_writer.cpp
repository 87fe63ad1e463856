// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/write/volume_writer.hpp"

#include "io/formats/files.hpp"
#include "io/write/atomic_file.hpp"
#include "io/write/formats.hpp"
#include "io/write/image_data.hpp"
#include "io/write/text.hpp"
#include "kernel/geometry/input_error.hpp"

namespace crest::io {
namespace {

using kernel::SampledGrid;
using kernel::operator*;

std::string nrrd(const SampledGrid& grid) {
  constexpr const char* types[] = {"int8",   "uint8", "int16",  "uint16", "int32",
                                   "uint32", "int64", "uint64", "float",  "double"};
  const auto n = static_cast<std::size_t>(grid.dimension());
  Text text;
  text.add("NRRD0004\ntype: {}\ndimension: {}\nspace dimension: 3\nsizes:",
           types[static_cast<std::size_t>(grid.type())], n);
  for (std::size_t k = 0; k < n; ++k) text.add(" {}", grid.size[k]);
  text.add("\nspace directions:");
  for (std::size_t k = 0; k < n; ++k) {
    const kernel::Vec3 step = grid.spacing[k] * grid.directions[k];
    text.add(" ({},{},{})", step[0], step[1], step[2]);
  }
  text.add("\nspace origin: ({},{},{})\nendian: little\nencoding: raw\n\n", grid.origin[0],
           grid.origin[1], grid.origin[2]);
  return text.text() + sample_bytes(grid);
}

}  // namespace

void write_volume(const std::string& path, const SampledGrid& grid) {
  const std::string extension = lower_extension(path);
  if (extension == ".nrrd") return write_atomically(path, nrrd(grid));
  if (extension == ".vti") return write_vti(path, *image_data(grid));
  throw kernel::InputError(path + ": file: has an unknown extension; write .nrrd or .vti");
}

void write_points(const std::string& path, const std::vector<kernel::Vec3>& points,
                  const std::vector<kernel::Vec3>& normals) {
  const std::string extension = lower_extension(path);
  if (extension != ".xyz" && extension != ".pwn")
    throw kernel::InputError(path + ": file: has an unknown extension; write .xyz or .pwn");
  Text text;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const auto &p = points[i], &n = normals[i];
    text.add("{} {} {} {} {} {}\n", p[0], p[1], p[2], n[0], n[1], n[2]);
  }
  write_atomically(path, text.text());
}

}  // namespace crest::io
