// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The one line of bad input.
#include <string>

#include "kernel/geometry/input_error.hpp"

namespace crest::tests {

template <class Call>
std::string error_of(const Call& call) {
  try {
    call();
  } catch (const kernel::InputError& error) {
    return error.what();
  }
  return "no error";
}

}  // namespace crest::tests
