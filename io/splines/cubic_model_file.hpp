// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Cubic splines as .vti files: arrays `vertex` and `slopes` of the points, `centre` of the cells,
// and as field data `type` "cubic", `smoothness`, `box` and `unit` (the box and not the
// spacing, which is a rounded copy).
#include <string>
#include <string_view>

#include "algorithms/splines/cubic_model.hpp"

namespace crest::io {

/// Writes a model. Guarantees: read back it is the same, bit by bit; no half-written file.
void write_cubic_model(const std::string& path, const splines::CubicModel& model);

/// Whether a file has such arrays; no more is checked.
bool is_cubic_model(const std::string& path);

/// Guarantees: arrays as long as the numbers of cubes say, all numbers finite, box and cubes sound.
/// Throws: kernel::InputError "FILE: ELEMENT: PROBLEM; REMEDY", one line.
splines::CubicModel read_cubic_model(const std::string& path);

/// The same for a file that is in memory: `name` stands in messages.
splines::CubicModel read_cubic_model_bytes(const std::string& name, std::string_view bytes);

}  // namespace crest::io
