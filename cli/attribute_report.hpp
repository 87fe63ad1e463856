// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// What attributes a mesh has, for the report.
#include <span>

#include "cli/json.hpp"
#include "kernel/geometry/attribute.hpp"

namespace crest::cli {

/// Name, place, type and number of components of each.
Json to_json(std::span<const kernel::Attribute> attributes);

}  // namespace crest::cli
