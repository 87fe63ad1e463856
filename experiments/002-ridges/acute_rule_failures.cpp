// SPDX-License-Identifier: GPL-3.0-or-later
// How often the acute rule errs (paper 002, definition 3): on exact surfaces, every mesh edge is
// oriented by the sign of d1(p).d1(q) and by following d1 along the edge's image on the surface.
//
// The image is the projection of the straight edge. d1 turns by at most about s / (2 d) over a step
// s at distance d from the nearest umbilic, so steps of d / 4 never lose its orientation; an edge
// that comes nearer to an umbilic than its length / 2^20 is counted as undecided.
#include <fmt/format.h>
#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>

#include "algorithms/sampling/umbilics.hpp"
#include "experiments/program.hpp"
#include "kernel/geometry/triangle_mesh.hpp"

namespace crest {
namespace {

using kernel::distance, kernel::dot, kernel::MongeForm;
using kernel::operator+, kernel::operator-, kernel::operator*;
using sampling::Surface;
using sampling::Vec3;

struct Options {
  std::vector<std::string> surfaces = {"ellipsoid", "blend", "perturbed-torus"};
  std::vector<int> vertices = {160, 640, 2500, 10000, 40000, 160000};
};

// Edge length over distance from the edge to the nearest umbilic.
constexpr std::array<double, 8> kBins = {0.05, 0.1, 0.2, 0.5, 1, 2, 5, 1e300};

Vec3 between(const Vec3& a, const Vec3& b, double t) {
  return a + t * (b - a);
}
double distance_to_segment(const Vec3& a, const Vec3& b, const Vec3& p) {
  const Vec3 u = b - a, w = p - a;
  return distance(p, between(a, b, std::clamp(dot(u, w) / dot(u, u), 0.0, 1.0)));
}

class Tracker {
 public:
  Tracker(const Surface& surface, std::vector<sampling::ExactUmbilic> umbilics)
      : surface_(surface), umbilics_(std::move(umbilics)) {}

  /// Of a point.
  double to_umbilic(const Vec3& p) const {
    double least = 1e300;
    for (const auto& u : umbilics_) least = std::min(least, distance(p, u.point));
    return least;
  }
  /// Of an edge.
  double to_umbilic(const Vec3& a, const Vec3& b) const {
    double least = 1e300;
    for (const auto& u : umbilics_) least = std::min(least, distance_to_segment(a, b, u.point));
    return least;
  }
  /// +1 or -1 as d1(p), carried along the edge's image, meets d1(q) or its opposite; 0: undecided.
  int orientation(const Vec3& p, const Vec3& q, const MongeForm& at_p,
                  const MongeForm& at_q) const {
    const double length = distance(p, q);
    Vec3 here = p, d = at_p.d1;
    for (double t = 0; t < 1;) {
      double step = std::min({0.5, to_umbilic(here) / (4 * length), 1 - t});
      for (;; step /= 2) {
        if (step < 0x1p-20 && step < 1 - t) return 0;
        const bool last = step >= 1 - t;
        const Vec3 next =
            last ? q
                 : sampling::to_vec3(surface_.project(sampling::to_point(between(p, q, t + step))));
        const Vec3 e = last ? at_q.d1 : surface_.monge_form(next).d1;
        const double product = dot(d, e);
        if (std::abs(product) < 0.9) continue;  // turned by more than 25 degrees: halve the step
        if (last) return product > 0 ? 1 : -1;
        here = next;
        d = product > 0 ? e : Vec3{-e[0], -e[1], -e[2]};
        t += step;
        break;
      }
    }
    return 0;
  }

 private:
  const Surface& surface_;
  std::vector<sampling::ExactUmbilic> umbilics_;
};

struct EdgeResult {
  double ratio;
  bool failed, undecided;
};

std::vector<EdgeResult> compare(const Tracker& tracker, const sampling::SurfaceSample& sample) {
  const kernel::TriangleMesh mesh(sample.points, sample.faces);
  std::vector<EdgeResult> results(mesh.edge_count());
  tbb::parallel_for(tbb::blocked_range<kernel::Index>(0, mesh.edge_count(), 256),
                    [&](const auto& range) {
                      for (kernel::Index e = range.begin(); e != range.end(); ++e) {
                        const auto& [v, w, f0, f1] = mesh.edges()[e];
                        const Vec3 &p = sample.points[v], &q = sample.points[w];
                        const MongeForm &a = sample.forms[v], &b = sample.forms[w];
                        const int truth = tracker.orientation(p, q, a, b);
                        const int acute = dot(a.d1, b.d1) > 0 ? 1 : -1;
                        results[e] = {distance(p, q) / tracker.to_umbilic(p, q),
                                      truth != 0 && truth != acute, truth == 0};
                      }
                    });
  return results;
}

void print_row(const std::string& name, std::size_t vertices,
               const std::vector<EdgeResult>& edges) {
  std::array<int, kBins.size()> all{}, failed{};
  int failures = 0, undecided = 0;
  double first = 1e300;
  for (const EdgeResult& e : edges) {
    const auto bin = static_cast<std::size_t>(
        std::lower_bound(kBins.begin(), kBins.end(), e.ratio) - kBins.begin());
    ++all[bin];
    failed[bin] += e.failed;
    failures += e.failed;
    undecided += e.undecided;
    if (e.failed) first = std::min(first, e.ratio);
  }
  fmt::print("| {} | {} | {} | {} | {} | {} |", name, vertices, edges.size(), failures, undecided,
             failures > 0 ? fmt::format("{:.2f}", first) : "-");
  for (std::size_t bin = 0; bin < kBins.size(); ++bin)
    fmt::print(" {} / {} |", failed[bin], all[bin]);
  fmt::print("\n");
}

std::vector<sampling::ExactUmbilic> all_umbilics(const Surface& surface) {
  const auto umbilics = sampling::find_umbilics(surface, sampling::sample(surface, 10000, true));
  int sum = 0;
  for (const auto& u : umbilics) sum += u.twice_index;
  if (sum != 2 * surface.known.euler_characteristic)
    throw std::runtime_error(surface.name + ": umbilics are missing");
  return umbilics;
}

void run(const Options& o) {
  fmt::print("| surface | vertices | edges | failures | undecided | least r of a failure |");
  for (std::size_t bin = 0; bin + 1 < kBins.size(); ++bin) fmt::print(" r <= {} |", kBins[bin]);
  fmt::print(" r > {} |\n|---|---|---|---|---|---|", kBins[kBins.size() - 2]);
  for (std::size_t bin = 0; bin < kBins.size(); ++bin) fmt::print("---|");
  fmt::print("\n");
  for (const std::string& name : o.surfaces) {
    const Surface surface = sampling::make_surface(name, {}, true);
    const Tracker tracker(surface, all_umbilics(surface));
    for (const int vertices : o.vertices) {
      const sampling::SurfaceSample sample = sampling::sample(surface, vertices, true);
      print_row(name, sample.points.size(), compare(tracker, sample));
      std::fflush(stdout);
    }
  }
  fmt::print("\nUmbilics:");
  for (const std::string& name : o.surfaces)
    fmt::print(" {} {}", name, all_umbilics(sampling::make_surface(name, {}, true)).size());
  fmt::print(
      "\nr: edge length over the edge's distance to the nearest umbilic; cells: failures / "
      "edges\n");
}

}  // namespace
}  // namespace crest

int main(int argc, char** argv) {
  crest::Options o;
  crest::experiments::Program program(
      "Failures of the acute rule against orientation by continuity");
  program.list("--surfaces", o.surfaces, "names of crest sample");
  program.list("--vertices", o.vertices, "mesh sizes");
  return program.run(argc, argv, [&] {
    crest::run(o);
    return 0;
  });
}
