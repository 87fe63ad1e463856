// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/write/mesh_writer.hpp"

#include <fmt/format.h>

#include "io/formats/files.hpp"
#include "io/write/atomic_file.hpp"
#include "io/write/poly_data.hpp"
#include "io/write/text.hpp"
#include "kernel/geometry/input_error.hpp"

namespace crest::io {
namespace {

using Points = std::vector<kernel::Vec3>;
using Faces = std::vector<kernel::Triangle>;

/// Header, then a line a point and a line a face with the given starts; indices from `base`.
std::string text_of(const Points& points, const Faces& faces, const std::string& header,
                    const char* vertex, const char* face, kernel::Index base) {
  Text text;
  text.add("{}", header);
  for (const kernel::Vec3& p : points) text.add("{}{} {} {}\n", vertex, p[0], p[1], p[2]);
  for (const kernel::Triangle& f : faces)
    text.add("{}{} {} {}\n", face, f[0] + base, f[1] + base, f[2] + base);
  return text.text();
}

std::string ply_header(std::size_t points, std::size_t faces) {
  return fmt::format(
      "ply\nformat ascii 1.0\nelement vertex {}\nproperty double x\nproperty double y\n"
      "property double z\nelement face {}\nproperty list uchar int vertex_indices\nend_header\n",
      points, faces);
}

std::string vtp_of(const Points& points, const Faces& faces) {
  PolyData data;
  data.add_points(points);
  for (const kernel::Triangle& f : faces) data.add_triangle(f[0], f[1], f[2]);
  return data.bytes();
}

}  // namespace

void write_mesh(const std::string& path, const Points& points, const Faces& faces) {
  const std::string extension = lower_extension(path);
  std::string bytes;
  if (extension == ".off") {
    bytes = text_of(points, faces, fmt::format("OFF\n{} {} 0\n", points.size(), faces.size()), "",
                    "3 ", 0);
  } else if (extension == ".obj") {
    bytes = text_of(points, faces, "", "v ", "f ", 1);
  } else if (extension == ".ply") {
    bytes = text_of(points, faces, ply_header(points.size(), faces.size()), "", "3 ", 0);
  } else if (extension == ".vtp") {
    bytes = vtp_of(points, faces);
  } else {
    throw kernel::InputError(path + ": file: has an unknown extension; write .off .obj .ply .vtp");
  }
  write_atomically(path, bytes);
}

}  // namespace crest::io
