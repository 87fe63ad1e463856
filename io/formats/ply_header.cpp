// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/formats/ply_header.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "io/formats/files.hpp"
#include "io/formats/text_scan.hpp"

namespace crest::io {
namespace {

[[noreturn]] void fail_line(const TextScan& scan, const std::string& problem) {
  fail(fmt::format("header (line {})", scan.line()), problem, "correct the PLY header");
}

NumberType take_type(TextScan& scan) {
  static const std::map<std::string_view, NumberType> types = {
      {"char", NumberType::i8},     {"int8", NumberType::i8},    {"uchar", NumberType::u8},
      {"uint8", NumberType::u8},    {"short", NumberType::i16},  {"int16", NumberType::i16},
      {"ushort", NumberType::u16},  {"uint16", NumberType::u16}, {"int", NumberType::i32},
      {"int32", NumberType::i32},   {"uint", NumberType::u32},   {"uint32", NumberType::u32},
      {"int64", NumberType::i64},   {"uint64", NumberType::u64}, {"float", NumberType::f32},
      {"float32", NumberType::f32}, {"double", NumberType::f64}, {"float64", NumberType::f64}};
  if (!scan.in_line()) fail_line(scan, "incomplete property");
  const auto found = types.find(scan.peek());
  if (found == types.end()) fail_line(scan, "unknown type " + quoted(scan.peek()));
  scan.skip_word();
  return found->second;
}

void add_property(TextScan& scan, PlyHeader& header) {
  if (header.elements.empty()) fail_line(scan, "property without an element");
  PlyProperty property;
  property.list = scan.in_line() && scan.peek() == "list";
  if (property.list) {
    scan.skip_word();
    property.length = take_type(scan);
    if (is_real(property.length)) fail_line(scan, "the length of a list is not an integer");
  }
  property.value = take_type(scan);
  if (!scan.in_line()) fail_line(scan, "incomplete property");
  property.name = scan.word();
  header.elements.back().properties.push_back(std::move(property));
}

void add_element(TextScan& scan, PlyHeader& header) {
  PlyElement element;
  if (scan.in_line()) element.name = scan.word();
  std::int64_t count = 0;
  if (!scan.in_line() || !scan.take(count) || count < 0) fail_line(scan, "bad element count");
  element.count = static_cast<std::size_t>(count);
  header.elements.push_back(std::move(element));
}

void read_format(TextScan& scan, PlyHeader& header) {
  const std::string_view format = scan.in_line() ? scan.peek() : "";
  header.binary = format != "ascii";
  header.big_endian = format == "binary_big_endian";
  if (header.binary && !header.big_endian && format != "binary_little_endian")
    fail_line(scan, "unknown format " + quoted(format));
}

/// Up to the end of the line 'end_header'.
void read_lines(TextScan& scan, PlyHeader& header) {
  bool has_format = false;
  while (scan.more()) {
    const std::string_view keyword = scan.word();
    if (keyword == "end_header") {
      if (!has_format) fail("header", "has no 'format' line", "correct the PLY header");
      return;
    }
    if (keyword == "format") {
      read_format(scan, header);
      has_format = true;
    } else if (keyword == "element") {
      add_element(scan, header);
    } else if (keyword == "property") {
      add_property(scan, header);
    } else if (keyword != "comment" && keyword != "obj_info") {
      fail_line(scan, "unknown keyword " + quoted(keyword));
    }
    scan.next_line();
  }
  fail("header", "has no 'end_header'", "the file is truncated; export the mesh again");
}

void check_vertices(const PlyElement& element) {
  for (const char* name : {"x", "y", "z"}) {
    const PlyProperty* property = element.find(name);
    if (!property || property->list)
      fail("header", fmt::format("vertices have no number '{}'", name),
           "export the coordinates x, y and z");
  }
}

void check_corners(const PlyElement& element) {
  const PlyProperty* corners = element.corners();
  if (!corners || !corners->list || is_real(corners->value))
    fail("header", fmt::format("{}s have no list of integers 'vertex_indices'", element.singular()),
         "export vertex_indices as a list of int");
}

void check_element(const PlyElement& element, bool binary, std::size_t room) {
  if (element.count == 0) return;
  if (element.properties.empty())
    fail("header", "element '" + element.name + "' has no properties", "correct the header");
  // A number in a text is a digit and a blank; the last blank may miss.
  const std::size_t least = binary ? element.least_size() : 2 * element.properties.size();
  if (element.count > (room + 1) / least) {
    fail("header",
         fmt::format("announces {} of element '{}', more than the file holds", element.count,
                     element.name),
         "the file is truncated or its header wrong; export the mesh again");
  }
}

void check_elements(const PlyHeader& header, std::size_t room, bool points_will_do) {
  bool faces = false;
  std::string others;
  for (const PlyElement& element : header.elements) {
    const auto is_like = [&](const PlyElement& e) { return e.kind() == element.kind(); };
    if (element.kind() != PlyElement::Kind::other &&
        std::count_if(header.elements.begin(), header.elements.end(), is_like) > 1)
      fail("header", "element '" + element.name + "' is there twice", "correct the header");
    if (element.vertices()) check_vertices(element);
    if (element.faces() || element.strips()) {
      check_corners(element);
      faces = faces || element.count > 0;
    } else if (!element.vertices()) {
      others += " '" + element.name + "'";
    }
    check_element(element, header.binary, room);
  }
  if (points_will_do) return;
  if (!faces && !others.empty())
    fail("faces", "there are none, only elements" + others, "convert these to triangles");
  if (!faces) fail("faces", "there are none", "export the mesh with its faces");
}

}  // namespace

PlyElement::Kind PlyElement::kind() const {
  if (name == "vertex" || name == "vertices") return Kind::vertices;
  if (name == "face" || name == "faces") return Kind::faces;
  return name == "tristrips" ? Kind::strips : Kind::other;
}

const PlyProperty* PlyElement::find(std::string_view property) const {
  const auto found = std::find_if(properties.begin(), properties.end(),
                                  [&](const PlyProperty& p) { return p.name == property; });
  return found == properties.end() ? nullptr : &*found;
}

const PlyProperty* PlyElement::corners() const {
  if (!faces() && !strips()) return nullptr;
  const PlyProperty* indices = find("vertex_indices");
  return indices ? indices : find("vertex_index");
}

std::size_t PlyElement::least_size() const {
  std::size_t size = 0;
  for (const PlyProperty& p : properties) size += size_of(p.list ? p.length : p.value);
  return size;
}

PlyHeader read_ply_header(std::string_view bytes, bool points_will_do) {
  TextScan scan(bytes);
  if (scan.peek() != "ply")
    fail("header (line 1)", "does not start with 'ply'", "correct the PLY header");
  // Data may start with a line feed, so only the line end of the first line counts.
  scan.skip_word();
  const std::size_t end = bytes.find_first_of("\r\n", scan.position());
  const bool old_mac = end < bytes.size() && bytes[end] == '\r' && bytes.substr(end, 2) != "\r\n";
  PlyHeader header;
  scan.next_line();
  read_lines(scan, header);
  scan.rest_of_line();
  if (!old_mac)
    scan.next_line();
  else if (scan.room() > 0)
    scan.take_bytes(1);
  header.size = scan.position();
  check_elements(header, scan.room(), points_will_do);
  return header;
}

}  // namespace crest::io
