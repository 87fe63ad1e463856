// SPDX-License-Identifier: GPL-3.0-or-later
// CalculiX's results as text (CalculiX GraphiX manual, "Result Format"): records of fixed columns,
// whose kind stands in the first five. Numbers have no blanks between them where they are negative.
#include <fmt/format.h>

#include <array>
#include <charconv>
#include <cmath>
#include <limits>
#include <optional>

#include "io/formats/files.hpp"
#include "io/formats/msh_source.hpp"
#include "io/formats/solid_readers.hpp"

namespace crest::io {
namespace {

constexpr const char* kWriteResults = "write the results again";

/// CalculiX's elements as VTK's cells; `order`: which node comes k-th in VTK.
struct Element {
  CellType type;
  std::vector<std::size_t> order;
};

std::vector<std::size_t> in_order(std::size_t n) {
  std::vector<std::size_t> r(n);
  for (std::size_t i = 0; i < n; ++i) r[i] = i;
  return r;
}

/// Numbered from 1; nothing for another number.
const Element* element(std::int64_t type) {
  static const std::array<Element, 12> elements = {
      {{CellType::hexahedron, in_order(8)},
       {CellType::wedge, in_order(6)},
       {CellType::tetrahedron, in_order(4)},
       // VTK has the nodes of the upper edges before those of the upright ones.
       {CellType::quadratic_hexahedron,
        {0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 16, 17, 18, 19, 12, 13, 14, 15}},
       {CellType::quadratic_wedge, {0, 1, 2, 3, 4, 5, 6, 7, 8, 12, 13, 14, 9, 10, 11}},
       {CellType::quadratic_tetrahedron, in_order(10)},
       {CellType::triangle, in_order(3)},
       {CellType::quadratic_triangle, in_order(6)},
       {CellType::quad, in_order(4)},
       {CellType::quadratic_quad, in_order(8)},
       {CellType::line, in_order(2)},
       {CellType::quadratic_edge, in_order(3)}}};
  return type >= 1 && type <= 12 ? &elements[static_cast<std::size_t>(type - 1)] : nullptr;
}

/// The lines of a file and their columns.
class FrdLines {
 public:
  explicit FrdLines(std::string_view text) : rest_(text) {}

  bool next_line() {
    if (rest_.empty()) return false;
    const std::size_t end = std::min(rest_.find('\n'), rest_.size());
    line_ = rest_.substr(0, end);
    if (line_.ends_with('\r')) line_.remove_suffix(1);
    rest_.remove_prefix(std::min(end + 1, rest_.size()));
    ++number_;
    return true;
  }
  void require_line() {
    if (!next_line())
      fail(fmt::format("line {}", number_), "is the last of a block",
           "the file is truncated; " + std::string(kWriteResults));
  }
  template <class T>
  T number(std::size_t first, std::size_t count) const {
    const std::string_view s = blank_free(column(first, count));
    T x{};
    const auto [end, error] = std::from_chars(s.data(), s.data() + s.size(), x);
    // CalculiX writes NaN and infinities as C does.
    if (error != std::errc() || end != s.data() + s.size() || s.empty())
      fail(fmt::format("line {}", number_),
           fmt::format("{} in columns {} to {} is no number", quoted(s), first + 1, first + count),
           kWriteResults);
    return x;
  }
  bool is_end() const { return blank_free(column(0, 3)) == "-3"; }
  bool is_record(const char* kind) const { return blank_free(column(0, 3)) == kind; }

  /// The width of node numbers, by the format that a block's last column names.
  std::size_t id_width(std::size_t at) const {
    const auto format = number<int>(at, 2);
    if (format != 0 && format != 1)
      fail(fmt::format("line {}", number_), "begins a binary block", "write the results as text");
    return format == 1 ? 10 : 5;
  }
  std::string_view line_column(std::size_t first, std::size_t count) const {
    return blank_free(column(first, count));
  }
  /// "line 7".
  std::string where() const { return fmt::format("line {}", number_); }
  std::size_t line_number() const { return number_; }

 private:
  static std::string_view blank_free(std::string_view s) {
    while (!s.empty() && s.front() == ' ') s.remove_prefix(1);
    while (!s.empty() && s.back() == ' ') s.remove_suffix(1);
    return s;
  }
  std::string_view column(std::size_t first, std::size_t count) const {
    return first < line_.size() ? line_.substr(first, count) : std::string_view{};
  }
  std::string_view rest_, line_;
  std::size_t number_ = 0;
};

class FrdReader {
 public:
  FrdReader(std::string_view bytes, const FieldRequest& request)
      : lines_(check_text(bytes)), request_(request) {}

  Soup read() {
    while (lines_.next_line()) {
      const std::string_view key = lines_.line_column(0, 6);
      if (key == "2C")
        read_nodes();
      else if (key == "3C")
        read_elements();
      else if (key.starts_with("100C"))
        read_result();
      else if (key == "9999")
        break;
    }
    if (soup_.points.empty()) fail("nodes", "there are none", kWriteResults);
    if (request_.step && !found_step_)
      fail("time step", fmt::format("there is no step {}", *request_.step),
           steps_.empty() ? "the file has none" : "its steps are " + steps_);
    return std::move(soup_);
  }

 private:
  void read_nodes() {
    const std::size_t width = lines_.id_width(73);
    while (lines_.require_line(), !lines_.is_end()) {
      soup_.point_tags.push_back(lines_.number<std::int64_t>(3, width));
      auto& p = soup_.points.emplace_back();
      for (std::size_t k = 0; k < 3; ++k) p[k] = lines_.number<double>(3 + width + 12 * k, 12);
      if (!std::isfinite(p[0]) || !std::isfinite(p[1]) || !std::isfinite(p[2]))
        soup_.lines_not_finite.emplace_back(soup_.points.size() - 1, lines_.line_number());
    }
    table_.emplace(soup_.point_tags, "node");
  }
  std::size_t node(std::int64_t tag) const {
    const auto found = table_ ? table_->find(tag) : std::nullopt;
    if (!found) fail(lines_.where(), fmt::format("node {} does not exist", tag), kWriteResults);
    return *found;
  }

  void read_elements() {
    const std::size_t width = lines_.id_width(73), most = width == 10 ? 10 : 15;
    lines_.require_line();
    while (!lines_.is_end()) {
      if (!lines_.is_record("-1")) fail(lines_.where(), "begins no element", kWriteResults);
      const auto tag = lines_.number<std::int64_t>(3, width),
                 type = lines_.number<std::int64_t>(3 + width, 5);
      const Element* e = element(type);
      if (!e)
        fail(fmt::format("element {} (line {})", tag, lines_.line_number()),
             fmt::format("has the unknown type {}", type), kWriteResults);
      std::vector<Cells::Node> nodes;
      while (nodes.size() < e->order.size()) {
        lines_.require_line();
        if (!lines_.is_record("-2"))
          fail(fmt::format("element {} (line {})", tag, lines_.line_number()), "has too few nodes",
               kWriteResults);
        for (std::size_t k = 0; k < most && nodes.size() < e->order.size(); ++k)
          nodes.push_back(
              static_cast<Cells::Node>(node(lines_.number<std::int64_t>(3 + width * k, width))));
      }
      std::vector<Cells::Node> ordered;
      for (const std::size_t i : e->order) ordered.push_back(nodes[i]);
      soup_.cells.add(e->type, ordered);
      soup_.cell_tags.push_back(tag);
      lines_.require_line();
    }
  }

  /// One quantity of one step.
  void read_result() {
    const auto step = lines_.number<std::int64_t>(58, 5);
    const std::size_t width = lines_.id_width(73);
    lines_.require_line();
    if (!lines_.is_record("-4")) fail(lines_.where(), "begins no quantity", kWriteResults);
    Field field;
    field.name = std::string(lines_.line_column(5, 8));
    const auto announced = lines_.number<std::size_t>(13, 5);
    std::vector<std::size_t> place;  // of each component in the file
    bool tensor = announced == 6;
    for (std::size_t k = 0; k < announced; ++k) {
      lines_.require_line();
      if (!lines_.is_record("-5")) fail(lines_.where(), "begins no component", kWriteResults);
      // Those that the reading program computes (iexist = 1) have no numbers.
      if (!lines_.line_column(33, 5).empty() && lines_.number<int>(33, 5) == 1) continue;
      const auto row = lines_.number<std::size_t>(23, 5), at = lines_.number<std::size_t>(28, 5);
      constexpr std::size_t places[3][3] = {{0, 3, 5}, {3, 1, 4}, {5, 4, 2}};
      tensor =
          tensor && lines_.number<int>(18, 5) == 4 && row >= 1 && row <= 3 && at >= 1 && at <= 3;
      place.push_back(tensor ? places[row - 1][at - 1] : k);
    }
    if (!tensor)
      for (std::size_t k = 0; k < place.size(); ++k) place[k] = k;
    field.components = static_cast<int>(place.size());
    read_values(field, place, width);
    keep(std::move(field), step);
  }

  void read_values(Field& field, const std::vector<std::size_t>& place, std::size_t width) {
    const std::size_t n = place.size();
    std::vector<double> numbers(n * soup_.points.size(), 0);
    field.missing.assign(soup_.points.size(), true);
    const bool wanted = request_.asks_for(field.name);
    std::size_t v = 0, k = 0;
    while (lines_.require_line(), !lines_.is_end()) {
      if (lines_.is_record("-1")) {
        v = node(lines_.number<std::int64_t>(3, width));
        k = 0;
        field.missing[v] = false;
      } else if (!lines_.is_record("-2") || k == 0) {
        fail(lines_.where(), "begins no value", kWriteResults);
      }
      for (std::size_t i = 0; i < 6 && k < n && wanted; ++i, ++k)
        numbers[n * v + place[k]] = lines_.number<double>(3 + width + 12 * i, 12);
      k += wanted ? 0 : 1;
    }
    if (std::find(field.missing.begin(), field.missing.end(), true) == field.missing.end())
      field.missing.clear();
    if (wanted) field.numbers = std::move(numbers);
  }

  /// The one of the latest step, or of the step that is asked for.
  void keep(Field field, std::int64_t step) {
    const std::string word = std::to_string(step);
    if (last_step_ != step) steps_ += (steps_.empty() ? "" : ", ") + word;
    last_step_ = step;
    if (request_.step && step != *request_.step) return;
    found_step_ = true;
    for (Field& f : soup_.point_fields)
      if (f.name == field.name) {
        f = std::move(field);
        return;
      }
    soup_.point_fields.push_back(std::move(field));
  }

  FrdLines lines_;
  const FieldRequest& request_;
  Soup soup_;
  std::optional<TagTable> table_;
  std::optional<std::int64_t> last_step_;
  std::string steps_;
  bool found_step_ = false;
};

}  // namespace

Soup read_frd(std::string_view bytes, const FieldRequest& request) {
  return FrdReader(bytes, request).read();
}

}  // namespace crest::io
