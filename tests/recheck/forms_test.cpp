// SPDX-License-Identifier: GPL-3.0-or-later
// E_j, A and the counting of branches where the answer is known.
#include <catch2/catch.hpp>

#include "certify/second/rays.hpp"

namespace {

using namespace crest::recheck;

double number(const Model& m) {
  return m.range().middle();
}

Certificate parametric(const std::string& x, const std::string& y, const std::string& z) {
  Certificate c{};
  c.implicit = false;
  c.texts = {x, y, z, "-1", "1", "-1", "1"};
  return c;
}

/// E at u = v = 0 along e1, with jets of degree 1, in unit coordinates (half the size).
Jet2<Model> at_origin(const std::string& x, const std::string& y, const std::string& z,
                      std::size_t j) {
  const Surface surface(parametric(x, y, z));
  const Forms<Model> f = surface.forms(Model(0.5), Model(0.5));
  const auto v = directions(f.i, operator_of(f), {32, 0});
  return extremality(f, v[j]);
}

}  // namespace

TEST_CASE("recheck: at the origin of a Monge form E1 is b0, E2 is b3, up to positive factors") {
  const Scope scope(1);
  const std::string monge = "0.5*(2*u^2+v^2)+(0.3*u^3-0.9*u^2*v+0.6*u*v^2-0.7*v^3)/6";
  CHECK(at_origin("u", "v", monge, 0)[0].sign() == 1);
  CHECK(at_origin("u", "v", monge, 1)[0].sign() == -1);
  // The general forms and the height field's agree up to a positive factor: u + 0 * v^2 is not
  // affine.
  for (const std::size_t j : {0U, 1U}) {
    const Jet2<Model> height = at_origin("u", "v", monge, j),
                      general = at_origin("u+0*v^2", "v", monge, j);
    const double factor = number(general[0]) / number(height[0]);
    CHECK(factor > 0);
  }
}

TEST_CASE("recheck: E vanishes on the symmetry planes of an ellipsoid's graph") {
  const Scope scope(0);
  // z = 1 - sqrt(1 - u^2/4 - v^2/9): k1 along u; u = 0 and v = 0 are planes of symmetry.
  const Surface surface(parametric("u", "v", "1-sqrt(1-u^2/4-v^2/9)"));
  const Forms<Model> f = surface.forms(Model(0.5), Model(0.7));
  const auto v = directions(f.i, operator_of(f), {32, 0});
  CHECK(extremality(f, v[0])[0].sign() == 0);
  CHECK(extremality(f, v[1])[0].sign() != 0);
  const Forms<Model> g = surface.forms(Model(0.6), Model(0.7));
  CHECK(extremality(g, directions(g.i, operator_of(g), {32, 0})[0])[0].sign() != 0);
}

TEST_CASE("recheck: the implicit function has the derivatives of the graph") {
  const Scope scope(1);
  Certificate c{};
  c.implicit = true;
  c.texts = {"z-0.5*(2*x^2+y^2)-x*y^2+0.25*(z-0.5*(2*x^2+y^2)-x*y^2)^3"};
  const Surface surface(c);
  const Frame frame = {{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}}, 1};
  const Jet3<Model> f = surface.expand<Model>({0.0, 0.0, 0.0}, frame, 4);
  const Forms<Model> forms = surface.forms(f, 1);
  CHECK(number(forms.l[0][0]) == Approx(2));
  CHECK(number(forms.l[2][0]) == Approx(1));
  CHECK(number(forms.t[2][0]) == Approx(3 * 2));
  CHECK(number(forms.t[0][0]) == Approx(0));
  CHECK_THROWS_AS(surface.forms(f, -1), Open);
}

TEST_CASE("recheck: branches are counted from the signs once around") {
  const auto count = [](const std::vector<RayInterval>& around) { return count_branches(around); };
  // One change of sign in a run, and the frame turns once.
  CHECK(count({{true, 1, 1}, {false, -1, 1}, {true, -1, -1}}) == 1);
  // The same from another start.
  CHECK(count({{false, -1, 1}, {true, -1, -1}, {true, 1, 1}}) == 1);
  CHECK(count({{true, 1, 1},
               {false, -1, 1},
               {true, -1, 1},
               {false, 1, 1},
               {true, 1, 1},
               {false, -1, 1},
               {true, -1, -1}}) == 3);
  // A run without a branch.
  CHECK(count({{true, 1, 1}, {false, 1, 1}, {true, 1, 1}, {false, -1, 1}, {true, -1, -1}}) == 1);
  const std::vector<std::vector<RayInterval>> wrong = {
      {},
      {{false, 1, -1}},                               // nothing free
      {{true, 1, 1}, {false, -1, 1}, {true, -1, 1}},  // the frame does not turn
      {{true, 1, 1}, {true, -1, -1}},                 // a sign that changes without a run
      {{true, 1, 1}, {false, 1, 1}, {true, -1, -1}},  // a run against the signs
      {{true, 1, 1}, {false, -1, 1}, {false, 1, 1}, {true, -1, -1}}};  // a run of two signs
  for (const auto& around : wrong) CHECK_THROWS_AS(count(around), Rejected);
}
