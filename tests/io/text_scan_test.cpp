// SPDX-License-Identifier: GPL-3.0-or-later
// The scanner of text formats.
#include "io/formats/text_scan.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <cstdlib>
#include <cstring>
#include <limits>

#include "tests/support/random.hpp"

namespace {

using crest::io::TextScan;

bool same(double a, double b) {
  return std::memcmp(&a, &b, sizeof a) == 0 || (std::isnan(a) && std::isnan(b));
}

/// Alone and with so much behind it that it may be read as a short number.
std::optional<double> number(const std::string& word) {
  std::optional<double> first;
  for (const std::string& text : {word, word + "\n" + std::string(16, '7')}) {
    TextScan scan(text);
    double value = 0;
    if (!scan.take(value)) {
      CHECK(scan.position() == 0);
      CHECK_FALSE(first);
      continue;
    }
    CHECK(scan.position() == word.size());
    if (first) CHECK(same(*first, value));
    first = value;
  }
  return first;
}

}  // namespace

TEST_CASE("numbers in texts are rounded correctly", "[io]") {
  const char* const formats[] = {"%.17g", "%+.9e", "%.25g", "%.9g", "%.6f", "%+.7e"};
  int exponent = 0;
  crest::tests::Random random(crest::tests::kSeed);
  for (std::uint64_t i = crest::tests::scaled(20000); i > 0; --i) {
    const std::uint64_t bits = random();
    double x;
    std::memcpy(&x, &bits, sizeof x);
    char text[64];
    const double moderate = std::ldexp(std::frexp(x, &exponent), static_cast<int>(bits % 90) - 45);
    std::snprintf(text, sizeof text, formats[i % 6], i % 6 < 3 ? x : moderate);
    INFO(text);
    const auto value = number(text);
    REQUIRE(value);
    CHECK(same(*value, std::strtod(text, nullptr)));
  }
}

TEST_CASE("numbers in every spelling", "[io]") {
  const double inf = std::numeric_limits<double>::infinity(), nan = std::nan("");
  const std::pair<const char*, double> good[] = {{"1", 1},
                                                 {"+1", 1},
                                                 {"-0", -0.0},
                                                 {"1.", 1},
                                                 {".5", 0.5},
                                                 {"+.5e+1", 5},
                                                 {"1e999", inf},
                                                 {"-1e999", -inf},
                                                 {"1e-999", 0},
                                                 {"-1e-999", -0.0},
                                                 {"4.9e-324", 5e-324},
                                                 {"2e-324", 0},
                                                 {"inf", inf},
                                                 {"-Infinity", -inf},
                                                 {"+inf", inf},
                                                 {"nan", nan},
                                                 {"-NaN", nan},
                                                 {"1.5d3", 1500},
                                                 {"-1.5D-01", -0.15},
                                                 {"1.#INF", inf},
                                                 {"-1.#INF00", -inf},
                                                 {"1.#QNAN", nan},
                                                 {"-1.#IND", nan},
                                                 {"00012", 12},
                                                 {"000000000000000", 0},
                                                 {"999999999999999", 999999999999999},
                                                 {"9999999999999999", 1e16},
                                                 {".00000000000001", 1e-14},
                                                 {"1e22", 1e22},
                                                 {"3e23", 3e23},
                                                 {"12345e-22", 12345e-22},
                                                 {"1e-23", 1e-23}};
  for (const auto& [word, value] : good) {
    INFO(word);
    const auto read = number(word);
    REQUIRE(read);
    CHECK(same(*read, value));
  }
  for (const char* word : {"", "x", "1x", "0x10", "1,5", "+-1", "--1", "++1", "1e", "e5", "1.2.3",
                           "infx", ".", "d1", "1e+", "-.", "1e+-5", "1-", "1e5.5"}) {
    INFO(word);
    CHECK_FALSE(number(word));
  }
}

TEST_CASE("integers in texts", "[io]") {
  const std::pair<const char*, std::int64_t> good[] = {
      {"0", 0},
      {"-0", 0},
      {"+7", 7},
      {"007", 7},
      {"999999999999999999", 999999999999999999},
      {"9223372036854775807", std::numeric_limits<std::int64_t>::max()},
      {"-9223372036854775808", std::numeric_limits<std::int64_t>::min()}};
  for (const auto& [word, value] : good) {
    TextScan scan(word);
    std::int64_t read = 1;
    CHECK(scan.take(read));
    CHECK(read == value);
  }
  for (const char* word : {"", "-", "1.0", "x", "9223372036854775808", "1e3", "+-1"}) {
    TextScan scan(word);
    std::int64_t read = 1;
    INFO(word);
    CHECK_FALSE(scan.take(read));
    CHECK(scan.position() == 0);
  }
}

TEST_CASE("words and lines", "[io]") {
  TextScan scan("\xef\xbb\xbf a\tb # c\r\n\r\n#x\n\rd\v e#f\n", '#');
  CHECK(scan.in_line());
  CHECK(scan.word() == "a");
  CHECK(scan.in_line());
  CHECK(scan.word() == "b");
  CHECK_FALSE(scan.in_line());
  CHECK(scan.line() == 1);
  CHECK(scan.more());
  CHECK(scan.line() == 5);
  CHECK(scan.peek() == "d");
  CHECK(scan.word() == "d");
  CHECK(scan.in_line());
  CHECK(scan.line() == 6);
  CHECK(scan.word() == "e");
  CHECK_FALSE(scan.more());
  CHECK(scan.line() == 7);
  scan.move_to(3);
  CHECK(scan.line() == 1);
  CHECK(scan.rest_of_line() == "a\tb # c");
  CHECK(crest::io::is_keyword("FaCet", "facet"));
  CHECK_FALSE(crest::io::is_keyword("facets", "facet"));
}
