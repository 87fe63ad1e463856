// SPDX-License-Identifier: GPL-3.0-or-later
// What crest-verify has of its own in a page: its SHA-256 against the standard's examples and
// OpenSSL's, its algorithms on ranges against libstdc++'s. The whole is tried by scripts/wasm.sh.
#include <algorithm>
#include <catch2/catch.hpp>
#include <numeric>
#include <vector>

#include "certify/container/sha256.hpp"
#include "cli/verify_page/lacking.hpp"
#include "cli/verify_page/sha256.hpp"
#include "tests/support/random.hpp"

namespace crest::tests {
namespace {

using Bytes = std::vector<std::uint8_t>;

certify::Digest digest_of(std::initializer_list<std::span<const std::uint8_t>> pieces) {
  page::Sha256 hash;
  for (const auto& piece : pieces) hash.add(piece);
  return hash.digest();
}
std::string hex_of(const std::string& text) {
  const Bytes bytes(text.begin(), text.end());
  return certify::hex(digest_of({bytes}));
}

struct Row {
  int key, number;
  bool operator==(const Row&) const = default;
};

std::vector<Row> random_rows(Random& random) {
  std::vector<Row> rows(random() % 12);
  int number = 0;
  for (Row& row : rows) row = {static_cast<int>(random() % 6), number++};
  return rows;
}
std::vector<int> random_numbers(Random& random) {
  std::vector<int> numbers(random() % 12);
  for (int& x : numbers) x = static_cast<int>(random() % 6);
  return numbers;
}

}  // namespace

TEST_CASE("SHA-256 of a page: the examples of FIPS 180") {
  CHECK(hex_of("") == "e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855");
  CHECK(hex_of("abc") == "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
  CHECK(hex_of("abcdbcdecdefdefgefghfghighijhijkijkljklmklmnlmnomnopnopq") ==
        "248d6a61d20638b8e5c026930c3e6039a33ce45964ff2167f6ecedd419db06c1");
  CHECK(hex_of(std::string(1000000, 'a')) ==
        "cdc76e5c9914fb9281a1c7e284d73e67f1809a48a497200e046d39ccc7112cd0");
}

TEST_CASE("SHA-256 of a page is OpenSSL's, for all lengths about a block's and any pieces") {
  Random random(1);
  for (std::size_t length = 0; length < 300; ++length) {
    Bytes bytes(length);
    for (auto& byte : bytes) byte = static_cast<std::uint8_t>(random());
    const std::span<const std::uint8_t> all(bytes);
    const std::size_t cut = length == 0 ? 0 : random() % length;
    INFO(length << " bytes, cut at " << cut);
    REQUIRE(digest_of({all}) == certify::sha256({all}));
    REQUIRE(digest_of({all.first(cut), all.subspan(cut)}) == certify::sha256({all}));
    certify::Sha256 pieces;
    pieces.add(all.first(cut));
    pieces.add(all.subspan(cut));
    REQUIRE(pieces.digest() == certify::sha256({all}));
  }
}

TEST_CASE("algorithms on ranges of a page order and search as the library's") {
  Random random(2);
  for (int round = 0; round < 2000; ++round) {
    auto rows = random_rows(random);
    auto numbers = random_numbers(random), sorted = numbers;
    const int x = static_cast<int>(random() % 6);
    lacking::sort(sorted);
    CHECK(std::ranges::is_sorted(sorted));
    CHECK(std::ranges::is_permutation(sorted, numbers));
    CHECK(lacking::is_sorted(numbers) == std::ranges::is_sorted(numbers));
    CHECK(lacking::is_sorted(sorted, std::less_equal<>()) ==
          std::ranges::is_sorted(sorted, std::less_equal<>()));
    CHECK(lacking::lower_bound(sorted, x) == std::ranges::lower_bound(sorted, x));
    CHECK(lacking::binary_search(sorted, x) == std::ranges::binary_search(sorted, x));
    const auto [first, last] = lacking::equal_range(sorted, x);
    CHECK(std::ranges::equal_range(sorted, x).begin() == first);
    CHECK(std::ranges::equal_range(sorted, x).end() == last);
    lacking::sort(rows, {}, &Row::key);
    CHECK(std::ranges::is_sorted(rows, {}, &Row::key));
    CHECK(lacking::lower_bound(rows, x, {}, &Row::key) ==
          std::ranges::lower_bound(rows, x, {}, &Row::key));
    lacking::sort(numbers, std::greater<>());
    CHECK(std::ranges::is_sorted(numbers, std::greater<>()));
    if (numbers.empty()) continue;
    const auto ends = std::ranges::minmax(numbers);
    const auto ours = lacking::minmax(numbers);
    CHECK((ours.min == ends.min && ours.max == ends.max));
  }
}

TEST_CASE("algorithms on ranges of a page find, count and change as the library's") {
  Random random(3);
  for (int round = 0; round < 2000; ++round) {
    const auto rows = random_rows(random);
    const auto numbers = random_numbers(random), others = random_numbers(random);
    const int x = static_cast<int>(random() % 6);
    const auto above = [&](int y) { return y > x; };
    CHECK(lacking::max_element(numbers) == std::ranges::max_element(numbers));
    CHECK(lacking::all_of(numbers, above) == std::ranges::all_of(numbers, above));
    CHECK(lacking::any_of(rows, above, &Row::key) == std::ranges::any_of(rows, above, &Row::key));
    CHECK(lacking::none_of(numbers, above) == std::ranges::none_of(numbers, above));
    CHECK(lacking::count_if(numbers, above) == std::ranges::count_if(numbers, above));
    CHECK(lacking::count(rows, x, &Row::key) == std::ranges::count(rows, x, &Row::key));
    CHECK(lacking::find_if(numbers, above) == std::ranges::find_if(numbers, above));
    CHECK(lacking::find(rows, x, &Row::number) == std::ranges::find(rows, x, &Row::number));
    CHECK(lacking::adjacent_find(numbers) == std::ranges::adjacent_find(numbers));
    CHECK(lacking::adjacent_find(numbers, std::greater<>()) ==
          std::ranges::adjacent_find(numbers, std::greater<>()));
    CHECK(lacking::equal(numbers, others) == std::ranges::equal(numbers, others));
    CHECK(lacking::equal(rows, numbers, {}, &Row::key) ==
          std::ranges::equal(rows, numbers, {}, &Row::key));
    auto a = numbers, b = numbers;
    const auto left = lacking::unique(a);
    const auto expected = std::ranges::unique(b);
    CHECK(std::equal(a.begin(), left.begin(), b.begin(), expected.begin()));
    CHECK(left.end() == a.end());
    a = b = numbers;
    lacking::reverse(a), std::ranges::reverse(b);
    CHECK(a == b);
    const auto middle = static_cast<std::ptrdiff_t>(random() % (numbers.size() + 1));
    lacking::rotate(a, a.begin() + middle), std::ranges::rotate(b, b.begin() + middle);
    CHECK(a == b);
    lacking::replace(a, x, 9), std::ranges::replace(b, x, 9);
    CHECK(a == b);
    lacking::copy(numbers, a.begin());
    CHECK(a == numbers);
  }
  CHECK(lacking::bit_cast<std::uint64_t>(1.0) == 0x3ff0000000000000U);
}

}  // namespace crest::tests
