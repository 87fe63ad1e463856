// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// What is wrong with a stream.
#include <stdexcept>

namespace crest::coding {

/// Thrown by decoders; what() completes "the section ...".
class StreamError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

}  // namespace crest::coding
