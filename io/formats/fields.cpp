// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/formats/fields.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <type_traits>

#include "io/formats/files.hpp"

namespace crest::io {
namespace {

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

}  // namespace

const Field& choose_scalar(const Soup& soup, const std::string& name, const std::string& remedy) {
  const std::vector<Field>& fields = soup.point_fields;
  const std::vector<std::string> scalars = scalar_names(fields);
  const std::string known =
      scalars.empty() ? "there is no scalar point field, " + remedy
                      : fmt::format("the scalar point fields are {}", quoted_list(scalars));
  if (name.empty()) {
    if (scalars.size() > 1)
      fail("fields", "there are several", known + "; choose one with --field");
    if (scalars.empty()) fail("fields", "none is given", known);
  }
  const std::string& wanted = name.empty() ? scalars[0] : name;
  const auto is_meant = [&](const Field& field) { return field.name == wanted; };
  const auto found = std::find_if(fields.begin(), fields.end(), is_meant);
  const std::string element = fmt::format("field '{}'", wanted);
  if (found == fields.end()) {
    const bool cells = std::any_of(soup.cell_fields.begin(), soup.cell_fields.end(), is_meant);
    fail(element, cells ? "belongs to the cells" : "does not exist", known);
  }
  if (found->components != 1) {
    const std::string what = found->components == 0
                                 ? std::string("does not hold numbers")
                                 : fmt::format("has {} components", found->components);
    fail(element, what, known);
  }
  if (std::count_if(fields.begin(), fields.end(), is_meant) > 1)
    fail(element, "is there several times", "keep one time step");
  return *found;
}

std::vector<double> exact_doubles(const Soup& soup, const Field& field) {
  const auto components = static_cast<std::size_t>(field.components);
  if (field.size() != soup.points.size() * components)
    fail(fmt::format("field '{}'", field.name), "has not one value a node", "export it again");
  std::vector<double> result;
  result.reserve(field.size());
  std::visit(
      [&](const auto& numbers) {
        using Number = typename std::decay_t<decltype(numbers)>::value_type;
        for (const Number x : numbers) {
          if constexpr (std::is_integral_v<Number>) {
            constexpr Number most = Number{1} << 53;
            if (x > most || (std::is_signed_v<Number> && x < Number{0} - most))
              fail(fmt::format("node {}", soup.point_tag(result.size() / components)),
                   fmt::format("its value of '{}' exceeds 2^53", field.name),
                   "store the field as doubles");
          }
          result.push_back(static_cast<double>(x));
        }
      },
      field.numbers);
  return result;
}

}  // namespace crest::io
