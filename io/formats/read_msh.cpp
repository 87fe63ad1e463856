// SPDX-License-Identifier: GPL-3.0-or-later
// Gmsh meshes, versions 2 and 4.1, text or binary: nodes, elements of every type, $NodeData and
// $ElementData. The nodes of solids of higher order stay in Gmsh's order.
// Gmsh's own library would bring a CAD kernel and a user interface along; VTK 9.1 has no reader.
#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "io/formats/files.hpp"
#include "io/formats/msh_fields.hpp"
#include "io/formats/msh_source.hpp"
#include "io/formats/readers.hpp"
#include "io/formats/remedy.hpp"

namespace crest::io {
namespace {

struct ElementType {
  CellType type = CellType::empty;
  std::size_t nodes = 0;  ///< 0: there is no such type
};

/// By Gmsh's numbers.
ElementType element_type(std::int64_t number) {
  using enum CellType;
  static constexpr std::array<ElementType, 32> first = {{{},
                                                         {line, 2},
                                                         {triangle, 3},
                                                         {quad, 4},
                                                         {tetrahedron, 4},
                                                         {hexahedron, 8},
                                                         {wedge, 6},
                                                         {pyramid, 5},
                                                         {quadratic_edge, 3},
                                                         {quadratic_triangle, 6},
                                                         {biquadratic_quad, 9},
                                                         {quadratic_tetrahedron, 10},
                                                         {triquadratic_hexahedron, 27},
                                                         {biquadratic_wedge, 18},
                                                         {lagrange_pyramid, 14},
                                                         {vertex, 1},
                                                         {quadratic_quad, 8},
                                                         {quadratic_hexahedron, 20},
                                                         {quadratic_wedge, 15},
                                                         {quadratic_pyramid, 13},
                                                         {lagrange_triangle, 9},
                                                         {lagrange_triangle, 10},
                                                         {lagrange_triangle, 12},
                                                         {lagrange_triangle, 15},
                                                         {lagrange_triangle, 15},
                                                         {lagrange_triangle, 21},
                                                         {lagrange_curve, 4},
                                                         {lagrange_curve, 5},
                                                         {lagrange_curve, 6},
                                                         {lagrange_tetrahedron, 20},
                                                         {lagrange_tetrahedron, 35},
                                                         {lagrange_tetrahedron, 56}}};
  if (number > 0 && number < static_cast<std::int64_t>(first.size()))
    return first[static_cast<std::size_t>(number)];
  switch (number) {
    case 36:
      return {lagrange_quad, 16};
    case 37:
      return {lagrange_quad, 25};
    case 38:
      return {lagrange_quad, 36};
    case 92:
      return {lagrange_hexahedron, 64};
    case 93:
      return {lagrange_hexahedron, 125};
    default:
      return {};
  }
}

class MshReader {
 public:
  MshReader(std::string_view bytes, const FieldRequest& request)
      : source_(bytes), fields_(source_, request) {}

  Soup read() {
    while (!source_.next_section().empty()) {
      const std::string& section = source_.section();
      if (section == "$MeshFormat")
        read_format();
      else if (section == "$Nodes")
        version_ < 3 ? read_nodes_2() : read_nodes_4();
      else if (section == "$Elements")
        version_ < 3 ? read_elements_2() : read_elements_4();
      else if (section == "$NodeData" || section == "$ElementData")
        fields_.read_section();
      else if (section == "$NOD")
        fail("$NOD", "is of Gmsh's format 1",
             "save as 4.1 (gmsh FILE -0 -format msh41 -o NEW.msh)");
      source_.end_section();
    }
    if (version_ == 0) fail("file", "has no $MeshFormat", "save it from Gmsh as .msh");
    if (nodes_) soup_.point_fields = fields_.take(true, *nodes_, soup_.points.size(), soup_);
    soup_.cell_fields = fields_.take(false, elements(), soup_.cells.size(), soup_);
    return std::move(soup_);
  }

 private:
  void read_format() {
    source_.begin_line();
    version_ = source_.word_real();
    if (!(version_ >= 2 && version_ < 3) && version_ != 4.1)
      fail("$MeshFormat", "is neither 2.2 nor 4.1", "save as one of these");
    const bool binary = source_.word_integer() != 0;
    if (source_.in_line() && source_.word_integer() != 8)
      fail("$MeshFormat", "has numbers of another size than 8 bytes", kExportMesh);
    source_.end_line();
    if (binary) source_.set_binary();
  }

  void add_node(std::int64_t tag) {
    kernel::Vec3 point{};
    for (double& x : point) x = source_.real();
    if (!std::isfinite(point[0]) || !std::isfinite(point[1]) || !std::isfinite(point[2])) {
      if (!source_.binary())
        soup_.lines_not_finite.emplace_back(soup_.points.size(), source_.line_number());
    }
    soup_.points.push_back(point);
    soup_.point_tags.push_back(tag);
  }

  /// Only fields of elements ask for them by tag, and then no tag may be there twice.
  TagTable elements() const {
    return TagTable(fields_.any(false) ? soup_.cell_tags : std::vector<std::int64_t>(), "element");
  }

  void end_nodes() { nodes_.emplace(soup_.point_tags, "node"); }

  /// A count on a line of its own, in binary files, too.
  std::int64_t count_line() {
    source_.begin_line();
    const std::int64_t count = source_.word_integer();
    source_.end_line();
    return count;
  }

  void read_nodes_2() {
    const std::int64_t count = count_line();
    for (std::int64_t i = 0; i < count; ++i) {
      source_.begin_record();
      add_node(source_.integer());
      source_.end_record();
    }
    end_nodes();
  }

  /// The head of $Nodes and $Elements: blocks, all, least tag, greatest tag.
  std::int64_t blocks() {
    source_.begin_record();
    const std::int64_t count = source_.size();
    for (int i = 0; i < 3; ++i) source_.size();
    source_.end_record();
    return count;
  }

  void read_nodes_4() {
    std::vector<std::int64_t> tags;
    for (std::int64_t b = blocks(); b > 0; --b) {
      source_.begin_record();
      const std::int64_t dimension = source_.integer();
      source_.integer();
      const bool parametric = source_.integer() != 0;
      const std::int64_t count = source_.size();
      source_.end_record();
      tags.clear();
      for (std::int64_t i = 0; i < count; ++i) {
        source_.begin_record();
        tags.push_back(source_.size());
        source_.end_record();
      }
      for (const std::int64_t tag : tags) {
        source_.begin_record();
        add_node(tag);
        const bool places = parametric && source_.binary();  // in a text: the rest of the line
        for (std::int64_t k = 0; places && k < dimension; ++k) source_.real();
        source_.end_record();
      }
    }
    end_nodes();
  }

  /// The nodes follow: of type `size` or of type int.
  void add_element(std::int64_t tag, std::int64_t type_number, bool wide) {
    const auto name = [&] { return source_.name_of("element", tag); };
    const ElementType type = element_type(type_number);
    if (type.nodes == 0)
      fail(name(), fmt::format("has the unknown type {}", type_number), kExportMesh);
    element_.clear();
    for (std::size_t k = 0; k < type.nodes; ++k) {
      if (!source_.binary() && !source_.in_line()) {
        fail(name(), fmt::format("has {} nodes instead of {}", k, type.nodes),
             k >= 3 ? "its mid-side nodes are missing, add them" : kExportMesh);
      }
      const std::int64_t node = wide ? source_.size() : source_.integer();
      const auto position = nodes_ ? nodes_->find(node) : std::nullopt;
      if (!position) fail(name(), fmt::format("node {} does not exist", node), kExportMesh);
      element_.push_back(static_cast<Cells::Node>(*position));
    }
    if (!source_.binary() && source_.in_line())
      fail(name(), fmt::format("has more than {} nodes", type.nodes), kExportMesh);
    if (type.type == CellType::quadratic_tetrahedron) std::swap(element_[8], element_[9]);
    soup_.cells.add(type.type, element_);
    soup_.cell_tags.push_back(tag);
  }

  void skip_tags(std::int64_t count) {
    if (count < 0 || count > 1000)
      fail(source_.binary() ? source_.section() : source_.line(), "has a bad number of tags",
           kExportMesh);
    for (std::int64_t i = 0; i < count; ++i) source_.integer();
  }

  void read_elements_2() {
    const std::int64_t count = count_line();
    for (std::int64_t done = 0; done < count;) {
      if (source_.binary()) {
        // Elements of one type have one head.
        const std::int64_t type = source_.integer(), follow = source_.integer(),
                           tags = source_.integer();
        if (follow <= 0) fail("$Elements", "has an empty block", kExportMesh);
        for (std::int64_t i = 0; i < follow; ++i, ++done) {
          const std::int64_t tag = source_.integer();
          skip_tags(tags);
          add_element(tag, type, false);
        }
        continue;
      }
      source_.begin_line();
      const std::int64_t tag = source_.integer(), type = source_.integer();
      skip_tags(source_.integer());
      add_element(tag, type, false);
      source_.end_line();
      ++done;
    }
  }

  void read_elements_4() {
    for (std::int64_t b = blocks(); b > 0; --b) {
      source_.begin_record();
      source_.integer();
      source_.integer();
      const std::int64_t type = source_.integer(), count = source_.size();
      source_.end_record();
      for (std::int64_t i = 0; i < count; ++i) {
        source_.begin_record();
        const std::int64_t tag = source_.size();
        add_element(tag, type, true);
        source_.end_record();
      }
    }
  }

  MshSource source_;
  MshFields fields_;
  double version_ = 0;
  std::optional<TagTable> nodes_;
  std::vector<Cells::Node> element_;
  Soup soup_;
};

}  // namespace

Soup read_msh(std::string_view bytes, const FieldRequest& request) {
  return MshReader(bytes, request).read();
}

}  // namespace crest::io
