// SPDX-License-Identifier: GPL-3.0-or-later
// Every test program's main: numbers are printed with all their digits, a failure with what made
// its random numbers, a skipped case with its reason.
#define CATCH_CONFIG_RUNNER
#include <algorithm>
#include <catch2/catch.hpp>
#include <iostream>
#include <limits>

#include "tests/support/failures.hpp"
#include "tests/support/skip.hpp"

namespace {

using namespace crest::tests;

class Explain : public Catch::TestEventListenerBase {
 public:
  using TestEventListenerBase::TestEventListenerBase;
  void testCaseStarting(const Catch::TestCaseInfo& info) override {
    TestEventListenerBase::testCaseStarting(info);
    printed_.clear();
    latest_generator.clear();
    is_random = false;
  }
  bool assertionEnded(const Catch::AssertionStats& stats) override {
    if (stats.assertionResult.isOk()) return false;
    std::string text;
    if (is_random) text = "Random numbers of the next failure: " + random_origin() + "\n";
    for (const auto& words : said_on_failure) text += "  " + words() + "\n";
    if (text != printed_) Catch::cout() << "\n" << text << std::flush;
    printed_ = text;
    return false;
  }

 private:
  std::string printed_;
};
CATCH_REGISTER_LISTENER(Explain)

}  // namespace

int main(int argc, char** argv) {
  Catch::StringMaker<double>::precision = std::numeric_limits<double>::max_digits10;
  const int failed = Catch::Session().run(argc, argv);
  for (const std::string& reason : skipped) std::cout << "SKIPPED " << reason << "\n";
  // Catch's exit code is a count, which could be kSkipped by chance.
  if (failed != 0) return std::min(failed, kSkipped - 1);
  return skipped.empty() ? 0 : kSkipped;
}
