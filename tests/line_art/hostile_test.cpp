// SPDX-License-Identifier: GPL-3.0-or-later
// Meshes nobody would draw: they are drawn all the same, or refused in one line.
#include <catch2/catch.hpp>
#include <limits>

#include "algorithms/line_art/certificate.hpp"
#include "certify/lineart/encode.hpp"
#include "certify/verify.hpp"
#include "io/line_art/drawing_writer.hpp"
#include "tests/line_art/drawn.hpp"

using namespace crest;
using namespace crest::line_art;
using namespace crest::tests;

namespace {

/// With hatches in both styles and fields; the certificate holds.
void check_drawn(const kernel::TriangleMesh& mesh, const Vec3& eye) {
  for (const HatchStyle style : {HatchStyle::fishbone, HatchStyle::streamlines})
    for (const bool cross : {false, true}) {
      HatchOptions options;
      options.style = style;
      options.cross_field = options.cross_hatch = cross;
      const Drawing drawing = draw(mesh, eye, options);
      CHECK(drawing.counts.over_contours == 0);
      CHECK(io::svg_of(drawing).find("nan") == std::string::npos);
      const auto verdict = certify::verify(certify::encode(line_art_record(drawing)));
      CHECK(verdict.reason == "");
    }
}

}  // namespace

TEST_CASE("One triangle is drawn, from its front, its back and its edge") {
  const kernel::TriangleMesh one({{0, 0, 0}, {3, 0, 0}, {0, 2, 0}}, {{0, 1, 2}});
  check_drawn(one, {0, 0, 1});
  check_drawn(one, {1, 2, -3});
  check_drawn(one, {1, 0, 0});
}

TEST_CASE("A plane seen edge-on is a line without hatches") {
  std::vector<Vec3> points;
  std::vector<Triangle> faces;
  for (Index j = 0; j < 5; ++j)
    for (Index i = 0; i < 5; ++i) points.push_back({i * 1.0, j * 1.0, 0});
  for (Index j = 0; j < 4; ++j)
    for (Index i = 0; i < 4; ++i) {
      const Index v = 5 * j + i;
      faces.insert(faces.end(), {{v, v + 1, v + 6}, {v, v + 6, v + 5}});
    }
  const kernel::TriangleMesh plane(points, faces);
  check_drawn(plane, {1, 0, 0});
  check_drawn(plane, {1, 1, 0});
  CHECK(draw(plane, {1, 0, 0}, {}).hatches.empty());
  CHECK(draw(plane, {0, 0, 1}, {}).hatches.size() > 20);
}

TEST_CASE("A face without an area is no bar to contours") {
  // A square with two points on its diagonal: one face lies on a line.
  const Scene flat = weld({{0, 0, 0}, {2, 0, 0}, {2, 2, 0}, {0, 2, 0}, {1, 1, 0}, {0.5, 0.5, 0}},
                          {{0, 1, 4}, {1, 2, 4}, {2, 3, 4}, {0, 4, 5}, {3, 0, 5}, {3, 5, 4}});
  CHECK(seen(flat, {0, 0, 1}, false).counts.visible == 4);
  CHECK(seen(flat, {1, 2, 3}, false).counts.visible == 4);
}

TEST_CASE("Contours of duplicate faces are those of one, inked once") {
  Scene once = step_scene(1);
  std::vector<Triangle> twice = once.faces;
  twice.insert(twice.end(), once.faces.begin(), once.faces.end());
  const Scene doubled = weld(once.points, twice);
  for (const Vec3& eye : {Vec3{0, 0, 1}, Vec3{1, 2, 3}, Vec3{0, 1, 0}}) {
    const Contours a = seen(once, eye, false), b = seen(doubled, eye, false);
    CHECK(a.edges.size() == b.edges.size());
    CHECK(a.pieces.size() == b.pieces.size());
    for (std::size_t k = 0; k < std::min(a.pieces.size(), b.pieces.size()); ++k) {
      CHECK(a.pieces[k].drawn() == b.pieces[k].drawn());
      CHECK(2 * a.pieces[k].in_front == b.pieces[k].in_front);
    }
  }
}

TEST_CASE("Coordinates that are no numbers, and no faces, are refused in one line") {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const double infinite = std::numeric_limits<double>::infinity();
  for (const double bad : {nan, infinite, -infinite})
    CHECK_THROWS_WITH(weld({{0, 0, 0}, {1, 0, bad}, {0, 1, 0}}, {{0, 1, 2}}),
                      Catch::StartsWith("vertex 1: a coordinate is not finite"));
  // Where no face needs it, it is no bar.
  CHECK(weld({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {nan, 0, 0}}, {{0, 1, 2}}).points.size() == 3);
  CHECK_THROWS_WITH(weld({}, {}), Catch::StartsWith("faces: none has three corners apart"));
  CHECK_THROWS_WITH(weld({{0, 0, 0}, {1, 0, 0}, {0, 0, 0}}, {{0, 1, 2}}),
                    Catch::StartsWith("faces: none has three corners apart"));
}
