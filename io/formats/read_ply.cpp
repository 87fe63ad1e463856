// SPDX-License-Identifier: GPL-3.0-or-later
// PLY, text or binary: vertices, faces, triangle strips and their properties. VTK's and assimp's
// readers narrow to float and know no fields; CGAL's knows neither strips nor short indices.
#include <fmt/format.h>

#include <algorithm>

#include "io/formats/files.hpp"
#include "io/formats/ply_header.hpp"
#include "io/formats/readers.hpp"
#include "io/formats/text_parts.hpp"
#include "io/formats/text_scan.hpp"

namespace crest::io {
namespace {

/// Where the numbers of a property go: one of the three, or nowhere.
struct Column {
  const PlyProperty* property = nullptr;
  double* reals = nullptr;
  std::int64_t* integers = nullptr;
  std::uint64_t* naturals = nullptr;
  std::size_t stride = 1;
  bool corners = false;
  bool is_read() const { return reals || integers || naturals; }
};

/// The columns of one element over the soup.
class Columns {
 public:
  Columns(const PlyElement& element, const FieldRequest& request, Soup& soup)
      : element_(element), request_(request), soup_(soup) {
    for (const PlyProperty& property : element.properties)
      columns_.push_back({.property = &property, .corners = &property == element.corners()});
    if (element.vertices()) {
      soup.points.resize(element.count);
      if (element.count > 0) take_triple({"x", "y", "z"}, soup.points[0].data());
      take_normals();
    }
    if (element.vertices() || element.faces()) {
      // Pointers to numbers of a field stay where its vector moves.
      for (Column& column : columns_)
        if (!column.reals && !column.corners) add_field(column);
    }
  }
  const std::vector<Column>& all() const { return columns_; }

 private:
  void take_triple(const std::array<const char*, 3>& names, double* numbers) {
    for (std::size_t k = 0; k < 3; ++k) {
      const PlyProperty* property = element_.find(names[k]);
      for (Column& column : columns_) {
        if (column.property != property) continue;
        column.reals = numbers + k;
        column.stride = 3;
      }
    }
  }

  void take_normals() {
    for (const char* name : {"nx", "ny", "nz"}) {
      const PlyProperty* property = element_.find(name);
      if (!property || property->list) return;
    }
    Field& field =
        soup_.point_fields.emplace_back(Field{.name = "Normals", .components = 3, .normals = true});
    field.type = element_.find("nx")->value;
    if (!request_.normals && !request_.asks_for(field.name)) return;
    auto& numbers = field.numbers.emplace<std::vector<double>>(3 * element_.count);
    if (!numbers.empty()) take_triple({"nx", "ny", "nz"}, numbers.data());
  }

  void add_field(Column& column) {
    const PlyProperty& property = *column.property;
    auto& fields = element_.vertices() ? soup_.point_fields : soup_.cell_fields;
    if (is_normal(property)) return;
    Field& field =
        fields.emplace_back(Field{.name = property.name, .components = property.list ? 0 : 1});
    field.type = property.value;
    if (property.list || !request_.asks_for(property.name)) return;
    if (is_real(property.value))
      column.reals = field.numbers.emplace<std::vector<double>>(element_.count).data();
    else if (property.value == NumberType::u64)
      column.naturals = field.numbers.emplace<std::vector<std::uint64_t>>(element_.count).data();
    else
      column.integers = field.numbers.emplace<std::vector<std::int64_t>>(element_.count).data();
  }

  /// Of normals that were not asked for.
  bool is_normal(const PlyProperty& property) const {
    const std::string& name = property.name;
    return element_.vertices() && !soup_.point_fields.empty() && soup_.point_fields[0].normals &&
           (name == "nx" || name == "ny" || name == "nz");
  }

  const PlyElement& element_;
  const FieldRequest& request_;
  Soup& soup_;
  std::vector<Column> columns_;
};

/// What texts and binary files have in common.
class PlyReader {
 public:
  PlyReader(const PlyHeader& header, const FieldRequest& request)
      : header_(header), request_(request) {}
  virtual ~PlyReader() = default;

  Soup read() {
    for (const PlyElement& element : header_.elements)
      if (element.vertices()) vertices_ = element.count;
    for (const PlyElement& element : header_.elements) {
      element_ = &element;
      strips_ = element.strips();
      if (element.faces()) {
        first_face_ = soup_.cells.size();
        soup_.cells.reserve(element.count, 3 * element.count);
      }
      read_rows(Columns(element, request_, soup_).all());
    }
    spread_cell_fields();
    return std::move(soup_);
  }

 protected:
  virtual void read_rows(const std::vector<Column>& columns) = 0;
  virtual std::string where() const = 0;

  const PlyElement& element() const { return *element_; }

  [[noreturn]] void fail_end() const {
    fail(where(), "the file ends before or in it", "the file is truncated; export the mesh again");
  }

  std::size_t checked_length(std::int64_t length) const {
    if (length < 0) fail(where(), "a list has a negative length", "correct it");
    return static_cast<std::size_t>(length);
  }

  /// Takes over the list corners_.
  void add_cell() {
    for (const Cells::Node v : corners_)
      if ((v < 0 && !(strips_ && v == -1)) || v >= static_cast<Cells::Node>(vertices_))
        fail_vertex(where(), v, vertices_);
    if (!strips_) return soup_.cells.add(face_type(corners_.size()), corners_);
    // -1 starts the next strip.
    for (auto begin = corners_.begin(); begin != corners_.end();) {
      const auto end = std::find(begin, corners_.end(), -1);
      if (end != begin) soup_.cells.add(CellType::triangle_strip, {begin, end});
      begin = end == corners_.end() ? end : end + 1;
    }
  }

  Soup soup_;
  std::vector<Cells::Node> corners_;
  std::size_t item_ = 0;  ///< of the element

 private:
  /// Strips have no values of the faces' properties.
  void spread_cell_fields() {
    for (Field& field : soup_.cell_fields) {
      const std::size_t faces = field.size(), cells = soup_.cells.size();
      if (faces == 0 || faces == cells) continue;
      field.missing.assign(cells, true);
      std::fill_n(field.missing.begin() + static_cast<std::ptrdiff_t>(first_face_), faces, false);
      std::visit(
          [&](auto& numbers) {
            numbers.insert(numbers.begin(), first_face_, 0);
            numbers.resize(cells);
          },
          field.numbers);
    }
  }

  const PlyHeader& header_;
  const FieldRequest& request_;
  const PlyElement* element_ = nullptr;
  bool strips_ = false;  ///< element_ is one of strips
  std::size_t vertices_ = 0, first_face_ = 0;
};

/// A sequence of words, wherever lines end.
class TextPly : public PlyReader {
 public:
  TextPly(std::string_view text, const PlyHeader& header, const FieldRequest& request)
      : PlyReader(header, request), scan_(text) {
    scan_.move_to(header.size);
  }

 private:
  std::string where() const override { return numbered(element().singular(), item_, scan_.line()); }

  template <class T>
  T take() {
    if (!scan_.more()) fail_end();
    T value{};
    if (!scan_.take(value)) {
      const char* kind = std::is_integral_v<T> ? " is not an integer" : " is not a number";
      fail(where(), quoted(scan_.peek()) + kind, "correct it");
    }
    return value;
  }

  void skip() {
    if (!scan_.more()) fail_end();
    scan_.skip_word();
  }

  void take_list(const Column& column) {
    const std::size_t length = checked_length(take<std::int64_t>());
    if (!column.corners) {
      for (std::size_t i = 0; i < length; ++i) skip();
      return;
    }
    corners_.clear();
    for (std::size_t i = 0; i < length; ++i) corners_.push_back(take<std::int64_t>());
    add_cell();
  }

  void read_rows(const std::vector<Column>& columns) override {
    for (item_ = 0; item_ < element().count; ++item_) {
      for (const Column& column : columns)
        if (column.property->list)
          take_list(column);
        else if (column.reals)
          column.reals[column.stride * item_] = take<double>();
        else if (column.integers)
          column.integers[item_] = take<std::int64_t>();
        else if (column.naturals)
          column.naturals[item_] = take<std::uint64_t>();
        else
          skip();
      if (element().vertices()) note_not_finite(soup_, item_, scan_);
    }
  }

  TextScan scan_;
};

class BinaryPly : public PlyReader {
 public:
  BinaryPly(std::string_view bytes, const PlyHeader& header, const FieldRequest& request)
      : PlyReader(header, request),
        at_(bytes.data() + header.size),
        end_(bytes.data() + bytes.size()),
        big_endian_(header.big_endian) {}

 private:
  std::string where() const override { return fmt::format("{} {}", element().singular(), item_); }

  const char* take_bytes(std::size_t count) {
    if (static_cast<std::size_t>(end_ - at_) < count) fail_end();
    at_ += count;
    return at_ - count;
  }

  /// Rows of one size, one column after another in blocks that stay in the cache.
  void read_equal_rows(const std::vector<Column>& columns) {
    const std::size_t size = element().least_size();
    constexpr std::size_t block = 512;
    for (item_ = 0; item_ < element().count;) {
      const std::size_t rows =
          std::min({block, element().count - item_, static_cast<std::size_t>(end_ - at_) / size});
      if (rows == 0) fail_end();
      const char* at = take_bytes(rows * size);
      for (const Column& column : columns) {
        if (column.is_read()) read_column(column, at, rows, size);
        at += size_of(column.property->value);
      }
      item_ += rows;
    }
  }

  void read_column(const Column& column, const char* at, std::size_t rows, std::size_t size) const {
    with_type(column.property->value, [&](auto sample) {
      using Native = decltype(sample);
      const auto copy = [&](auto* to) {
        using To = std::remove_reference_t<decltype(*to)>;
        to += column.stride * item_;
        for (std::size_t i = 0; i < rows; ++i, at += size, to += column.stride)
          *to = static_cast<To>(load_number<Native>(at, big_endian_));
      };
      if (column.reals) copy(column.reals);
      if (column.integers) copy(column.integers);
      if (column.naturals) copy(column.naturals);
    });
  }

  void take_list(const Column& column) {
    const PlyProperty& property = *column.property;
    const char* const at = take_bytes(size_of(property.length));
    const std::size_t length =
        checked_length(load_as<std::int64_t>(property.length, at, big_endian_));
    const std::size_t size = size_of(property.value);
    if (length > static_cast<std::size_t>(end_ - at_) / size) fail_end();
    const char* numbers = take_bytes(length * size);
    if (!column.corners) return;
    corners_.resize(length);
    with_type(property.value, [&](auto sample) {
      for (Cells::Node& corner : corners_) {
        corner = static_cast<Cells::Node>(load_number<decltype(sample)>(numbers, big_endian_));
        numbers += sizeof sample;
      }
    });
    add_cell();
  }

  void read_rows(const std::vector<Column>& columns) override {
    const auto is_list = [](const Column& column) { return column.property->list; };
    if (std::none_of(columns.begin(), columns.end(), is_list) && element().count > 0)
      return read_equal_rows(columns);
    for (item_ = 0; item_ < element().count; ++item_) {
      for (const Column& column : columns) {
        if (column.property->list) {
          take_list(column);
          continue;
        }
        const char* const at = take_bytes(size_of(column.property->value));
        if (column.is_read()) read_column(column, at, 1, 0);
      }
    }
  }

  const char *at_, *end_;
  bool big_endian_;
};

/// Where a text has nothing but vertices that start with their place, faces that start with their
/// corners, and no value that is asked for: what read_triangle_rows() may try.
std::optional<TriangleRows> plain_rows(const PlyHeader& header, const FieldRequest& request) {
  if (header.elements.size() != 2 || request.wanted || request.normals) return std::nullopt;
  const PlyElement &points = header.elements[0], &faces = header.elements[1];
  if (!points.vertices() || !faces.faces() || points.properties.size() < 3) return std::nullopt;
  const auto is_list = [](const PlyProperty& property) { return property.list; };
  if (std::any_of(points.properties.begin(), points.properties.end(), is_list) ||
      std::count_if(faces.properties.begin(), faces.properties.end(), is_list) != 1 ||
      faces.corners() != &faces.properties[0])
    return std::nullopt;
  for (std::size_t k = 0; k < 3; ++k)
    if (points.properties[k].name != std::string(1, "xyz"[k])) return std::nullopt;
  return TriangleRows{header.size, points.count, faces.count, points.properties.size() - 3,
                      faces.properties.size() - 1};
}

}  // namespace

Soup read_ply(std::string_view bytes, const FieldRequest& request) {
  const PlyHeader header = read_ply_header(bytes, request.points);
  if (header.binary) return BinaryPly(bytes, header, request).read();
  const std::string_view text = check_text(bytes);
  const auto rows = reads_parts() ? plain_rows(header, request) : std::nullopt;
  Soup soup;
  if (rows && read_triangle_rows(text, *rows, soup)) {
    for (const PlyElement& element : header.elements) Columns(element, request, soup);  // lists
    return soup;
  }
  return TextPly(text, header, request).read();
}

}  // namespace crest::io
