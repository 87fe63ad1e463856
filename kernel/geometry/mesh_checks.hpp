// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// What meshes require of points and faces, and how their errors name elements.
#include <algorithm>
#include <cmath>
#include <string>

#include "kernel/arithmetic/vec3.hpp"
#include "kernel/geometry/index.hpp"
#include "kernel/geometry/input_error.hpp"

namespace crest::kernel {

inline std::string name(const char* what, Index i) {
  return std::string(what) + " " + std::to_string(i);
}
inline std::string edge_name(Index v, Index w) {
  return "edge " + std::to_string(v) + "-" + std::to_string(w);
}

inline void require_finite(Index v, const Vec3& point) {
  for (const double x : point)
    if (!std::isfinite(x))
      throw InputError(name("vertex", v) +
                       ": a coordinate is not a finite number; remove the vertex and its faces");
}

inline void require_three_vertices(Index f, const Triangle& face, std::size_t vertex_count) {
  const auto [a, b, c] = face;
  if (std::max({a, b, c}) >= vertex_count)
    throw InputError(name("face", f) + ": a vertex number is out of range; repair the file");
  if (a == b || b == c || c == a)
    throw InputError(name("face", f) + ": it repeats a vertex; remove degenerate faces");
}

/// Requires: the two share two corners, so the third ones decide.
inline bool same_corners(const Triangle& s, const Triangle& t) {
  return (s[0] ^ s[1] ^ s[2]) == (t[0] ^ t[1] ^ t[2]);
}

}  // namespace crest::kernel
