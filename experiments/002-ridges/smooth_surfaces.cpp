// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/002-ridges/smooth_surfaces.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <random>

namespace crest::experiments {
namespace {

constexpr std::array<double, 6> cube(double half) {
  return {-half, half, -half, half, -half, half};
}

SmoothSurface implicit(const std::string& name, const std::string& f,
                       const std::array<double, 6>& box) {
  return {name, {f}, box, {}, {}};
}

SmoothSurface height_field(const std::string& name, const std::string& z,
                           const std::array<std::string, 4>& domain) {
  return {name, {"u", "v", z}, {}, domain, {false, false}};
}

SmoothSurface doubly_periodic(const std::string& name, const std::vector<std::string>& xyz) {
  return {name, xyz, {}, {"0", "2*pi", "0", "2*pi"}, {true, true}};
}

/// Semi-axes between 0.7 and 2, no two closer than 15 %: three digits, so that the text is exact.
std::vector<SmoothSurface> random_ellipsoids(int count) {
  std::mt19937_64 random(2004);
  // Not std::uniform_real_distribution: its numbers depend on the library.
  const auto number = [&] { return 0.7 + 0.001 * static_cast<double>(random() % 1301); };
  std::vector<SmoothSurface> all;
  while (all.size() < static_cast<std::size_t>(count)) {
    std::array<double, 3> axes = {number(), number(), number()};
    std::sort(axes.begin(), axes.end());
    if (axes[1] > 1.15 * axes[0] && axes[2] > 1.15 * axes[1])
      all.push_back(ellipsoid(axes[0], axes[1], axes[2]));
  }
  return all;
}

// The torus of tube 0.45 (twice as high) around the unit circle, bent by z -> z + 0.2 x y + 0.1 x^2
// + 0.15 y and stretched by y -> 1.3 y: polynomial with polynomial inverse, so both forms are
// exact.
SmoothSurface bent_torus_implicit() {
  const std::string y = "(y/1.3)";
  const std::string z = "(z-0.2*x*" + y + "-0.1*x^2-0.15*" + y + ")";
  const std::string f = "(x^2+" + y + "^2+" + z + "^2/4+0.7975)^2-4*(x^2+" + y + "^2)";
  return implicit("bent torus, implicit", f, cube(3));
}
SmoothSurface bent_torus_parametric() {
  const std::string x = "((1+0.45*cos(v))*cos(u))", y = "((1+0.45*cos(v))*sin(u))";
  return doubly_periodic(
      "bent torus, parametric",
      {x, "1.3*" + y, "0.9*sin(v)+0.2*" + x + "*" + y + "+0.1*" + x + "^2+0.15*" + y});
}

// Two sheets over an ellipse without two disks.
SmoothSurface genus_2() {
  return implicit("genus 2",
                  "(z-0.15*x*y)^2-0.3*(1-x^2/4-y^2/1.5)*((x-0.9)^2+(y-0.1)^2-0.15)*"
                  "((x+1)^2+(y+0.05)^2-0.12)",
                  {-3, 3, -2, 2, -2, 2});
}

SmoothSurface biquartic() {
  return height_field(
      "bi-quartic patch",
      "116*u^4*v^4-200*u^4*v^3+108*u^4*v^2-24*u^4*v-312*u^3*v^4+592*u^3*v^3-360*u^3*v^2+80*u^3*v+"
      "252*u^2*v^4-504*u^2*v^3+324*u^2*v^2-72*u^2*v-56*u*v^4+112*u*v^3-72*u*v^2+16*u*v",
      {"0", "1", "0", "1"});
}

}  // namespace

SmoothSurface ellipsoid(double a, double b, double c) {
  return implicit(fmt::format("ellipsoid {:.4g}, {:.4g}, {:.4g}", a, b, c),
                  fmt::format("(x/{:.4g})^2+(y/{:.4g})^2+(z/{:.4g})^2-1", a, b, c),
                  cube(1.5 * std::max({a, b, c})));
}

SmoothSurface blend(double sharpness) {
  const std::string s = fmt::format("{:.4g}", sharpness);
  return implicit("blend, exponent -" + s,
                  "1-exp(-" + s + "*((x/0.15)^2+(y/0.25)^2+(z/0.35)^2-1))-exp(-" + s +
                      "*(((x-0.25)/0.1)^2+((y-0.1)/0.2)^2+((z-0.1)/0.3)^2-1))",
                  cube(1));
}

std::vector<SmoothSurface> generic_surfaces() {
  std::vector<SmoothSurface> all = {ellipsoid(1, 1.5, 2), ellipsoid(1, 1.2, 1.7)};
  for (SmoothSurface& e : random_ellipsoids(5)) all.push_back(std::move(e));
  all.push_back(blend(0.7));
  all.push_back(implicit("perturbed quartic",
                         "x^2+0.6*y^2+0.4*z^2+0.1*(x^4+y^4+z^4)+0.1*(x*y^2+0.7*y*z^2-0.4*z*x^2)-1",
                         cube(3)));
  all.push_back(bent_torus_implicit());
  all.push_back(bent_torus_parametric());
  all.push_back(genus_2());
  all.push_back(biquartic());
  all.push_back(height_field("3-ridge umbilic",
                             "0.5*(u^2+v^2)+0.5*(u^3-3*u*v^2)+0.1*u^2*v+0.3*u^4-0.2*u^3*v+0.1*v^4",
                             {"-0.3", "0.3", "-0.3", "0.3"}));
  return all;
}

std::vector<SmoothSurface> degenerate_surfaces() {
  return {
      implicit("sphere", "x^2+y^2+z^2-1", cube(2)),
      doubly_periodic("torus of revolution", {"(2+cos(v))*cos(u)", "(2+cos(v))*sin(u)", "sin(v)"}),
      implicit("ellipsoid of revolution 1, 1, 2", "x^2+y^2+z^2/4-1", cube(3)),
      implicit("cylinder in a box", "x^2+y^2-1", cube(2)),
      implicit("cone in a box", "x^2+y^2-z^2", cube(1)),
      implicit("two cones, closed (singular point)", "x^2+y^2-z^2*(1-z^2)", cube(2)),
      implicit("wave without bounds", "z-0.1*sin(3*x)*cos(2*y)", cube(1)),
      implicit("empty", "x^2+y^2+z^2+1", cube(1)),
      // On the mirror line u = 0 the fourth derivative is 24 (1 + 2 v), and P1 = 0 at v = 0: a
      // second blue ridge crosses the first one there.
      height_field("two blue ridges cross", "u^2+0.5*v^2+u^4*(1+2*v)",
                   {"-0.11", "0.12", "-0.13", "0.1"}),
      height_field("monkey saddle", "u^3-3*u*v^2", {"-0.5", "0.5", "-0.5", "0.5"})};
}

std::vector<SmoothSurface> reported_surfaces() {
  const auto beside_tiny = [](const std::string& squared) {
    return implicit(
        "beside one of squared size " + squared,
        "(x^2+y^2/2.25+z^2/4-1)*((x-2.4)^2+(y-0.3)^2/1.69+(z-0.2)^2/2.9-" + squared + ")", cube(3));
  };
  const std::string r = "(0.7+0.1*cos(u))";
  return {implicit("near", "x^2+y^2/1.002001+z^2/1.004004-1", cube(2)),
          implicit("sincos", "x^2+y^2+1.2*z^2+0.3*sin(2*x+1)*cos(y)-1.5", cube(3)),
          implicit("sqrt", "sqrt(1+x^2)+sqrt(1+2*y^2)+sqrt(1+0.5*z^2+0.2*x*z)-4", cube(4)),
          implicit("quartic", "x^4+2*y^4+1.5*z^4+0.3*x*y*z+x^2+0.7*y^2+1.2*z^2-1", cube(2)),
          implicit("wobble", "x^2+1.3*y^2+1.7*z^2-1+0.15*sin(3*x)*sin(2*y)*z", cube(2)),
          doubly_periodic("torusA", {"(2+0.7*cos(v))*cos(u)", "(2+0.7*cos(v))*sin(u)*1.1",
                                     "0.7*sin(v)+0.2*sin(2*u)"}),
          doubly_periodic("torusB", {"(2+" + r + "*cos(v))*cos(u)", "(2+" + r + "*cos(v))*sin(u)",
                                     r + "*sin(v)+0.15*cos(3*u)"}),
          height_field("patchE", "0.4*u^2+0.6*v^2+0.2*exp(u*v)-0.1*sin(3*u)",
                       {"-0.9", "1.1", "-1", "0.8"}),
          beside_tiny("1e-4"),
          beside_tiny("1e-6")};
}

std::vector<SmoothSurface> growing_surfaces() {
  std::vector<SmoothSurface> all;
  for (const double e : {0.5, 0.2, 0.1, 0.05}) all.push_back(ellipsoid(1, 1 + e, 1 + 2 * e));
  for (const double s : {0.7, 1.5, 3.0}) all.push_back(blend(s));
  return all;
}

}  // namespace crest::experiments
