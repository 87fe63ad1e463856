// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/extremal/extraction.hpp"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>

namespace crest::extremal {
namespace {

/// lambda1 / (lambda1 + lambda2); an image's third direction does not count.
double plateness_of(const Tensor& t, const Vec3& n, bool plane) {
  const double first = kernel::dot(n, product(t, n));
  double second;
  if (plane) {
    second = t[0] + t[1] - first;
  } else {
    const auto [u, v] = kernel::frame_across(n);
    const Vec3 tu = product(t, u), tv = product(t, v);
    const double a = kernel::dot(u, tu), b = kernel::dot(u, tv), c = kernel::dot(v, tv);
    second = 0.5 * (a + c) + std::sqrt(0.25 * (a - c) * (a - c) + b * b);
  }
  const double sum = first + second;
  return sum > 0 ? std::clamp(first / sum, 0.0, 1.0) : 1;
}

}  // namespace

Extraction::Extraction(const Volume& volume, const Options& options)
    : options_(options),
      fields_(volume, options),
      nodes_(fields_, options.min_value),
      cells_(fields_, nodes_),
      edges_(fields_, nodes_, cells_),
      faces_(fields_, nodes_, cells_, edges_),
      clusters_(fields_, cells_, edges_, faces_) {}

Extraction::Mesh Extraction::mesh(bool critical) const {
  Mesh r;
  r.sheets = make_sheets(fields_, cells_, edges_, faces_, critical);
  r.trimmed = trim(fields_, r.sheets, {options_.min_value, options_.min_strength});
  r.measured = measure(fields_, r.sheets, r.trimmed, clusters_);
  return r;
}

Counts Extraction::counts(const Mesh& mesh) const {
  Counts c;
  c.nodes = fields_.grid().nodes();
  c.active_nodes = nodes_.count(NodeState::active);
  c.flat_nodes = nodes_.count(NodeState::flat);
  c.empty = cells_.count(CellState::empty);
  c.regular = cells_.count(CellState::regular) + cells_.count(CellState::regular_extremal);
  c.cone = cells_.count(CellState::cone);
  c.open = cells_.count(CellState::open);
  c.edges = edges_.count();
  c.critical_edges = edges_.critical_edges().size();
  for (const CriticalEdge& e : edges_.critical_edges()) {
    c.extremal_edges += edges_.state(e.edge) == EdgeState::extremal ? 1 : 0;
    c.undecided_types += edges_.state(e.edge) == EdgeState::type_undecided ? 1 : 0;
  }
  c.undecided_edges = edges_.undecided().size();
  c.valence = mesh.trimmed.valence;
  c.bisections = edges_.depths();
  c.cone_tests = edges_.tests();
  count_crossings(fields_, edges_, faces_, c);
  return c;
}

/// Points that polygons use, in their order, with n.
void Extraction::write_points(const Mesh& mesh, Result& result) const {
  const TrimmedMesh& t = mesh.trimmed;
  std::vector<Index> number(t.points.size(), kernel::kNone), kept;
  for (const Index v : t.corners) number[v] = 0;
  for (Index v = 0; v < number.size(); ++v) {
    if (number[v] == kernel::kNone) continue;
    number[v] = static_cast<Index>(kept.size());
    kept.push_back(v);
  }
  result.points.resize(kept.size());
  result.normals.resize(kept.size());
  std::vector<double> residuals(kept.size());
  const Vec3& d = fields_.grid().spacing;
  const double least = std::min({d[0], d[1], result.dimension == 2 ? d[0] : d[2]});
  tbb::parallel_for(tbb::blocked_range<std::size_t>(0, kept.size(), 256), [&](const auto& range) {
    for (std::size_t i = range.begin(); i < range.end(); ++i) {
      const TrimmedPoint& p = t.points[kept[i]];
      const Vec3 low = {double(p.cell[0]), double(p.cell[1]), double(p.cell[2])};
      const Local l = fields_.at(p.cell, p.place - low);
      result.points[i] = fields_.grid().position(p.place);
      result.normals[i] = dominant_direction(l.tensor);
      const Vec3& n = result.normals[i];
      const double bend = std::fabs(kernel::dot(n, product(l.hessian, n))) * least;
      residuals[i] = bend > 0 ? std::fabs(kernel::dot(n, l.gradient)) / bend : 0;
    }
  });
  for (const double x : residuals) result.max_residual = std::max(result.max_residual, x);
  result.first = t.first;
  for (const Index v : t.corners) result.corners.push_back(number[v]);
  for (const Feature& f : t.features)
    result.features.push_back({number[f.a], number[f.b], f.reason});
  // n on the side of the first polygon that has the point.
  if (result.dimension == 2) return;
  std::vector<bool> seen(kept.size(), false);
  for (std::size_t p = 0; p < result.polygons(); ++p) {
    const Index begin = result.first[p], end = result.first[p + 1];
    Vec3 across{};
    for (Index i = begin + 2; i < end; ++i)
      across =
          across +
          kernel::cross(result.points[result.corners[i - 1]] - result.points[result.corners[begin]],
                        result.points[result.corners[i]] - result.points[result.corners[begin]]);
    for (Index i = begin; i < end; ++i) {
      const Index v = result.corners[i];
      if (!seen[v] && kernel::dot(across, result.normals[v]) < 0)
        result.normals[v] = -1.0 * result.normals[v];
      seen[v] = true;
    }
  }
}

void Extraction::write_polygons(const Mesh& mesh, Result& result) const {
  const std::size_t count = mesh.trimmed.source.size();
  result.component = mesh.measured.component_of;
  result.critical_type.resize(count);
  result.strength.resize(count);
  result.s.resize(count);
  result.plateness.resize(count);
  tbb::parallel_for(tbb::blocked_range<std::size_t>(0, count, 256), [&](const auto& range) {
    for (std::size_t i = range.begin(); i < range.end(); ++i) {
      const SheetPolygon& p = mesh.sheets.polygons[mesh.trimmed.source[i]];
      const auto [cell, t] = zero_of(fields_.grid(), p);
      const Local l = fields_.at(cell, t);
      const Vec3 n = dominant_direction(l.tensor);
      result.critical_type[i] = p.extremal ? 1 : 0;
      result.strength[i] = kernel::dot(n, product(l.hessian, n));
      result.s[i] = fields_.sign() * l.value;
      result.plateness[i] = plateness_of(l.tensor, n, result.dimension == 2);
    }
  });
}

Result Extraction::result(const Mesh& mesh) const {
  const Grid& g = fields_.grid();
  Result r;
  r.dimension = g.dimension();
  const double plane = std::min(g.spacing[0], g.spacing[1]);
  r.h =
      std::sqrt(2.0) * options_.sigma * (r.dimension == 2 ? plane : std::min(plane, g.spacing[2]));
  write_points(mesh, r);
  write_polygons(mesh, r);
  r.components = mesh.measured.components;
  const auto add = [&](Index e, bool type) {
    const Node v = g.node(e / 3);
    Vec3 a = {double(v[0]), double(v[1]), double(v[2])}, b = a;
    b[e % 3] += 1;
    r.undecided.push_back({g.position(a), g.position(b), type});
  };
  for (const Index e : edges_.undecided()) add(e, false);
  for (const CriticalEdge& e : edges_.critical_edges())
    if (edges_.state(e.edge) == EdgeState::type_undecided) add(e.edge, true);
  r.counts = counts(mesh);
  return r;
}

}  // namespace crest::extremal
