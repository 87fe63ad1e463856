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
constexpr double kNearly = 5;  ///< slack (io/picture/drawing.hpp) of what is nearly seen

/// Tells which points the eye can see.
class Sight {
 public:
  Sight(const Camera& camera, const Canvas& surface, const kernel::TriangleMesh& mesh,
        const std::vector<Vec3>& normals)
      : camera_(camera), surface_(surface), mesh_(mesh), normals_(normals), outward_(side(mesh)) {}

  bool free(const Vec3& pixel, double slack = 1) const {
    return in_sight(camera_, surface_, pixel, slack);
  }

  /// The back of a closed surface is hidden even where the bias does not tell, at its outline.
  bool faces_eye(kernel::Index v, kernel::Index w, double most = 0.1) const {
    if (!mesh_.closed()) return true;
    const Vec3 n = combine(1, normals_[v], 1, normals_[w]);
    const Vec3 unit = normalised(n, combine(-1, camera_.forward, 0, n));
    return outward_ * dot(unit, camera_.forward) < most;
  }
  bool faces_eye(const ridges::Crossing& crossing, double most = 0.1) const {
    const kernel::Edge& e = mesh_.edges()[crossing.edge];
    return faces_eye(e.v0, e.v1, most);
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

enum class Seen : std::uint8_t { no, nearly, yes };

/// Nearly: a little behind what hides it.
Seen seen(const Sight& sight, const LinePoint& p) {
  constexpr double kTurned = 0.6;
  if (p.spur) return Seen::no;
  const Vec3 pixel = sight.camera().project(p.point);
  if ((p.crossing == nullptr || sight.faces_eye(*p.crossing)) && sight.free(pixel))
    return Seen::yes;
  const bool turned = p.crossing != nullptr && !sight.faces_eye(*p.crossing, kTurned);
  return !turned && sight.free(pixel, kNearly) ? Seen::nearly : Seen::no;
}

/// Calls visit(first, end) for the runs of numbers below n with in(i).
template <class In, class Visit>
void for_runs(std::size_t n, const In& in, const Visit& visit) {
  for (std::size_t i = 0, end = 0; i < n; i = end + 1) {
    for (end = i; end < n && in(end);) ++end;
    if (end > i) visit(i, end);
  }
}

/// Which points of a line a picture by salience draws. At an outline a line weaves in and out of
/// sight: short stretches that are nearly seen are drawn, glimpses are not.
std::vector<bool> points_in_sight(const Sight& sight, const std::vector<LinePoint>& line) {
  constexpr double kBridge = 0.03, kGlimpse = 0.012;  // of the picture's width
  const std::size_t n = line.size();
  std::vector<Seen> state;
  std::vector<double> place = {0};
  for (const LinePoint& p : line) state.push_back(seen(sight, p));
  for (std::size_t i = 1; i < n; ++i) {
    const Vec3 way = combine(1, sight.camera().project(line[i].point), -1,
                             sight.camera().project(line[i - 1].point));
    place.push_back(place.back() + std::hypot(way[0], way[1]) / sight.camera().width);
  }
  std::vector<bool> drawn(n);
  for (std::size_t i = 0; i < n; ++i) drawn[i] = state[i] == Seen::yes;
  for_runs(
      n, [&](std::size_t i) { return state[i] == Seen::nearly; },
      [&](std::size_t first, std::size_t end) {
        if (first > 0 && end < n && drawn[first - 1] && drawn[end] &&
            place[end] - place[first - 1] < kBridge)
          std::fill_n(drawn.begin() + static_cast<std::ptrdiff_t>(first), end - first, true);
      });
  for_runs(
      n, [&](std::size_t i) { return drawn[i]; },
      [&](std::size_t first, std::size_t end) {
        if ((first > 0 || end < n) && place[end - 1] - place[first] < kGlimpse)
          std::fill_n(drawn.begin() + static_cast<std::ptrdiff_t>(first), end - first, false);
      });
  return drawn;
}

/// Those of a picture of the whole graph.
std::vector<bool> points_facing(const Sight& sight, const std::vector<LinePoint>& line) {
  std::vector<bool> drawn;
  for (const LinePoint& p : line)
    drawn.push_back(p.crossing == nullptr || sight.faces_eye(*p.crossing));
  return drawn;
}

/// The ridges' strokes.
void add_strokes(const Sight& sight, const Canvas& surface, const ridges::RidgeGraph& graph,
                 const std::vector<std::vector<LinePoint>>& lines, const PictureOptions& options,
                 Drawing& drawing) {
  const std::size_t full = options.by_salience ? kRidgeClasses : 0;
  StrokeMaker maker(sight.camera(), surface, drawing, options.by_salience ? kNearly : 1);
  for (std::size_t r = 0; r < lines.size(); ++r) {
    const ridges::Ridge& ridge = graph.ridges[r];
    const std::vector<LinePoint>& line = lines[r];
    const std::vector<bool> drawn =
        options.by_salience ? points_in_sight(sight, line) : points_facing(sight, line);
    const std::size_t n = line.size();
    for (std::size_t i = 0; i + (ridge.loop ? 0 : 1) < n; ++i) {
      const LinePoint& next = line[(i + 1) % n];
      const std::size_t stroke_class = segment_class(ridge, line[i], next, options);
      drawing.classes[stroke_class % kRidgeClasses + full].in_graph = true;
      if (drawn[i] && drawn[(i + 1) % n])
        maker.add(line[i].point, next.point, stroke_class);
      else
        maker.end();
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

std::vector<std::vector<LinePoint>> shown_lines(const kernel::TriangleMesh& mesh,
                                                const std::vector<Vec3>& normals,
                                                const ridges::RidgeGraph& graph,
                                                const PictureOptions& options) {
  if (options.by_salience)
    return drawn_lines(mesh, normals, graph, options.spur, options.full_level);
  std::vector<std::vector<LinePoint>> lines;
  for (const ridges::Ridge& ridge : graph.ridges) lines.push_back(line_points(ridge));
  return lines;
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
  add_strokes(sight, surface, graph, shown_lines(mesh, normals, graph, options), options, drawing);
  const std::vector<ridges::Umbilic> umbilics = shown_umbilics(graph, options);
  add_dots(sight, umbilics, drawing);
  set_sizes(camera, drawing);
  add_legend(umbilics, options, drawing);
  return drawing;
}

}  // namespace crest::io
