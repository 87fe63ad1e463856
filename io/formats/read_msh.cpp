// SPDX-License-Identifier: GPL-3.0-or-later
// Gmsh meshes, text versions 2.2 and 4.1: triangles of first and second order with $NodeData.
// Gmsh's own library would bring a CAD kernel and a user interface along; VTK 9.1 has no reader.
#include <fmt/format.h>

#include <algorithm>
#include <unordered_map>

#include "io/formats/files.hpp"
#include "io/formats/readers.hpp"
#include "io/formats/text_scan.hpp"

namespace crest::io {
namespace {

constexpr const char* kRepair = "export the mesh again";
constexpr std::int64_t kTriangle = 2, kQuadraticTriangle = 9;

/// One time step of a field.
struct NodeData {
  std::string name;
  int components = 0;
  bool needed = false;
  std::vector<std::pair<std::int64_t, double>> values;  ///< node's tag, value
};

class MshReader {
 public:
  MshReader(const std::string& text, const FieldRequest& request)
      : scan_(text), request_(request) {}

  Soup read() {
    while (scan_.next()) {
      const std::string section(scan_.words()[0]);
      if (section == "$MeshFormat")
        read_format();
      else if (section == "$Nodes")
        version_ < 3 ? read_nodes_2() : read_nodes_4();
      else if (section == "$Elements")
        version_ < 3 ? read_elements_2() : read_elements_4();
      else if (section == "$NodeData")
        read_node_data();
      if (section[0] == '$') skip_to_end(section);
    }
    if (version_ == 0) fail("file", "has no $MeshFormat", kRepair);
    finish();
    return std::move(soup_);
  }

 private:
  std::string line() const { return fmt::format("line {}", scan_.number()); }

  void require_line(const char* section) {
    if (!scan_.next() || scan_.words()[0][0] == '$')
      fail(section, fmt::format("ends early (line {})", scan_.number()), kRepair);
  }

  std::int64_t integer(std::size_t word) const {
    const auto& words = scan_.words();
    const auto value = word < words.size() ? integer_of(words[word]) : std::nullopt;
    if (!value) fail(line(), fmt::format("word {} is not an integer", word + 1), kRepair);
    return *value;
  }

  double number(std::size_t word) const {
    const auto& words = scan_.words();
    const auto value = word < words.size() ? number_of(words[word]) : std::nullopt;
    if (!value) fail(line(), fmt::format("word {} is not a number", word + 1), kRepair);
    return *value;
  }

  void skip_to_end(const std::string& section) {
    const std::string end = "$End" + section.substr(1);
    do {
      if (scan_.words()[0] == end) return;
    } while (scan_.next());
    fail(section.substr(0, 40), "does not end", "the file is truncated; export the mesh again");
  }

  void read_format() {
    require_line("$MeshFormat");
    version_ = number(0);
    if (version_ != 2.2 && version_ != 4.1)
      fail("$MeshFormat", "is neither 2.2 nor 4.1", "save as one of these");
    if (integer(1) != 0) fail("$MeshFormat", "is binary", "save as text (Mesh.Binary = 0)");
  }

  void add_node(std::int64_t tag, std::size_t first) {
    const auto name = [&] { return fmt::format("node {} ({})", tag, line()); };
    const kernel::Vec3 point = coordinates(scan_.words(), first, name);
    if (!node_.emplace(tag, soup_.points.size()).second) fail(name(), "is there twice", kRepair);
    soup_.points.push_back(point);
    soup_.point_tags.push_back(tag);
  }

  void read_nodes_2() {
    require_line("$Nodes");
    const std::int64_t count = integer(0);
    for (std::int64_t i = 0; i < count; ++i) {
      require_line("$Nodes");
      add_node(integer(0), 1);
    }
  }

  void read_nodes_4() {
    require_line("$Nodes");
    const std::int64_t blocks = integer(0);
    std::vector<std::int64_t> tags;
    for (std::int64_t b = 0; b < blocks; ++b) {
      require_line("$Nodes");
      const std::int64_t count = integer(3);
      tags.clear();
      for (std::int64_t i = 0; i < count; ++i) {
        require_line("$Nodes");
        tags.push_back(integer(0));
      }
      for (const std::int64_t tag : tags) {
        require_line("$Nodes");
        add_node(tag, 0);
      }
    }
  }

  std::size_t node(std::int64_t tag, const std::string& element) const {
    const auto found = node_.find(tag);
    if (found == node_.end()) fail(element, fmt::format("node {} does not exist", tag), kRepair);
    return found->second;
  }

  /// Points and lines (types 1, 8, 15 and the like) are how a mesh knows its boundary: left out.
  static bool is_thin(std::int64_t type) {
    return type == 1 || type == 8 || type == 15 || (type >= 26 && type <= 28);
  }

  void add_element(std::int64_t tag, std::int64_t type, std::size_t first) {
    if (is_thin(type)) return;
    const std::string element = fmt::format("element {} ({})", tag, line());
    if (type != kTriangle && type != kQuadraticTriangle) {
      fail(element, fmt::format("has type {}", type),
           "give triangles of first (type 2) or second order (9)");
    }
    const std::size_t wanted = type == kTriangle ? 3 : 6, words = scan_.words().size();
    if (words != first + wanted) {
      const std::size_t given = words - std::min(words, first);
      fail(element, fmt::format("has {} nodes instead of {}", given, wanted),
           wanted == 6 && given < 6 ? "its mid-side nodes are missing, add them" : kRepair);
    }
    std::array<Cells::Node, 6> nodes{};
    for (std::size_t k = 0; k < wanted; ++k)
      nodes[k] = static_cast<Cells::Node>(node(integer(first + k), element));
    soup_.cells.add(wanted == 3 ? CellType::triangle : CellType::quadratic_triangle,
                    {nodes.data(), wanted});
    soup_.cell_tags.push_back(tag);
  }

  void read_elements_2() {
    require_line("$Elements");
    const std::int64_t count = integer(0);
    for (std::int64_t i = 0; i < count; ++i) {
      require_line("$Elements");
      const std::int64_t tags = integer(2);
      if (tags < 0 || tags > 1000) fail(line(), "has a bad number of tags", kRepair);
      add_element(integer(0), integer(1), 3 + static_cast<std::size_t>(tags));
    }
  }

  void read_elements_4() {
    require_line("$Elements");
    const std::int64_t blocks = integer(0);
    for (std::int64_t b = 0; b < blocks; ++b) {
      require_line("$Elements");
      const std::int64_t type = integer(2), count = integer(3);
      for (std::int64_t i = 0; i < count; ++i) {
        require_line("$Elements");
        add_element(integer(0), type, 1);
      }
    }
  }

  /// A count line, then so many lines; the last line read is the first of them.
  std::int64_t begin_list(const char* what) {
    require_line("$NodeData");
    const std::int64_t count = integer(0);
    if (count < 0 || count > 1000) fail(line(), fmt::format("bad number of {}", what), kRepair);
    return count;
  }

  void read_node_data() {
    NodeData data;
    const std::int64_t strings = begin_list("names");
    for (std::int64_t i = 0; i < strings; ++i) {
      require_line("$NodeData");
      if (i > 0) continue;
      const std::string_view text = scan_.line();
      const std::size_t begin = text.find('"'), end = text.rfind('"');
      data.name = begin < end && end != text.npos ? text.substr(begin + 1, end - begin - 1)
                                                  : scan_.words()[0];
    }
    for (std::int64_t i = begin_list("reals"); i > 0; --i) require_line("$NodeData");
    const std::int64_t integers = begin_list("integers");
    std::int64_t numbers[3] = {0, 1, 0};  // time step, components, nodes
    for (std::int64_t i = 0; i < integers; ++i) {
      require_line("$NodeData");
      if (i < 3) numbers[i] = integer(0);
    }
    data.components = static_cast<int>(std::clamp<std::int64_t>(numbers[1], 0, 1000));
    data.needed = request_.wanted && data.components == 1 &&
                  (request_.name.empty() || request_.name == data.name);
    for (std::int64_t i = 0; data.needed && i < numbers[2]; ++i) {
      require_line("$NodeData");
      data.values.emplace_back(integer(0), number(1));
    }
    fields_.push_back(std::move(data));
  }

  void finish() {
    for (const NodeData& data : fields_) {
      Field& field =
          soup_.point_fields.emplace_back(Field{.name = data.name, .components = data.components});
      if (!data.needed) continue;
      std::vector<double> values(soup_.points.size(), 0);
      field.missing.assign(soup_.points.size(), true);
      for (const auto& [tag, value] : data.values) {
        const std::size_t v = node(tag, fmt::format("field '{}'", data.name));
        values[v] = value;
        field.missing[v] = false;
      }
      field.numbers = std::move(values);
    }
  }

  LineScanner scan_;
  const FieldRequest& request_;
  double version_ = 0;
  std::unordered_map<std::int64_t, std::size_t> node_;
  std::vector<NodeData> fields_;
  Soup soup_;
};

}  // namespace

Soup read_msh(std::string bytes, const FieldRequest& request) {
  check_text(bytes);
  if (bytes.find("$MeshFormat") == std::string::npos)
    fail("file", "has no $MeshFormat", "save it from Gmsh as .msh");
  return MshReader(bytes, request).read();
}

}  // namespace crest::io
