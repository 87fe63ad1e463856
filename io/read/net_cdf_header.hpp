// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// NetCDF's library allocates what a header announces: its counts are compared with the file first.
#include <string_view>

namespace crest::io {

/// Whether a file is of one of the classic formats (not HDF5).
bool is_classic_net_cdf(std::string_view bytes);

/// Throws kernel::InputError without the file's name unless the lists of a classic header, and
/// their names and attributes, are within the file. Cost: linear in the header.
void check_classic_net_cdf(std::string_view bytes);

}  // namespace crest::io
