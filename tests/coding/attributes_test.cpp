// SPDX-License-Identifier: GPL-3.0-or-later
// Attributes of every type at vertices, faces and corners come back bit for bit.
#include "algorithms/coding/attributes.hpp"

#include <bit>
#include <catch2/catch.hpp>
#include <cmath>
#include <functional>

#include "algorithms/coding/stream_error.hpp"
#include "algorithms/coding/verify.hpp"
#include "kernel/geometry/input_error.hpp"
#include "tests/coding/meshes.hpp"

namespace crest::tests {
namespace {

using coding::EncodeOptions;
using coding::Method;
using kernel::Attribute;
using kernel::NumberType;
using kernel::Site;

constexpr std::size_t kTypes = 10, kSites = 3;

std::size_t places_of(const PlainMesh& mesh, Site site) {
  return site == Site::vertices ? mesh.points.size()
         : site == Site::faces  ? mesh.faces.size()
                                : 3 * mesh.faces.size();
}

/// Any bits of the type, the extreme ones among them.
std::uint64_t any_word(NumberType type, Random& random) {
  const std::uint64_t bits = random() % 8 == 0 ? random() % 2 - 1 : random();
  switch (type) {
    case NumberType::i8:
      return static_cast<std::uint64_t>(std::int64_t{static_cast<std::int8_t>(bits)});
    case NumberType::u8:
      return static_cast<std::uint8_t>(bits);
    case NumberType::i16:
      return static_cast<std::uint64_t>(std::int64_t{static_cast<std::int16_t>(bits)});
    case NumberType::u16:
      return static_cast<std::uint16_t>(bits);
    case NumberType::i32:
      return static_cast<std::uint64_t>(std::int64_t{static_cast<std::int32_t>(bits)});
    case NumberType::u32:
      return static_cast<std::uint32_t>(bits);
    case NumberType::f32: {
      const auto x = std::bit_cast<float>(static_cast<std::uint32_t>(bits));
      return std::bit_cast<std::uint64_t>(static_cast<double>(x));
    }
    default:
      return bits;
  }
}

Attribute blank(const PlainMesh& mesh, std::string name, Site site, NumberType type,
                std::uint32_t components) {
  Attribute a{std::move(name), site, type, components};
  a.words.assign(components * places_of(mesh, site), 0);
  return a;
}

/// Of few different values, so that corners share them, or of any.
Attribute random_attribute(const PlainMesh& mesh, Site site, NumberType type,
                           std::uint32_t components, bool gaps, Random& random) {
  Attribute a = blank(mesh, "a" + std::to_string(random() % 1000), site, type, components);
  std::vector<std::uint64_t> few;
  for (int i = 0; i < 3; ++i) few.push_back(any_word(type, random));
  const bool any = random() % 3 == 0;
  for (std::uint64_t& word : a.words) word = any ? any_word(type, random) : few[random() % 3];
  if (!gaps) return a;
  const std::size_t places = a.places();
  for (std::size_t p = 0; p < places; ++p) {
    a.missing.push_back(random() % 4 == 0);
    if (a.missing[p])
      for (std::size_t c = 0; c < components; ++c) a.words[c * places + p] = 0;
  }
  return a;
}

coding::Encoded check_round_trip(const PlainMesh& mesh, const std::vector<Attribute>& attributes,
                                 const EncodeOptions& options) {
  auto encoded = coding::encode(mesh.vertices(), mesh.faces, mesh.points, options, attributes);
  CHECK_NOTHROW(coding::verify(encoded, mesh.faces, mesh.points, options, attributes));
  CHECK(encoded.info.sizes.total() == encoded.stream.size());
  if (options.keep_order) {
    const auto decoded = coding::decode(encoded.stream);
    for (std::size_t i = 0; i < attributes.size(); ++i)
      if (attributes[i].site != Site::corners) CHECK(decoded.attributes[i] == attributes[i]);
  }
  return encoded;
}

std::vector<PlainMesh> some_meshes(Random& random) {
  std::vector<PlainMesh> meshes;
  meshes.push_back(joined_tori(2, 5, 6));
  flip_edges(meshes.back(), 300, random);
  meshes.push_back(punch_holes(torus_grid(9, 9), 3, random));
  meshes.push_back(stacked_sphere(40, random));
  meshes.push_back({{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}}});
  return meshes;
}

TEST_CASE("attributes: every type, place, number of components, with gaps and without") {
  Random random(kSeed);
  for (const PlainMesh& mesh : some_meshes(random))
    for (std::size_t site = 0; site < kSites; ++site)
      for (std::size_t type = 0; type < kTypes; ++type)
        for (const bool gaps : {false, true}) {
          INFO(mesh.vertices() << " vertices, site " << site << ", type " << type);
          const auto components = static_cast<std::uint32_t>(1 + random() % 7);
          EncodeOptions options;
          options.method = static_cast<Method>(random() % 4);
          options.keep_order = random() % 2 == 0;
          check_round_trip(
              mesh,
              {random_attribute(mesh, static_cast<Site>(site), static_cast<NumberType>(type),
                                components, gaps, random)},
              options);
        }
}

TEST_CASE("attributes: many in a stream, of scalars in groups, without places, all missing") {
  Random random(kSeed + 1);
  for (const PlainMesh& mesh : some_meshes(random))
    for (int round = 0; round < 6 * multiplier(); ++round) {
      std::vector<Attribute> list;
      for (std::size_t n = 1 + random() % 9; n > 0; --n)
        list.push_back(random_attribute(mesh, static_cast<Site>(random() % 3),
                                        static_cast<NumberType>(random() % 2 * (random() % 9)),
                                        random() % 3 == 0 ? 2 : 1, random() % 5 == 0, random));
      EncodeOptions options;
      options.method = Method::valence;
      options.places = static_cast<coding::Places>(round % 3);
      options.tolerance = 0.01;
      check_round_trip(mesh, list, options);
    }
  const PlainMesh mesh = torus_grid(4, 5);
  for (std::size_t site = 0; site < kSites; ++site) {
    Attribute none = blank(mesh, "", static_cast<Site>(site), NumberType::f32, 2);
    none.missing.assign(none.places(), true);
    check_round_trip(mesh, {none}, {});
  }
}

TEST_CASE("attributes: a chart's seam costs its corners, a constant nothing, a smooth one little") {
  const PlainMesh mesh = torus_grid(60, 60);
  const EncodeOptions options{.method = Method::valence, .places = coding::Places::none};
  const auto bytes = [&](const Attribute& a) {
    return check_round_trip(mesh, {a}, options).info.sizes.attributes;
  };
  // Texture coordinates that jump where the torus closes.
  Attribute chart = blank(mesh, "TCoords", Site::corners, NumberType::f64, 2);
  Attribute smooth = blank(mesh, "height", Site::vertices, NumberType::f64, 1);
  for (std::size_t f = 0; f < mesh.faces.size(); ++f)
    for (std::size_t k = 0; k < 3; ++k) {
      const auto v = mesh.faces[f][k];
      const std::size_t i = f / 2 / 60, j = f / 2 % 60;
      const auto u = v / 60 < i ? 60u : v / 60, w = v % 60 < j ? 60u : v % 60;
      chart.words[3 * f + k] = std::bit_cast<std::uint64_t>(u / 64.0);
      chart.words[chart.places() + 3 * f + k] = std::bit_cast<std::uint64_t>(w / 64.0);
      smooth.words[v] = std::bit_cast<std::uint64_t>(std::sin(v / 60 * M_PI / 30));
    }
  CHECK(bytes(blank(mesh, "zero", Site::corners, NumberType::u64, 3)) < 60);
  CHECK(bytes(blank(mesh, "zero", Site::faces, NumberType::f32, 1)) < 40);
  CHECK(bytes(chart) < 3600);       // 3600 vertices, a chart of two coordinates
  CHECK(bytes(smooth) < 3 * 3600);  // of 60 values of 8 bytes
}

TEST_CASE("attributes: those that are not what they say are refused by name") {
  const PlainMesh mesh = torus_grid(3, 4);
  const auto refused = [&](const std::function<void(Attribute&)>& edit) {
    Attribute a = blank(mesh, "heat", Site::vertices, NumberType::u8, 2);
    edit(a);
    try {
      coding::encode(mesh.vertices(), mesh.faces, mesh.points, {}, std::vector{a});
    } catch (const kernel::InputError& error) {
      return std::string(error.what()).find("attribute 'heat'") != std::string::npos;
    }
    return false;
  };
  CHECK_FALSE(refused([](Attribute&) {}));
  CHECK(refused([](Attribute& a) { a.words.pop_back(); }));
  CHECK(refused([](Attribute& a) { a.components = 0; }));
  CHECK(refused([](Attribute& a) { a.words[3] = 256; }));
  CHECK(refused([](Attribute& a) { a.missing.assign(5, false); }));
  CHECK(refused([](Attribute& a) { a.missing.assign(12, true), a.words[1] = 7; }));
  CHECK(refused([](Attribute& a) {
    a.type = NumberType::f32;
    a.words[0] = std::bit_cast<std::uint64_t>(0.1);
  }));
}

TEST_CASE("attributes: few bytes that stand for many numbers are refused before room is made") {
  const PlainMesh mesh = torus_grid(20, 20);
  Attribute wide = blank(mesh, "wide", Site::corners, NumberType::u8, 1000);
  const std::vector list = {blank(mesh, "thin", Site::vertices, NumberType::u8, 2), wide};
  const auto stream = coding::encode(mesh.vertices(), mesh.faces, mesh.points, {}, list).stream;
  const std::size_t numbers = 2 * mesh.points.size() + wide.words.size();
  CHECK(numbers > 200 * stream.size());
  CHECK(coding::decode(stream, {.numbers = numbers}).attributes.size() == 2);
  const auto refused = [&](std::size_t limit) {
    try {
      coding::decode(stream, {.numbers = limit});
    } catch (const kernel::InputError& error) {
      return std::string(error.what()).find("more numbers than are allowed") != std::string::npos;
    }
    return false;
  };
  for (const std::size_t limit : {numbers - 1, wide.words.size(), std::size_t{0}})
    CHECK(refused(limit));
}

TEST_CASE("attributes: sections with more components or longer names than may be are refused") {
  const PlainMesh triangle = {{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}}};
  const coding::Surface surface(3, triangle.faces);
  const auto problem = [&](const Attribute& a) -> std::string {
    try {
      coding::decode_attributes(coding::encode_attributes(surface, std::vector{a}), surface,
                                1000000);
    } catch (const coding::StreamError& error) {
      return error.what();
    }
    return "";
  };
  const auto of_components = [&](std::uint32_t n) {
    return blank(triangle, "a", Site::faces, NumberType::u8, n);
  };
  const auto of_length = [&](std::size_t n) {
    return blank(triangle, std::string(n, 'a'), Site::faces, NumberType::u8, 1);
  };
  CHECK(problem(of_components(65535)) == "");
  CHECK(problem(of_length(65535)) == "");
  for (const Attribute& a : {of_components(65536), of_length(65536)})
    CHECK(problem(a).find("more than 65535") != std::string::npos);
  CHECK_THROWS_AS(coding::decode_attributes({}, surface, 1000000), coding::StreamError);
}

}  // namespace
}  // namespace crest::tests
