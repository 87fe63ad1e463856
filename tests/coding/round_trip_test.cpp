// SPDX-License-Identifier: GPL-3.0-or-later
// Streams decode to the mesh they were made from: real meshes, random ones, every option.
#include <array>
#include <bit>
#include <catch2/catch.hpp>
#include <cmath>

#include "algorithms/coding/positions.hpp"
#include "algorithms/coding/verify.hpp"
#include "kernel/geometry/input_error.hpp"
#include "tests/coding/shared_meshes.hpp"
#include "tests/coding/stream_digests.hpp"

namespace crest::tests {
namespace {

using coding::EncodeOptions;
using coding::Method;
using coding::Places;

constexpr std::array<Method, 4> kMethods = {Method::valence, Method::fan, Method::zigzag,
                                            Method::fixed};

void check_round_trip(const PlainMesh& mesh, const EncodeOptions& options) {
  const auto encoded = coding::encode(mesh.vertices(), mesh.faces, mesh.points, options);
  CHECK_NOTHROW(coding::verify(encoded, mesh.faces, mesh.points, options));
  CHECK(encoded.info.sizes.total() == encoded.stream.size());
  CHECK(encoded.info.sizes.header <= 64);
}

TEST_CASE("round trip: every oriented manifold of the shared data, every method") {
  for (const std::string& name : kSharedMeshes) {
    const auto path = shared_data("meshes/" + name);
    if (!path) return;
    INFO(name);
    const PlainMesh mesh = read_plain(*path);
    for (const Method method : kMethods)
      check_round_trip(mesh, {.method = method, .places = Places::none});
    check_round_trip(mesh, {.method = Method::fixed});
    check_round_trip(
        mesh,
        {.method = Method::fan, .places = Places::rounded, .tolerance = 0.003, .keep_order = true});
  }
}

TEST_CASE("round trip: random surfaces of genus 0 to 5 with holes") {
  Random random(kSeed);
  for (int i = 0; i < 12 * multiplier(); ++i) {
    const auto genus = static_cast<kernel::Index>(i % 6);
    PlainMesh mesh = genus == 0 ? stacked_sphere(300, random)
                                : joined_tori(genus, 5 + static_cast<kernel::Index>(random() % 5),
                                              5 + static_cast<kernel::Index>(random() % 9));
    flip_edges(mesh, random() % 2000, random);
    mesh = punch_holes(mesh, random() % 5, random);
    INFO("genus " << genus << ", " << mesh.faces.size() << " faces");
    for (const Method method : kMethods) {
      check_round_trip(mesh, {.method = method});
      check_round_trip(mesh, {.method = method, .places = Places::none, .keep_order = true});
    }
  }
}

TEST_CASE("vertices have one order, whatever is coded with the connectivity") {
  Random random(kSeed);
  PlainMesh mesh = joined_tori(2, 6, 7);
  flip_edges(mesh, 300, random);
  for (const Method method : kMethods) {
    const auto decoded = [&](const EncodeOptions& options) {
      return coding::decode(
          coding::encode(mesh.vertices(), mesh.faces, mesh.points, options).stream);
    };
    const auto bare = decoded({.method = method, .places = Places::none});
    CHECK(bare.faces == decoded({.method = method}).faces);
    CHECK(bare.faces ==
          decoded({.method = method, .places = Places::rounded, .tolerance = 0.1}).faces);
    CHECK(bare.points.empty());
  }
}

TEST_CASE("exact places: every kind of double comes back bit for bit") {
  Random random(kSeed);
  PlainMesh mesh = torus_grid(12, 17);
  const auto fill = [&](auto&& number) {
    for (auto& p : mesh.points)
      for (double& x : p) x = number();
    check_round_trip(mesh, {.method = Method::valence});
  };
  fill([&] { return static_cast<double>(random() % 1000) / 1000; });
  fill([&] {
    return static_cast<double>(static_cast<float>(static_cast<double>(random() % 1000000) / 1e5));
  });
  fill([&] {
    return static_cast<double>(std::ldexp(static_cast<float>(random() % 0xffffff), -30));
  });
  fill([&] { return random() % 2 == 0 ? 0.0 : -0.0; });
  fill([&] { return random() % 300 == 0 ? -0.0 : static_cast<double>(random() % 10); });
  fill([&] { return random() % 9 == 0 ? 0x1p-1074 : -0x1.fffffffffffffp+1023; });
  fill([&] {
    for (;;)
      if (const double x = std::bit_cast<double>(random()); std::isfinite(x)) return x;
  });
}

TEST_CASE("tolerance: halves of steps, an ulp beside, the least tolerance of a step") {
  Random random(kSeed);
  PlainMesh mesh = torus_grid(11, 13);
  for (int i = 0; i < 40 * multiplier(); ++i) {
    const double step = std::ldexp(static_cast<double>((1u << 19) + random() % (1u << 19)),
                                   -25 - static_cast<int>(random() % 20));
    double tolerance = step * std::sqrt(0.75);
    while (coding::step_within(tolerance) < step) tolerance = std::nextafter(tolerance, HUGE_VAL);
    while (coding::step_within(std::nextafter(tolerance, 0)) >= step)
      tolerance = std::nextafter(tolerance, 0);
    CHECK(coding::step_within(tolerance) == step);
    for (auto& p : mesh.points)
      for (double& x : p) {
        x = (static_cast<double>(random() % 2001) - 1000.5) * step;
        if (const auto side = random() % 3; side > 0)
          x = std::nextafter(x, side == 1 ? HUGE_VAL : -HUGE_VAL);
      }
    check_round_trip(
        mesh, {.method = Method::valence, .places = Places::rounded, .tolerance = tolerance});
  }
  const auto encode = [&](double tolerance) {
    return coding::encode(mesh.vertices(), mesh.faces, mesh.points,
                          {.places = Places::rounded, .tolerance = tolerance});
  };
  CHECK_THROWS_AS(encode(0x1p-1060), kernel::InputError);
  mesh.points[5][1] = 1e300;
  CHECK_THROWS_WITH(encode(1e-3),
                    Catch::Contains("vertex 5") && Catch::Contains("larger tolerance"));
}

TEST_CASE("what is no oriented manifold is refused with its element") {
  const auto refused = [](kernel::Index vertices, std::vector<kernel::Triangle> faces) {
    try {
      coding::encode(vertices, faces, {}, {.places = Places::none});
    } catch (const kernel::InputError& error) {
      return std::string(error.what());
    }
    return std::string();
  };
  // Two tetrahedra that share a vertex.
  CHECK(refused(7, {{0, 1, 2},
                    {0, 2, 3},
                    {0, 3, 1},
                    {1, 3, 2},
                    {0, 4, 5},
                    {0, 5, 6},
                    {0, 6, 4},
                    {4, 6, 5}}) != "");
  // An annulus pinched to one vertex.
  CHECK(refused(6, {{0, 1, 2}, {1, 3, 2}, {0, 4, 5}, {3, 1, 4}, {4, 1, 5}}) != "");
  CHECK(refused(3, {{0, 1, 2}, {0, 2, 1}}) != "");
  CHECK(refused(4, {{0, 1, 2}, {0, 1, 3}}) != "");
  CHECK(refused(4, {{0, 1, 2}}) != "");
  CHECK(refused(3, {{0, 1, 1}}) != "");
  CHECK(refused(3, {{0, 1, 3}}) != "");
  CHECK(refused(0, {}) != "");
}

TEST_CASE("the bytes of streams are those of every compiler, and of the first version") {
  int count = 0;
  CHECK(digest_of_streams(count) == "39fb9bc956e07e84");
  CHECK(count == 88);
}

}  // namespace
}  // namespace crest::tests
