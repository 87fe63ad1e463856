// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/formats/msh_fields.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "io/formats/files.hpp"

namespace crest::io {

/// Three lists, each a count and so many lines: names, reals, integers.
MshFields::Data MshFields::read_head(std::int64_t& count) {
  const auto begin_list = [&] {
    source_.begin_line();
    const std::int64_t size = source_.word_integer();
    if (size < 0 || size > 1000)
      fail(source_.line(), fmt::format("has a bad count {}", size), "export the mesh again");
    source_.end_line();
    return size;
  };
  Data data;
  data.of_nodes = source_.section() == "$NodeData";
  const std::int64_t strings = begin_list();
  for (std::int64_t i = 0; i < strings; ++i) {
    source_.begin_line();
    const std::string_view text = source_.rest_of_line();
    const std::size_t begin = text.find('"'), end = text.rfind('"');
    if (i == 0) data.name = begin < end ? text.substr(begin + 1, end - begin - 1) : text;
    source_.end_line();
  }
  for (std::int64_t i = begin_list(); i > 0; --i) {
    source_.begin_line();
    source_.end_line();
  }
  std::int64_t numbers[3] = {0, 1, 0};  // time step, components, values
  const std::int64_t integers = begin_list();
  for (std::int64_t i = 0; i < integers; ++i) {
    source_.begin_line();
    if (i < 3) numbers[i] = source_.word_integer();
    source_.end_line();
  }
  data.step = numbers[0];
  data.components = static_cast<std::size_t>(std::clamp<std::int64_t>(numbers[1], 0, 1000));
  // Gmsh knows scalars, vectors and tensors; others would need more memory than the file has.
  data.needed = request_.asks_for(data.name) && data.components <= 9;
  count = numbers[2];
  return data;
}

bool MshFields::supersedes(Data& data) {
  if (request_.step) return data.step == *request_.step;
  const auto is_same = [&](const Data& d) {
    return d.name == data.name && d.of_nodes == data.of_nodes;
  };
  bool later = false;
  for (Data& d : data_) {
    if (!is_same(d) || d.step == data.step) continue;
    d.several = data.several = true;
    later = later || d.step > data.step;
  }
  std::erase_if(data_, [&](const Data& d) { return is_same(d) && d.step < data.step; });
  return !later;
}

void MshFields::read_values(Data& data, std::int64_t count) {
  for (std::int64_t i = 0; i < count; ++i) {
    source_.begin_record();
    data.tags.push_back(source_.integer());
    for (std::size_t k = 0; k < data.components; ++k) data.values.push_back(source_.real());
    source_.end_record();
  }
}

void MshFields::read_section() {
  std::int64_t count = 0;
  Data data = read_head(count);
  if (data.needed) steps_.insert(data.step);
  if (!supersedes(data)) return;
  if (data.needed) read_values(data, count);
  data_.push_back(std::move(data));
}

bool MshFields::any(bool of_nodes) const {
  return std::any_of(data_.begin(), data_.end(),
                     [&](const Data& d) { return d.of_nodes == of_nodes; });
}

void MshFields::require_step() const {
  if (!request_.step || steps_.empty() || steps_.contains(*request_.step)) return;
  fail(fmt::format("time step {}", *request_.step), "is not there",
       fmt::format("the file has {}", fmt::join(steps_, ", ")));
}

std::vector<Field> MshFields::take(bool of_nodes, const TagTable& tags, std::size_t count,
                                   Soup& soup) {
  require_step();
  std::vector<Field> fields;
  for (const Data& data : data_) {
    if (data.of_nodes != of_nodes) continue;
    Field& field = fields.emplace_back(
        Field{.name = data.name, .components = static_cast<int>(data.components)});
    if (!data.needed) continue;
    if (data.several) {
      soup.warnings.push_back(
          fmt::format("took time step {} of field '{}', its last; --step chooses another of {}",
                      data.step, data.name.substr(0, 60), fmt::join(steps_, ", ")));
    }
    std::vector<double> values(count * data.components, 0);
    field.missing.assign(count, true);
    for (std::size_t i = 0; i < data.tags.size(); ++i) {
      const auto at = tags.find(data.tags[i]);
      if (!at) {
        fail(fmt::format("field '{}'", data.name),
             fmt::format("{} {} does not exist", of_nodes ? "node" : "element", data.tags[i]),
             "export the mesh again");
      }
      field.missing[*at] = false;
      for (std::size_t k = 0; k < data.components; ++k)
        values[*at * data.components + k] = data.values[i * data.components + k];
    }
    if (std::find(field.missing.begin(), field.missing.end(), true) == field.missing.end())
      field.missing.clear();
    field.numbers = std::move(values);
  }
  return fields;
}

}  // namespace crest::io
