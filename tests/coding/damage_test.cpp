// SPDX-License-Identifier: GPL-3.0-or-later
// Streams that are damaged, forged or of another version: refused in one line, at once.
#include <boost/crc.hpp>
#include <catch2/catch.hpp>
#include <ctime>

#include "algorithms/coding/container.hpp"
#include "algorithms/coding/range_coder.hpp"
#include "kernel/geometry/input_error.hpp"
#include "tests/coding/meshes.hpp"
#include "tests/support/failures.hpp"

namespace crest::tests {
namespace {

using coding::Bytes;
using coding::Method;
using coding::Places;

/// Empty: decoded.
std::string refusal(const Bytes& stream, kernel::Index max_faces = 1u << 20) {
  try {
    coding::decode(stream, max_faces);
  } catch (const kernel::InputError& error) {
    return error.what();
  }
  return "";
}

std::vector<Bytes> some_streams(Random& random) {
  PlainMesh mesh = joined_tori(2, 6, 7);
  flip_edges(mesh, 400, random);
  mesh = punch_holes(mesh, 2, random);
  std::vector<Bytes> streams;
  for (int i = 0; i < 12; ++i) {
    coding::EncodeOptions options;
    options.method = static_cast<Method>(i % 4);
    options.places = static_cast<Places>(i / 4);
    options.tolerance = 0.01;
    options.keep_order = i % 3 == 0;
    streams.push_back(coding::encode(mesh.vertices(), mesh.faces, mesh.points, options).stream);
  }
  return streams;
}

/// Where a section's bytes begin, by its number among those that are there.
void renew_checksums(Bytes& stream) {
  std::size_t at = 7;
  const auto varint = [&] {
    std::size_t x = 0;
    for (int shift = 0; at < stream.size(); shift += 7) {
      x |= std::size_t{stream[at] & 127u} << shift;
      if (stream[at++] < 128) break;
    }
    return x;
  };
  const int flags = stream[5];
  varint();
  for (int bit = 0; bit < 3; ++bit)
    if ((flags >> bit & 1) != 0) varint();
  const int sections = 1 + ((flags & 24) != 0 ? 1 : 0) + ((flags & 64) != 0 ? 1 : 0);
  for (int i = 0; i < sections; ++i) {
    const std::size_t size = varint();
    if (at + 4 + size > stream.size()) return;
    boost::crc_32_type crc;
    crc.process_bytes(stream.data() + at + 4, size);
    for (int k = 0; k < 4; ++k)
      stream[at + static_cast<std::size_t>(k)] =
          static_cast<std::uint8_t>(crc.checksum() >> (8 * k));
    at += 4 + size;
  }
}

bool same_mesh(const Bytes& a, const Bytes& b) {
  const auto x = coding::decode(a), y = coding::decode(b);
  return x.faces == y.faces && x.points == y.points;
}

TEST_CASE("damaged streams are refused in one line, in time, even with right checksums") {
  Random random(kSeed);
  const std::vector<Bytes> streams = some_streams(random);
  for (const Bytes& stream : streams) CHECK(refusal(stream) == "");
  Failures failures;
  double slowest = 0;
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
    if (words == "") failures.expect(same_mesh(stream, whole), "another mesh", i);
  }
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

TEST_CASE("streams of other versions, with other flags, with bytes after them are refused") {
  Random random(kSeed);
  const Bytes stream = some_streams(random)[0];
  const auto with = [&](std::size_t at, std::uint8_t byte) {
    Bytes changed = stream;
    changed[at] = byte;
    return refusal(changed);
  };
  CHECK_THAT(with(4, 2), Catch::Contains("version 2"));
  CHECK_THAT(with(0, 'X'), Catch::Contains("no .cmc stream"));
  CHECK_THAT(with(5, 0x80), Catch::Contains("flag"));
  CHECK_THAT(with(5, 0x20), Catch::Contains("flag"));
  CHECK_THAT(with(6, 4), Catch::Contains("method"));
  Bytes longer = stream;
  longer.push_back(0);
  CHECK_THAT(refusal(longer), Catch::Contains("bytes follow"));
  CHECK_THAT(refusal(stream, 10), Catch::Contains("more faces than are allowed"));
  CHECK(refusal({}) != "");
}

}  // namespace
}  // namespace crest::tests
