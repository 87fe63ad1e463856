// SPDX-License-Identifier: GPL-3.0-or-later
// Paper 002, figures 1 and 2 in numbers: ridges and umbilics of ellipsoids, whose ridges are the
// three principal ellipses, from fitted and from exact Monge forms.
//
// Hausdorff distances are between the union of the ridges of one principal plane and the ellipse
// there: both ways, from the ridges' points and from 4096 points of the ellipse.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "algorithms/sampling/umbilics.hpp"
#include "experiments/peers/ridges/crest_run.hpp"
#include "experiments/program.hpp"

namespace crest {
namespace {

using kernel::distance;
using sampling::Surface;
using sampling::Vec3;
using Polyline = std::vector<Vec3>;

struct Options {
  std::vector<std::string> axes = {"1,1.5,2", "1,1.2,3", "2,5,5.5", "1,2,8"};
  std::vector<int> vertices = {2500, 10000, 40000, 160000};
};

constexpr int kEllipsePoints = 4096;

double distance_to_segment(const Vec3& p, const Vec3& a, const Vec3& b) {
  double uu = 0, uw = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    uu += (b[i] - a[i]) * (b[i] - a[i]);
    uw += (b[i] - a[i]) * (p[i] - a[i]);
  }
  const double t = uu > 0 ? std::clamp(uw / uu, 0.0, 1.0) : 0;
  Vec3 q;
  for (std::size_t i = 0; i < 3; ++i) q[i] = a[i] + t * (b[i] - a[i]);
  return distance(p, q);
}
double distance_to(const Vec3& p, const std::vector<Polyline>& lines) {
  double least = 1e300;
  for (const Polyline& line : lines)
    for (std::size_t i = 0; i + 1 < line.size(); ++i)
      least = std::min(least, distance_to_segment(p, line[i], line[i + 1]));
  return least;
}
double hausdorff(const std::vector<Polyline>& a, const std::vector<Polyline>& b) {
  double most = 0;
  for (const Polyline& line : a)
    for (const Vec3& p : line) most = std::max(most, distance_to(p, b));
  for (const Polyline& line : b)
    for (const Vec3& p : line) most = std::max(most, distance_to(p, a));
  return most;
}

/// The ellipse in the plane with this coordinate zero.
Polyline ellipse(const std::vector<double>& axes, std::size_t plane) {
  const std::size_t i = (plane + 1) % 3, j = (plane + 2) % 3;
  Polyline line;
  for (int k = 0; k <= kEllipsePoints; ++k) {
    const double t = 2 * std::acos(-1.0) * k / kEllipsePoints;
    Vec3 p{};
    p[i] = axes[i] * std::cos(t);
    p[j] = axes[j] * std::sin(t);
    line.push_back(p);
  }
  return line;
}

/// A ridge in the ellipsoid's own coordinates, joined to its umbilics.
Polyline body_line(const Surface& surface, const ridges::Ridge& ridge) {
  Polyline line;
  const auto add = [&](const Vec3& p) {
    line.push_back(sampling::to_vec3(surface.to_body(sampling::to_point(p))));
  };
  for (const Vec3& p : ridge.lead_in) add(p);
  for (const ridges::Crossing& c : ridge.crossings) add(c.point);
  for (const Vec3& p : ridge.lead_out) add(p);
  if (ridge.loop) line.push_back(line.front());
  return line;
}

/// The plane whose coordinate is least along the line, relative to the axes.
std::size_t plane_of(const Polyline& line, const std::vector<double>& axes) {
  std::array<double, 3> most{};
  for (const Vec3& p : line)
    for (std::size_t i = 0; i < 3; ++i) most[i] = std::max(most[i], std::abs(p[i]) / axes[i]);
  return static_cast<std::size_t>(std::min_element(most.begin(), most.end()) - most.begin());
}

/// Of each principal plane; nothing where no ridge lies in it.
std::array<std::string, 3> plane_distances(const Surface& surface, const std::vector<double>& axes,
                                           const ridges::RidgeGraph& graph, double edge) {
  std::array<std::vector<Polyline>, 3> lines;
  for (const ridges::Ridge& ridge : graph.ridges) {
    Polyline line = body_line(surface, ridge);
    lines[plane_of(line, axes)].push_back(std::move(line));
  }
  std::array<std::string, 3> text;
  for (std::size_t plane = 0; plane < 3; ++plane) {
    if (lines[plane].empty()) {
      text[plane] = "-";
      continue;
    }
    const double h = hausdorff(lines[plane], {ellipse(axes, plane)});
    text[plane] = fmt::format("{:.2e} ({:.2f})", h, h / edge);
  }
  return text;
}

double umbilic_error(const std::vector<sampling::ExactUmbilic>& exact,
                     const ridges::RidgeGraph& graph) {
  double most = 0;
  for (const auto& u : exact) {
    double least = 1e300;
    for (const auto& v : graph.umbilics) least = std::min(least, distance(u.point, v.point));
    most = std::max(most, least);
  }
  return most;
}

void print_row(const std::string& axes_text, const std::vector<double>& axes,
               const Surface& surface, const sampling::SurfaceSample& sample,
               const kernel::TriangleMesh& mesh, const std::vector<kernel::MongeForm>& forms,
               const std::string& kind) {
  const ridges::RidgeGraph graph = ridges::extract_ridge_graph(mesh, forms);
  const peers::CrestResult r = peers::count(graph);
  const double edge = sampling::mean_edge_length(sample.points, sample.faces);
  const auto planes = plane_distances(surface, axes, graph, edge);
  const double umbilics = umbilic_error(sampling::find_umbilics(surface, sample), graph);
  fmt::print(
      "| {} | {} | {} | {}, {}, {} | {} | {} + {} | {} + {} | {} | {} | {} | {} | {:.2e} ({:.2f}) "
      "|\n",
      axes_text, mesh.vertex_count(), kind, r.plus, r.minus, r.other, r.index_sum, r.blue.loops,
      r.blue.segments, r.red.loops, r.red.segments, r.open_ends, planes[0], planes[1], planes[2],
      umbilics, umbilics / edge);
  std::fflush(stdout);
}

std::vector<double> parse(const std::string& text) {
  std::vector<double> numbers;
  for (std::size_t at = 0; at < text.size();) {
    std::size_t used = 0;
    numbers.push_back(std::stod(text.substr(at), &used));
    at += used + 1;
  }
  if (numbers.size() != 3) throw std::invalid_argument("axes are three numbers A,B,C: " + text);
  return numbers;
}

void run(const Options& o) {
  fmt::print(
      "| semi-axes | vertices | Monge forms | umbilics +1/2, -1/2, other | index sum | blue loops "
      "+ "
      "segments | red loops + segments | unjoined ends | Hausdorff, x = 0 | y = 0 | z = 0 | "
      "umbilics |\n|---|---|---|---|---|---|---|---|---|---|---|---|\n");
  for (const std::string& text : o.axes)
    for (const int vertices : o.vertices) {
      const std::vector<double> axes = parse(text);
      const Surface surface = sampling::make_surface("ellipsoid", axes, true);
      const sampling::SurfaceSample sample = sampling::sample(surface, vertices, true);
      const kernel::TriangleMesh mesh(sample.points, sample.faces);
      print_row(text, axes, surface, sample, mesh, sample.forms, "exact");
      print_row(text, axes, surface, sample, mesh, ridges::fit_monge_forms(mesh, {}).forms,
                "fitted");
    }
  fmt::print("\nDistances in units of the semi-axes, in brackets in mean edge lengths.\n");
}

}  // namespace
}  // namespace crest

int main(int argc, char** argv) {
  crest::Options o;
  crest::experiments::Program program(
      "Ridges and umbilics of ellipsoids against the principal ellipses");
  program.option("--axes", o.axes, "triples A,B,C");
  program.list("--vertices", o.vertices, "mesh sizes");
  return program.run(argc, argv, [&] {
    crest::run(o);
    return 0;
  });
}
