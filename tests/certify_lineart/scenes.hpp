// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Scenes for claim 15.
#include <algorithm>
#include <set>

#include "certify/lineart/records.hpp"
#include "tests/support/random.hpp"

namespace crest::tests {

using certify::LineArtCertificate;

inline void look(LineArtCertificate& c, std::array<double, 3> eye, bool parallel,
                 std::array<double, 3> up = {0, 1, 0}) {
  c.eye = eye;
  c.parallel = parallel;
  if (parallel)
    c.view = {{{{0, 0, 0}, up, {0, 0, 0}}}, {0, 0}, {1, 1}};
  else
    c.view = {{{{1, 0, 0}, {0, 1, 0}, {0, 0, -1}}}, {0.5, -0.25}, {64, 64}};
}

/// Points with whole coordinates, without those no face uses.
inline LineArtCertificate scene(const std::vector<std::array<double, 3>>& points,
                                const std::vector<std::array<std::uint32_t, 3>>& faces) {
  LineArtCertificate c;
  c.points = points;
  c.faces = faces;
  return c;
}

/// Triangles without any order: they cross and share corners and edges, three at an edge too.
inline LineArtCertificate random_soup(Random& random, bool parallel, std::int64_t range) {
  LineArtCertificate c;
  const auto number = [&] {
    return static_cast<double>(
        static_cast<std::int64_t>(random() % static_cast<std::uint64_t>(2 * range + 1)) - range);
  };
  std::set<std::array<double, 3>> places;
  const std::size_t count = 6 + random() % 6;
  while (places.size() < count) places.insert({number(), number(), number()});
  const std::vector<std::array<double, 3>> pool(places.begin(), places.end());
  std::vector<std::uint32_t> name(pool.size(), 0xffffffffu);
  const auto vertex = [&](std::size_t i) {
    if (name[i] == 0xffffffffu) {
      name[i] = static_cast<std::uint32_t>(c.points.size());
      c.points.push_back(pool[i]);
    }
    return name[i];
  };
  const std::size_t faces = 3 + random() % 7;
  while (c.faces.size() < faces) {
    const std::size_t p = random() % count, q = random() % count, r = random() % count;
    if (p == q || q == r || r == p) continue;
    c.faces.push_back({vertex(p), vertex(q), vertex(r)});
  }
  const auto& [p, q, r] = c.faces[random() % faces];
  c.creases = {{std::min(p, q), std::max(p, q)}};
  const auto far = static_cast<double>(3 * range);
  look(c, {number(), number() + 0.5, parallel ? number() + 0.25 : far}, parallel);
  return c;
}

}  // namespace crest::tests
