// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/ridges/drawn_lines.hpp"

#include <algorithm>
#include <array>

namespace crest::io {
namespace {

using kernel::dot;
using kernel::Vec3;
using kernel::operator+;
using kernel::operator-;
using kernel::operator*;

/// The part of a vector in the tangent plane at the crossing.
Vec3 tangential(const kernel::TriangleMesh& mesh, const std::vector<Vec3>& normals,
                const ridges::Crossing& crossing, const Vec3& v) {
  const kernel::Edge& e = mesh.edges()[crossing.edge];
  const Vec3 n = normals[e.v0] + normals[e.v1];
  const double squared = dot(n, n);
  return squared > 0 ? v - (dot(v, n) / squared) * n : v;
}

void smooth(const kernel::TriangleMesh& mesh, const std::vector<Vec3>& normals, bool loop,
            std::vector<LinePoint>& line) {
  constexpr int kSteps = 32;
  const std::size_t n = line.size();
  const std::vector<LinePoint> given = line;
  for (int step = 0; step < kSteps; ++step) {
    const std::vector<LinePoint> old = line;
    for (std::size_t i = 0; i < n; ++i) {
      if (old[i].crossing == nullptr || (!loop && (i == 0 || i + 1 == n))) continue;
      const Vec3 mean = 0.5 * (old[(i + n - 1) % n].point + old[(i + 1) % n].point);
      const Vec3 moved = 0.5 * (old[i].point + mean);
      line[i].point =
          given[i].point + tangential(mesh, normals, *given[i].crossing, moved - given[i].point);
    }
  }
}

/// How many points at the run's first end are a spur; at(i), i < count, is the run from that end.
template <class At>
std::size_t spur_points(std::size_t count, const At& at, double spur) {
  std::vector<double> length(count, 0.0);
  for (std::size_t i = 1; i < count; ++i)
    length[i] = length[i - 1] + kernel::distance(at(i - 1), at(i));
  std::size_t points = 0;
  for (std::size_t i = 1, j = 1; i < count && length[i] <= spur; ++i) {
    while (j < count && length[j] < length[i] + spur) ++j;
    if (j == count) break;
    const Vec3 before = at(i) - at(0), after = at(j) - at(i);
    if (dot(before, after) < 0.5 * kernel::norm(before) * kernel::norm(after)) points = i;
  }
  return points;
}

/// How many ridges of each colour end at each umbilic.
using UmbilicEnds = std::vector<std::array<int, 2>>;

UmbilicEnds umbilic_ends(const ridges::RidgeGraph& graph) {
  UmbilicEnds ends(graph.umbilics.size());
  for (const ridges::Ridge& ridge : graph.ridges)
    for (const ridges::RidgeEnd& end : ridge.ends)
      if (end.kind == ridges::EndKind::umbilic)
        ++ends[end.umbilic][ridge.colour == kernel::Colour::blue];
  return ends;
}

/// Whether the picture leaves a ridge's end open.
bool is_open(const ridges::RidgeGraph& graph, const UmbilicEnds& ends, kernel::Colour colour,
             const ridges::RidgeEnd& end) {
  if (end.kind != ridges::EndKind::umbilic) return end.kind == ridges::EndKind::cut;
  return graph.umbilics[end.umbilic].region_twice_index == 0 &&
         ends[end.umbilic][colour == kernel::Colour::blue] == 1;
}

/// Whether all of the line is within `spur`, measured by the box around it.
bool within(const std::vector<LinePoint>& line, double spur) {
  Vec3 low = line.front().point, high = low;
  for (const LinePoint& p : line)
    for (std::size_t k = 0; k < 3; ++k) {
      low[k] = std::min(low[k], p.point[k]);
      high[k] = std::max(high[k], p.point[k]);
    }
  return kernel::distance(low, high) < spur;
}

void prune(const ridges::Ridge& ridge, const bool (&open)[2], double spur, int level,
           std::vector<LinePoint>& line) {
  const auto lesser = [&](const LinePoint& p) { return p.spur || p.level < level; };
  const auto first = std::find_if(line.begin(), line.end(), lesser);
  if (ridge.loop && first == line.end()) return;
  if (ridge.loop) std::rotate(line.begin(), first, line.end());
  const std::size_t n = line.size();
  for (std::size_t i = 0; i < n; ++i) {
    std::size_t end = i;
    while (end < n && !lesser(line[end])) ++end;
    const std::size_t count = end - i;
    if (count < 2) continue;
    std::size_t front = 0, back = 0;
    if (i > 0 || ridge.loop || open[0])
      front = spur_points(
          count, [&](std::size_t k) { return line[i + k].point; }, spur);
    if (end < n || ridge.loop || open[1])
      back = spur_points(
          count, [&](std::size_t k) { return line[end - 1 - k].point; }, spur);
    for (std::size_t k = 0; k < front; ++k) line[i + k].spur = true;
    for (std::size_t k = 0; k < back; ++k) line[end - 1 - k].spur = true;
    i = end;
  }
}

}  // namespace

std::vector<std::vector<LinePoint>> drawn_lines(const kernel::TriangleMesh& mesh,
                                                const std::vector<Vec3>& normals,
                                                const ridges::RidgeGraph& graph, double spur,
                                                int full_level) {
  const UmbilicEnds ends = umbilic_ends(graph);
  std::vector<std::vector<LinePoint>> lines;
  for (const ridges::Ridge& ridge : graph.ridges) {
    std::vector<LinePoint>& line = lines.emplace_back(line_points(ridge));
    const bool open[2] = {is_open(graph, ends, ridge.colour, ridge.ends[0]),
                          is_open(graph, ends, ridge.colour, ridge.ends[1])};
    if (ridge.loop && within(line, spur))
      for (LinePoint& p : line) p.spur = true;
    smooth(mesh, normals, ridge.loop, line);
    for (const int level : {1, full_level}) prune(ridge, open, spur, level, line);
  }
  return lines;
}

}  // namespace crest::io
