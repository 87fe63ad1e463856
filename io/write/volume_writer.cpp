// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/write/volume_writer.hpp"

#include <bit>
#include <cstring>

#include "io/formats/files.hpp"
#include "io/write/atomic_file.hpp"
#include "io/write/text.hpp"
#include "kernel/geometry/input_error.hpp"

namespace crest::io {
namespace {

using kernel::SampledGrid;
using kernel::operator*;

static_assert(std::endian::native == std::endian::little);

std::string sample_bytes(const SampledGrid& grid) {
  return std::visit(
      [](const auto& x) {
        std::string bytes(x.size() * sizeof x[0], '\0');
        std::memcpy(bytes.data(), x.data(), bytes.size());
        return bytes;
      },
      grid.samples);
}

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

std::string vti(const SampledGrid& grid) {
  constexpr const char* types[] = {"Int8",   "UInt8", "Int16",  "UInt16",  "Int32",
                                   "UInt32", "Int64", "UInt64", "Float32", "Float64"};
  Text extent, text;
  extent.add("0 {} 0 {} 0 {}", grid.size[0] - 1, grid.size[1] - 1, grid.size[2] - 1);
  const auto& d = grid.directions;
  text.add(
      "<?xml version=\"1.0\"?>\n<VTKFile type=\"ImageData\" version=\"1.0\" "
      "byte_order=\"LittleEndian\" header_type=\"UInt64\">\n<ImageData WholeExtent=\"{}\" "
      "Origin=\"{} {} {}\" Spacing=\"{} {} {}\" Direction=\"{} {} {} {} {} {} {} {} {}\">\n<Piece "
      "Extent=\"{}\">\n<PointData Scalars=\"value\">\n<DataArray type=\"{}\" Name=\"value\" "
      "format=\"appended\" offset=\"0\"/>\n</PointData>\n</Piece>\n</ImageData>\n"
      "<AppendedData encoding=\"raw\">\n_",
      extent.text(), grid.origin[0], grid.origin[1], grid.origin[2], grid.spacing[0],
      grid.spacing[1], grid.spacing[2], d[0][0], d[1][0], d[2][0], d[0][1], d[1][1], d[2][1],
      d[0][2], d[1][2], d[2][2], extent.text(), types[static_cast<std::size_t>(grid.type())]);
  const std::string samples = sample_bytes(grid);
  const std::uint64_t size = samples.size();
  std::string bytes = text.text();
  bytes.append(reinterpret_cast<const char*>(&size), sizeof size);
  return bytes + samples + "\n</AppendedData>\n</VTKFile>\n";
}

}  // namespace

void write_volume(const std::string& path, const SampledGrid& grid) {
  const std::string extension = lower_extension(path);
  if (extension == ".nrrd") return write_atomically(path, nrrd(grid));
  if (extension == ".vti") return write_atomically(path, vti(grid));
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
