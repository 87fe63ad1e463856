// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Which field of a soup is meant, and its numbers.
#include <string>
#include <vector>

#include "io/formats/soup.hpp"

namespace crest::io {

/// The scalar point field of that name, or (empty name) the only one there is.
/// Throws: kernel::InputError with the names there are, or with `remedy` if there are none.
const Field& choose_scalar(const Soup& soup, const std::string& name, const std::string& remedy);

/// The numbers as doubles, without loss. Throws: kernel::InputError if they are not `components` a
/// point, or for an integer beyond 2^53, which would be rounded so that ties appear.
std::vector<double> exact_doubles(const Soup& soup, const Field& field);

}  // namespace crest::io
