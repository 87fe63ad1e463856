// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/mesh_reader.hpp"

#include <filesystem>
#include <fstream>
#include <map>
#include <new>

#include "io/formats.hpp"
#include "io/polygon_soup.hpp"
#include "kernel/geometry/input_error.hpp"

namespace crest::io {
namespace {

constexpr std::uintmax_t kLargestFile = std::uintmax_t{1} << 36;

std::string load(const std::string& path) {
  std::error_code error;
  if (!std::filesystem::exists(path, error)) {
    fail("file", "does not exist", "check the path");
  }
  if (!std::filesystem::is_regular_file(path, error)) {
    fail("file", "is not a regular file", "give the path of a mesh file");
  }
  const auto size = std::filesystem::file_size(path, error);
  if (error || size > kLargestFile) fail("file", "is too large", "split the mesh");
  if (size == 0) fail("file", "is empty", "export the mesh again");
  std::string bytes(static_cast<std::size_t>(size), '\0');
  std::ifstream stream(path, std::ios::binary);
  if (!stream.read(bytes.data(), static_cast<std::streamsize>(bytes.size()))) {
    fail("file", "cannot be read", "check its permissions");
  }
  return bytes;
}

MeshFile read_without_name(const std::string& path) {
  using Reader = PolygonSoup (*)(std::string);
  static const std::map<std::string, Reader> readers = {{".off", read_off},
                                                        {".obj", read_obj},
                                                        {".ply", read_ply},
                                                        {".stl", read_stl},
                                                        {".vtp", read_vtp}};
  const std::string extension = lower_extension(path);
  const auto reader = readers.find(extension);
  if (reader == readers.end()) {
    fail("file",
         extension.empty() ? "has no extension" : "has the unknown extension '" + extension + "'",
         "use .off, .obj, .ply, .stl or .vtp");
  }
  std::string bytes = load(path);
  try {
    return mesh_of_soup(reader->second(std::move(bytes)));
  } catch (const kernel::InputError&) {
    throw;
  } catch (const std::bad_alloc&) {
    fail("file", "needs more memory than there is", "split the mesh");
  } catch (const std::exception&) {
    fail("file", "cannot be read as " + extension.substr(1), "export the mesh again");
  }
}

/// File names and words quoted from files may hold anything; the message stays one line.
std::string one_line(std::string text) {
  for (char& c : text) {
    if (static_cast<unsigned char>(c) < 0x20 || c == 0x7f) c = '?';
  }
  return text;
}

}  // namespace

void fail(const std::string& element, const std::string& problem, const std::string& remedy) {
  throw kernel::InputError(element + ": " + problem + "; " + remedy);
}

MeshFile read_mesh(const std::string& path) {
  try {
    return read_without_name(path);
  } catch (const kernel::InputError& error) {
    throw kernel::InputError(one_line(error.with_file(path).what()));
  }
}

}  // namespace crest::io
