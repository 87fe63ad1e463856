// SPDX-License-Identifier: GPL-3.0-or-later
// Claim 15: holes that readers found in its first statement, with their numbers.
#include <catch2/catch.hpp>
#include <numeric>

#include "certify/lineart/contours.hpp"
#include "certify/lineart/encode.hpp"
#include "certify/verify.hpp"
#include "tests/certify_lineart/scenes.hpp"

using namespace crest::certify;
using namespace crest::tests;
using crest::kernel::Rational;

namespace {

/// The claims as the checker finds them: for views whose ties no other program here breaks.
LineArtCertificate with_found_claims(LineArtCertificate c) {
  const Contours contours(c);
  c.edges.clear();
  for (const SceneEdge& edge : contours.drawn()) {
    const FoundEdge found = contours.find(edge);
    LineEdge line{edge.low, edge.high, {}, found.pieces};
    for (const LineBreak& at : found.breaks) line.breaks.push_back(at.events);
    c.edges.push_back(line);
  }
  return c;
}

const LineEdge* edge_of(const LineArtCertificate& c, std::uint32_t low, std::uint32_t high) {
  for (const LineEdge& edge : c.edges)
    if (edge.low == low && edge.high == high) return &edge;
  return nullptr;
}

/// Top z = 1 over -2 <= x <= 0, wall x = 0, floor z = 0 over 0 <= x <= 2; mirrored if s = -1.
LineArtCertificate step(double s) {
  const std::vector<std::array<double, 3>> points = {{-2 * s, -1, 1}, {0, -1, 1}, {0, 1, 1},
                                                     {-2 * s, 1, 1},  {0, -1, 0}, {2 * s, -1, 0},
                                                     {2 * s, 1, 0},   {0, 1, 0}};
  LineArtCertificate c =
      scene(points, {{0, 1, 2}, {0, 2, 3}, {1, 4, 7}, {1, 7, 2}, {4, 5, 6}, {4, 6, 7}});
  look(c, {0, 0, 1}, true);
  return c;
}

TEST_CASE("refereed: the rim of a wall seen edge-on is drawn, whichever way the wall faces") {
  for (const double s : {1.0, -1.0}) {
    const LineArtCertificate c = with_found_claims(step(s));
    CHECK(verify(encode(c)).accepted);
    // The upper end of the wall: 1-2, visible all along.
    const LineEdge* upper = edge_of(c, 1, 2);
    REQUIRE(upper);
    for (const LinePiece& piece : upper->pieces) CHECK(piece.hiding == 0);
    // Without it: rejected.
    LineArtCertificate without = c;
    std::erase_if(without.edges, [](const LineEdge& e) { return e.low == 1 && e.high == 2; });
    CHECK_FALSE(verify(encode(without)).accepted);
    // Page: X = up x e = (1, 0, 0), Y = (0, 1, 0). A hatch across the jump of the depth.
    LineArtCertificate across = c;
    across.hatches = {{{-1 * s, 0.3}, {1 * s, 0.25}}};
    across.hatch_faces = {s > 0 ? 1u : 1u};
    CHECK_FALSE(verify(encode(across)).accepted);
    LineArtCertificate beside = c;
    beside.hatches = {{{-1.5 * s, -0.3}, {-0.5 * s, -0.25}}};
    for (const std::uint32_t f : {0u, 1u, 4u}) {
      beside.hatch_faces = {f};
      CHECK(verify(encode(beside)).accepted == (f == 1));
    }
  }
}

/// Calls work(names) for all orders of five points.
template <class Work>
void all_numberings(Work&& work) {
  std::array<std::uint32_t, 5> names = {0, 1, 2, 3, 4};
  do {
    work(names);
  } while (std::next_permutation(names.begin(), names.end()));
}

/// a, b in the plane of the face p q r; point i gets the number names[i]. A far face holds a and b.
LineArtCertificate contact(const std::array<std::uint32_t, 5>& names, std::array<double, 3> eye) {
  const std::array<std::array<double, 3>, 5> at = {
      {{2, 3, 0}, {8, 3, 0}, {-20, -20, 0}, {40, -20, 0}, {0, 40, 0}}};
  LineArtCertificate c;
  c.points.resize(6);
  for (std::size_t i = 0; i < 5; ++i) c.points[names[i]] = at[i];
  c.points[5] = {5, 3, 7};
  c.faces = {{names[2], names[3], names[4]}, {names[0], names[1], 5}};
  look(c, eye, true);
  return c;
}

TEST_CASE("refereed: a place in a plane is the limit of one perturbation for all points") {
  std::size_t parted = 0;
  all_numberings([&](const auto& names) {
    const LineArtCertificate c = contact(names, {1, 2, 3});
    const Orientation o(c);
    const EdgeEnds edge = {id_of(names[0]), id_of(names[1])};
    const PointId p = id_of(names[2]), q = id_of(names[3]), r = id_of(names[4]);
    CHECK(o.plain_sign(p, q, r, edge.a) == crest::kernel::Sign::zero);
    if (o.sign(p, q, r, edge.a) == o.sign(p, q, r, edge.b)) return;
    ++parted;
    // The first movers are coordinates of single points: of a, of b, or of a corner, when both
    // ends' coefficients are areas and the ratio is that of the lines.
    const Rational t = o.limit(p, q, r, edge);
    CHECK((t >= 0 && t <= 1));
    if (names == std::array<std::uint32_t, 5>{0, 2, 1, 3, 4}) CHECK(t == 1);  // a < p < b < q < r
  });
  CHECK(parted > 0);
}

TEST_CASE("refereed: an edge that rests on a face is drawn for every numbering") {
  std::size_t hidden_by_perturbation = 0;
  all_numberings([&](const auto& names) {
    const LineArtCertificate c = with_found_claims(contact(names, {1, 2, 3}));
    const LineEdge* edge = edge_of(c, std::min(names[0], names[1]), std::max(names[0], names[1]));
    REQUIRE(edge);
    std::uint32_t front = 0;
    for (const LinePiece& piece : edge->pieces) {
      CHECK(piece.hiding == 0);
      front = std::max(front, piece.front);
    }
    hidden_by_perturbation += front > 0;
    CHECK(verify(encode(c)).accepted);
  });
  CHECK(hidden_by_perturbation == 72);
}

TEST_CASE("refereed: a hatch through a self-intersection is continuous, and no more is said") {
  LineArtCertificate c = scene({{-2, -2, -2},
                                {2, -2, 2},
                                {2, 2, 2},
                                {-2, 2, -2},
                                {-2, -2, 2},
                                {2, -2, -2},
                                {2, 2, -2},
                                {-2, 2, 2}},
                               {{0, 1, 2}, {0, 2, 3}, {4, 5, 6}, {4, 6, 7}});
  look(c, {0, 0, 1}, true);
  c = with_found_claims(c);
  // From a point off both diagonals.
  c.hatches = {{{-0.5, 0.25}, {0.5, 0.25}}};
  c.hatch_faces = {3};
  const Verdict verdict = verify(encode(c));
  INFO(verdict.reason);
  REQUIRE(verdict.accepted);
  for (const std::string& line : verdict.lines) CHECK(line.find("sheet") == std::string::npos);
}

TEST_CASE("refereed: a hatch through the joint of two contours crosses them") {
  // A triangle with the corner (1, 1) between two of its sides, over a large face far below.
  LineArtCertificate c =
      scene({{0, 0, 5}, {1, 1, 5}, {2, 0, 5}, {-40, -40, 0}, {40, -40, 0}, {0, 40, 0}},
            {{0, 1, 2}, {3, 4, 5}});
  look(c, {0, 0, 1}, true);
  c = with_found_claims(c);
  // Page y is -Y: (1, 0.5) to (1, 2) in the scene's plane.
  c.hatches = {{{1, -0.5}, {1, -2}}};
  c.hatch_faces = {0};
  CHECK_FALSE(verify(encode(c)).accepted);
  c.hatches = {{{1, -0.5}, {1, -0.75}}};
  CHECK(verify(encode(c)).accepted);
  c.hatches = {{{1, -0.5}, {1, -1}}};  // ends at the joint
  CHECK(verify(encode(c)).accepted);
  c.hatches = {{{1, -0.5}, {1, -1}, {1.25, -0.5}}};  // touches it on its way
  CHECK_FALSE(verify(encode(c)).accepted);
}

TEST_CASE("refereed: points of one sight line are one point of the page") {
  // X and Y are exact for a direction whose orthonormal frame in doubles is not.
  LineArtCertificate c = scene({{0, 0, 0}, {6, 0, 0}, {0, 7, 0}}, {{0, 1, 2}});
  look(c, {2, 1, 3}, true);
  c = with_found_claims(c);
  const Verdict verdict = verify(encode(c));
  CHECK(verdict.accepted);
  bool for_the_scene = false;
  for (const std::string& line : verdict.lines)
    for_the_scene = for_the_scene || line.find("not needed") != std::string::npos;
  CHECK(for_the_scene);
  // X = up x e = (3, 0, -2): corner 1 is at page x = 18, corner 0 at 0; both on the same page y 0
  // and Y = e x X = (-2, 13, -3): a hatch along the side itself meets it.
  c.hatches = {{{0, 0}, {18, 12}}};
  c.hatch_faces = {0};
  CHECK_FALSE(verify(encode(c)).accepted);
}

TEST_CASE("refereed: a sight line that grazes a side all along needs the perturbation") {
  // Edge 0-1 lies under the edge 3-4, which no face ends at.
  LineArtCertificate c =
      scene({{0, 0, 0},
             {1, 0, 0},
             {.5, .2, 0},
             {-1, 0, 1},
             {2, 0, 1},
             {0, 10, 1.25},
             {.125, -10, 1.5},
             {-10, .5, 1.75},
             {10, .75, 2}},
            {{0, 1, 2}, {3, 4, 5}, {4, 3, 6}, {3, 5, 7}, {3, 7, 6}, {4, 6, 8}, {4, 8, 5}});
  look(c, {0, 0, 1}, true);
  c = with_found_claims(c);
  const Verdict verdict = verify(encode(c));
  INFO(verdict.reason);
  REQUIRE(verdict.accepted);
  for (const std::string& line : verdict.lines) CHECK(line.find("not needed") == std::string::npos);
}

TEST_CASE("line art: stacked cubes with a common face, seen along an axis, are certified") {
  const auto box = [](double z) {
    std::vector<std::array<double, 3>> p;
    for (int i = 0; i < 8; ++i)
      p.push_back({i & 1 ? 1.0 : 0.0, i & 2 ? 1.0 : 0.0, z + (i & 4 ? 1.0 : 0.0)});
    return p;
  };
  const std::vector<std::array<std::uint32_t, 3>> sides = {
      {0, 2, 1}, {1, 2, 3}, {4, 5, 6}, {5, 7, 6}, {0, 1, 4}, {1, 5, 4},
      {2, 6, 3}, {3, 6, 7}, {0, 4, 2}, {2, 4, 6}, {1, 3, 5}, {3, 7, 5}};
  // The second stands on the first: four vertices and a face of two triangles in common.
  std::vector<std::array<double, 3>> points = box(0);
  for (int i = 4; i < 8; ++i) points.push_back(box(1)[static_cast<std::size_t>(i)]);
  std::vector<std::array<std::uint32_t, 3>> faces = sides;
  for (auto face : sides) {
    for (auto& v : face) v += 4;
    faces.push_back(face);
  }
  for (const auto& eye : std::vector<std::array<double, 3>>{
           {0, 0, 1}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}, {0, 1, -1}, {1, 1, 1}}) {
    LineArtCertificate c = scene(points, faces);
    look(c, eye, true, {0.25, 1, 0.5});
    c = with_found_claims(c);
    CHECK(c.edges.size() >= 4);
    CHECK(verify(encode(c)).accepted);
  }
}

}  // namespace
