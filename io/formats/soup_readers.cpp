// SPDX-License-Identifier: GPL-3.0-or-later
#include <map>

#include "io/formats/files.hpp"
#include "io/formats/readers.hpp"

namespace crest::io {

SoupReader soup_reader(const std::string& extension) {
  using Reader = Soup (*)(std::string, const FieldRequest&);
  static const std::map<std::string, Reader> readers = {
      {".off", read_off}, {".obj", read_obj}, {".ply", read_ply}, {".stl", read_stl},
      {".vtp", read_vtp}, {".vtu", read_vtu}, {".vtk", read_vtk}, {".msh", read_msh}};
  const auto found = readers.find(extension);
  if (found == readers.end()) {
    fail("file",
         extension.empty() ? "has no extension" : "has the unknown extension '" + extension + "'",
         "use .off, .obj, .ply, .stl, .vtp, .vtu, .vtk or .msh");
  }
  return [reader = found->second, extension](std::string bytes, const FieldRequest& request) {
    if (request.step && extension != ".msh")
      fail("time step", extension.substr(1) + " files have none", "leave --step out");
    return reader(std::move(bytes), request);
  };
}

}  // namespace crest::io
