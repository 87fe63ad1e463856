// SPDX-License-Identifier: GPL-3.0-or-later
// Claim 14: true certificates are accepted, changed ones rejected unless they are true as well.
#include <algorithm>
#include <bit>
#include <catch2/catch.hpp>
#include <cmath>
#include <functional>
#include <map>
#include <set>

#include "algorithms/coding/coding.hpp"
#include "algorithms/coding/container.hpp"
#include "algorithms/coding/numbers.hpp"
#include "algorithms/coding/range_coder.hpp"
#include "certify/coding/encode.hpp"
#include "certify/coding/stream.hpp"
#include "certify/container/container.hpp"
#include "certify/container/reject.hpp"
#include "certify/verify.hpp"
#include "tests/support/random.hpp"

using namespace crest;
using namespace crest::certify;
using namespace crest::tests;

namespace {

struct Mesh {
  std::vector<std::array<double, 3>> points;
  std::vector<kernel::Triangle> faces;
};

/// m n vertices on a torus, or, cut open, a cylinder or a disc.
Mesh grid(std::uint32_t m, std::uint32_t n, bool round, bool high) {
  Mesh mesh;
  for (std::uint32_t j = 0; j < n; ++j)
    for (std::uint32_t i = 0; i < m; ++i)
      mesh.points.push_back({0.1 * i, 0.25 * j, std::sin(i * 0.7 + j)});
  for (std::uint32_t j = 0; j < n - (high ? 0 : 1); ++j)
    for (std::uint32_t i = 0; i < m - (round ? 0 : 1); ++i) {
      const std::uint32_t a = i + m * j, b = (i + 1) % m + m * j,
                          c = (i + 1) % m + m * ((j + 1) % n), d = i + m * ((j + 1) % n);
      mesh.faces.push_back({a, b, c});
      mesh.faces.push_back({a, c, d});
    }
  return mesh;
}

/// A sphere of vertices put into random faces, -0 among their coordinates.
Mesh stacked(std::uint32_t vertices, Random& random) {
  Mesh mesh;
  mesh.faces = {{0, 1, 2}, {0, 2, 3}, {0, 3, 1}, {1, 3, 2}};
  for (std::uint32_t v = 4; v < vertices; ++v) {
    auto& t = mesh.faces[random() % mesh.faces.size()];
    const auto [a, b, c] = t;
    t = {a, b, v};
    mesh.faces.push_back({b, c, v});
    mesh.faces.push_back({c, a, v});
  }
  for (std::uint32_t v = 0; v < vertices; ++v)
    mesh.points.push_back({std::ldexp(static_cast<double>(random() % 1000), -5),
                           v % 7 == 0 ? -0.0 : 1.0 / (v + 1), static_cast<double>(v) * 1e4});
  return mesh;
}

Mesh both(const Mesh& first, const Mesh& second) {
  Mesh mesh = first;
  mesh.points.insert(mesh.points.end(), second.points.begin(), second.points.end());
  for (auto face : second.faces) {
    for (auto& v : face) v += static_cast<std::uint32_t>(first.points.size());
    mesh.faces.push_back(face);
  }
  return mesh;
}

CodingCertificate certificate(const Mesh& mesh, const coding::EncodeOptions& options) {
  const auto encoded = coding::encode(
      static_cast<std::uint32_t>(mesh.points.size()), mesh.faces,
      options.places == coding::Places::none ? std::vector<std::array<double, 3>>() : mesh.points,
      options);
  CodingCertificate c;
  c.faces = mesh.faces;
  for (const auto& p : mesh.points)
    c.positions.push_back({std::bit_cast<std::uint64_t>(p[0]), std::bit_cast<std::uint64_t>(p[1]),
                           std::bit_cast<std::uint64_t>(p[2])});
  c.mode = static_cast<CodingMode>(options.places);
  c.keep_order = options.keep_order;
  c.tolerance = options.places == coding::Places::rounded ? options.tolerance : 0;
  c.stream = encoded.stream;
  c.permutation = encoded.vertex_order;
  c.components = encoded.info.components;
  c.handles = encoded.info.handles;
  c.loops = encoded.info.loops;
  return c;
}

const std::vector<CodingCertificate>& originals() {
  static const auto all = [] {
    Random random(3);
    const std::vector<Mesh> meshes = {grid(7, 5, true, true),
                                      grid(8, 4, true, false),
                                      grid(6, 6, false, false),
                                      stacked(60, random),
                                      both(grid(5, 5, true, true), stacked(12, random)),
                                      both(stacked(5, random), grid(4, 4, false, false))};
    using coding::Method, coding::Places;
    std::vector<CodingCertificate> list;
    for (const Mesh& mesh : meshes) {
      for (const Method method : {Method::valence, Method::fan, Method::zigzag, Method::fixed})
        list.push_back(certificate(mesh, {.method = method}));
      list.push_back(certificate(mesh, {.places = Places::rounded, .tolerance = 0.01}));
      list.push_back(certificate(mesh, {.keep_order = true}));
      list.push_back(certificate(mesh, {.places = Places::none}));
    }
    return list;
  }();
  return all;
}

TEST_CASE("coding: streams of all methods and modes are accepted") {
  for (std::size_t i = 0; i < originals().size(); ++i) {
    const Verdict verdict = verify(encode(originals()[i]));
    INFO("certificate " << i << ": " << verdict.reason);
    CHECK(verdict.accepted);
  }
}

using Edit = std::function<bool(CodingCertificate&, Random&)>;

using Edits = std::map<std::string, Edit>;

Edits first_edits() {
  return {{"vertices exchanged",
           [](auto& c, auto& r) {
             const auto i = r() % c.permutation.size(), j = r() % c.permutation.size();
             std::swap(c.permutation[i], c.permutation[j]);
             return i != j;
           }},
          {"a vertex twice",
           [](auto& c, auto& r) {
             const auto i = r() % c.permutation.size(), j = r() % c.permutation.size();
             c.permutation[i] = c.permutation[j];
             return i != j;
           }},
          {"a face turned round",
           [](auto& c, auto& r) {
             auto& face = c.faces[r() % c.faces.size()];
             std::swap(face[0], face[1]);
             return true;
           }},
          {"all faces turned round",
           [](auto& c, auto&) {
             for (auto& face : c.faces) std::swap(face[0], face[1]);
             return true;
           }},
          {"a face less",
           [](auto& c, auto& r) {
             c.faces.erase(c.faces.begin() + static_cast<std::ptrdiff_t>(r() % c.faces.size()));
             return true;
           }},
          {"a diagonal flipped",
           [](auto& c, auto&) {
             // 0 1 b and a 1 0: the first two of a grid share a diagonal.
             auto &s = c.faces[0], &t = c.faces[1];
             if (s[0] != t[0] || s[2] != t[1]) return false;
             const auto [a, b, d] = s;
             const auto e = t[2];
             s = {a, b, e};
             t = {b, d, e};
             return true;
           }},
          {"a bit of a place", [](auto& c, auto& r) {
             c.positions[r() % c.positions.size()][r() % 3] ^= 1;
             return c.mode == CodingMode::exact;
           }}};
}

Edits more_edits() {
  return {{"the sign of a zero",
           [](auto& c, auto&) {
             for (auto& p : c.positions)
               for (auto& x : p)
                 if (x << 1 == 0) {
                   x ^= std::uint64_t{1} << 63;
                   return c.mode == CodingMode::exact;
                 }
             return false;
           }},
          {"a place too far",
           [](auto& c, auto& r) {
             auto& x = c.positions[r() % c.positions.size()][r() % 3];
             x = std::bit_cast<std::uint64_t>(std::bit_cast<double>(x) + 4 * c.tolerance);
             return c.mode == CodingMode::tolerance;
           }},
          {"a tolerance too small",
           [](auto& c, auto&) {
             c.tolerance /= 1000;
             return c.mode == CodingMode::tolerance;
           }},
          {"no tolerance",
           [](auto& c, auto&) {
             c.tolerance = 0;
             return c.mode == CodingMode::tolerance;
           }},
          {"another mode",
           [](auto& c, auto& r) {
             c.mode =
                 static_cast<CodingMode>((static_cast<std::uint64_t>(c.mode) + 1 + r() % 2) % 3);
             c.tolerance = c.mode == CodingMode::tolerance ? 1e300 : 0;
             return true;
           }},
          {"order kept, or not",
           [](auto& c, auto&) {
             c.keep_order = !c.keep_order;
             return true;
           }},
          {"a component more", [](auto& c, auto&) { return ++c.components, true; }}};
}

Edits last_edits() {
  return {{"a handle more", [](auto& c, auto&) { return ++c.handles, true; }},
          {"a loop more", [](auto& c, auto&) { return ++c.loops, true; }},
          {"a byte of the stream",
           [](auto& c, auto& r) {
             c.stream[r() % c.stream.size()] ^= static_cast<std::uint8_t>(1u << r() % 8);
             return true;
           }},
          {"a byte less", [](auto& c, auto&) { return c.stream.pop_back(), true; }},
          {"a byte more", [](auto& c, auto&) { return c.stream.push_back(0), true; }}};
}

/// Each changes what is stated, or says that it could not.
const Edits& edits() {
  static const Edits all = [] {
    Edits list = first_edits();
    list.merge(more_edits());
    list.merge(last_edits());
    return list;
  }();
  return all;
}

TEST_CASE("coding: every changed claim is rejected") {
  std::map<std::string, std::size_t> tried;
  for (std::size_t i = 0; i < originals().size(); ++i)
    for (const auto& [name, edit] : edits())
      for (std::uint64_t seed = 1; seed <= scaled(2); ++seed) {
        Random random(seed);
        CodingCertificate mutant = originals()[i];
        if (!edit(mutant, random)) continue;
        // An isomorphism of a symmetric mesh without places is as good as another.
        const bool may_be_true =
            name == "vertices exchanged" && mutant.mode == CodingMode::connectivity;
        INFO(name << ", certificate " << i << ", seed " << seed);
        if (!may_be_true) CHECK_FALSE(verify(encode(mutant)).accepted);
        ++tried[name];
      }
  for (const auto& [name, edit] : edits()) {
    INFO(name);
    CHECK(tried[name] > 0);
  }
}

TEST_CASE("coding: streams of another mesh of the same counts are rejected") {
  // Checksums and digest are right: only the comparison of faces can tell.
  Random random(11);
  const Mesh first = stacked(40, random), second = stacked(40, random);
  CodingCertificate c = certificate(first, {.places = coding::Places::none});
  c.stream = certificate(second, {.places = coding::Places::none}).stream;
  const Verdict verdict = verify(encode(c));
  CHECK_FALSE(verdict.accepted);
  CHECK(verdict.reason.find("faces") != std::string::npos);
}

TEST_CASE("coding: of an attributes section nothing is claimed but that it is not empty") {
  Random random(12);
  const CodingCertificate plain = certificate(stacked(20, random), {});
  const auto with_section = [&](const coding::Bytes& section) {
    coding::Container parts = coding::parse(plain.stream);
    parts.has_attributes = true;
    parts.sections[static_cast<std::size_t>(coding::Section::attributes)] = section;
    CodingCertificate c = plain;
    c.stream = coding::compose(parts);
    CHECK_THROWS(coding::decode(c.stream));
    return verify(encode(c));
  };
  const auto disclaims = [](const Verdict& verdict) {
    return std::any_of(verdict.lines.begin(), verdict.lines.end(), [](const std::string& line) {
      return line.find(
                 "without its attributes section; whether a decoder accepts that section is "
                 "not claimed") != std::string::npos;
    });
  };
  CHECK_FALSE(disclaims(verify(encode(plain))));
  const Verdict garbage = with_section({0x67, 0x61, 0x72, 0x62, 0x61, 0x67, 0x65, 0xff});
  CHECK(garbage.accepted);
  CHECK(disclaims(garbage));
  const Verdict empty = with_section({});
  CHECK_FALSE(empty.accepted);
  CHECK(empty.reason.find("section is empty") != std::string::npos);
}

TEST_CASE("coding: data that are no oriented manifold are rejected before the stream is read") {
  const Mesh tetrahedron = {{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}},
                            {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {0, 3, 2}}};
  const CodingCertificate good = certificate(tetrahedron, {});
  REQUIRE(verify(encode(good)).accepted);
  const auto refused = [&](const std::function<void(CodingCertificate&)>& edit) {
    CodingCertificate c = good;
    edit(c);
    return !verify(encode(c)).accepted;
  };
  // Two spheres that share a vertex.
  CHECK(refused([](auto& c) {
    c.positions.insert(c.positions.end(), {{1, 2, 3}, {4, 5, 6}, {7, 8, 9}});
    c.permutation.insert(c.permutation.end(), {4, 5, 6});
    for (auto face : std::vector<std::array<std::uint32_t, 3>>(c.faces)) {
      for (auto& v : face) v += v > 0 ? 3 : 0;
      c.faces.push_back(face);
    }
  }));
  CHECK(refused([](auto& c) { c.faces[0] = c.faces[1]; }));
  CHECK(refused([](auto& c) { c.faces[0][0] = 9; }));
  CHECK(refused([](auto& c) { c.faces[0][0] = c.faces[0][1]; }));
  for (const double bad : {HUGE_VAL, -HUGE_VAL, std::nan("")})
    CHECK(refused([&](auto& c) { c.positions[1][2] = std::bit_cast<std::uint64_t>(bad); }));
  const certify::Bytes bytes = encode(good);
  for (std::size_t size = 0; size < bytes.size(); ++size)
    CHECK_FALSE(verify(std::span(bytes).first(size)).accepted);
}

TEST_CASE("coding: a residual of more than 64 bits is refused") {
  // One triangle, exact places as patterns of doubles: on axis 2 vertex 0 has a residual of 64
  // bits, and vertex 1 says that its own has more. It was read from behind a table once.
  std::vector<std::uint8_t> section = {0x03, 0xfa, 0xcd, 0xcc, 0xaf, 0x58, 0xff, 0xff, 0xff,
                                       0xff, 0xfe, 0xda, 0x18, 0xcf, 0x44, 0x80, 0x00};
  section.resize(64, 0);
  try {
    decode_positions(section, {{0, 1, 2}}, 3, 1);
    FAIL("accepted");
  } catch (const Reject& reject) {
    CHECK(std::string(reject.what()).find("more than 64 bits") != std::string::npos);
  }
}

TEST_CASE("coding: a step below the normal numbers is refused") {
  const auto problem = [](double step) -> std::string {
    coding::RangeEncoder range;
    coding::LargeNumber::code_lower(range, std::bit_cast<std::uint64_t>(step), 64);
    auto section = range.finish();
    section.resize(64, 0);
    try {
      decode_positions(section, {{0, 1, 2}}, 3, 2);
    } catch (const Reject& reject) {
      return reject.what();
    }
    return "";
  };
  for (const double bad : {0x1p-1023, 0x1p-1055, 0.0, -1.0, HUGE_VAL})
    CHECK(problem(bad).find("no normal positive number") != std::string::npos);
  CHECK(problem(0x1p-1022).find("no normal positive number") == std::string::npos);
}

TEST_CASE("coding: hostile streams end soon") {
  // A header of few bytes with huge counts, and random sections behind a right header.
  Random random(5);
  const CodingCertificate good = originals()[3];
  std::size_t refused = 0, tried = 0;
  for (std::uint64_t n = scaled(500); n > 0; --n) {
    auto stream = good.stream;
    for (std::size_t k = 1 + random() % 4; k > 0; --k)
      stream[random() % stream.size()] = static_cast<std::uint8_t>(random());
    if (random() % 4 == 0) stream.resize(random() % stream.size());
    ++tried;
    try {
      const DecodedMesh mesh = decode_stream(stream, good.positions.size(), good.faces.size());
      CHECK(stream == good.stream);
      CHECK(mesh.faces.size() == good.faces.size());
    } catch (const Reject&) {
      ++refused;
    }
  }
  CHECK(refused > tried * 9 / 10);
}

}  // namespace
