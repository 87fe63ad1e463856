// SPDX-License-Identifier: GPL-3.0-or-later
// How often the acute rule errs (paper 002, definition 3), proven: every edge of an even
// triangulation of a smooth surface is oriented by the sign of d1(p).d1(q), and by continuity along
// the chain of edges into which certification bisects it.
//
// On a certified face S(w) > 0 (certify/ridges_smooth/SPEC.md): d1 stays within 45 degrees of w, so
// w orients d1 at both ends of an edge by continuity along it. Chains that meet an umbilic's patch,
// or a face that is not certified, are undecided.
#include <fmt/format.h>

#include <map>

#include "algorithms/smooth_ridges/directions.hpp"
#include "algorithms/smooth_ridges/forms.hpp"
#include "algorithms/smooth_ridges/initial_mesh.hpp"
#include "algorithms/smooth_ridges/refinement.hpp"
#include "experiments/002-ridges/smooth_surfaces.hpp"
#include "experiments/program.hpp"
#include "kernel/arithmetic/self_test.hpp"

namespace crest {
namespace {

using kernel::Index;
using kernel::Vec3;
using smooth_ridges::Surface;
using smooth_ridges::Triangulation;
using smooth_ridges::Vertex;

struct Options {
  std::vector<std::string> surfaces = {"ellipsoid 1, 1.5, 2", "perturbed quartic",
                                       "bent torus, implicit", "genus 2"};
  std::vector<int> faces = {300, 1000, 3000, 10000, 30000};
};

using Edge = std::array<Index, 2>;  ///< the smaller index first
Edge edge_of(Index a, Index b) {
  return {std::min(a, b), std::max(a, b)};
}

/// A start triangulation that keeps in mind which vertex bisects which edge.
class Bisections {
 public:
  explicit Bisections(const Surface& surface, int faces) {
    const Triangulation start = smooth_ridges::initial_mesh(surface, faces);
    vertices_ = start.vertices().size();
    for (Index v = 0; v < vertices_; ++v) number_[start.vertices()[v]] = v;
    smooth_ridges::EdgeRules rules = smooth_ridges::edge_rules(surface);
    rules.place = [this, place = rules.place](const Vertex& a, const Vertex& b) {
      const Vertex middle = place(a, b);
      const auto fresh = static_cast<Index>(number_.size());
      if (!number_.emplace(middle, fresh).second) throw std::runtime_error("a vertex twice");
      middle_[edge_of(number_.at(a), number_.at(b))] = fresh;
      return middle;
    };
    start_ = Triangulation(start.vertices(), start.faces(), start.lifts(), rules);
  }
  const Triangulation& start() const { return start_; }
  std::size_t start_vertices() const { return vertices_; }
  /// The vertices from a to b, without a.
  void follow(Index a, Index b, std::vector<Index>& chain) const {
    const auto at = middle_.find(edge_of(a, b));
    if (at == middle_.end()) return chain.push_back(b);
    follow(a, at->second, chain);
    follow(at->second, b, chain);
  }

 private:
  std::size_t vertices_ = 0;
  std::map<Vertex, Index> number_;
  std::map<Edge, Index> middle_;
  Triangulation start_;
};

/// d1 at vertices, oriented by the certified faces around them.
class Directions {
 public:
  Directions(const Surface& surface, const smooth_ridges::RefinedSurface& refined)
      : f_(surface), refined_(refined) {
    const auto& faces = refined.mesh.faces();
    std::vector<bool> certified(faces.size());
    for (Index f = 0; f < faces.size(); ++f) certified[f] = refined.patch_of[f] == kernel::kNone;
    for (const auto& cell : refined.uncertified) certified[cell.face] = false;
    for (Index f = 0; f < faces.size(); ++f)
      if (certified[f])
        for (std::size_t i = 0; i < 3; ++i) face_[edge_of(faces[f][i], faces[f][(i + 1) % 3])] = f;
  }
  /// d1 at both ends of an edge, oriented by continuity along it; nothing if that is not certified.
  std::optional<std::array<Vec3, 2>> along(Index a, Index b) {
    const auto at = face_.find(edge_of(a, b));
    if (at == face_.end()) return std::nullopt;
    return std::array{oriented(a, at->second), oriented(b, at->second)};
  }

 private:
  /// v1 = w + A w / sigma, in space.
  Vec3 oriented(Index v, Index face) {
    using namespace smooth_ridges;
    const auto& result = refined_.faces[face];
    const auto frame = frame_vectors(result.frame);
    const auto jet =
        GraphJet<double, 2>::of(f_.along(position(refined_.mesh.vertices()[v]), frame), 2);
    const GraphGeometry<double, 2> geometry{jet};
    const auto w = direction(result.w);
    const auto shape = shape_of(geometry.first<0>(), geometry.second<0>());
    const auto v1 = first_principal(times(shape, w), sqrt(squared_sigma(shape)), w);
    const double p = v1[0][0], q = v1[1][0];
    const double m = p * jet.coefficient(1, 0) + q * jet.coefficient(0, 1);
    Vec3 d;
    for (std::size_t k = 0; k < 3; ++k) d[k] = p * frame[0][k] + q * frame[1][k] + m * frame[2][k];
    return d;
  }

  smooth_ridges::ImplicitMap<double, 2> f_;
  const smooth_ridges::RefinedSurface& refined_;
  std::map<Edge, Index> face_;
};

struct Counts {
  int edges = 0, decided = 0, whole = 0, failed = 0;
};

/// One edge of the start triangulation.
void compare(const Bisections& bisections, Directions& directions, Index a, Index b, Counts& c) {
  ++c.edges;
  std::vector<Index> chain;
  bisections.follow(a, b, chain);
  Vec3 first{}, d{};
  for (std::size_t i = 0; i < chain.size(); ++i) {
    auto ends = directions.along(i == 0 ? a : chain[i - 1], chain[i]);
    if (!ends) return;
    if (i == 0) first = (*ends)[0];
    // The same line at a vertex shared by two faces: their products are far from zero.
    const bool turned = i > 0 && kernel::dot(d, (*ends)[0]) < 0;
    d = (*ends)[1];
    if (turned)
      for (double& x : d) x = -x;
  }
  ++c.decided;
  c.whole += chain.size() == 1;
  // By continuity `first` goes with d: the acute rule errs if their product is not positive.
  c.failed += !(kernel::dot(first, d) > 0);
}

void row(const experiments::SmoothSurface& s, int faces) {
  const Surface surface = experiments::make_surface(s);
  const Bisections bisections(surface, faces);
  const auto refined = smooth_ridges::refine(surface, bisections.start(), {});
  Directions directions(surface, refined);
  Counts c;
  for (const auto& face : bisections.start().faces())
    for (std::size_t i = 0; i < 3; ++i)
      // On a closed surface every edge is met once each way.
      if (face[i] < face[(i + 1) % 3])
        compare(bisections, directions, face[i], face[(i + 1) % 3], c);
  fmt::print("| {} | {} | {} | {} | {} | {} | {} | {} |\n", s.name,
             bisections.start().faces().size(), refined.mesh.faces().size(),
             refined.uncertified.size(), c.edges, c.edges - c.decided, c.decided - c.whole,
             c.failed);
  std::fflush(stdout);
}

void run(const Options& o) {
  fmt::print(
      "| surface | triangles | of them certified after bisections | uncertified | edges | "
      "undecided "
      "| decided along a chain | failures |\n|---|---|---|---|---|---|---|---|\n");
  for (const auto& surface : experiments::generic_surfaces())
    for (const std::string& name : o.surfaces)
      if (surface.name == name)
        for (const int faces : o.faces) row(surface, faces);
  fmt::print(
      "\nTriangles: of the even triangulation, and after the bisections that certify it. "
      "Undecided: the chain of an "
      "edge\nmeets an umbilic's patch. Chain: the edge is bisected at least once. Failures: the "
      "sign of d1(p).d1(q) "
      "is not that of\nthe proven orientation by continuity along the chain.\n");
}

}  // namespace
}  // namespace crest

int main(int argc, char** argv) {
  crest::Options o;
  crest::experiments::Program program("Failures of the acute rule against certified orientations");
  program.option("--surfaces", o.surfaces, "implicit ones, by name");
  program.list("--faces", o.faces, "of the even triangulations");
  return program.run(argc, argv, [&] {
    crest::kernel::require_sound_floating_point();
    crest::run(o);
    return 0;
  });
}
