// SPDX-License-Identifier: GPL-3.0-or-later
// A failing test explains itself: operands that can be pasted, seed, salt, multiplier; a skipped
// one is no passed one (tests/support).
#include <catch2/catch.hpp>

#include "kernel/predicates/acute_rule.hpp"
#include "kernel/predicates/segment_type.hpp"
#include "tests/architecture/source_tree.hpp"
#include "tests/support/degenerate_families.hpp"
#include "tests/support/failures.hpp"
#include "tests/support/shared_data.hpp"

using namespace crest;
using namespace crest::tests;

namespace {

ProgramResult run_hidden(const std::string& name, const std::string& environment) {
  const auto self = fs::read_symlink("/proc/self/exe");
  return run_shell(environment + " '" + self.string() + "' '" + name + "'", fs::current_path(),
                   ".");
}

bool has(const ProgramResult& result, const std::string& text) {
  INFO(result.out << "\nlacks " << text);
  const bool found = result.out.find(text) != std::string::npos;
  CHECK(found);
  return found;
}

}  // namespace

TEST_CASE("operands in words can be pasted: hexadecimal floats, braces") {
  CHECK(in_words(0.1) == "0x1.999999999999ap-4");
  CHECK(in_words(-0.0) == "-0x0p+0");
  CHECK(in_words(HUGE_VAL) == "HUGE_VAL");
  CHECK(in_words(std::array<int, 2>{1, -2}) == "{1, -2}");
  CHECK(in_words(std::vector<std::array<int, 1>>{{1}, {2}}) == "{{{1}, {2}}}");
  const kernel::AcuteProduct product{{1, 0, 0.5}, {0, -2, 0}};
  CHECK(in_words(product) == "{{0x1p+0, 0x0p+0, 0x1p-1}, {0x0p+0, -0x1p+1, 0x0p+0}}");
  // As it is printed above.
  const kernel::AcuteProduct pasted = {{0x1p+0, 0x0p+0, 0x1p-1}, {0x0p+0, -0x1p+1, 0x0p+0}};
  CHECK(pasted.d == product.d);
  CHECK(pasted.e == product.e);
  const kernel::CrossedTriangle triangle{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, 1, 2, 3};
  CHECK(in_words(kernel::SegmentSide{triangle, {1, 0, 0}, {0, 0, 1}, true}).ends_with("true}"));
}

TEST_CASE("counted failures keep the first, its operands and where they come from") {
  Failures failures;
  failures.expect(true, "one is one", 1);
  CHECK(failures.report() == "");
  const Draw d(40, Family::tiny);
  failures.expect(false, "x is small", 0.5, 2);
  failures.expect(false, "x is small", 0.25, 3);
  CHECK(failures.count() == 2);
  CHECK(failures.report() ==
        "2 of 3 are not so, the first: x is small {0x1p-1, 2} (" + random_origin() + ")");
  CHECK(random_origin().find("kSeed " + std::to_string(kSeed)) != std::string::npos);
  CHECK(random_origin().find("Draw(43), family tiny") != std::string::npos);
}

// Hidden: run by the next test.
TEST_CASE("a case that fails", "[.fails]") {
  Draw d(40, Family::generic);
  const double x = d.uniform();
  const OnFailure shown([&] { return "x = " + in_words(x); });
  CHECK(x == 2.1);
}

TEST_CASE("a case whose data are not there", "[.skips]") {
  if (!shared_data("no such file")) return;
  FAIL("there is such a file");
}

TEST_CASE("a failing random test prints seed, salt, multiplier and operands") {
  const auto result = run_hidden("a case that fails", "CREST_TEST_MULTIPLIER=3");
  CHECK(result.exit_code == 1);
  has(result, "kSeed " + std::to_string(kSeed));
  has(result, "CREST_TEST_MULTIPLIER 3");
  has(result, "Draw(40), family generic");
  has(result, "  x = 0x1.");
  has(result, "2.10000000000000009");
}

TEST_CASE("a test skips only where there are no shared data, and says so") {
  const auto result = run_hidden("a case whose data are not there", "");
  const bool shared = fs::exists(fs::path(CREST_SOURCE_DIR) / ".." / "shared");
  CHECK(result.exit_code == (shared ? 1 : kSkipped));
  has(result, shared ? "../shared is there, but not its data/no such file"
                     : "SKIPPED a case whose data are not there: ../shared is not there");
}

TEST_CASE("random tests take their numbers from tests/support, which notes the seed") {
  // Put together here so that this file passes its own test.
  const std::string engine = std::string("std::") + "mt19937";
  for (const std::string& path : project_files()) {
    if (!has_prefix(path, "tests/") || !is_cpp(path) || path == "tests/support/random.hpp")
      continue;
    INFO(path);
    CHECK(read_text(fs::path(CREST_SOURCE_DIR) / path).find(engine) == std::string::npos);
  }
}
