// SPDX-License-Identifier: GPL-3.0-or-later
#include <map>

#include "io/formats/files.hpp"
#include "io/formats/readers.hpp"

namespace crest::io {

SoupReader soup_reader(const std::string& extension) {
  using Reader = Soup (*)(std::string_view, const FieldRequest&);
  static const std::map<std::string, Reader> readers = {
      {".off", read_off}, {".obj", read_obj}, {".ply", read_ply}, {".stl", read_stl},
      {".vtp", read_vtp}, {".vtu", read_vtu}, {".vtk", read_vtk}, {".msh", read_msh}};
  const auto found = readers.find(extension);
  if (found == readers.end()) {
    fail("file",
         extension.empty() ? "has no extension" : "has the unknown extension '" + extension + "'",
         "use .off, .obj, .ply, .stl, .vtp, .vtu, .vtk or .msh");
  }
  return [reader = found->second, extension](std::string_view bytes, const FieldRequest& request) {
    if (request.step && extension != ".msh")
      fail("time step", extension.substr(1) + " files have none", "leave --step out");
    return reader(bytes, request);
  };
}

Soup read_soup(const std::string& path, const FieldRequest& request) {
  const SoupReader reader = soup_reader(lower_extension(path));
  return reader(load(path), request);
}

Soup read_soup(const std::string& name, std::string_view bytes, const FieldRequest& request) {
  const SoupReader reader = soup_reader(lower_extension(name));
  if (bytes.empty()) fail("file", "is empty", "export the mesh again");
  return reader(bytes, request);
}

}  // namespace crest::io
