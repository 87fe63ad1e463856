// SPDX-License-Identifier: GPL-3.0-or-later
// Normals of PLY files, text or binary.
#include <array>
#include <bit>
#include <cstdint>
#include <map>
#include <sstream>

#include "io/formats/files.hpp"
#include "io/formats/readers.hpp"

namespace crest::io {
namespace {

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
  if (found == sizes.end()) fail("header", "unknown PLY type", "export the mesh again");
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
      if (first != vertices) fail("header", "vertices do not come first", "export again");
      if (vertices) words >> v.count;
    }
    if (word == "property" && (element == "vertex" || element == "vertices")) {
      words >> type >> name;
      if (type == "list") fail("header", "a vertex has a list", "export the mesh again");
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

std::vector<Field> field_of(std::vector<double> normals) {
  return {{.name = "Normals", .components = 3, .numbers = std::move(normals), .normals = true}};
}

}  // namespace

std::vector<Field> ply_normals(const std::string& bytes) {
  const PlyVertices v = vertices_of(bytes);
  std::array<std::size_t, 3> column{}, offset{};
  std::size_t found = 0, stride = 0;
  for (std::size_t i = 0; i < v.properties.size(); ++i) {
    const auto& [name, type] = v.properties[i];
    for (std::size_t k = 0; k < 3; ++k) {
      if (name != std::string("n") + "xyz"[k]) continue;
      if (type[0] != 'f' && type[0] != 'd') fail("normals", "they are integers", "export as float");
      column[k] = i;
      offset[k] = stride;
      ++found;
    }
    stride += size_of(type);
  }
  if (found != 3) return {};
  std::vector<double> normals;
  if (v.format == "ascii") {
    std::istringstream text(bytes.substr(v.data));
    std::vector<double> row(v.properties.size());
    for (std::size_t i = 0; i < v.count; ++i) {
      for (double& x : row)
        if (!(text >> x)) fail("vertex " + std::to_string(i), "bad number", "correct it");
      for (const std::size_t k : column) normals.push_back(row[k]);
    }
    return field_of(std::move(normals));
  }
  if ((bytes.size() - v.data) / stride < v.count)
    fail("file", "ends within the vertices", "export the mesh again");
  const bool big = v.format == "binary_big_endian";
  for (std::size_t i = 0; i < v.count; ++i) {
    const char* row = bytes.data() + v.data + i * stride;
    for (std::size_t k = 0; k < 3; ++k)
      normals.push_back(binary_value(row + offset[k], v.properties[column[k]].type, big));
  }
  return field_of(std::move(normals));
}

}  // namespace crest::io
