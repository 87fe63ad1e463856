// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/formats/volume_field.hpp"

#include <fmt/format.h>

namespace crest::io {

const Field& chosen_field(const std::vector<Field>& fields, const std::string& wanted,
                          const std::string& active) {
  std::string names;
  for (const Field& f : fields)
    names +=
        fmt::format("{}'{}' ({})", names.empty() ? "" : ", ", f.name.substr(0, 60), f.components);
  const std::string remedy = names.empty()
                                 ? "the file has no array of points; give samples at the nodes"
                                 : "the arrays of points (and their numbers each) are " + names;
  const std::string& name = wanted.empty() ? active : wanted;
  const Field* found = nullptr;
  for (const Field& f : fields) {
    if (name.empty() ? f.components != 1 : f.name != name) continue;
    if (found)
      fail("samples", "several arrays could be meant", remedy + "; choose one with --field");
    found = &f;
  }
  const std::string element =
      name.empty() ? "samples" : fmt::format("array '{}'", name.substr(0, 60));
  if (!found)
    fail(element, name.empty() ? "no array has one number a point" : "does not exist", remedy);
  if (found->components != 1)
    fail(element, fmt::format("has {} numbers a point", found->components), remedy);
  return *found;
}

}  // namespace crest::io
