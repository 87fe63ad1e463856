// SPDX-License-Identifier: GPL-3.0-or-later
// Faces tested eight at a time get what they get alone: proven, failing in every way, undefined.
#include <catch2/catch.hpp>
#include <cstring>
#include <map>

#include "algorithms/smooth_ridges/face_test.hpp"
#include "algorithms/smooth_ridges/initial_mesh.hpp"

namespace crest::smooth_ridges {
namespace {

bool same(const ColourResult& a, const ColourResult& b) {
  return a.no_zero == b.no_zero && a.monotone == b.monotone && a.crossed == b.crossed &&
         a.edge_decided == b.edge_decided && a.at == b.at && a.type == b.type &&
         a.loose_corner == b.loose_corner && a.slope == b.slope;
}
bool same(const FaceResult& a, const FaceResult& b) {
  for (std::size_t k = 0; k < 3; ++k)
    if (a.image[k].low != b.image[k].low || a.image[k].high != b.image[k].high) return false;
  const bool alike = a.status == b.status && a.purple == b.purple;
  if (a.status != FaceStatus::proven) return alike;
  return alike && a.frame == b.frame && a.w == b.w && same(a.colour[0], b.colour[0]) &&
         same(a.colour[1], b.colour[1]);
}

/// By status, how many faces of four rounds of refinement there were.
std::map<FaceStatus, int> compare(const Surface& surface) {
  Triangulation mesh = initial_mesh(surface, 300, {}, {});
  FaceTest test(surface);
  std::map<FaceStatus, int> seen;
  for (int round = 0; round < 4; ++round) {
    std::vector<std::array<Vertex, 3>> faces;
    std::vector<Index> failed;
    for (Index f = 0; f < mesh.faces().size(); ++f) faces.push_back(mesh.corners(f));
    std::vector<FaceResult> results(faces.size());
    test(faces, results);
    int different = 0;
    for (Index f = 0; f < faces.size(); ++f) {
      different += same(test(faces[f]), results[f]) ? 0 : 1;
      ++seen[results[f].status];
      if (results[f].status != FaceStatus::proven) failed.push_back(f);
    }
    CHECK(different == 0);
    mesh.refine(failed);
  }
  return seen;
}

TEST_CASE("Faces tested together get what each gets alone") {
  const auto ellipsoid = compare(Surface::implicit("x^2+y^2/2.25+z^2/4-1", {-3, 3, -3, 3, -3, 3}));
  CHECK(ellipsoid.at(FaceStatus::proven) > 300);
  CHECK(ellipsoid.at(FaceStatus::ridge) > 100);
  CHECK(ellipsoid.at(FaceStatus::regular) > 30);
  compare(Surface::implicit("sqrt(1+x^2)+sqrt(1+2*y^2)+sqrt(1+0.5*z^2+0.2*x*z)-4",
                            {-4, 4, -4, 4, -4, 4}));
  compare(Surface::parametric(
      {"(2+0.7*cos(v))*cos(u)", "(2+0.7*cos(v))*sin(u)*1.1", "0.7*sin(v)+0.2*sin(2*u)"},
      {"0", "2*pi", "0", "2*pi"}, {true, true}));
  compare(Surface::parametric({"u", "v", "0.4*u^2+0.6*v^2+0.2*exp(u*v)-0.1*sin(3*u)"},
                              {"-0.9", "1.1", "-1", "0.8"}, {false, false}));
}

TEST_CASE("Faces where the expression is not defined do not change what others get") {
  // The root ends at u = 0, where some faces are.
  const auto seen = compare(Surface::parametric({"u", "v", "u*sqrt(u+v^2*0)+0.3*v^2+0.1*u*v^2"},
                                                {"0", "1", "0", "1"}, {false, false}));
  CHECK(seen.size() >= 2);
}

}  // namespace
}  // namespace crest::smooth_ridges
