// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The array of a volume's points that holds its samples.
#include "io/formats/volume.hpp"

namespace crest::io {

/// By its name, else the active one, else the only one. Throws, with the arrays there are, where it
/// is not one number a point.
const Field& chosen_field(const std::vector<Field>& fields, const std::string& wanted,
                          const std::string& active);

}  // namespace crest::io
