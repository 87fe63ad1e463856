// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/ridges/drawn_lines.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>

using namespace crest;

namespace {

const kernel::TriangleMesh& square() {
  static const kernel::TriangleMesh mesh({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}},
                                         {{0, 1, 2}, {0, 2, 3}});
  return mesh;
}

/// A ridge through the points, level 2 on all of them.
ridges::Ridge ridge_of(const std::vector<kernel::Vec3>& points, ridges::EndKind first,
                       ridges::EndKind last) {
  ridges::Ridge ridge{};
  ridge.ends[0].kind = first;
  ridge.ends[1].kind = last;
  for (const kernel::Vec3& p : points) {
    ridges::Crossing c{};
    c.point = p;
    c.type = kernel::RidgeType::elliptic;
    c.level = 2;
    ridge.crossings.push_back(c);
  }
  return ridge;
}

/// In a graph of two umbilics, the first of which is shown; others: more of its ridges.
std::vector<io::LinePoint> drawn(const ridges::Ridge& ridge, double spur,
                                 const std::vector<ridges::Ridge>& others = {}) {
  const std::vector<kernel::Vec3> normals(4, {0, 0, 1});
  ridges::RidgeGraph graph;
  graph.umbilics.resize(2);
  graph.umbilics[0].region_twice_index = 1;
  graph.ridges = {ridge};
  graph.ridges.insert(graph.ridges.end(), others.begin(), others.end());
  return io::drawn_lines(square(), normals, graph, spur, 2).front();
}

std::ptrdiff_t pruned(const std::vector<io::LinePoint>& line) {
  return std::count_if(line.begin(), line.end(), [](const auto& p) { return p.spur; });
}

constexpr auto kCut = ridges::EndKind::cut, kBoundary = ridges::EndKind::boundary;

}  // namespace

TEST_CASE("drawn lines: a zigzag is smoothed in the tangent plane, the ends stay") {
  std::vector<kernel::Vec3> zigzag;
  for (int i = 0; i <= 40; ++i) zigzag.push_back({double(i), i % 2 == 0 ? 0.4 : -0.4, 0.1 * i});
  const auto line = drawn(ridge_of(zigzag, kCut, kCut), 0);
  REQUIRE(line.size() == 41);
  CHECK(line.front().point == zigzag.front());
  CHECK(line.back().point == zigzag.back());
  for (std::size_t i = 0; i < 41; ++i) CHECK(line[i].point[2] == Approx(0.1 * double(i)));
  for (std::size_t i = 15; i < 26; ++i) CHECK(std::fabs(line[i].point[1]) < 0.05);
  CHECK(pruned(line) == 0);
}

TEST_CASE("drawn lines: a short piece that turns off at a cut end is pruned") {
  std::vector<kernel::Vec3> hook;
  for (int i = 8; i > 0; --i) hook.push_back({0, double(i), 0});
  for (int i = 0; i <= 60; ++i) hook.push_back({double(i), 0, 0});
  const auto line = drawn(ridge_of(hook, kCut, kCut), 15);
  CHECK(pruned(line) >= 6);
  CHECK(!line[20].spur);
  CHECK(!line.back().spur);
  // What is longer than a spur, or ends at something, stays.
  CHECK(pruned(drawn(ridge_of(hook, kCut, kCut), 3)) == 0);
  CHECK(pruned(drawn(ridge_of(hook, kBoundary, kCut), 15)) == 0);
  // So does what ends at an umbilic that is shown, or at which another ridge of the colour ends.
  ridges::Ridge at_umbilic = ridge_of(hook, ridges::EndKind::umbilic, kCut);
  at_umbilic.ends[0].umbilic = 0;
  CHECK(pruned(drawn(at_umbilic, 15)) == 0);
  at_umbilic.ends[0].umbilic = 1;
  CHECK(pruned(drawn(at_umbilic, 15)) == pruned(line));
  CHECK(pruned(drawn(at_umbilic, 15, {at_umbilic})) == 0);
  std::reverse(hook.begin(), hook.end());
  CHECK(pruned(drawn(ridge_of(hook, kBoundary, kCut), 15)) == pruned(line));
}

TEST_CASE("drawn lines: a loop smaller than a spur is left out") {
  std::vector<kernel::Vec3> ring;
  for (int i = 0; i < 12; ++i) ring.push_back({2 * std::cos(0.5 * i), 2 * std::sin(0.5 * i), 0});
  ridges::Ridge loop = ridge_of(ring, ridges::EndKind::none, ridges::EndKind::none);
  loop.loop = true;
  CHECK(pruned(drawn(loop, 6)) == 12);
  CHECK(pruned(drawn(loop, 5)) == 0);
  CHECK(pruned(drawn(ridge_of(ring, kBoundary, kBoundary), 6)) == 0);
}

TEST_CASE("drawn lines: a loop without a cut end has no spur, a run inside a ridge has cut ends") {
  std::vector<kernel::Vec3> square_loop;
  for (int i = 0; i < 10; ++i) square_loop.push_back({double(i), 0, 0});
  for (int i = 0; i < 10; ++i) square_loop.push_back({10, double(i), 0});
  for (int i = 10; i > 0; --i) square_loop.push_back({double(i), 10, 0});
  for (int i = 10; i > 0; --i) square_loop.push_back({0, double(i), 0});
  ridges::Ridge loop = ridge_of(square_loop, ridges::EndKind::none, ridges::EndKind::none);
  loop.loop = true;
  CHECK(pruned(drawn(loop, 8)) == 0);
  for (std::size_t i = 4; i < 24; ++i) loop.crossings[i].level = 1;
  const auto line = drawn(loop, 8);
  CHECK(line.size() == square_loop.size());
  CHECK(line.front().level == 1);  // it begins where it is thin
  CHECK(pruned(line) > 0);         // the corner's short side
}
