// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Surfaces with known topology.
#include <string>
#include <vector>

#include "algorithms/smooth_ridges/surface.hpp"

namespace crest::smooth_ridges {

struct Sample {
  std::string name;
  Surface surface;
  int euler_characteristic;
  std::size_t components;
};

inline std::vector<Sample> closed_samples() {
  return {
      {"ellipsoid", Surface::implicit("x^2 + y^2/2.25 + z^2/4 - 1", {-3, 3, -3, 3, -3, 3}), 2, 1},
      {"torus",
       Surface::implicit("(x^2+y^2+z^2+0.84)^2 - 4*(x^2+y^2) + 0.05*x*y*z", {-2, 2, -2, 2, -2, 2}),
       0, 1},
      {"genus 2", Surface::implicit("(x*(x-1)^2*(x-2)+y^2)^2 + z^2 - 0.01", {-1, 3, -2, 2, -1, 1}),
       -2, 1},
      {"two spheres",
       Surface::implicit("(x^2+y^2+z^2-0.25) * ((x-1.5)^2+y^2+z^2-0.16)", {-3, 3, -3, 3, -3, 3}), 4,
       2},
  };
}

inline Surface parametric_torus() {
  return Surface::parametric({"(1+0.4*cos(v))*cos(u)", "(1+0.4*cos(v))*sin(u)", "0.4*sin(v)"},
                             {"0", "2*pi", "-pi", "pi"}, {true, true});
}
inline Surface parametric_tube() {
  return Surface::parametric({"cos(u)", "sin(u)", "v"}, {"0", "2*pi", "0", "10"}, {true, false});
}
inline Surface parametric_patch() {
  return Surface::parametric({"u", "v", "u^2*v + u*v^3"}, {"-1", "1", "0", "1/3"}, {false, false});
}

}  // namespace crest::smooth_ridges
