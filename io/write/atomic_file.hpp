// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Output files appear whole or not at all.
#include <string>
#include <string_view>

namespace crest::io {

/// Writes `bytes` to a temporary file beside `path`, then renames it to `path`.
/// A target that is a symbolic link keeps being one; a device or pipe is written directly.
/// Guarantees: on failure the old file, if any, is untouched and nothing new is left behind.
/// Throws: kernel::InputError, one line naming the file.
void write_atomically(const std::string& path, std::string_view bytes);

}  // namespace crest::io
