// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Scenes that are hard on visibility: ties, contact, bodies through one another, soups.
#include <cmath>
#include <numbers>

#include "algorithms/line_art/contours.hpp"
#include "tests/support/degenerate_families.hpp"

namespace crest::tests {

using line_art::Index, line_art::Scene, line_art::Triangle;

inline line_art::Contours seen(const Scene& scene, const Vec3& eye, bool perspective) {
  line_art::ViewRequest request;
  request.towards = eye;
  if (perspective) request.eye = eye;
  if (std::abs(eye[0]) + std::abs(eye[2]) < 1e-6 * std::abs(eye[1])) request.up = {0, 0, 1};
  return line_art::find_contours(scene, line_art::make_view(request, scene), {std::nullopt});
}

struct Builder {
  std::vector<Vec3> points;
  std::vector<Triangle> faces;
  void quad(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
    const auto n = static_cast<Index>(points.size());
    points.insert(points.end(), {a, b, c, d});
    faces.insert(faces.end(), {{n, n + 1, n + 2}, {n, n + 2, n + 3}});
  }
  /// Without its lid: open.
  void box(const Vec3& l, const Vec3& h, bool lid = true) {
    const auto p = [&](int x, int y, int z) {
      return Vec3{x != 0 ? h[0] : l[0], y != 0 ? h[1] : l[1], z != 0 ? h[2] : l[2]};
    };
    quad(p(0, 0, 0), p(0, 1, 0), p(1, 1, 0), p(1, 0, 0));
    if (lid) quad(p(0, 0, 1), p(1, 0, 1), p(1, 1, 1), p(0, 1, 1));
    quad(p(0, 0, 0), p(1, 0, 0), p(1, 0, 1), p(0, 0, 1));
    quad(p(0, 1, 0), p(0, 1, 1), p(1, 1, 1), p(1, 1, 0));
    quad(p(0, 0, 0), p(0, 0, 1), p(0, 1, 1), p(0, 1, 0));
    quad(p(1, 0, 0), p(1, 1, 0), p(1, 1, 1), p(1, 0, 1));
  }
  Scene scene() const { return line_art::weld(points, faces); }
};

/// A surface over a grid of angles; u comes round, v too if `closed`, with a twist if `twisted`.
template <class Place>
Builder revolved(int m, int n, bool closed, Place&& place) {
  Builder b;
  for (int i = 0; i < m; ++i)
    for (int j = 0; j < n; ++j) {
      const auto at = [&](int u, int v) {
        return place(2 * std::numbers::pi * (u % m) / m,
                     closed ? 2 * std::numbers::pi * (v % n) / n : std::numbers::pi * v / n);
      };
      b.quad(at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1));
    }
  return b;
}

inline Scene sphere_scene(int bands, int around) {
  return revolved(around, bands, false,
                  [](double u, double v) {
                    // Poles and seams exactly where their neighbours have them.
                    const double s = v > 3.141 ? 0 : std::sin(v);
                    return Vec3{s * std::cos(u), s * std::sin(u), std::cos(v)};
                  })
      .scene();
}

/// Top z = 1 for x <= 0, wall x = 0, floor z = 0; mirrored by -1.
inline Scene step_scene(double side) {
  Builder b;
  b.quad({-2 * side, -1, 1}, {0, -1, 1}, {0, 1, 1}, {-2 * side, 1, 1});
  b.quad({0, -1, 1}, {0, -1, 0}, {0, 1, 0}, {0, 1, 1});
  b.quad({0, -1, 0}, {2 * side, -1, 0}, {2 * side, 1, 0}, {0, 1, 0});
  return b.scene();
}

inline std::vector<Scene> hard_scenes() {
  std::vector<Scene> scenes = {sphere_scene(8, 12), step_scene(1), step_scene(-1)};
  Builder stacked, through, open, sheets;
  stacked.box({0, 0, 0}, {1, 1, 1});
  stacked.box({0, 0, 1}, {1, 1, 2});
  stacked.box({1, 0, 0}, {2, 1, 1});
  through.box({0, 0, 0}, {3, 1, 1});
  through.box({1, -1, -1}, {2, 2, 0.5});
  open.box({0, 0, 0}, {2, 2, 1}, false);
  open.box({0.5, 0.5, 0.25}, {1, 1, 3});
  sheets.quad({-2, -2, -2}, {2, -2, 2}, {2, 2, 2}, {-2, 2, -2});
  sheets.quad({-2, -2, 2}, {2, -2, -2}, {2, 2, -2}, {-2, 2, 2});
  for (const Builder& b : {stacked, through, open, sheets}) scenes.push_back(b.scene());
  // A Klein bottle: a figure of eight, turned half round.
  scenes.push_back(revolved(16, 8, true, [](double u, double v) {
                     const double r =
                         2 + std::cos(u / 2) * std::sin(v) - std::sin(u / 2) * std::sin(2 * v);
                     const double z =
                         std::sin(u / 2) * std::sin(v) + std::cos(u / 2) * std::sin(2 * v);
                     return Vec3{r * std::cos(u), r * std::sin(u), z};
                   }).scene());
  // Two rings through one another.
  Builder rings = revolved(14, 8, true, [](double u, double v) {
    return Vec3{(3 + std::cos(v)) * std::cos(u), (3 + std::cos(v)) * std::sin(u), std::sin(v)};
  });
  const Builder other = revolved(14, 8, true, [](double u, double v) {
    return Vec3{3 + (3 + std::cos(v)) * std::cos(u), std::sin(v), (3 + std::cos(v)) * std::sin(u)};
  });
  const auto n = static_cast<Index>(rings.points.size());
  rings.points.insert(rings.points.end(), other.points.begin(), other.points.end());
  for (const Triangle& f : other.faces) rings.faces.push_back({f[0] + n, f[1] + n, f[2] + n});
  scenes.push_back(rings.scene());
  // Soups of small integers.
  Draw d(10);
  for (int k = 0; k < 30; ++k) {
    Builder soup;
    for (int i = 0; i < 8; ++i) soup.points.push_back(draw_vector(d, Family::small_integers));
    for (int i = 0; i < 10; ++i) {
      const auto v = [&] { return static_cast<Index>(d.integer(0, 7)); };
      soup.faces.push_back({v(), v(), v()});
    }
    try {
      scenes.push_back(soup.scene());
    } catch (const std::exception&) {  // no face has three corners apart
    }
  }
  return scenes;
}

}  // namespace crest::tests
