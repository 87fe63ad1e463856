// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/attribute_report.hpp"

#include <array>

namespace crest::cli {

Json to_json(std::span<const kernel::Attribute> attributes) {
  constexpr std::array sites = {"vertices", "faces", "corners"};
  constexpr std::array types = {"int8",   "uint8", "int16",  "uint16",  "int32",
                                "uint32", "int64", "uint64", "float32", "float64"};
  Json list = Json::array();
  for (const kernel::Attribute& a : attributes)
    list.push_back({{"name", a.name},
                    {"at", sites[static_cast<std::size_t>(a.site)]},
                    {"type", types[static_cast<std::size_t>(a.type)]},
                    {"components", a.components}});
  return list;
}

}  // namespace crest::cli
