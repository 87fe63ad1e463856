// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/ridges/ridge_drawing.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "io/ridges/drawn_lines.hpp"

namespace crest::io {
namespace {

using kernel::Vec3;
using ridges::RidgeType;
using ridges::UmbilicKind;

constexpr Rgb kGrey = {128, 128, 128};

/// Tells which points the eye can see.
class Sight {
 public:
  Sight(const Camera& camera, const Canvas& surface, const kernel::TriangleMesh& mesh,
        const std::vector<Vec3>& normals)
      : camera_(camera), surface_(surface), mesh_(mesh), normals_(normals), outward_(side(mesh)) {}

  bool free(const Vec3& pixel) const { return in_sight(camera_, surface_, pixel); }

  /// The back of a closed surface is hidden even where the bias does not tell, at its outline.
  bool faces_eye(kernel::Index v, kernel::Index w) const {
    if (!mesh_.closed()) return true;
    const Vec3 n = combine(1, normals_[v], 1, normals_[w]);
    return outward_ * dot(normalised(n, combine(-1, camera_.forward, 0, n)), camera_.forward) < 0.1;
  }
  bool faces_eye(const ridges::Crossing& crossing) const {
    const kernel::Edge& e = mesh_.edges()[crossing.edge];
    return faces_eye(e.v0, e.v1);
  }
  bool faces_eye(const ridges::Umbilic& umbilic) const {
    const kernel::Triangle& f = mesh_.faces()[umbilic.face];
    return faces_eye(f[0], f[1]);
  }
  const Camera& camera() const { return camera_; }

 private:
  /// 1 if the normals point out of a closed mesh, -1 if into it: the sign of its volume.
  static double side(const kernel::TriangleMesh& mesh) {
    double volume = 0;
    const Vec3& o = mesh.points()[0];
    for (const kernel::Triangle& f : mesh.faces()) {
      Vec3 e[3];
      for (std::size_t k = 0; k < 3; ++k) e[k] = combine(1, mesh.points()[f[k]], -1, o);
      volume += e[0][0] * (e[1][1] * e[2][2] - e[1][2] * e[2][1]) +
                e[0][1] * (e[1][2] * e[2][0] - e[1][0] * e[2][2]) +
                e[0][2] * (e[1][0] * e[2][1] - e[1][1] * e[2][0]);
    }
    return volume < 0 ? -1 : 1;
  }

  const Camera& camera_;
  const Canvas& surface_;
  const kernel::TriangleMesh& mesh_;
  const std::vector<Vec3>& normals_;
  double outward_;
};

/// The ridges' strokes.
template <class LineOf>
void add_strokes(const Sight& sight, const Canvas& surface, const ridges::RidgeGraph& graph,
                 const LineOf& line_of, const PictureOptions& options, Drawing& drawing) {
  const std::size_t full = options.by_salience ? kRidgeClasses : 0;
  StrokeMaker maker(sight.camera(), surface, drawing);
  const auto hidden = [&](const LinePoint& p) {
    return p.crossing != nullptr && !sight.faces_eye(*p.crossing);
  };
  for (const ridges::Ridge& ridge : graph.ridges) {
    const std::vector<LinePoint> line = line_of(ridge);
    const std::size_t n = line.size();
    for (std::size_t i = 0; i + (ridge.loop ? 0 : 1) < n; ++i) {
      const LinePoint& next = line[(i + 1) % n];
      const std::size_t stroke_class = segment_class(ridge, line[i], next, options);
      drawing.classes[stroke_class % kRidgeClasses + full].in_graph = true;
      if (line[i].spur || next.spur || hidden(line[i]) || hidden(next))
        maker.end();
      else
        maker.add(line[i].point, next.point, stroke_class);
    }
    maker.end();
  }
}

/// Umbilics that stand for a region of non-zero index.
std::vector<ridges::Umbilic> significant_umbilics(const ridges::RidgeGraph& graph) {
  std::vector<ridges::Umbilic> umbilics;
  for (const ridges::Umbilic& u : graph.umbilics)
    if (u.region_twice_index != 0) umbilics.push_back(u);
  return umbilics;
}

/// Umbilics at which a ridge of the graph ends: filters take the others' ridges away.
std::vector<ridges::Umbilic> joined_umbilics(const ridges::RidgeGraph& graph) {
  std::vector<bool> joined(graph.umbilics.size(), false);
  for (const ridges::Ridge& ridge : graph.ridges)
    for (const ridges::RidgeEnd& end : ridge.ends)
      if (end.kind == ridges::EndKind::umbilic) joined[end.umbilic] = true;
  std::vector<ridges::Umbilic> umbilics;
  for (std::size_t i = 0; i < joined.size(); ++i)
    if (joined[i]) umbilics.push_back(graph.umbilics[i]);
  return umbilics;
}

void add_dots(const Sight& sight, const std::vector<ridges::Umbilic>& umbilics, Drawing& drawing) {
  for (const ridges::Umbilic& umbilic : umbilics) {
    const Vec3 pixel = sight.camera().project(umbilic.point);
    if (sight.faces_eye(umbilic) && sight.free(pixel))
      drawing.dots.push_back(is_region(umbilic) ? Dot{pixel, kGrey, Mark::diamond}
                                                : Dot{pixel, dot_colour(umbilic.kind)});
  }
}

void add_legend(const std::vector<ridges::Umbilic>& umbilics, const PictureOptions& options,
                Drawing& drawing) {
  add_class_legend(drawing);
  const bool thin = std::any_of(drawing.classes.begin(), drawing.classes.end(),
                                [](const auto& c) { return c.width < 1 && !c.strokes.empty(); });
  if (thin) drawing.legend.push_back({"thin, not salient", {200, 200, 200}, false});
  const std::pair<UmbilicKind, const char*> kinds[] = {
      {UmbilicKind::one_ridge, "umbilic, 1-ridge"},
      {UmbilicKind::three_ridge, "umbilic, 3-ridge"},
      {UmbilicKind::degenerate, "umbilic, degenerate"}};
  for (const auto& [kind, label] : kinds) {
    const bool present = std::any_of(umbilics.begin(), umbilics.end(), [&](const auto& umbilic) {
      return umbilic.kind == kind && !is_region(umbilic);
    });
    if (present) drawing.legend.push_back({label, dot_colour(kind), true});
  }
  if (std::any_of(umbilics.begin(), umbilics.end(), is_region))
    drawing.legend.push_back({"umbilic region", kGrey, true, Mark::diamond});
  add_note(options.note, drawing);
}

/// Length of the elliptic ridges that face the eye, weighted by their curvature: features count,
/// ripples hardly.
double facing_strength(const kernel::TriangleMesh& mesh, const std::vector<Vec3>& normals,
                       const ridges::RidgeGraph& graph, const Vec3& view) {
  double sum = 0;
  for (const ridges::Ridge& ridge : graph.ridges) {
    for (std::size_t i = 0; i + 1 < ridge.crossings.size(); ++i) {
      const ridges::Crossing& c = ridge.crossings[i];
      const kernel::Edge& e = mesh.edges()[c.edge];
      if (c.type != ridges::RidgeType::elliptic || dot(normals[e.v0], view) >= 0) continue;
      const Vec3 d = combine(1, ridge.crossings[i + 1].point, -1, c.point);
      sum += std::abs(ridge.colour == ridges::Colour::blue ? c.k1 : c.k2) * std::sqrt(dot(d, d));
    }
  }
  return sum;
}

}  // namespace

std::vector<StrokeClass> ridge_classes() {
  return {
      {"red, flat", kGrey, {}},
      {"red hyperbolic", {250, 208, 20}, {}},
      {"red turning", {240, 128, 24}, {}},
      {"red elliptic", {218, 26, 32}, {}},
      {"blue, flat", kGrey, {}},
      {"blue hyperbolic", {22, 158, 60}, {}},
      {"blue turning", {24, 140, 160}, {}},
      {"blue elliptic", {28, 70, 222}, {}},
  };
}

std::size_t ridge_class(kernel::Colour colour, RidgeType type) {
  constexpr std::array<std::size_t, 4> place = {0, 3, 1, 2};  // none, elliptic, hyperbolic, turning
  return place[static_cast<std::size_t>(type)] + (colour == kernel::Colour::blue ? 4 : 0);
}

Rgb dot_colour(UmbilicKind kind) {
  if (kind == UmbilicKind::one_ridge) return {255, 255, 255};
  if (kind == UmbilicKind::three_ridge) return {0, 0, 0};
  return kGrey;
}

std::vector<StrokeClass> classes_by_salience() {
  std::vector<StrokeClass> classes = ridge_classes();
  const std::vector<StrokeClass> full = classes;
  const auto paler = [](std::uint8_t c) { return static_cast<std::uint8_t>((c + 255) / 2); };
  for (StrokeClass& c : classes) {
    c.width = 1.0 / 3;
    c.colour = {paler(c.colour.red), paler(c.colour.green), paler(c.colour.blue)};
  }
  classes.insert(classes.end(), full.begin(), full.end());
  return classes;
}

bool is_region(const ridges::Umbilic& u) {
  return u.region_twice_index != 0 && u.level == 0;
}

std::vector<LinePoint> shown_line(const kernel::TriangleMesh& mesh,
                                  const std::vector<Vec3>& normals, const ridges::Ridge& ridge,
                                  const PictureOptions& options) {
  return options.by_salience ? drawn_line(mesh, normals, ridge, options.spur, options.full_level)
                             : line_points(ridge);
}

std::size_t segment_class(const ridges::Ridge& ridge, const LinePoint& from, const LinePoint& to,
                          const PictureOptions& options) {
  const bool full = std::min(from.level, to.level) >= options.full_level;
  const RidgeType type = options.order == 3 ? from.third_order : from.fourth_order;
  return ridge_class(ridge.colour, type) + (options.by_salience && full ? kRidgeClasses : 0);
}

std::vector<ridges::Umbilic> shown_umbilics(const ridges::RidgeGraph& graph,
                                            const PictureOptions& options) {
  return options.by_salience ? significant_umbilics(graph) : joined_umbilics(graph);
}

ViewScore view_score(const kernel::TriangleMesh& mesh, const std::vector<Vec3>& normals,
                     const ridges::RidgeGraph& graph) {
  if (graph.ridges.empty()) return {};
  return [&](const Vec3& view) { return facing_strength(mesh, normals, graph, view); };
}

Drawing make_drawing(const Camera& camera, const Canvas& surface, const kernel::TriangleMesh& mesh,
                     const std::vector<Vec3>& normals, const ridges::RidgeGraph& graph,
                     const PictureOptions& options) {
  Drawing drawing{};
  drawing.classes = options.by_salience ? classes_by_salience() : ridge_classes();
  const Sight sight(camera, surface, mesh, normals);
  const auto line_of = [&](const ridges::Ridge& ridge) {
    return shown_line(mesh, normals, ridge, options);
  };
  add_strokes(sight, surface, graph, line_of, options, drawing);
  const std::vector<ridges::Umbilic> umbilics = shown_umbilics(graph, options);
  add_dots(sight, umbilics, drawing);
  set_sizes(camera, drawing);
  add_legend(umbilics, options, drawing);
  return drawing;
}

}  // namespace crest::io
