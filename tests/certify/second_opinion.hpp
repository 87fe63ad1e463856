// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// What the second checker of claim 4 says of what the first was given.
#include <cstdint>
#include <string>

#include "certify/verify.hpp"

namespace crest::tests {

class SecondOpinions {
 public:
  /// Asks about every `stride`-th certificate; about all with CREST_SECOND_OPINION=1.
  explicit SecondOpinions(std::uint64_t stride);
  ~SecondOpinions();  ///< prints how many agreed
  SecondOpinions(const SecondOpinions&) = delete;
  SecondOpinions& operator=(const SecondOpinions&) = delete;

  /// Fails where the second rejects what the first accepts. What the second alone accepts is
  /// printed and counted: it divides a piece further than is recorded, where the first says
  /// undecided; it must state the same as the original, which the caller checks. Returns whether
  /// the second, if asked, accepts.
  bool compare(const certify::Bytes& bytes, const certify::Verdict& first, const std::string& what);

 private:
  std::uint64_t stride_, given_ = 0, asked_ = 0, accepted_ = 0, alone_ = 0, refused_ = 0;
};

}  // namespace crest::tests
