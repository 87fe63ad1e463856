// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/certify/second_opinion.hpp"

#include <catch2/catch.hpp>
#include <cstdlib>
#include <iostream>

#include "certify/second/check.hpp"

namespace crest::tests {

SecondOpinions::SecondOpinions(std::uint64_t stride)
    : stride_(std::getenv("CREST_SECOND_OPINION") != nullptr ? 1 : stride) {}

SecondOpinions::~SecondOpinions() {
  std::cout << "second checker: asked about " << asked_ << " of " << given_ << "; both accept "
            << accepted_ << ", the second alone " << alone_ << ", the first alone " << refused_
            << "\n";
}

bool SecondOpinions::compare(const certify::Bytes& bytes, const certify::Verdict& first,
                             const std::string& what) {
  if (given_++ % stride_ != 0) return false;
  ++asked_;
  std::string reason;
  try {
    recheck::recheck(recheck::Bytes(bytes.begin(), bytes.end()));
  } catch (const recheck::Rejected& rejected) {
    reason = rejected.what();
  }
  const bool accepted = reason.empty();
  if (accepted && !first.accepted)
    std::cout << what << ": accepted by the second checker alone; the first: " << first.reason
              << "\n";
  INFO(what << ": the second checker: " << reason);
  CHECK((accepted || !first.accepted));
  accepted_ += accepted && first.accepted;
  alone_ += accepted && !first.accepted;
  refused_ += !accepted && first.accepted;
  return accepted;
}

}  // namespace crest::tests
