// SPDX-License-Identifier: GPL-3.0-or-later
#include <Eigen/SparseCholesky>
#include <stdexcept>

#include "algorithms/vector_fields/domain.hpp"
#include "algorithms/vector_fields/importance.hpp"

namespace crest::vector_fields {

using kernel::cross;
using kernel::dot;
using kernel::operator-;

namespace {

/// Vertices whose neighbours go once around them.
std::vector<std::uint8_t> inner_vertices(const Domain& domain) {
  std::vector<std::uint8_t> inner(domain.field().points.size(), 0);
  for (Index t = 0; t < domain.triangle_count(); ++t)
    if (domain.live(t))
      for (const Index v : domain.field().triangles[t]) inner[v] = 1;
  for (HalfEdge h = 0; h < 3 * domain.triangle_count(); ++h)
    if (domain.twin(h) == kNone) inner[domain.from(h)] = inner[domain.to(h)] = 0;
  return inner;
}

/// Of the corner opposite a half-edge.
double cotangent(const Domain& domain, HalfEdge h) {
  const Vec2& apex = domain.point(domain.from(Domain::previous(h)));
  const Vec2 e = domain.point(domain.from(h)) - apex, f = domain.point(domain.to(h)) - apex;
  return dot(e, f) / cross(e, f);
}

}  // namespace

std::vector<Vec2> smoothed(const PlanarField& field, Laplacian laplacian) {
  const Domain domain(field);
  const auto inner = inner_vertices(domain);
  std::vector<Eigen::Index> row(inner.size(), -1);
  Eigen::Index rows = 0;
  for (std::size_t v = 0; v < inner.size(); ++v)
    if (inner[v] != 0) row[v] = rows++;
  std::vector<Vec2> result = field.vectors;
  if (rows == 0) return result;
  std::vector<Eigen::Triplet<double>> entries;
  Eigen::MatrixX2d right = Eigen::MatrixX2d::Zero(rows, 2);
  for (HalfEdge h = 0; h < 3 * domain.triangle_count(); ++h) {
    const Index v = domain.from(h), w = domain.to(h);
    const HalfEdge g = domain.twin(h);
    if (row[v] < 0 || !domain.live(h / 3)) continue;
    // Each edge at an inner vertex leaves it once.
    const double weight =
        laplacian == Laplacian::uniform ? 1 : cotangent(domain, h) + cotangent(domain, g);
    entries.emplace_back(row[v], row[v], weight);
    if (row[w] >= 0)
      entries.emplace_back(row[v], row[w], -weight);
    else
      for (int k = 0; k < 2; ++k)
        right(row[v], k) += weight * field.vectors[w][static_cast<std::size_t>(k)];
  }
  Eigen::SparseMatrix<double> matrix(rows, rows);
  matrix.setFromTriplets(entries.begin(), entries.end());
  const Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> solver(matrix);
  const Eigen::MatrixX2d x = solver.solve(right);
  if (solver.info() != Eigen::Success || !x.allFinite())
    throw std::runtime_error("smoothing: the system is not definite; use the uniform Laplacian");
  for (std::size_t v = 0; v < inner.size(); ++v)
    if (row[v] >= 0) result[v] = {x(row[v], 0), x(row[v], 1)};
  return result;
}

PlanarField blended(const PlanarField& field, const std::vector<Vec2>& smooth, double t) {
  PlanarField result = field;
  for (std::size_t v = 0; v < smooth.size(); ++v)
    for (std::size_t k = 0; k < 2; ++k)
      // Where both agree, so does what is between them.
      if (smooth[v][k] != field.vectors[v][k])
        result.vectors[v][k] = (1 - t) * field.vectors[v][k] + t * smooth[v][k];
  return result;
}

}  // namespace crest::vector_fields
