// SPDX-License-Identifier: GPL-3.0-or-later
#include <catch2/catch.hpp>
#include <map>

#include "tests/ridges/ridge_cases.hpp"

using namespace crest;
using namespace crest::tests;
using kernel::Vec3;

namespace {

using Chord = std::array<std::array<double, 2>, 2>;

double side(const std::array<double, 2>& a, const std::array<double, 2>& b,
            const std::array<double, 2>& c) {
  return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
}
bool cross_properly(const Chord& s, const Chord& t) {
  const double tiny = 1e-12;
  return side(s[0], s[1], t[0]) * side(s[0], s[1], t[1]) < -tiny &&
         side(t[0], t[1], s[0]) * side(t[0], t[1], s[1]) < -tiny;
}

}  // namespace

TEST_CASE("lines drawn inside patches do not cross") {
  // In the plane, with Monge data that give many umbilics, crossings can be tested directly.
  RidgeCase c = exact_case("plane", {}, 400, false);
  std::size_t pairs = 0;
  for (std::uint64_t salt = 0; salt < scaled(20); ++salt) {
    c.forms = random_forms(c.forms.size(), Family::generic, 3000 + salt);
    const ridges::RidgeGraph g = ridges::extract_ridge_graph(c.mesh, c.forms);
    std::map<kernel::Index, std::vector<std::vector<Vec3>>> lines;  // by umbilic
    for (const ridges::Ridge& r : g.ridges) {
      if (r.ends[0].kind == ridges::EndKind::umbilic) {
        lines[r.ends[0].umbilic].push_back(r.lead_in);
        lines[r.ends[0].umbilic].back().push_back(r.crossings.front().point);
      }
      if (r.ends[1].kind == ridges::EndKind::umbilic) {
        lines[r.ends[1].umbilic].push_back({r.crossings.back().point});
        auto& line = lines[r.ends[1].umbilic].back();
        line.insert(line.end(), r.lead_out.begin(), r.lead_out.end());
      }
    }
    for (const auto& [umbilic, group] : lines)
      for (std::size_t i = 0; i < group.size(); ++i)
        for (std::size_t j = i + 1; j < group.size(); ++j)
          for (std::size_t a = 0; a + 1 < group[i].size(); ++a)
            for (std::size_t b = 0; b + 1 < group[j].size(); ++b) {
              ++pairs;
              auto flat = [](const Vec3& p) { return std::array<double, 2>{p[0], p[1]}; };
              REQUIRE(!cross_properly({flat(group[i][a]), flat(group[i][a + 1])},
                                      {flat(group[j][b]), flat(group[j][b + 1])}));
            }
  }
  CHECK(pairs > 1000);
}

TEST_CASE("filters drop what they say, and crest pieces are elliptic") {
  const RidgeCase c = fitted_case("blend", {}, 10000, true);
  const ridges::RidgeGraph all = ridges::extract_ridge_graph(c.mesh, c.forms);
  ridges::RidgeGraph g = all;
  CHECK(ridges::filter(g, {}).by_sharpness == 0);
  CHECK(g.ridges.size() == all.ridges.size());

  ridges::FilterOptions sharp;
  sharp.min_sharpness = 1;
  const auto report = ridges::filter(g, sharp);
  CHECK(g.ridges.size() + report.by_sharpness == all.ridges.size());
  for (const ridges::Ridge& r : g.ridges) CHECK(r.sharpness >= 1);

  g = all;
  ridges::FilterOptions crest;
  crest.crest_only = true;
  ridges::filter(g, crest);
  CHECK(!g.ridges.empty());
  for (const ridges::Ridge& r : g.ridges)
    for (const ridges::Crossing& x : r.crossings) {
      CHECK(x.type == ridges::RidgeType::elliptic);
      const bool blue = r.colour == ridges::Colour::blue;
      CHECK(std::max(std::fabs(x.k1), std::fabs(x.k2)) == std::fabs(blue ? x.k1 : x.k2));
    }
}

TEST_CASE("sharpness does not depend on the unit of length") {
  const sampling::SurfaceSample s = sampling::sample("blend", {}, 2500, true);
  auto sharpness = [&](double unit) {
    auto points = s.points;
    for (auto& p : points)
      for (double& x : p) x *= unit;
    const kernel::TriangleMesh mesh(points, s.faces);
    double sum = 0;
    for (const auto& r :
         ridges::extract_ridge_graph(mesh, ridges::fit_monge_forms(mesh, {}).forms).ridges)
      sum += r.sharpness;
    return sum;
  };
  CHECK(sharpness(1024) == Approx(sharpness(1)).epsilon(1e-6));
}
