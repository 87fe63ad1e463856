// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/write/mesh_writer.hpp"

#include <fmt/format.h>

#include <utility>

#include "io/formats/files.hpp"
#include "io/write/atomic_file.hpp"
#include "io/write/mesh_texts.hpp"
#include "kernel/geometry/input_error.hpp"

namespace crest::io {

std::vector<std::string> write_mesh(const std::string& path,
                                    const std::vector<kernel::Vec3>& points,
                                    const std::vector<kernel::Triangle>& faces,
                                    std::span<const kernel::Attribute> attributes) {
  const std::string extension = lower_extension(path);
  LeftOut left_out;
  if (extension == ".off")
    write_atomically(path, off_text(points, faces, attributes, left_out));
  else if (extension == ".obj")
    write_atomically(path, obj_text(points, faces, attributes, left_out));
  else if (extension == ".ply")
    write_atomically(path, ply_text(points, faces, attributes, left_out));
  else if (extension == ".vtp")
    write_vtp_mesh(path, points, faces, attributes, left_out);
  else
    throw kernel::InputError(path + ": file: has an unknown extension; write .off .obj .ply .vtp");
  return left_out;
}

}  // namespace crest::io
