// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <filesystem>
#include <map>

#include "io/formats/binary.hpp"
#include "io/formats/files.hpp"
#include "io/formats/join_soups.hpp"
#include "io/formats/parallel_index.hpp"
#include "io/formats/readers.hpp"
#include "kernel/geometry/input_error.hpp"

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
         "use .off, .obj, .ply, .stl, .vtp, .vtu, .vtk, .msh, .pvtp or .pvtu");
  }
  return [reader = found->second, extension](std::string_view bytes, const FieldRequest& request) {
    if (request.step && extension != ".msh")
      fail("time step", extension.substr(1) + " files have none", "leave --step out");
    return reader(bytes, request);
  };
}

namespace {

struct Signature {
  std::string_view start;
  const char* problem;
  const char* remedy;
  const char* extension = "";  ///< of the format
};

/// What the bytes are, if they say so.
const Signature* signature_of(std::string_view bytes) {
  static constexpr Signature signatures[] = {
      {"ply", "holds PLY", "name it .ply", ".ply"},
      {"# vtk DataFile", "holds legacy VTK", "name it .vtk", ".vtk"},
      {"$MeshFormat", "holds a Gmsh mesh", "name it .msh", ".msh"},
      {"solid ", "holds STL", "name it .stl", ".stl"},
      {"OFF", "holds OFF", "name it .off", ".off"},
      {"\x1f\x8b", "is compressed by gzip", "unpack it"},
      {"\xfd"
       "7zXZ",
       "is compressed by xz", "unpack it"},
      {"BZh", "is compressed by bzip2", "unpack it"},
      {"PK\x03\x04", "is a ZIP archive", "unpack it"},
      {"\xff\xfe", "is a text in UTF-16", "save it as UTF-8"},
      {"\xfe\xff", "is a text in UTF-16", "save it as UTF-8"}};
  static constexpr Signature polydata = {"", "holds VTK polygonal data", "name it .vtp", ".vtp"},
                             stl = {"", "holds binary STL", "name it .stl", ".stl"},
                             grid = {"", "holds a VTK unstructured grid", "name it .vtu", ".vtu"};
  for (const Signature& signature : signatures)
    if (bytes.starts_with(signature.start)) return &signature;
  constexpr std::size_t header = 84, facet = 50;  // of binary STL
  if (bytes.size() > header && load_number<std::uint32_t>(bytes.data() + header - 4, false) ==
                                   (bytes.size() - header) / facet)
    return &stl;
  const std::string_view head = bytes.substr(0, 1000);
  if (head.find("<VTKFile") == head.npos) return nullptr;
  return head.find("\"PolyData\"") != head.npos           ? &polydata
         : head.find("\"UnstructuredGrid\"") != head.npos ? &grid
                                                          : nullptr;
}

/// A format that is not the name's explains why there is no mesh better than its reader does.
Soup read_as(const std::string& name, std::string_view bytes, const SoupReader& reader,
             const FieldRequest& request) {
  const Signature* const signature = signature_of(bytes);
  if (!signature || signature->extension == lower_extension(name)) return reader(bytes, request);
  try {
    Soup soup = reader(bytes, request);
    if (!soup.cells.empty()) return soup;
  } catch (const kernel::InputError&) {
  }
  fail("file", signature->problem, signature->remedy);
}

/// Of .pvtp and .pvtu: their pieces lie beside them.
Soup read_pieces(const std::string& path, const FieldRequest& request) {
  const bool grid = lower_extension(path) == ".pvtu";
  const std::string extension = grid ? ".vtu" : ".vtp";
  const ParallelIndex index =
      parallel_index(load(path), grid ? "PUnstructuredGrid" : "PPolyData", extension);
  std::vector<Soup> pieces;
  for (const ParallelIndex::Piece& piece : index.pieces) {
    const auto place = std::filesystem::path(path).parent_path() / piece.source;
    try {
      pieces.push_back(read_soup(place.string(), request));
    } catch (const kernel::InputError& error) {
      throw kernel::InputError(
          fmt::format("piece {} ('{}'): {}", pieces.size(), one_line(piece.source), error.what()));
    }
  }
  return join(std::move(pieces));
}

bool has_pieces(const std::string& path) {
  const std::string extension = lower_extension(path);
  return extension == ".pvtp" || extension == ".pvtu";
}

}  // namespace

Soup read_soup(const std::string& path, const FieldRequest& request) {
  if (has_pieces(path)) return read_pieces(path, request);
  const SoupReader reader = soup_reader(lower_extension(path));
  return read_as(path, load(path), reader, request);
}

Soup read_soup(const std::string& name, std::string_view bytes, const FieldRequest& request) {
  if (has_pieces(name))
    fail("file", "names other files as its pieces", "give its path, not its bytes");
  const SoupReader reader = soup_reader(lower_extension(name));
  if (bytes.empty()) fail("file", "is empty", "export the mesh again");
  return read_as(name, bytes, reader, request);
}

}  // namespace crest::io
