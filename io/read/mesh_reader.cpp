// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/read/mesh_reader.hpp"

#include "io/formats/files.hpp"
#include "io/formats/readers.hpp"
#include "io/read/soup_to_mesh.hpp"

namespace crest::io {

MeshFile read_mesh(const std::string& path) {
  MeshFile file;
  read_named(path, [&] {
    // Before a large file of another format is loaded.
    const SoupReader reader = soup_reader(lower_extension(path));
    file = mesh_of_soup(reader(load(path), {}));
  });
  return file;
}

MeshFile read_mesh_bytes(const std::string& name, std::string bytes) {
  MeshFile file;
  read_named(name, [&] {
    const SoupReader reader = soup_reader(lower_extension(name));
    if (bytes.empty()) fail("file", "is empty", "export the mesh again");
    file = mesh_of_soup(reader(std::move(bytes), {}));
  });
  return file;
}

}  // namespace crest::io
