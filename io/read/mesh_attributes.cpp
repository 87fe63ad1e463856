// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/read/mesh_attributes.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>

namespace crest::io {
namespace {

using kernel::Attribute;
using kernel::Index;
using kernel::NumberType;
using kernel::Site;

std::uint64_t word_at(const Field& field, std::size_t i) {
  return std::visit([i](const auto& numbers) { return std::bit_cast<std::uint64_t>(numbers[i]); },
                    field.numbers);
}

/// Of integers from `least` to `most` as words.
template <class T>
bool all_are(const std::vector<std::uint64_t>& words) {
  return std::all_of(words.begin(), words.end(), [](std::uint64_t word) {
    if constexpr (std::is_floating_point_v<T>) {
      const auto x = std::bit_cast<double>(word);
      return !(std::isfinite(x) && std::fabs(x) > std::numeric_limits<T>::max()) &&
             std::bit_cast<std::uint64_t>(static_cast<double>(static_cast<T>(x))) == word;
    } else {
      const auto x = static_cast<std::int64_t>(word);
      return static_cast<std::int64_t>(static_cast<T>(x)) == x;
    }
  });
}

bool hold(NumberType type, const std::vector<std::uint64_t>& words) {
  switch (type) {
    case NumberType::i8:
      return all_are<std::int8_t>(words);
    case NumberType::u8:
      return all_are<std::uint8_t>(words);
    case NumberType::i16:
      return all_are<std::int16_t>(words);
    case NumberType::u16:
      return all_are<std::uint16_t>(words);
    case NumberType::i32:
      return all_are<std::int32_t>(words);
    case NumberType::u32:
      return all_are<std::uint32_t>(words);
    case NumberType::f32:
      return all_are<float>(words);
    default:
      return true;
  }
}

/// That of the file, or one as wide as there is.
NumberType type_of(const Field& field, const std::vector<std::uint64_t>& words) {
  constexpr NumberType widest[] = {NumberType::f64, NumberType::i64, NumberType::u64};
  const NumberType wide = widest[field.numbers.index()];
  if (!field.type || is_real(*field.type) != is_real(wide)) return wide;
  return hold(*field.type, words) ? *field.type : wide;
}

/// The field's numbers at the places whose sources are given; beyond its end: none there.
Attribute taken(const Field& field, Site site, const std::vector<Index>& source) {
  Attribute a{field.name, site, NumberType::f64, static_cast<std::uint32_t>(field.components)};
  const std::size_t tuples = field.size() / a.components;
  const auto has = [&](Index i) {
    return i < tuples && (field.missing.empty() || !field.missing[i]);
  };
  if (!std::all_of(source.begin(), source.end(), has))
    for (const Index i : source) a.missing.push_back(!has(i));
  for (std::size_t c = 0; c < a.components; ++c)
    for (const Index i : source)
      a.words.push_back(has(i) ? word_at(field, std::size_t{i} * a.components + c) : 0);
  a.type = type_of(field, a.words);
  return a;
}

/// The soup's corner at each of the triangles' corners. Only polygons have numbers at corners.
std::vector<Index> corner_sources(const Soup& soup, const Surface& surface) {
  std::vector<std::size_t> begin;
  for (std::size_t c = 0, nodes = 0; c < soup.cells.size(); ++c) {
    begin.push_back(nodes);
    nodes += soup.cells.nodes(c).size();
  }
  std::vector<Index> source;
  for (std::size_t f = 0; f < surface.faces.size(); ++f) {
    const Index cell = surface.cell_of[f];
    const auto nodes = soup.cells.nodes(cell);
    const bool placed = !surface.places.empty() && surface.places[f][0] != kernel::kNone;
    for (std::size_t k = 0; k < 3; ++k) {
      const Cells::Node node{surface.point_of[surface.faces[f][k]]};
      const auto at = placed ? surface.places[f][k]
                             : std::find(nodes.begin(), nodes.end(), node) - nodes.begin();
      source.push_back(static_cast<Index>(begin[cell] + static_cast<std::size_t>(at)));
    }
  }
  return source;
}

/// The same at vertices, if all corners of each agree.
Attribute at_vertices(Attribute a, const Surface& surface) {
  const std::size_t places = a.places(), vertices = surface.points.size();
  std::vector<Index> source(vertices, kernel::kNone);
  const auto same = [&](std::size_t p, std::size_t q) {
    for (std::size_t first = 0; first < a.words.size(); first += places)
      if (a.words[first + p] != a.words[first + q]) return false;
    return a.has(p) == a.has(q);
  };
  for (Index p = 0; p < places; ++p) {
    Index& first = source[surface.faces[p / 3][p % 3]];
    if (first == kernel::kNone) first = p;
    if (!same(first, p)) return a;
  }
  Attribute b{a.name, Site::vertices, a.type, a.components};
  for (std::size_t first = 0; first < a.words.size(); first += places)
    for (const Index p : source) b.words.push_back(a.words[first + p]);
  if (!a.missing.empty())
    for (const Index p : source) b.missing.push_back(a.missing[p]);
  return b;
}

}  // namespace

std::vector<Attribute> attributes_of(const Soup& soup, const Surface& surface,
                                     std::vector<std::string>& left_out) {
  std::vector<Attribute> attributes;
  const auto take = [&](const std::vector<Field>& fields, Site site,
                        const std::vector<Index>& source) {
    for (const Field& field : fields)
      if (field.components <= 0 || field.size() == 0)
        left_out.push_back(field.name);
      else
        attributes.push_back(taken(field, site, source));
  };
  take(soup.point_fields, Site::vertices, surface.point_of);
  take(soup.cell_fields, Site::faces, surface.cell_of);
  if (soup.corner_fields.empty()) return attributes;
  const std::size_t first = attributes.size();
  take(soup.corner_fields, Site::corners, corner_sources(soup, surface));
  for (std::size_t i = first; i < attributes.size(); ++i)
    attributes[i] = at_vertices(std::move(attributes[i]), surface);
  return attributes;
}

}  // namespace crest::io
