// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/formats/legacy_fields.hpp"

#include <fmt/format.h>

#include <map>

#include "io/formats/files.hpp"
#include "io/formats/remedy.hpp"

namespace crest::io {
namespace {

/// Of colours: bytes in binary files, reals from 0 to 1 in texts.
LegacyType colour_type(const LegacySource& source) {
  return {source.binary() ? NumberType::u8 : NumberType::f32};
}

}  // namespace

bool LegacyFields::read_section() {
  const std::string& section = source_.section();
  if (section == "point_data" || section == "cell_data") {
    owner_ = section == "point_data" ? &points_ : &cells_;
    owner_->announced = true;
    owner_->count = source_.take_count();
  } else if (section == "field") {
    source_.take_word();  // its name
    for (std::size_t arrays = source_.take_count(); arrays > 0; --arrays) read_field_array();
  } else if (section == "scalars") {
    read_scalars();
  } else if (section == "color_scalars") {
    const std::string name = source_.take_name();
    read_values(name, source_.take_count(), colour_type(source_));
  } else if (section == "lookup_table") {
    source_.take_word();
    source_.skip(colour_type(source_), source_.product(4, source_.take_count()));
  } else if (section == "texture_coordinates") {
    const std::string name = source_.take_name();
    const std::size_t components = source_.take_count();
    read_values(name, components, source_.take_type());
  } else {
    static const std::map<std::string, std::size_t> components = {
        {"vectors", 3},    {"normals", 3},      {"tensors", 9},   {"tensors6", 6},
        {"global_ids", 1}, {"pedigree_ids", 1}, {"edge_flags", 1}};
    const auto found = components.find(section);
    if (found == components.end()) return false;
    const std::string name = source_.take_name();
    read_values(name, found->second, source_.take_type());
  }
  return true;
}

/// "NAME TYPE [COMPONENTS]", then, mostly, the name of a table on a line.
void LegacyFields::read_scalars() {
  const std::string name = source_.take_name();
  const LegacyType type = source_.take_type();
  const std::size_t components = source_.in_line() ? source_.take_count() : 1;
  source_.take_line_of("lookup_table");
  read_values(name, components, type);
}

/// "NAME COMPONENTS TUPLES TYPE", then the numbers.
void LegacyFields::read_field_array() {
  while (source_.take_line_of("metadata")) source_.skip_block();
  source_.require_more();
  const std::string name = source_.take_name();
  const std::size_t components = source_.take_count(), tuples = source_.take_count();
  if (source_.take_line_of("string")) {
    if (source_.binary())
      fail(source_.where(), "has an array of strings", "leave it out or save the file as text");
    return source_.skip_lines(source_.product(components, tuples));
  }
  const LegacyType type = source_.take_type();
  if (owner_ && tuples == owner_->count) return read_values(name, components, type);
  source_.skip(type, source_.product(components, tuples));
}

void LegacyFields::read_values(const std::string& name, std::size_t components, LegacyType type) {
  if (!owner_) fail(source_.where(), "is neither of POINT_DATA nor of CELL_DATA", kExportMesh);
  if (components > 1000)
    fail(source_.where(), fmt::format("has {} components", components), kExportMesh);
  const std::size_t numbers = source_.product(components, owner_->count);
  Field field{.name = name, .components = static_cast<int>(components)};
  field.normals = source_.section() == "normals" && owner_ == &points_;
  if (request_.asks_for(name) || (request_.normals && field.normals))
    field.numbers = source_.take(type, numbers);
  else
    source_.skip(type, numbers);
  owner_->fields.push_back(std::move(field));
}

std::vector<Field> LegacyFields::taken(const char* section, Owner& owner, std::size_t count) {
  if (owner.announced && owner.count != count)
    fail(section, fmt::format("is of {}, the file has {}", owner.count, count), kExportMesh);
  return std::move(owner.fields);
}

void LegacyFields::finish(Soup& soup) {
  soup.point_fields = taken("POINT_DATA", points_, soup.points.size());
  soup.cell_fields = taken("CELL_DATA", cells_, soup.cells.size());
}

std::vector<Field> LegacyFields::finish_points(std::size_t points) {
  return taken("POINT_DATA", points_, points);
}

}  // namespace crest::io
