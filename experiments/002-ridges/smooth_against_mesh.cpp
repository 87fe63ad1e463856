// SPDX-License-Identifier: GPL-3.0-or-later
// Paper 002, case II against case I: the ridge graph of a mesh beside the certified one of the
// smooth surface, on even meshes of growing size and on the certified triangulation; with fitted
// Monge forms, and with those of the surface itself (what is left then is the mesh's doing).
#include <fmt/format.h>

#include <algorithm>

#include "algorithms/smooth_ridges/initial_mesh.hpp"
#include "algorithms/smooth_ridges/local_graph.hpp"
#include "algorithms/smooth_ridges/refinement.hpp"
#include "algorithms/smooth_ridges/smooth_ridges.hpp"
#include "experiments/002-ridges/smooth_surfaces.hpp"
#include "experiments/peers/ridges/crest_run.hpp"
#include "experiments/program.hpp"
#include "kernel/arithmetic/self_test.hpp"

namespace crest {
namespace {

using kernel::cross, kernel::dot, kernel::norm;
using kernel::operator+, kernel::operator-, kernel::operator*;
using experiments::SmoothSurface;
using kernel::MongeForm;
using kernel::TriangleMesh;
using kernel::Vec3;
using smooth_ridges::SmoothRidges;
using smooth_ridges::Surface;

struct Options {
  std::vector<std::string> only = {"ellipsoid 1, 1.5, 2", "blend", "quartic", "bent", "genus"};
  std::vector<int> faces = {1000, 3000, 10000, 30000, 100000};
};

struct Counts {
  int plus = 0, minus = 0, other = 0;
  std::array<int, 2> loops{}, paths{};  ///< blue, red
  bool operator==(const Counts&) const = default;
};

Counts counts_of(const SmoothRidges& r) {
  Counts c;
  for (const auto& u : r.umbilics) ++(u.twice_index > 0 ? c.plus : c.minus);
  for (const auto& ridge : r.ridges)
    ++(ridge.loop ? c.loops : c.paths)[static_cast<std::size_t>(ridge.colour)];
  return c;
}

Counts counts_of(const ridges::RidgeGraph& graph) {
  const peers::CrestResult r = peers::count(graph);
  return {r.plus, r.minus, r.other, {r.blue.loops, r.red.loops}, {r.blue.segments, r.red.segments}};
}

std::string text_of(const Counts& c) {
  return fmt::format("{}, {}, {}; {} + {}; {} + {}", c.plus, c.minus, c.other, c.loops[0],
                     c.paths[0], c.loops[1], c.paths[1]);
}

/// Of an implicit surface, n = grad F / |grad F|, in double.
class MongeForms {
 public:
  explicit MongeForms(const Surface& surface) : f_(surface) {}

  MongeForm at(const Vec3& x) {
    MongeForm form;
    form.n = normal(x);
    // Any tangent frame, then the one of II's axes.
    const auto& n = form.n;
    const Vec3 axis = std::abs(n[0]) < 0.6 ? Vec3{1, 0, 0} : Vec3{0, 1, 0};
    Vec3 p = axis - dot(axis, n) * n;
    p = 1 / norm(p) * p;
    const auto rough = graph(x, p, n);
    const double xx = rough.coefficient(2, 0), xy = rough.coefficient(1, 1),
                 yy = rough.coefficient(0, 2);
    const double angle = 0.5 * std::atan2(xy, xx - yy);
    form.d1 = std::cos(angle) * p + std::sin(angle) * cross(n, p);
    const auto h = graph(x, form.d1, n);
    form.k1 = 2 * h.coefficient(2, 0), form.k2 = 2 * h.coefficient(0, 2);
    form.b0 = 6 * h.coefficient(3, 0), form.b1 = 2 * h.coefficient(2, 1);
    form.b2 = 2 * h.coefficient(1, 2), form.b3 = 6 * h.coefficient(0, 3);
    form.c0 = 24 * h.coefficient(4, 0), form.c1 = 6 * h.coefficient(3, 1);
    form.c2 = 4 * h.coefficient(2, 2), form.c3 = 6 * h.coefficient(1, 3);
    form.c4 = 24 * h.coefficient(0, 4);
    return form;
  }

 private:
  Vec3 normal(const Vec3& x) {
    const auto f = f_(x);
    const Vec3 g{f.coefficient(1, 0, 0), f.coefficient(0, 1, 0), f.coefficient(0, 0, 1)};
    return 1 / norm(g) * g;
  }
  kernel::Jet<double, 2, 4> graph(const Vec3& x, const Vec3& p, const Vec3& n) {
    return smooth_ridges::GraphJet<double, 4>::of(f_.along(x, {p, cross(n, p), n}), 2);
  }

  smooth_ridges::ImplicitMap<double, 4> f_;
};

struct Comparison {
  const SmoothSurface& surface;
  Surface smooth;
  Counts proven;

  /// Case II on a mesh of the surface.
  void row(const char* kind, const TriangleMesh& mesh) const {
    const auto fitted =
        counts_of(ridges::extract_ridge_graph(mesh, ridges::fit_monge_forms(mesh, {}).forms));
    std::string exact = " | ";
    if (smooth.is_implicit()) {
      MongeForms at(smooth);
      std::vector<MongeForm> forms;
      for (const Vec3& x : mesh.points()) forms.push_back(at.at(x));
      exact = verdict(counts_of(ridges::extract_ridge_graph(mesh, forms)));
    }
    fmt::print("| {} | {}, {} | {} | {} | {} |\n", surface.name, kind, mesh.face_count(),
               text_of(proven), verdict(fitted), exact);
    std::fflush(stdout);
  }

 private:
  std::string verdict(const Counts& c) const {
    const bool umbilics =
        c.plus == proven.plus && c.minus == proven.minus && c.other == proven.other;
    return fmt::format("{} | {}", text_of(c), c == proven ? "all" : umbilics ? "umbilics" : "no");
  }
};

void compare(const SmoothSurface& s, const Options& o) {
  const Surface surface = experiments::make_surface(s);
  const SmoothRidges certified = smooth_ridges::smooth_ridges(surface, {});
  if (!certified.certified) throw std::runtime_error(s.name + ": not certified");
  const Comparison comparison{s, surface, counts_of(certified)};
  for (const int faces : o.faces) {
    const auto mesh = smooth_ridges::initial_mesh(surface, faces);
    smooth_ridges::Places places(surface);
    std::vector<Vec3> points;
    for (const auto& v : mesh.vertices()) points.push_back(places(v));
    comparison.row("even", TriangleMesh(std::move(points), mesh.faces()));
  }
  comparison.row("certified", TriangleMesh(certified.points, certified.faces));
}

void run(const Options& o) {
  fmt::print(
      "| surface | mesh, triangles | proven | fitted forms | right | exact forms | right |\n"
      "|---|---|---|---|---|---|---|\n");
  for (const SmoothSurface& surface : experiments::generic_surfaces())
    if (std::any_of(o.only.begin(), o.only.end(), [&](const std::string& part) {
          return surface.name.find(part) != std::string::npos;
        }))
      compare(surface, o);
  fmt::print(
      "\nUmbilics of index +1/2, -1/2, other; blue loops + paths; red loops + paths. Fits with the "
      "defaults of `crest ridges`.\n\n"
      "Proven: by `crest ridges --surface` or `--param`. Even: triangulations of nearly equal "
      "edges; certified: the "
      "refined\ntriangulation of the proof, whose edges differ much in length. Exact forms are "
      "derivatives of the "
      "expression, of\nimplicit surfaces only: what is wrong with them is the mesh's doing, the "
      "rest is that of the "
      "fits.\n");
}

}  // namespace
}  // namespace crest

int main(int argc, char** argv) {
  crest::Options o;
  crest::experiments::Program program("Ridges of meshes against certified ones");
  program.option("--only", o.only, "surfaces whose name contains one of these");
  program.list("--faces", o.faces, "of the even meshes");
  return program.run(argc, argv, [&] {
    crest::kernel::require_sound_floating_point();
    crest::run(o);
    return 0;
  });
}
