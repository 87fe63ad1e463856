// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// What is wrong with a stream.
#include <stdexcept>
#include <string>

namespace crest::coding {

/// Thrown by decoders; what() completes "the section ...".
class StreamError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Runs `decode` and says in its errors how many bytes it had read.
template <class Range, class Decode>
auto with_position(const Range& range, Decode&& decode) {
  try {
    return decode();
  } catch (const StreamError& error) {
    throw StreamError(std::string(error.what()) + " (byte " + std::to_string(range.position()) +
                      ")");
  }
}

}  // namespace crest::coding
