// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/read/point_values.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <type_traits>

#include "io/formats/files.hpp"

namespace crest::io {
namespace {

using kernel::Index;

/// Twenty names at most, as they may be long and many.
std::string quoted_list(const std::vector<std::string>& names) {
  std::string list;
  constexpr std::size_t most = 20;
  for (std::size_t i = 0; i < std::min(names.size(), most); ++i)
    list += fmt::format("{}'{}'", i == 0 ? "" : ", ", names[i].substr(0, 60));
  return names.size() > most ? list + ", .." : list;
}

std::vector<std::string> scalar_names(const std::vector<Field>& fields) {
  std::vector<std::string> names;
  for (const Field& field : fields)
    if (field.components == 1) names.push_back(field.name);
  return names;
}

std::string known_fields(const Soup& soup, const std::string& remedy) {
  const auto of_points = scalar_names(soup.point_fields), of_cells = scalar_names(soup.cell_fields);
  if (of_points.empty() && of_cells.empty()) return "the file has no scalar field, " + remedy;
  std::string known = "the scalar fields are ";
  known += quoted_list(of_points);
  if (!of_cells.empty()) known += (of_points.empty() ? "" : ", of cells ") + quoted_list(of_cells);
  return known;
}

const Field* find(const std::vector<Field>& fields, const std::string& name) {
  const auto found = std::find_if(fields.begin(), fields.end(),
                                  [&](const Field& field) { return field.name == name; });
  return found == fields.end() ? nullptr : &*found;
}

/// The name that is meant if none is given.
std::string only_name(const Soup& soup, const std::string& remedy) {
  for (const auto* fields : {&soup.point_fields, &soup.cell_fields}) {
    const auto names = scalar_names(*fields);
    if (names.size() == 1) return names[0];
    if (names.size() > 1)
      fail("fields", "there are several", known_fields(soup, remedy) + "; choose one with --field");
  }
  fail("fields", "none is given", known_fields(soup, remedy));
}

/// The i-th number as a double; nothing for an integer that is none.
std::optional<double> exact_double(const Field& field, std::size_t i) {
  return std::visit(
      [i](const auto& numbers) -> std::optional<double> {
        using Number = typename std::decay_t<decltype(numbers)>::value_type;
        const Number x = numbers[i];
        if constexpr (std::is_integral_v<Number>) {
          constexpr Number most = Number{1} << 53;
          if (x > most || (std::is_signed_v<Number> && x < Number{0} - most)) return std::nullopt;
        }
        return static_cast<double>(x);
      },
      field.numbers);
}

/// Of an element that messages call `element`.
double exact_value(const Field& field, std::size_t i, const std::string& element) {
  if (!field.missing.empty() && field.missing[i])
    fail(element, fmt::format("has no value of '{}'", field.name), "give every one a value");
  const std::optional<double> value = exact_double(field, i);
  if (!value) {
    fail(element, fmt::format("its value of '{}' exceeds 2^53", field.name),
         "store the field as doubles");
  }
  return *value;
}

}  // namespace

PointValues::PointValues(const Soup& soup, const std::string& name, const std::string& remedy)
    : soup_(soup) {
  const std::string wanted = name.empty() ? only_name(soup, remedy) : name;
  const std::string element = fmt::format("field '{}'", wanted);
  field_ = find(soup.point_fields, wanted);
  const Field* const of_cells = find(soup.cell_fields, wanted);
  if (of_cells && (!field_ || (field_->components != 1 && of_cells->components == 1))) {
    field_ = of_cells;
    of_cells_ = true;
  }
  if (!field_) fail(element, "does not exist", known_fields(soup, remedy));
  if (field_->components != 1) {
    fail(element,
         field_->components == 0 ? std::string("does not hold numbers")
                                 : fmt::format("has {} components", field_->components),
         known_fields(soup, remedy));
  }
  const auto& fields = of_cells_ ? soup.cell_fields : soup.point_fields;
  if (std::count_if(fields.begin(), fields.end(),
                    [&](const Field& field) { return field.name == wanted; }) > 1)
    fail(element, "is there several times", "give the fields different names");
  if (field_->size() != (of_cells_ ? soup.cells.size() : soup.points.size())) {
    fail(element, of_cells_ ? "has not one value a cell" : "has not one value a point",
         "export it again");
  }
  if (of_cells_) average();
}

void PointValues::average() {
  means_.assign(soup_.points.size(), 0);
  faces_.assign(soup_.points.size(), 0);
  for (std::size_t c = 0; c < soup_.cells.size(); ++c) {
    if (dimension_of(soup_.cells.type(c)) != 2) continue;
    const double value = exact_value(*field_, c, fmt::format("face {}", soup_.cell_tag(c)));
    for (const Cells::Node node : soup_.cells.nodes(c)) {
      if (node < 0 || static_cast<std::size_t>(node) >= means_.size()) continue;
      means_[static_cast<std::size_t>(node)] += value;
      ++faces_[static_cast<std::size_t>(node)];
    }
  }
  for (std::size_t v = 0; v < means_.size(); ++v)
    if (faces_[v] > 0) means_[v] /= faces_[v];
}

std::optional<std::string> PointValues::note() const {
  if (!of_cells_) return std::nullopt;
  return fmt::format("'{}' is a field of cells: each vertex has the mean over its faces", name());
}

double PointValues::at(Index point) const {
  const double value =
      of_cells_ ? means_[point] : exact_value(*field_, point, soup_.point_name(point));
  if (!std::isfinite(value)) {
    fail(soup_.point_name(point), fmt::format("its value of '{}' is {}", name(), value),
         "repair the field");
  }
  return value;
}

std::vector<kernel::Vec3> point_normals(const Soup& soup, const std::vector<Index>& points) {
  const auto& fields = soup.point_fields;
  auto found = std::find_if(fields.begin(), fields.end(), [](const Field& f) { return f.normals; });
  if (found == fields.end())
    found = std::find_if(fields.begin(), fields.end(),
                         [](const Field& f) { return f.name == "Normals" && f.components > 0; });
  if (found == fields.end()) fail("normals", "the file has none", "use --normals estimated");
  if (found->components != 3 || found->size() != 3 * soup.points.size())
    fail("normals", "they are not three numbers a vertex", "export the mesh again");
  std::vector<kernel::Vec3> normals;
  normals.reserve(points.size());
  for (const Index v : points) {
    kernel::Vec3& n = normals.emplace_back();
    double length = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      n[k] = exact_double(*found, 3 * std::size_t{v} + k).value_or(HUGE_VAL);
      length = std::max(length, std::isnan(n[k]) ? HUGE_VAL : std::fabs(n[k]));
    }
    if (length == 0 || length == HUGE_VAL) {
      fail(soup.point_name(v), length == 0 ? "its normal is zero" : "its normal is not finite",
           "repair it or use --normals estimated");
    }
  }
  return normals;
}

}  // namespace crest::io
