// SPDX-License-Identifier: GPL-3.0-or-later
// Faces whose image no other face meets (certify/ridges_smooth/SPEC.md, "One sheet").
#include <algorithm>
#include <cmath>
#include <tuple>

#include "algorithms/smooth_ridges/chart.hpp"
#include "algorithms/smooth_ridges/completeness.hpp"

namespace crest::smooth_ridges {
namespace {

using Model = kernel::TaylorModel<3>;
using kernel::Range;
constexpr Range kAll = {-HUGE_VAL, HUGE_VAL};

/// Opened a little: the checker's may be wider.
Range roomy(const Range& r) {
  const double room = 0.01 * (r.high - r.low) + 1e-12 * (std::fabs(r.low) + std::fabs(r.high));
  return {r.low - room, r.high + room};
}
Range roomy(const Model& m) {
  return roomy(m.range());
}

class SheetFinder {
 public:
  SheetFinder(const Surface& surface, const Triangulation& mesh, FaceImages images)
      : mesh_(mesh), charts_(surface), images_(std::move(images)) {
    const auto is_known = [](const Range& r) { return std::isfinite(r.low - r.high); };
    images_.resize(mesh.faces().size(), {kAll, kAll, kAll});
    for (Index f = 0; f < images_.size(); ++f) {
      auto& [x, y, z] = images_[f];
      if (!is_known(x) || !is_known(y) || !is_known(z))
        if (const auto chart = charts_(mesh.corners(f)))
          std::tie(x, y, z) =
              std::tuple(chart->x[0].range(), chart->x[1].range(), chart->x[2].range());
      for (Range& r : images_[f]) r = roomy(r);
    }
  }

  bool holds(Index face) {
    auto chart = charts_(mesh_.corners(face));
    if (!chart || !projects_injectively(*chart, face)) return false;
    const auto corners = mesh_.corners(face);
    const std::array<Vec3, 3> x = {position(corners[0]), position(corners[1]),
                                   position(corners[2])};
    const Vec3 flat = cross(x[1] - x[0], x[2] - x[0]);
    std::array<Vec3, 3> outward;  // conormals
    for (std::size_t i = 0; i < 3; ++i) outward[i] = cross(x[(i + 1) % 3] - x[i], flat);
    // The centroid is the origin of a model's coordinates.
    Vec3 y{};
    for (std::size_t k = 0; k < 3; ++k) y[k] = chart->x[k].c[0];
    for (Index f = 0; f < mesh_.faces().size(); ++f)
      if (f != face && !apart(f, y, chart->x, outward)) return false;
    return true;
  }

 private:
  /// The derivative of the projection, times its inverse at the centroid, has a positive definite
  /// symmetric part.
  bool projects_injectively(Chart<Model>& chart, Index face) {
    charts_.tangents(chart, mesh_.corners(face));
    const std::size_t m = face_axis(mesh_, face), p = (m + 1) % 3, q = (m + 2) % 3;
    const auto& [d1, d2] = chart.dx;
    const double a = d1[p].c[0], b = d2[p].c[0], c = d1[q].c[0], d = d2[q].c[0];
    const double det = a * d - b * c;
    const auto entry = [&](double u, double v, const std::array<Model, 3>& t) {
      return roomy((u / det) * t[p] + (v / det) * t[q]);
    };
    const Range e11 = entry(d, -b, d1), e12 = entry(d, -b, d2);
    const Range e21 = entry(-c, a, d1), e22 = entry(-c, a, d2);
    const double off = std::max(std::fabs(e12.low + e21.low), std::fabs(e12.high + e21.high)) / 2;
    return e11.low > 0 && e22.low > 0 && e11.low * e22.low > 1.01 * off * off;
  }

  bool apart(Index f, const Vec3& y, const std::array<Model, 3>& centre,
             const std::array<Vec3, 3>& outward) {
    for (std::size_t k = 0; k < 3; ++k) {
      const double room = 2 * centre[k].radius + 1e-12 * std::fabs(y[k]);
      if (images_[f][k].low > y[k] + room || images_[f][k].high < y[k] - room) return true;
    }
    const auto chart = charts_(mesh_.corners(f));
    if (!chart) return false;
    for (const Vec3& c : outward) {
      const Model beyond = c[0] * (chart->x[0] - Model(y[0])) + c[1] * (chart->x[1] - Model(y[1])) +
                           c[2] * (chart->x[2] - Model(y[2]));
      double room = 0;
      for (std::size_t k = 0; k < 3; ++k) room += 2 * std::fabs(c[k]) * centre[k].radius;
      if (roomy(beyond).low > room) return true;
    }
    return false;
  }

  const Triangulation& mesh_;
  Charts<Model> charts_;
  FaceImages images_;
};

/// The least sine of a face's angles: how well shaped it is.
double shape(const Triangulation& mesh, Index face) {
  const auto c = mesh.corners(face);
  double least = 1;
  for (std::size_t k = 0; k < 3; ++k) {
    const Vec3 a = position(c[(k + 1) % 3]) - position(c[k]);
    const Vec3 b = position(c[(k + 2) % 3]) - position(c[k]);
    least = std::min(least, norm(cross(a, b)) / (norm(a) * norm(b)));
  }
  return least;
}

}  // namespace

std::uint8_t face_axis(const Triangulation& mesh, Index face) {
  Vec3 sum{};
  for (const Vertex& v : mesh.corners(face)) sum = sum + normal(v);
  std::uint8_t axis = 0;
  for (std::uint8_t k = 1; k < 3; ++k)
    if (std::fabs(sum[k]) > std::fabs(sum[axis])) axis = k;
  return axis;
}

OneSheet one_sheet(const Surface& surface, const Triangulation& mesh,
                   const std::vector<std::uint8_t>& skip, const FaceImages& images,
                   const Stop& stop) {
  const std::vector<Index> component = mesh.face_components();
  std::vector<std::vector<Index>> members;
  for (Index f = 0; f < component.size(); ++f) {
    if (component[f] == members.size()) members.emplace_back();
    members[component[f]].push_back(f);
  }
  SheetFinder finder(surface, mesh, images);
  OneSheet result;
  for (std::vector<Index>& faces : members) {
    // The best shaped first: slender neighbours spoil the conormals' test.
    std::vector<std::pair<double, Index>> order;
    for (const Index f : faces)
      if (skip.empty() || skip[f] == 0) order.emplace_back(-shape(mesh, f), f);
    std::sort(order.begin(), order.end());
    constexpr std::size_t kCandidates = 400;
    if (order.size() > kCandidates) order.resize(kCandidates);
    const auto found = std::find_if(order.begin(), order.end(), [&](const auto& entry) {
      result.stopped = is_over(stop);
      return !result.stopped && finder.holds(entry.second);
    });
    if (result.stopped) return result;
    if (found == order.end()) {
      result.failed = faces.front();
      return result;
    }
    result.faces.push_back(found->second);
  }
  std::sort(result.faces.begin(), result.faces.end());
  return result;
}

}  // namespace crest::smooth_ridges
