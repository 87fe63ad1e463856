// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Files' names and bytes, and what is said when something is wrong with them.
#include <functional>
#include <string>

namespace crest::io {

/// Throws kernel::InputError "ELEMENT: PROBLEM; REMEDY", one line; read_named puts the file's name
/// in front.
[[noreturn]] void fail(const std::string& element, const std::string& problem,
                       const std::string& remedy);

/// The extension in lower case, with its dot.
std::string lower_extension(const std::string& path);

/// The bytes of a regular file.
std::string load(const std::string& path);

/// Runs `read`; whatever it throws becomes an InputError of one line with the file's name in front.
void read_named(const std::string& name, const std::function<void()>& read);

}  // namespace crest::io
