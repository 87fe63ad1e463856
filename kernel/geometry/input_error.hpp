// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// What is wrong with the user's input, in one line.
#include <stdexcept>
#include <string>

namespace crest::kernel {

/// Thrown for bad input only (exit code 3). what() is one line: "FILE: ELEMENT: PROBLEM; REMEDY".
/// The layer that knows the file's name prepends it (see with_file).
class InputError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
  InputError with_file(const std::string& file) const { return InputError(file + ": " + what()); }
};

}  // namespace crest::kernel
