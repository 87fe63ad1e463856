// SPDX-License-Identifier: GPL-3.0-or-later
#include <tbb/blocked_range.h>

#include <algorithm>
#include <cmath>

#include "algorithms/extremal/components.hpp"
#include "algorithms/extremal/octree_mesh.hpp"
#include "kernel/geometry/input_error.hpp"
#include "kernel/geometry/parallel.hpp"

namespace crest::extremal {
namespace {

bool finite(const Vec3& v) {
  return std::isfinite(v[0]) && std::isfinite(v[1]) && std::isfinite(v[2]);
}

/// Points whose normals are not zero, with unit normals.
OrientedPoints checked(const OrientedPoints& given) {
  if (given.points.empty()) throw kernel::InputError("no points; give some");
  if (given.normals.size() != given.points.size())
    throw kernel::InputError("points without normals; estimate them first");
  OrientedPoints r;
  for (std::size_t i = 0; i < given.points.size(); ++i) {
    if (!finite(given.points[i]) || !finite(given.normals[i]))
      throw kernel::InputError("point " + std::to_string(i) +
                               ": a number that is not finite; remove it");
    const double length = kernel::norm(given.normals[i]);
    if (!(length > 0)) continue;
    r.points.push_back(given.points[i]);
    r.normals.push_back((1 / length) * given.normals[i]);
  }
  if (r.points.empty()) throw kernel::InputError("all normals are zero; estimate them first");
  return r;
}

/// The median distance to the 10th neighbour.
double default_radius(const std::vector<Vec3>& points) {
  if (points.size() < 11) throw kernel::InputError("fewer than 11 points; give --radius");
  std::vector<double> tenth(points.size());
  // Every so many points are enough for a median.
  const std::size_t step = std::max<std::size_t>(1, points.size() / 1000);
  std::vector<std::size_t> chosen;
  for (std::size_t i = 0; i < points.size(); i += step) chosen.push_back(i);
  kernel::parallel_for(tbb::blocked_range<std::size_t>(0, chosen.size()), [&](const auto& r) {
    std::vector<double> d(points.size());
    for (std::size_t i = r.begin(); i < r.end(); ++i) {
      for (std::size_t k = 0; k < d.size(); ++k)
        d[k] = kernel::distance(points[chosen[i]], points[k]);
      std::nth_element(d.begin(), d.begin() + 10, d.end());
      tenth[i] = d[10];
    }
  });
  tenth.resize(chosen.size());
  std::nth_element(tenth.begin(), tenth.begin() + static_cast<std::ptrdiff_t>(tenth.size() / 2),
                   tenth.end());
  return tenth[tenth.size() / 2];
}

/// Inside the rim of the points.
LevelValues rim_values(const PointField& field, const PointTree& tree, const SheetMesh& mesh) {
  LevelValues r;
  const auto value = [&](const Vec3& at) {
    const Vec3 x = tree.grid().position(at);
    const PointField::Sums s = field.at(x);
    return s.count == 0 ? -field.h() : field.inside(s, x, dominant_direction(s.local.tensor));
  };
  r.corners.resize(mesh.vertices.size());
  r.centres.resize(mesh.polygons.size());
  using Range = tbb::blocked_range<std::size_t>;
  kernel::parallel_for(Range(0, r.corners.size(), 64), [&](const Range& range) {
    for (std::size_t i = range.begin(); i < range.end(); ++i) r.corners[i] = value(mesh.points[i]);
  });
  kernel::parallel_for(Range(0, r.centres.size(), 64), [&](const Range& range) {
    for (std::size_t i = range.begin(); i < range.end(); ++i) {
      // Between its corners' values: beside a larger leaf the zero may be outside of its polygon,
      // and no rim runs round it alone.
      const SheetPolygon& p = mesh.polygons[i];
      double low = HUGE_VAL, high = -HUGE_VAL;
      for (std::size_t k = 0; k < p.count; ++k) {
        low = std::min(low, r.corners[p.corners[k]]);
        high = std::max(high, r.corners[p.corners[k]]);
      }
      r.centres[i] = std::clamp(value(p.zero), low, high);
    }
  });
  return r;
}

void count_tree(const PointTree& tree, Counts& c) {
  const auto leaves = static_cast<Index>(tree.tree().leaves().size());
  c.leaves = leaves;
  c.nodes = tree.count_nodes();
  c.active_nodes = tree.count_active();
  for (int s = 1 << tree.tree().depth(); s > tree.tree().finest(); s /= 2) ++c.depth;
  for (Index i = 0; i < leaves; ++i) {
    const PointField::Box& b = tree.box(i);
    ++(b.nonzero ? c.empty : b.passed ? c.cone : c.open);
  }
  for (const OctreeEdge& e : tree.edges()) {
    if (e.state == EdgeState::untested) continue;
    if (e.state == EdgeState::undecided) {
      ++c.undecided_edges;
      continue;
    }
    ++c.edges;
    const auto depth = static_cast<std::size_t>(e.depth);
    if (c.bisections.size() <= depth) c.bisections.resize(depth + 1);
    ++c.bisections[depth];
    c.critical_edges += e.state >= EdgeState::merely_critical ? 1 : 0;
    c.extremal_edges += e.state == EdgeState::extremal ? 1 : 0;
  }
}

}  // namespace

Result extract(const OrientedPoints& given, const PointOptions& options,
               certify::ExtremalCertificate* certificate) {
  if (certificate != nullptr)
    throw kernel::InputError("surfaces of points have no certificate yet; leave it out");
  if (options.depth < 1 || options.depth > Octree::kDeepest)
    throw kernel::InputError("depth: not a number from 1 to 19; choose another");
  OrientedPoints points = checked(given);
  const double h = options.radius ? *options.radius : default_radius(points.points);
  if (!(h > 0 && std::isfinite(h)))
    throw kernel::InputError("radius: not a positive number; give --radius");
  // The inverse of its square's square is asked for.
  if (!(h >= 0x1p-200 && h <= 0x1p200))
    throw kernel::InputError("radius: not from 2^-200 to 2^200; choose another unit of length");
  Result r;
  r.h = h;
  r.counts.points_dropped = given.points.size() - points.points.size();
  const PointField field(std::move(points.points), std::move(points.normals), h);
  const PointTree tree(field, options.depth);
  MeasuredMesh mesh;
  mesh.sheets = make_octree_sheets(tree, options.critical, r.counts);
  const LevelValues levels = rim_values(field, tree, mesh.sheets);
  mesh.trimmed = trim(mesh.sheets, levels);
  mesh.measured = measure(tree.grid(), mesh.sheets, mesh.trimmed);
  write_mesh(
      tree.grid(), mesh,
      [&](std::span<const Vec3> places) {
        std::vector<AtPlace> values(places.size());
        kernel::parallel_for(std::size_t{0}, places.size(), [&](std::size_t i) {
          values[i] = at_place(tree.sums(places[i]).local, false);
        });
        return values;
      },
      r);
  r.counts.valence = mesh.trimmed.valence;
  r.counts.odd_valence_unexplained = mesh.trimmed.unexplained;
  count_tree(tree, r.counts);
  for (const OctreeEdge& e : tree.edges()) {
    if (e.state != EdgeState::undecided) continue;
    const Node v = unpacked(e.low);
    const Vec3 a = {double(v[0]), double(v[1]), double(v[2])};
    Vec3 b = a;
    b[e.axis] += e.size;
    r.undecided.push_back({tree.grid().position(a), tree.grid().position(b), false});
  }
  return r;
}

}  // namespace crest::extremal
