// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/line_art/field.hpp"

#include <Eigen/SparseCholesky>
#include <complex>
#include <numbers>
#include <stdexcept>

#include "kernel/geometry/stop.hpp"
#include "kernel/predicates/rotation.hpp"

namespace crest::line_art {
namespace {

using kernel::cross, kernel::dot, kernel::norm;
using kernel::operator+, kernel::operator-, kernel::operator*;
using Complex = std::complex<double>;

constexpr double kSilent = 0.02;  // |k| times spacing: below it curvature says little
constexpr double kPrior = 0.01;   // tau

struct Tangent {
  Vec3 x, y;
};

Tangent tangent_of(const Vec3& n) {
  const Vec3 helper = std::abs(n[0]) < 0.6 ? Vec3{1, 0, 0} : Vec3{0, 1, 0};
  const Vec3 t = cross(n, helper);
  const Vec3 x = (1 / norm(t)) * t;
  return {x, cross(n, x)};
}

class Smoother {
 public:
  Smoother(const kernel::TriangleMesh& mesh, const std::vector<PrincipalFrame>& frames,
           const FieldOptions& options)
      : mesh_(mesh), frames_(frames), o_(options), n_(options.cross ? 4 : 2) {
    for (const PrincipalFrame& f : frames) tangents_.push_back(tangent_of(f.n));
  }

  std::vector<Vec3> run() {
    const auto vertices = static_cast<Eigen::Index>(mesh_.vertex_count());
    right_ = Eigen::VectorXcd::Zero(vertices);
    add_data();
    add_smoothness();
    Eigen::SparseMatrix<Complex> matrix(vertices, vertices);
    matrix.setFromTriplets(entries_.begin(), entries_.end());
    Eigen::SimplicialLDLT<Eigen::SparseMatrix<Complex>> solver;
    solver.analyzePattern(matrix);
    kernel::stop_point();
    solver.factorize(matrix);
    kernel::stop_point();
    if (solver.info() != Eigen::Success) throw std::runtime_error("direction field: not definite");
    const Eigen::VectorXcd u = solver.solve(right_);
    std::vector<Vec3> directions;
    for (Index v = 0; v < mesh_.vertex_count(); ++v) {
      const double theta = std::arg(u[static_cast<Eigen::Index>(v)]) / n_;
      directions.push_back(std::cos(theta) * tangents_[v].x + std::sin(theta) * tangents_[v].y);
    }
    return directions;
  }

 private:
  Complex power(Index v, const Vec3& d) const {
    const Complex z(dot(d, tangents_[v].x), dot(d, tangents_[v].y));
    const double size = std::abs(z);
    return size > 0 ? std::pow(z / size, n_) : Complex(0, 0);
  }

  void add(Index i, Index j, const Complex& x) {
    entries_.emplace_back(static_cast<int>(i), static_cast<int>(j), x);
  }

  void add_data() {
    std::vector<double> area(mesh_.vertex_count(), 0);
    for (const kernel::Triangle& f : mesh_.faces()) {
      const auto& p = mesh_.points();
      const double third = norm(cross(p[f[1]] - p[f[0]], p[f[2]] - p[f[0]])) / 6;
      for (const Index v : f) area[v] += third;
    }
    for (Index v = 0; v < mesh_.vertex_count(); ++v) {
      const PrincipalFrame& f = frames_[v];
      const double a1 = std::abs(f.k1), a2 = std::abs(f.k2);
      const double k = o_.spacing * (o_.cross ? f.k1 - f.k2 : a1 - a2);
      const double c = k * k / (k * k + kSilent * kSilent);
      const Complex data = power(v, o_.cross || a1 > a2 ? f.d1 : f.d2);
      const Complex prior = power(v, cross(f.n, o_.axis));
      const auto i = static_cast<Eigen::Index>(v);
      right_[i] += area[v] * (c * data + kPrior * prior);
      // Without prior or data the diagonal stays positive all the same.
      add(v, v, area[v] * (c + kPrior));
    }
  }

  bool coupled(const kernel::Edge& e) const {
    if (!o_.crease || e.f0 == kNone || e.f1 == kNone) return true;
    const auto normal = [&](Index f) {
      const kernel::Triangle& t = mesh_.faces()[f];
      const auto& p = mesh_.points();
      return cross(p[t[1]] - p[t[0]], p[t[2]] - p[t[0]]);
    };
    const Vec3 m = normal(e.f0), n = normal(e.f1);
    return dot(m, n) > std::cos(*o_.crease * std::numbers::pi / 180) * norm(m) * norm(n);
  }

  /// Half the cotangents opposite, as far as they are positive.
  double weight(const kernel::Edge& e) const {
    double sum = 0;
    for (const Index f : {e.f0, e.f1}) {
      if (f == kNone) continue;
      const kernel::Triangle& t = mesh_.faces()[f];
      const Index o = t[0] != e.v0 && t[0] != e.v1   ? t[0]
                      : t[1] != e.v0 && t[1] != e.v1 ? t[1]
                                                     : t[2];
      const auto& p = mesh_.points();
      const Vec3 a = p[e.v0] - p[o], b = p[e.v1] - p[o];
      const double area = norm(cross(a, b));
      if (area > 0) sum += 0.5 * std::max(0.0, dot(a, b) / area);
    }
    return std::min(std::max(sum, 0.05), 20.0);
  }

  void add_smoothness() {
    const double l2 = o_.smooth * o_.smooth;
    for (const kernel::Edge& e : mesh_.edges()) {
      if (!coupled(e)) continue;
      const Vec3 d = mesh_.points()[e.v1] - mesh_.points()[e.v0];
      // u at v1, carried to v0.
      const Complex r = power(e.v0, d) * std::conj(power(e.v1, d));
      const double w = l2 * weight(e);
      add(e.v0, e.v0, w);
      add(e.v1, e.v1, w * std::norm(r));
      add(e.v0, e.v1, -w * r);
      add(e.v1, e.v0, -w * std::conj(r));
    }
  }

  const kernel::TriangleMesh& mesh_;
  const std::vector<PrincipalFrame>& frames_;
  const FieldOptions& o_;
  int n_;
  std::vector<Tangent> tangents_;
  std::vector<Eigen::Triplet<Complex>> entries_;
  Eigen::VectorXcd right_;
};

/// Angles of stars: where neighbours stand, the field's angle, the scaled corners.
struct Stars {
  std::vector<double> position, corner;  ///< by place in the rings
  std::vector<Index> begin;
  std::vector<double> phi;
};

Stars stars_of(const kernel::TriangleMesh& mesh, const std::vector<PrincipalFrame>& frames,
               const std::vector<Vec3>& directions) {
  Stars s;
  s.begin.push_back(0);
  for (Index v = 0; v < mesh.vertex_count(); ++v)
    s.begin.push_back(s.begin.back() + static_cast<Index>(mesh.ring(v).size()));
  s.position.resize(s.begin.back());
  s.corner.resize(s.begin.back());
  std::vector<Vec3> ring;
  for (Index v = 0; v < mesh.vertex_count(); ++v) {
    ring.clear();
    for (const Index w : mesh.ring(v)) ring.push_back(mesh.points()[w]);
    const kernel::Star star{mesh.points()[v], ring, !mesh.on_boundary(v), directions[v],
                            frames[v].n};
    const std::size_t size = ring.size();
    s.phi.push_back(
        kernel::star_angles(star, {s.position.data() + s.begin[v], size},
                            {s.corner.data() + s.begin[v], size - (mesh.on_boundary(v) ? 1 : 0)})
            .phi);
  }
  return s;
}

/// The index of every face, times the symmetry: least turns along edges and the scaled corners sum
/// to a whole number of turns.
void find_singularities(const kernel::TriangleMesh& mesh, const Stars& s, DirectionField& field) {
  using std::numbers::pi;
  const int n = field.symmetry;
  const auto place = [&](Index v, Index w) {
    const auto ring = mesh.ring(v);
    return s.begin[v] + static_cast<Index>(std::find(ring.begin(), ring.end(), w) - ring.begin());
  };
  std::vector<double> turn(mesh.edge_count());  // from the lower to the higher vertex, times n
  for (Index e = 0; e < mesh.edge_count(); ++e) {
    const auto [v, w, f0, f1] = mesh.edges()[e];
    const double transport = s.position[place(w, v)] + pi - s.position[place(v, w)];
    const double raw = n * (s.phi[w] - s.phi[v] - transport);
    turn[e] = raw - 2 * pi * std::ceil(raw / (2 * pi) - 0.5);  // in (-pi, pi]
  }
  for (Index f = 0; f < mesh.face_count(); ++f) {
    double sum = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      const Index v = mesh.faces()[f][k], w = mesh.faces()[f][(k + 1) % 3];
      sum += v < w ? turn[mesh.face_edges()[f][k]] : -turn[mesh.face_edges()[f][k]];
      sum += n * s.corner[place(v, w)];
    }
    const int index = static_cast<int>(std::lround((sum - n * pi) / (2 * pi)));
    if (index == 0) continue;
    field.singular.push_back(f);
    field.index.push_back(index);
    field.index_sum += index;
  }
}

}  // namespace

DirectionField direction_field(const kernel::TriangleMesh& mesh,
                               const std::vector<PrincipalFrame>& frames,
                               const FieldOptions& options) {
  DirectionField field;
  field.symmetry = options.cross ? 4 : 2;
  field.direction = Smoother(mesh, frames, options).run();
  find_singularities(mesh, stars_of(mesh, frames, field.direction), field);
  return field;
}

}  // namespace crest::line_art
