// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Readers of formats that hold solids alone, as those of readers.hpp. The commands on surfaces do
// not offer them.
#include <string_view>

#include "io/formats/readers.hpp"

namespace crest::io {

/// Medit's .mesh, a text: no fields (those are in a .sol file beside it).
Soup read_medit(std::string_view bytes);
/// Medit's .sol, a text: one field a quantity, solution1 .., symmetric tensors in VTK's order; of
/// so many points. Throws if it is about another number of points.
void read_medit_solution(std::string_view bytes, Soup& soup);
/// CalculiX's .frd, a text: nodal results of the last step, or of the one asked for; symmetric
/// tensors in VTK's order.
Soup read_frd(std::string_view bytes, const FieldRequest& request);

}  // namespace crest::io
