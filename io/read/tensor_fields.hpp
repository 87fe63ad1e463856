// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Symmetric tensors from the numbers of files.
#include <array>
#include <span>
#include <string>

namespace crest::io {

/// Where each of xx yy zz xy yz xz stands in an order, words by blanks or commas. Throws:
/// kernel::InputError for words that are not these six.
std::array<std::size_t, 6> tensor_places(const std::string& order);

/// xx yy zz xy yz xz of 6 numbers, or of the rows of 9; `asymmetry` grows to the largest
/// |T_ij - T_ji|.
std::array<double, 6> tensor_of(std::span<const double> numbers,
                                const std::array<std::size_t, 6>& places, double& asymmetry);

}  // namespace crest::io
