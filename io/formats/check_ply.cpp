// SPDX-License-Identifier: GPL-3.0-or-later
// Checks of PLY before CGAL reads it: CGAL trusts the header's counts and types and every list's
// length.
#include <fmt/format.h>

#include <bit>
#include <cmath>
#include <cstring>
#include <map>

#include "io/formats/files.hpp"
#include "io/formats/readers.hpp"
#include "io/formats/text_scan.hpp"

namespace crest::io {
namespace {

struct Scalar {
  std::size_t size = 0;
  bool floating = false, is_signed = false;
};

struct Property {
  std::string name;
  bool list = false;
  Scalar length, value;
};

struct Element {
  std::string name;
  std::size_t count = 0;
  std::vector<Property> properties;
  bool vertices() const { return name == "vertex" || name == "vertices"; }
  bool faces() const { return name == "face" || name == "faces"; }
};

struct Header {
  bool binary = false, big_endian = false;
  std::vector<Element> elements;
  std::size_t size = 0;   ///< bytes up to the data
  std::size_t lines = 0;  ///< up to the data
};

[[noreturn]] void fail_header(std::size_t line, const std::string& problem) {
  fail(fmt::format("header (line {})", line), problem, "correct the PLY header");
}

Scalar scalar_of(std::string_view word, std::size_t line) {
  static const std::map<std::string_view, Scalar> types = {
      {"char", {1, false, true}},    {"int8", {1, false, true}},    {"uchar", {1, false, false}},
      {"uint8", {1, false, false}},  {"short", {2, false, true}},   {"int16", {2, false, true}},
      {"ushort", {2, false, false}}, {"uint16", {2, false, false}}, {"int", {4, false, true}},
      {"int32", {4, false, true}},   {"uint", {4, false, false}},   {"uint32", {4, false, false}},
      {"float", {4, true, true}},    {"float32", {4, true, true}},  {"double", {8, true, true}},
      {"float64", {8, true, true}}};
  const auto found = types.find(word);
  if (found == types.end())
    fail_header(line, "unknown type '" + std::string(word.substr(0, 40)) + "'");
  return found->second;
}

Property property_of(const std::vector<std::string_view>& words, std::size_t line) {
  Property property;
  property.list = words.size() > 1 && words[1] == "list";
  if (words.size() < (property.list ? 5u : 3u)) fail_header(line, "incomplete property");
  if (property.list) {
    property.length = scalar_of(words[2], line);
    if (property.length.floating) fail_header(line, "the length of a list is not an integer");
  }
  property.value = scalar_of(words[property.list ? 3 : 1], line);
  property.name = words[property.list ? 4 : 2];
  return property;
}

void add_header_line(Header& header, const std::vector<std::string_view>& words, std::size_t line) {
  if (words[0] == "element") {
    const auto count = words.size() < 3 ? std::nullopt : integer_of(words[2]);
    if (!count || *count < 0) fail_header(line, "bad element count");
    header.elements.push_back({std::string(words[1]), static_cast<std::size_t>(*count), {}});
  } else if (words[0] == "property") {
    if (header.elements.empty()) fail_header(line, "property without an element");
    header.elements.back().properties.push_back(property_of(words, line));
  } else if (words[0] != "comment" && words[0] != "obj_info") {
    fail_header(line, "unknown keyword '" + std::string(words[0].substr(0, 40)) + "'");
  }
}

Header header_of(std::string_view bytes) {
  Header header;
  LineScanner scanner(bytes);
  if (!scanner.next() || scanner.number() != 1 || scanner.words()[0] != "ply")
    fail_header(1, "does not start with 'ply'");
  if (!scanner.next() || scanner.number() != 2 || scanner.words()[0] != "format" ||
      scanner.words().size() < 3)
    fail_header(2, "has no 'format' line");
  const std::string_view format = scanner.words()[1];
  header.binary = format != "ascii";
  header.big_endian = format == "binary_big_endian";
  if (header.binary && !header.big_endian && format != "binary_little_endian")
    fail_header(2, "unknown format '" + std::string(format.substr(0, 40)) + "'");
  for (std::size_t line = 3; scanner.next(); ++line) {
    if (scanner.number() != line) fail_header(line, "is blank");
    if (scanner.words()[0] == "end_header") {
      header.size = std::min(scanner.offset() + scanner.line().size() + 1, bytes.size());
      header.lines = line;
      return header;
    }
    add_header_line(header, scanner.words(), line);
  }
  fail("header", "has no 'end_header'", "the file is truncated; export the mesh again");
}

const Property* find(const Element& element, std::string_view name) {
  for (const Property& property : element.properties)
    if (property.name == name) return &property;
  return nullptr;
}

/// What CGAL's reader takes for granted.
void check_vertices(const Element& element) {
  for (const char* name : {"x", "y", "z"}) {
    const Property* property = find(element, name);
    if (!property || property->list || !property->value.floating) {
      fail("header", fmt::format("vertices have no float or double property '{}'", name),
           "export coordinates as float or double");
    }
  }
}

void check_faces(const Element& element) {
  const Property* property = find(element, "vertex_indices");
  if (!property) property = find(element, "vertex_index");
  if (!property || !property->list || property->value.floating || property->value.size != 4) {
    fail("header", "faces have no list of int or uint 'vertex_indices'",
         "export vertex_indices as a list of int");
  }
}

bool is_corner_list(const Element& element, const Property& property) {
  const Property* indices = find(element, "vertex_indices");
  return &property == (indices ? indices : find(element, "vertex_index"));
}

void check_elements(const Header& header, std::size_t data_size) {
  bool faces = false;
  std::string others;
  for (const Element& element : header.elements) {
    if (element.vertices()) check_vertices(element);
    if (element.faces()) check_faces(element);
    if (element.faces() && element.count > 0) faces = true;
    if (!element.vertices() && !element.faces()) others += " '" + element.name + "'";
    if (element.name == "halfedge")
      fail("header", "elements 'halfedge' are not read", "export vertices and faces only");
    // A property takes a byte at least (a digit and a blank in a text; the last blank may miss).
    const std::size_t bytes = header.binary ? 1 : 2;
    if (element.count > 0 && element.properties.empty())
      fail("header", "element '" + element.name + "' has no properties", "correct the header");
    if (element.count > 0 &&
        element.count > (data_size + 1) / (bytes * element.properties.size())) {
      fail("header",
           fmt::format("announces {} of element '{}', more than the file holds", element.count,
                       element.name),
           "the file is truncated or its header wrong; export the mesh again");
    }
  }
  if (faces) return;
  if (others.empty()) fail("faces", "there are none", "export the mesh with its faces");
  fail("faces", "there are none, only elements" + others, "convert these to triangles");
}

/// Steps through the data one number at a time; throws where it ends too early.
class DataWalker {
 public:
  DataWalker(const Header& header, std::string_view bytes)
      : header_(header), bytes_(bytes), at_(header.size), line_(header.lines + 1) {}

  void start(const Element& element, std::size_t item) {
    element_ = &element;
    item_ = item;
  }
  std::string where() const {
    const std::string what = fmt::format("{} {}",
                                         element_->faces()      ? "face"
                                         : element_->vertices() ? "vertex"
                                                                : element_->name,
                                         item_);
    return header_.binary ? what : what + fmt::format(" (line {})", line_);
  }

  double next(const Scalar& type) { return header_.binary ? next_binary(type) : next_word(type); }

  /// Only for numbers whose value does not matter.
  void skip(const Scalar& type, std::size_t count) {
    if (header_.binary) {
      if (count > (bytes_.size() - at_) / type.size) fail_end();
      at_ += count * type.size;
    } else {
      for (std::size_t i = 0; i < count; ++i) next_word(type);
    }
  }

 private:
  [[noreturn]] void fail_end() const {
    fail(where(), "the file ends before or in it", "the file is truncated; export the mesh again");
  }

  double next_binary(const Scalar& type) {
    if (bytes_.size() - at_ < type.size) fail_end();
    std::uint64_t bits = 0;
    for (std::size_t i = 0; i < type.size; ++i) {
      const std::size_t at = header_.big_endian ? i : type.size - 1 - i;
      bits = bits << 8 | static_cast<unsigned char>(bytes_[at_ + at]);
    }
    at_ += type.size;
    if (type.floating && type.size == 8) return std::bit_cast<double>(bits);
    if (type.floating) return std::bit_cast<float>(static_cast<std::uint32_t>(bits));
    const std::size_t shift = 64 - 8 * type.size;
    if (!type.is_signed) return static_cast<double>(bits);
    return static_cast<double>(static_cast<std::int64_t>(bits << shift) >> shift);
  }

  double next_word(const Scalar& type) {
    while (at_ < bytes_.size() && std::string_view(" \t\r\n\v\f").find(bytes_[at_]) < 6)
      if (bytes_[at_++] == '\n') ++line_;
    if (at_ == bytes_.size()) fail_end();
    const std::size_t begin = at_;
    while (at_ < bytes_.size() && std::string_view(" \t\r\n\v\f").find(bytes_[at_]) > 6) ++at_;
    const std::string_view word = bytes_.substr(begin, at_ - begin);
    const std::string quoted(word.substr(0, 40));
    if (type.floating) {
      const auto value = number_of(word);
      if (!value) fail(where(), "'" + quoted + "' is not a number", "correct it");
      return *value;
    }
    const auto value = integer_of(word);
    if (!value) fail(where(), "'" + quoted + "' is not an integer", "correct it");
    if (!fits(*value, type)) fail(where(), quoted + " does not fit its type", "correct it");
    return static_cast<double>(*value);
  }

  /// CGAL reads bytes as short, hence the room it leaves.
  static bool fits(std::int64_t value, const Scalar& type) {
    const std::int64_t half = std::int64_t{1} << (8 * type.size - 1);
    return type.is_signed ? value >= -half && value < half : value >= 0 && value < 2 * half;
  }

  const Header& header_;
  std::string_view bytes_;
  std::size_t at_, line_;
  const Element* element_ = nullptr;
  std::size_t item_ = 0;
};

void check_property(DataWalker& walker, const Element& element, const Property& property) {
  if (!property.list) {
    if (!element.vertices()) return walker.skip(property.value, 1);
    const double value = walker.next(property.value);
    // A text reader stops at nan wherever it stands; coordinates must be finite in any case.
    const bool coordinate = property.name == "x" || property.name == "y" || property.name == "z";
    if (coordinate && !std::isfinite(value)) {
      fail(walker.where(), fmt::format("coordinate {} is not finite", property.name),
           "remove or repair the vertex");
    }
    return;
  }
  const double length = walker.next(property.length);
  if (length < 0) fail(walker.where(), "a list has a negative length", "correct it");
  if (element.faces() && is_corner_list(element, property))
    check_corner_count(static_cast<std::int64_t>(length), walker.where());
  walker.skip(property.value, static_cast<std::size_t>(length));
}

}  // namespace

void check_ply(const std::string& bytes) {
  const Header header = header_of(bytes);
  check_elements(header, bytes.size() - header.size);
  DataWalker walker(header, bytes);
  std::size_t vertices = 0, faces = 0, other = 0;
  for (const Element& element : header.elements) {
    std::size_t& count = element.vertices() ? vertices : element.faces() ? faces : other;
    for (std::size_t i = 0; i < element.count; ++i) {
      walker.start(element, count++);
      for (const Property& property : element.properties) check_property(walker, element, property);
    }
    other = 0;
  }
}

}  // namespace crest::io
