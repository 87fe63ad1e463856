// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/ridges/measures.hpp"

#include <cmath>

namespace crest::ridges {
namespace {

using kernel::MongeForm;
using kernel::norm;
using kernel::operator-;

double polyline_length(const std::vector<Vec3>& points, const Vec3& last) {
  double sum = 0;
  for (std::size_t i = 0; i < points.size(); ++i)
    sum += norm(points[i] - (i + 1 < points.size() ? points[i + 1] : last));
  return sum;
}

double extremality(const MongeForm& m, Colour c) {
  return c == Colour::blue ? m.b0 : m.b3;
}

// |P / (k1 - k2)|, the second derivative of the curvature along its line (observation 3).
double second_derivative(const Crossing& c) {
  const double gap = c.k1 - c.k2;
  return c.p == 0 ? 0 : std::fabs(c.p) / gap;
}

}  // namespace

double crossing_weight(const kernel::TriangleMesh& mesh, const std::vector<MongeForm>& forms,
                       Index edge, Colour colour) {
  const double bp = std::fabs(extremality(forms[mesh.edges()[edge].v0], colour));
  const double bq = std::fabs(extremality(forms[mesh.edges()[edge].v1], colour));
  if (bp == 0 && bq == 0) return 0.5;
  const double larger = std::fmax(bp, bq);  // scaled so that the sum cannot overflow
  return (bp / larger) / (bp / larger + bq / larger);
}

Crossing measure_crossing(const kernel::TriangleMesh& mesh, const std::vector<MongeForm>& forms,
                          Index edge, Colour colour) {
  const Index p = mesh.edges()[edge].v0, q = mesh.edges()[edge].v1;
  const MongeForm &a = forms[p], &b = forms[q];
  Crossing c;
  c.edge = edge;
  c.weight = crossing_weight(mesh, forms, edge, colour);
  const double w = c.weight;
  auto mix = [w](double x, double y) { return (1 - w) * x + w * y; };
  for (std::size_t k = 0; k < 3; ++k) c.point[k] = mix(mesh.points()[p][k], mesh.points()[q][k]);
  c.type = RidgeType::none;
  c.k1 = mix(a.k1, b.k1);
  c.k2 = mix(a.k2, b.k2);
  c.b = (std::fabs(extremality(a, colour)) + std::fabs(extremality(b, colour))) / 2;
  c.p = colour == Colour::blue ? mix(kernel::blue_p(a), kernel::blue_p(b))
                               : mix(kernel::red_p(a), kernel::red_p(b));
  return c;
}

double model_size(const kernel::TriangleMesh& mesh) {
  Vec3 mean{};
  for (const Vec3& p : mesh.points())
    for (std::size_t k = 0; k < 3; ++k) mean[k] += p[k];
  for (double& x : mean) x /= mesh.vertex_count();
  double size = 0;
  for (const Vec3& p : mesh.points()) size = std::fmax(size, norm(p - mean));
  return size;
}

void measure_ridge(Ridge& ridge, double model_size) {
  ridge.length = ridge.elliptic_length = ridge.hyperbolic_length = 0;
  ridge.strength = ridge.sharpness = 0;
  const auto& nodes = ridge.crossings;
  for (std::size_t i = 0; i < ridge.segment_count(); ++i) {
    const Crossing &a = nodes[i], &b = nodes[(i + 1) % nodes.size()];
    const double l = norm(a.point - b.point);
    ridge.length += l;
    switch (ridge.fourth_order(i)) {
      case RidgeType::elliptic:
        ridge.elliptic_length += l;
        break;
      case RidgeType::hyperbolic:
        ridge.hyperbolic_length += l;
        break;
      case RidgeType::turning: {
        const double sum = std::fabs(a.p) + std::fabs(b.p);
        const double share = sum > 0 ? std::fabs(a.p) / sum : 0.5;
        (a.p < 0 ? ridge.elliptic_length : ridge.hyperbolic_length) += share * l;
        (a.p < 0 ? ridge.hyperbolic_length : ridge.elliptic_length) += (1 - share) * l;
        break;
      }
      case RidgeType::none:
        break;
    }
    const auto curvature = [&](const Crossing& c) {
      return std::fabs(ridge.colour == Colour::blue ? c.k1 : c.k2);
    };
    ridge.strength += l * (curvature(a) + curvature(b)) / 2;
    ridge.sharpness += l * (second_derivative(a) + second_derivative(b)) / 2;
  }
  ridge.sharpness *= model_size * model_size;
  const double drawn =
      (ridge.lead_in.empty() ? 0 : polyline_length(ridge.lead_in, nodes[0].point)) +
      (ridge.lead_out.empty() ? 0
                              : polyline_length(ridge.lead_out, ridge.lead_out.back()) +
                                    norm(nodes.back().point - ridge.lead_out.front()));
  ridge.length += drawn;
  ridge.hyperbolic_length += drawn;
}

}  // namespace crest::ridges
