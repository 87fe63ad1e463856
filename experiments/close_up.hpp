// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Close-ups of a mesh with its edges, as SVG: a ball seen along its mean normal.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <vector>

#include "algorithms/curvature/curvature.hpp"
#include "io/write/atomic_file.hpp"

namespace crest::experiments {

using kernel::Index;
using kernel::Vec3;

struct CloseUpLine {
  Vec3 from, to, normal;  ///< drawn if the normal faces the eye
  std::string colour;
  double width = 3;  ///< pixels
};

/// What is drawn over the triangles. colours: one a vertex, empty for none.
struct CloseUp {
  Vec3 centre{};
  double radius = 1;
  double reach = 1.5;  ///< radii within which triangles are drawn
  Vec3 towards{};      ///< the eye; zero: the mean normal of the ball
  std::vector<std::string> dots = {};
  std::vector<CloseUpLine> lines = {};
};

namespace close_up_detail {

using kernel::cross, kernel::dot, kernel::norm;
using kernel::operator+, kernel::operator-, kernel::operator*;

/// The centre is in the middle of a square of kSide pixels.
struct Eye {
  static constexpr double kSide = 420;
  Vec3 right, up, towards, centre;
  double scale;

  Eye(const kernel::TriangleMesh& mesh, const std::vector<Vec3>& normals, const CloseUp& c)
      : towards{}, centre(c.centre), scale(0.5 * kSide / c.radius) {
    if (dot(c.towards, c.towards) > 0) towards = c.towards;
    for (Index v = 0; v < mesh.vertex_count() && dot(c.towards, c.towards) == 0; ++v) {
      const Vec3 d = mesh.points()[v] - centre;
      if (dot(d, d) <= c.radius * c.radius) towards = towards + normals[v];
    }
    const double length = norm(towards);
    towards = length > 0 ? (1 / length * towards) : Vec3{0, 0, 1};
    const Vec3 above = std::abs(towards[1]) < 0.9 ? Vec3{0, 1, 0} : Vec3{1, 0, 0};
    up = above - dot(above, towards) * towards;
    up = 1 / norm(up) * up;
    right = cross(up, towards);
  }
  std::array<double, 2> at(const Vec3& p) const {
    const Vec3 d = p - centre;
    return {0.5 * kSide + scale * dot(right, d), 0.5 * kSide - scale * dot(up, d)};
  }
  double depth(const Vec3& p) const { return dot(p - centre, towards); }
};

}  // namespace close_up_detail

/// Writes .svg. Triangles whose corners are within reach and that face the eye, far ones first.
/// Throws: kernel::InputError (write_atomically).
inline void write_close_up(const std::string& path, const kernel::TriangleMesh& mesh,
                           const CloseUp& c) {
  using namespace close_up_detail;
  const std::vector<Vec3> normals = curvature::area_weighted_normals(mesh);
  const Eye eye(mesh, normals, c);
  const auto& p = mesh.points();
  const auto inside = [&](Index v) {
    const Vec3 d = p[v] - c.centre;
    return dot(d, d) <= c.reach * c.reach * c.radius * c.radius;
  };
  std::string svg = fmt::format(
      "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{0}\" height=\"{0}\" viewBox=\"0 0 {0} "
      "{0}\">\n<rect width=\"{0}\" height=\"{0}\" fill=\"#fff\"/>\n<g stroke=\"#999\" "
      "stroke-width=\"0.6\" stroke-linejoin=\"round\">\n",
      Eye::kSide);
  std::vector<std::pair<double, Index>> order;
  for (Index f = 0; f < mesh.face_count(); ++f) {
    const auto& t = mesh.faces()[f];
    if (!inside(t[0]) || !inside(t[1]) || !inside(t[2])) continue;
    order.emplace_back(eye.depth(p[t[0]]) + eye.depth(p[t[1]]) + eye.depth(p[t[2]]), f);
  }
  std::sort(order.begin(), order.end());
  for (const auto& [depth, f] : order) {
    const auto& t = mesh.faces()[f];
    const auto a = eye.at(p[t[0]]), b = eye.at(p[t[1]]), d = eye.at(p[t[2]]);
    // Counter-clockwise faces face the eye; pixels' y points down.
    if ((b[0] - a[0]) * (d[1] - a[1]) - (b[1] - a[1]) * (d[0] - a[0]) >= 0) continue;
    Vec3 n = normals[t[0]] + normals[t[1]] + normals[t[2]];
    const double facing = std::max(0.0, dot(n, eye.towards) / 3);
    svg += fmt::format(
        "<path d=\"M{:.1f} {:.1f}L{:.1f} {:.1f}L{:.1f} {:.1f}Z\" fill=\"#{:02x}{:02x}{:02x}\"/>\n",
        a[0], a[1], b[0], b[1], d[0], d[1], static_cast<int>(150 + 95 * facing),
        static_cast<int>(150 + 95 * facing), static_cast<int>(155 + 95 * facing));
  }
  svg += "</g>\n<g stroke-linecap=\"round\">\n";
  for (const CloseUpLine& line : c.lines) {
    const Vec3 d = line.from - c.centre;
    if (dot(line.normal, eye.towards) < 0 || dot(d, d) > c.reach * c.reach * c.radius * c.radius)
      continue;
    const auto a = eye.at(line.from), b = eye.at(line.to);
    svg += fmt::format(
        "<path d=\"M{:.1f} {:.1f}L{:.1f} {:.1f}\" stroke=\"{}\" stroke-width=\"{}\"/>\n", a[0],
        a[1], b[0], b[1], line.colour, line.width);
  }
  svg += "</g>\n";
  for (Index v = 0; v < c.dots.size(); ++v) {
    if (c.dots[v].empty() || !inside(v) || dot(normals[v], eye.towards) < 0) continue;
    const auto a = eye.at(p[v]);
    svg += fmt::format("<circle cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"4\" fill=\"{}\"/>\n", a[0], a[1],
                       c.dots[v]);
  }
  io::write_atomically(path, svg + "</svg>\n");
}

}  // namespace crest::experiments
