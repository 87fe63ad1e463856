// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/formats/soup.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <string_view>

namespace crest::io {

int dimension_of(CellType type) {
  // Of VTK's numbers from 0 on: linear cells, those of higher order, parametric ones, Lagrange's
  // and Bezier's.
  constexpr std::string_view dimensions =
      "00011222223333333----"
      "12233332323332123---33--------"
      "122233---12223333"
      "12233331223333";
  static_assert(dimensions.size() == 82);
  const auto number = static_cast<std::size_t>(type);
  if (number >= dimensions.size() || dimensions[number] == '-') return -1;
  return dimensions[number] - '0';
}

void Cells::reserve(std::size_t cells, std::size_t nodes) {
  types_.reserve(cells);
  begin_.reserve(cells + 1);
  nodes_.reserve(nodes);
}

std::size_t Field::size() const {
  return std::visit([](const auto& values) { return values.size(); }, numbers);
}

std::string Soup::point_name(std::size_t v) const {
  const auto known = std::lower_bound(lines_not_finite.begin(), lines_not_finite.end(),
                                      std::pair(v, std::size_t{0}));
  if (known == lines_not_finite.end() || known->first != v)
    return fmt::format("vertex {}", point_tag(v));
  return fmt::format("vertex {} (line {})", point_tag(v), known->second);
}

}  // namespace crest::io
