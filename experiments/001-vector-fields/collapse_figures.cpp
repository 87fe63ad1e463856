// SPDX-License-Identifier: GPL-3.0-or-later
// Figures 5.11 and 5.12: a collapse that moves an unimportant critical point, one that makes two
// vanish; from the twin of the skin friction field, compressed, so that few triangles lie between.
#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <string>

#include "algorithms/sampling/planar_fields.hpp"
#include "algorithms/vector_fields/collapse_mesh.hpp"
#include "algorithms/vector_fields/compression.hpp"
#include "algorithms/vector_fields/vector_fields.hpp"
#include "experiments/program.hpp"
#include "io/vector_fields/skeleton_writer.hpp"
#include "kernel/predicates/planar_field.hpp"

namespace crest::experiments {
namespace {

using namespace vector_fields;

constexpr double kThreshold = 0.5;

bool has_zero(const kernel::FieldOnTriangle& f) {
  const kernel::Sign turn = kernel::vector_turn(f.v[0], f.v[1]);
  return turn != kernel::Sign::zero && turn == kernel::vector_turn(f.v[1], f.v[2]) &&
         turn == kernel::vector_turn(f.v[2], f.v[0]);
}

/// A compressed field in which unimportant critical points are known by their triangles.
class Figures {
 public:
  explicit Figures(const PlanarField& field)
      : small_(compress(field, {})),
        domain_(small_.field),
        boundary_(examine_boundary(domain_)),
        mesh_(domain_, boundary_),
        weight_(mesh_.triangle_count(), -1) {
    const Importance weights = weigh(field, smoothed(field, Laplacian::uniform), small_.before);
    std::map<kernel::Vec2, double> by_place;
    for (std::size_t z = 0; z < weights.zeros.size(); ++z)
      by_place[small_.before.critical_points[z].point] = weights.zeros[z].weight;
    for (const CriticalPoint& c : small_.after.critical_points)
      if (c.where == ZeroPlace::triangle) weight_[c.simplex] = by_place.at(c.point);
  }

  /// Draws the first collapse after which of so many unimportant points so many are left.
  bool draw(const std::string& path, std::size_t before, std::size_t after) {
    Collapse plan;
    for (HalfEdge h = 0; h < 3 * mesh_.triangle_count(); ++h) {
      const Index from = mesh_.from(h), to = mesh_.to(h);
      if (mesh_.plan(from, to, plan) != CollapseRefusal::none || !fits(plan, before, after))
        continue;
      const io::PlaneWindow window = around(plan);
      mesh_.apply(plan);
      std::vector<Index> vertices;
      const PlanarField collapsed = mesh_.field(vertices);
      mesh_.undo();
      const Skeleton skeleton = extract_skeleton(collapsed);
      io::write_comparison_picture(path, {&small_.field, &small_.after, {}, window},
                                   {&collapsed, &skeleton});
      fmt::print("{}: vertex {} onto {}, {} of {} critical points left\n", path, from, to,
                 skeleton.critical_points.size(), small_.after.critical_points.size());
      return true;
    }
    fmt::print("{}: there is none\n", path);
    return false;
  }

 private:
  bool fits(const Collapse& plan, std::size_t before, std::size_t after) const {
    std::size_t old = 0, now = 0;
    for (const Index t : plan.star) {
      if (weight_[t] >= kThreshold) return false;
      if (weight_[t] >= 0) ++old;
      if (t != plan.gone[0] && t != plan.gone[1] && has_zero(mesh_.data(t, plan.from, plan.to)))
        ++now;
    }
    return old == before && now == after;
  }
  io::PlaneWindow around(const Collapse& plan) const {
    io::PlaneWindow w{mesh_.point(plan.from), mesh_.point(plan.from)};
    for (const Index t : plan.star)
      for (const auto& p : mesh_.data(t).p)
        for (std::size_t k = 0; k < 2; ++k) {
          w.low[k] = std::min(w.low[k], p[k]);
          w.high[k] = std::max(w.high[k], p[k]);
        }
    const double margin = std::max(w.high[0] - w.low[0], w.high[1] - w.low[1]) / 3;
    for (std::size_t k = 0; k < 2; ++k) {
      w.low[k] -= margin;
      w.high[k] += margin;
    }
    return w;
  }

  Compression small_;
  Domain domain_;
  Boundary boundary_;
  CollapseMesh mesh_;
  std::vector<double> weight_;  ///< of the critical point in a triangle; none: -1
};

}  // namespace
}  // namespace crest::experiments

int main(int argc, char** argv) {
  std::string folder = ".";
  crest::experiments::Program program("Collapses of unimportant critical points, as pictures.");
  program.option("--folder", folder, "where they go");
  return program.run(argc, argv, [&] {
    const auto sample = crest::sampling::twin_skin();
    crest::experiments::Figures figures({sample.points, sample.vectors, sample.triangles});
    const bool moved = figures.draw(folder + "/figure-5.11.png", 1, 1);
    return figures.draw(folder + "/figure-5.12.png", 2, 0) && moved ? 0 : 1;
  });
}
