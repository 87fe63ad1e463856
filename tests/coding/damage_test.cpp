// SPDX-License-Identifier: GPL-3.0-or-later
// Streams that are damaged, forged or of another version: refused in one line, at once.
#include <catch2/catch.hpp>
#include <cstdlib>
#include <ctime>

#include "algorithms/coding/container.hpp"
#include "algorithms/coding/range_coder.hpp"
#include "kernel/geometry/input_error.hpp"
#include "tests/coding/damaged_streams.hpp"
#include "tests/support/failures.hpp"

namespace crest::tests {
namespace {

using coding::Bytes;
using coding::Method;
using coding::Places;

/// Empty: decoded.
std::string refusal(const Bytes& stream, kernel::Index max_faces = 1u << 20) {
  try {
    coding::decode(stream, {.faces = max_faces});
  } catch (const kernel::InputError& error) {
    return error.what();
  }
  return "";
}

bool same_mesh(const Bytes& a, const Bytes& b) {
  const auto x = coding::decode(a), y = coding::decode(b);
  return x.faces == y.faces && x.points == y.points && x.attributes == y.attributes;
}

TEST_CASE("damaged streams are refused in one line, in time, even with right checksums") {
  Random random(kSeed);
  const std::vector<Bytes> streams = some_streams(random);
  // Other damage to the same streams, so that a long run can be cut in pieces.
  if (const char* part = std::getenv("CREST_TEST_PART"))
    random = Random(kSeed + std::strtoull(part, nullptr, 10));
  for (const Bytes& stream : streams) CHECK(refusal(stream) == "");
  CHECK(coding::decode(streams.back()).info.cleared);
  Failures failures;
  double slowest = 0;
  int decoded = 0;
  for (int i = 0; i < 6000 * multiplier(); ++i) {
    const Bytes& whole = streams[random() % streams.size()];
    Bytes stream = whole;
    const auto at = random() % stream.size();
    switch (random() % 5) {
      case 0:
        stream.resize(at);
        break;
      case 1:
        stream[at] = static_cast<std::uint8_t>(random());
        break;
      case 2:
        stream[at] ^= static_cast<std::uint8_t>(1u << random() % 8);
        break;
      case 3:
        stream.insert(stream.begin() + static_cast<std::ptrdiff_t>(at),
                      static_cast<std::uint8_t>(random()));
        break;
      default:
        for (int k = 0; k < 4; ++k) stream[5 + random() % 12] = static_cast<std::uint8_t>(random());
    }
    const bool renewed = random() % 4 != 0 && stream.size() > 16;
    if (renewed) renew_checksums(stream);
    const std::clock_t begin = std::clock();
    const std::string words = refusal(stream);
    slowest = std::max(slowest, static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC);
    failures.expect(words.find('\n') == std::string::npos, "one line", words);
    // Decisions at the end may be spelt in several ways: then it is the same mesh.
    if (words != "") continue;
    failures.expect(same_mesh(stream, whole), "another mesh", i);
    ++decoded;
  }
  INFO(6000 * multiplier() << " damaged streams, of which " << decoded << " are the same mesh");
  CHECK(failures.report() == "");
  CHECK(slowest < 1);
}

/// The static code's decisions, by hand.
class StaticWriter {
 public:
  void leaf() { decide({true, false}); }
  void left(kernel::Index length) {
    length == 1 ? decide({true, true, false}) : longer(length, true);
  }
  void right(kernel::Index length) {
    length == 1 ? decide({true, true, true, true}) : longer(length, true);
  }
  void both(kernel::Index length) {
    length == 1 ? decide({true, true, true, false}) : longer(length, false);
  }
  Bytes finish() { return range_.finish(); }

 private:
  void longer(kernel::Index length, bool one) {
    decide({false});
    for (kernel::Index l = 2; l < length; ++l) decide({true});
    decide({false, one});
  }
  void decide(std::initializer_list<bool> bits) {
    for (const bool bit : bits) range_.code(bit, {2654435769u, 32});
  }
  coding::RangeEncoder range_;
};

Bytes forged(const Bytes& section, const coding::Counts& counts) {
  coding::Container c;
  c.method = Method::fixed;
  c.counts = counts;
  c.sections[0] = section;
  return coding::compose(c);
}

TEST_CASE("forged streams: a doubled edge, pieces that are left, loops that are no holes") {
  StaticWriter doubled;
  doubled.leaf();
  doubled.right(1);
  doubled.left(3);
  CHECK_THAT(refusal(forged(doubled.finish(), {.vertices = 5})), Catch::Contains("no manifold"));
  StaticWriter tetrahedron;
  tetrahedron.leaf();
  tetrahedron.right(2);
  CHECK_THAT(refusal(forged(tetrahedron.finish(), {.vertices = 4})), Catch::Contains("digest"));
  StaticWriter pieces;
  pieces.leaf();
  pieces.leaf();
  CHECK_THAT(refusal(forged(pieces.finish(), {.vertices = 4})), Catch::Contains("components"));
  StaticWriter missing;
  missing.left(1);
  CHECK_THAT(refusal(forged(missing.finish(), {.vertices = 3, .loops = 1})),
             Catch::Contains("not there"));
  StaticWriter disk;
  disk.leaf();
  disk.left(1);
  CHECK(refusal(forged(disk.finish(), {.vertices = 4})) != "");
  CHECK(refusal(forged({}, {.vertices = 4000000000u, .components = 7})) != "");
}

TEST_CASE("forged streams: a residual of 64 bits where numbers have 54 does not wrap") {
  // A tetrahedron whose first coordinate is 0 + (2^64 - 5), with the digest of -5.
  const Bytes stream = {0x43, 0x4d, 0x43, 0x1a, 0x01, 0x08, 0x00, 0x04, 0x02, 0x3d, 0xfb,
                        0xef, 0x3b, 0xbb, 0x8f, 0x17, 0x19, 0x81, 0xaa, 0xe2, 0xff, 0xff,
                        0xff, 0xdf, 0x0c, 0x50, 0x64, 0xfc, 0x00, 0x00, 0x00, 0x00, 0x78,
                        0xfc, 0x6f, 0xb7, 0x13, 0x4f, 0x7d, 0xd7, 0xb9, 0x05, 0x88, 0x68,
                        0xee, 0x00, 0x2d, 0x45, 0x6b, 0x81, 0x79};
  CHECK_THAT(refusal(stream), Catch::Contains("beyond its range"));
}

TEST_CASE("streams of other versions, with other flags, with bytes after them are refused") {
  Random random(kSeed);
  const Bytes stream = some_streams(random)[0];
  const auto with = [&](std::size_t at, std::uint8_t byte) {
    Bytes changed = stream;
    changed[at] = byte;
    return refusal(changed);
  };
  CHECK_THAT(with(4, 3), Catch::Contains("version 3"));
  CHECK_THAT(with(4, 2), Catch::Contains("version"));
  CHECK_THAT(with(0, 'X'), Catch::Contains("no .cmc stream"));
  CHECK_THAT(with(5, 0x80), Catch::Contains("flag"));
  CHECK_THAT(with(5, 0x20), Catch::Contains("flag"));
  CHECK_THAT(with(6, 8), Catch::Contains("method"));
  Bytes longer = stream;
  longer.push_back(0);
  CHECK_THAT(refusal(longer), Catch::Contains("bytes follow"));
  CHECK_THAT(refusal(stream, 10), Catch::Contains("more faces than are allowed"));
  CHECK(refusal({}) != "");
}

}  // namespace
}  // namespace crest::tests
