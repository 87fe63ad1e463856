// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/read/normals_reader.hpp"

#include <vtkDataArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkXMLPolyDataReader.h>

#include <bit>
#include <cstdint>
#include <cstring>
#include <fstream>
#include <iterator>
#include <map>
#include <sstream>

#include "io/formats/vtk_quiet.hpp"
#include "io/write/formats.hpp"
#include "kernel/geometry/input_error.hpp"

namespace crest::io {
namespace {

using kernel::InputError;
using kernel::Vec3;

std::string bytes_of(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  if (!file) throw InputError("file: cannot be read; check its name and permissions");
  return {std::istreambuf_iterator<char>(file), {}};
}

[[noreturn]] void fail_without_normals() {
  throw InputError("normals: the file has none; use --normals estimated");
}

std::vector<Vec3> normals_of_vtp(const std::string& path) {
  const VtkQuiet quiet;
  vtkNew<vtkXMLPolyDataReader> reader;
  reader->SetFileName(path.c_str());
  reader->Update();
  vtkPolyData* data = reader->GetOutput();
  if (quiet.failed() || !data) throw InputError("file: cannot be read as VTP; export it again");
  vtkDataArray* array = data->GetPointData()->GetNormals();
  if (!array) array = data->GetPointData()->GetArray("Normals");
  if (!array) fail_without_normals();
  if (array->GetNumberOfComponents() != 3)
    throw InputError("normals: they have not three components; export the mesh again");
  std::vector<Vec3> normals(static_cast<std::size_t>(array->GetNumberOfTuples()));
  for (std::size_t i = 0; i < normals.size(); ++i)
    array->GetTuple(static_cast<vtkIdType>(i), normals[i].data());
  return normals;
}

struct Property {
  std::string name, type;
};

/// The vertex element's part of a PLY header: it must be the first element, as it is by custom.
struct PlyVertices {
  std::string format;
  std::size_t count = 0, data = 0;
  std::vector<Property> properties;
};

std::size_t size_of(const std::string& type) {
  static const std::map<std::string, std::size_t> sizes = {
      {"char", 1},   {"int8", 1},    {"uchar", 1},  {"uint8", 1},  {"short", 2}, {"int16", 2},
      {"ushort", 2}, {"uint16", 2},  {"int", 4},    {"int32", 4},  {"uint", 4},  {"uint32", 4},
      {"float", 4},  {"float32", 4}, {"double", 8}, {"float64", 8}};
  const auto found = sizes.find(type);
  if (found == sizes.end()) throw InputError("header: unknown PLY type; export the mesh again");
  return found->second;
}

PlyVertices vertices_of(const std::string& bytes) {
  PlyVertices v;
  std::istringstream header(bytes.substr(0, bytes.find("end_header")));
  std::string element;
  for (std::string line; std::getline(header, line);) {
    std::istringstream words(line);
    std::string word, type, name;
    words >> word;
    if (word == "format") words >> v.format;
    if (word == "element") {
      const bool first = element.empty();
      words >> element;
      const bool vertices = element == "vertex" || element == "vertices";
      if (first != vertices) throw InputError("header: vertices do not come first; export again");
      if (vertices) words >> v.count;
    }
    if (word == "property" && (element == "vertex" || element == "vertices")) {
      words >> type >> name;
      if (type == "list") throw InputError("header: a vertex has a list; export the mesh again");
      size_of(type);
      v.properties.push_back({name, type});
    }
  }
  const std::size_t end = bytes.find('\n', bytes.find("end_header"));
  v.data = end == std::string::npos ? bytes.size() : end + 1;
  return v;
}

double binary_value(const char* at, const std::string& type, bool big_endian) {
  const std::size_t size = size_of(type);
  std::uint64_t bits = 0;
  for (std::size_t i = 0; i < size; ++i)
    bits = bits << 8 | static_cast<unsigned char>(at[big_endian ? i : size - 1 - i]);
  if (size == 8) return std::bit_cast<double>(bits);
  return std::bit_cast<float>(static_cast<std::uint32_t>(bits));
}

std::vector<Vec3> normals_of_ply(const std::string& path) {
  const std::string bytes = bytes_of(path);
  const PlyVertices v = vertices_of(bytes);
  std::array<std::size_t, 3> column{}, offset{};
  std::size_t found = 0, stride = 0;
  for (std::size_t i = 0; i < v.properties.size(); ++i) {
    const auto& [name, type] = v.properties[i];
    for (std::size_t k = 0; k < 3; ++k) {
      if (name != std::string("n") + "xyz"[k]) continue;
      if (type[0] != 'f' && type[0] != 'd')
        throw InputError("normals: they are integers; export as float");
      column[k] = i;
      offset[k] = stride;
      ++found;
    }
    stride += size_of(type);
  }
  if (found != 3) fail_without_normals();
  std::vector<Vec3> normals;
  if (v.format == "ascii") {
    std::istringstream text(bytes.substr(v.data));
    std::vector<double> row(v.properties.size());
    for (std::size_t i = 0; i < v.count; ++i) {
      for (double& x : row)
        if (!(text >> x))
          throw InputError("vertex " + std::to_string(i) + ": bad number; correct it");
      normals.push_back({row[column[0]], row[column[1]], row[column[2]]});
    }
    return normals;
  }
  if ((bytes.size() - v.data) / stride < v.count)
    throw InputError("file: ends within the vertices; export the mesh again");
  const bool big = v.format == "binary_big_endian";
  for (std::size_t i = 0; i < v.count; ++i) {
    const char* row = bytes.data() + v.data + i * stride;
    Vec3 n{};
    for (std::size_t k = 0; k < 3; ++k)
      n[k] = binary_value(row + offset[k], v.properties[column[k]].type, big);
    normals.push_back(n);
  }
  return normals;
}

}  // namespace

std::vector<Vec3> read_normals(const std::string& path) {
  try {
    const std::string extension = lower_extension(path);
    if (extension == ".vtp") return normals_of_vtp(path);
    if (extension == ".ply") return normals_of_ply(path);
    throw InputError("normals: only .ply and .vtp give them; convert the mesh or estimate them");
  } catch (const InputError& error) {
    throw error.with_file(path);
  }
}

}  // namespace crest::io
