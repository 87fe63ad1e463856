// SPDX-License-Identifier: GPL-3.0-or-later
// Faces through one another against CGAL's exact intersections; pieces that coincide on the page.
#include "algorithms/line_art/sheets.hpp"

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/intersections.h>

#include <catch2/catch.hpp>

#include "algorithms/line_art/chains.hpp"
#include "tests/line_art/scenes.hpp"

using namespace crest;
using namespace crest::line_art;
using namespace crest::tests;

namespace {

using Exact = CGAL::Exact_predicates_exact_constructions_kernel;

Exact::Triangle_3 triangle(const Scene& scene, Index f) {
  const auto corner = [&](std::size_t k) {
    const Vec3& p = scene.points[scene.faces[f][k]];
    return Exact::Point_3(p[0], p[1], p[2]);
  };
  return {corner(0), corner(1), corner(2)};
}

/// By what the intersection is: a vertex or edge in common is none.
bool meet(const Scene& scene, Index f, Index g) {
  const auto common = CGAL::intersection(triangle(scene, f), triangle(scene, g));
  if (!common) return false;
  std::size_t shared = 0;
  for (const Index v : scene.faces[f])
    for (const Index w : scene.faces[g]) shared += v == w;
  // What has a common vertex meets there, what has two along the edge.
  const bool point = boost::get<Exact::Point_3>(&*common) != nullptr;
  const bool segment = boost::get<Exact::Segment_3>(&*common) != nullptr;
  return !(shared == 1 && point) && !(shared == 2 && segment);
}

std::optional<std::pair<Index, Index>> first_pair(const Scene& scene) {
  const auto faces = static_cast<Index>(scene.faces.size());
  std::vector<bool> flat;
  for (Index f = 0; f < faces; ++f) flat.push_back(triangle(scene, f).is_degenerate());
  for (Index f = 0; f < faces; ++f) {
    if (flat[f]) return std::pair{f, f};
    for (Index g = f + 1; g < faces; ++g)
      if (!flat[g] && meet(scene, f, g)) return std::pair{f, g};
  }
  return std::nullopt;
}

/// Ink of the contours, and the length of what is visible.
DrawnContours inked(const Scene& scene, const Vec3& eye, bool perspective) {
  ViewRequest request;
  request.towards = eye;
  if (perspective) request.eye = eye;
  const View view = make_view(request, scene);
  return draw_contours(scene, view, find_contours(scene, view, {std::nullopt}));
}

double length_of(const DrawnContours& drawn) {
  double sum = 0;
  for (const Stroke& s : drawn.strokes) sum += s.length();
  return sum;
}

}  // namespace

TEST_CASE("Faces that go through one another are found, and no others") {
  std::size_t with = 0, without = 0;
  for (const Scene& scene : hard_scenes()) {
    const auto found = meeting_faces(scene);
    CHECK(found == first_pair(scene));
    ++(found ? with : without);
  }
  // Few faces at small places: both answers occur, sides and corners touch.
  Draw d(11);
  for (int k = 0; k < static_cast<int>(400 * multiplier()); ++k) {
    Builder soup;
    for (int i = 0; i < 6; ++i) soup.points.push_back(draw_vector(d, Family::small_integers));
    for (int i = 0; i < 2; ++i) {
      const auto v = [&] { return static_cast<Index>(d.integer(0, 5)); };
      soup.faces.push_back({v(), v(), v()});
    }
    bool kept = false;
    for (const Triangle& f : soup.faces)
      kept = kept ||
             (soup.points[f[0]] != soup.points[f[1]] && soup.points[f[1]] != soup.points[f[2]] &&
              soup.points[f[2]] != soup.points[f[0]]);
    if (!kept) continue;
    const Scene scene = soup.scene();
    const auto found = meeting_faces(scene);
    CHECK(found == first_pair(scene));
    ++(found ? with : without);
  }
  CHECK(with > 50);
  CHECK(without > 50);
}

TEST_CASE("Pieces that coincide on the page are inked once") {
  // A box along the line of sight: its lid's and its floor's sides lie over one another.
  Builder box;
  box.box({0, 0, 0}, {2, 1, 3});
  const DrawnContours along = inked(box.scene(), {0, 0, 1}, false);
  // The page is 160 mm wide with margins of 3 %: the box is 150.4 by 75.2.
  CHECK(along.visible_length == Approx(2 * (150.4 + 75.2)).epsilon(1e-9));
  CHECK(length_of(along) < 1.01 * along.visible_length);

  // Two squares seen along x = 0: the nearer one's side covers the middle of the farther one's.
  Builder squares;
  squares.quad({0, 0, 0}, {4, 0, 0}, {4, 4, 0}, {0, 4, 0});
  squares.quad({-2, 1, 1}, {0, 1, 1}, {0, 3, 1}, {-2, 3, 1});
  const DrawnContours side = inked(squares.scene(), {0, 0, 1}, false);
  const double unit = 150.4 / 6;
  CHECK(side.visible_length == Approx((16 + 8 - 2) * unit).epsilon(1e-9));

  // The same through an eye, at half the distance and half the size.
  Builder rays;
  rays.quad({0, 0, 0}, {4, 0, 0}, {4, 4, 0}, {0, 4, 0});
  rays.quad({-1, 0.5, 4}, {0, 0.5, 4}, {0, 1.5, 4}, {-1, 1.5, 4});
  const DrawnContours through = inked(rays.scene(), {0, 0, 8}, true);
  CHECK(through.visible_length == Approx((16 + 8 - 2) * unit).epsilon(1e-9));
}
