// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/line_art/line_art.hpp"

#include <algorithm>
#include <cmath>

#include "algorithms/line_art/face_locator.hpp"
#include "algorithms/line_art/fishbone.hpp"
#include "algorithms/line_art/steering.hpp"

namespace crest::line_art {
namespace {

using kernel::dot, kernel::norm;
using kernel::operator+, kernel::operator-, kernel::operator*;

/// A mm of the page in the mesh's units, in perspective at the middle of the scene.
double unit_of(const View& view, const Scene& scene) {
  if (!view.eye.finite) return 1 / view.scale;
  double depth = 0;
  for (const Vec3& p : scene.points) depth -= view.see(p).near;
  return depth / static_cast<double>(scene.points.size()) / view.scale;
}

/// Those that the eye sees, on the page.
std::vector<Vec2> seen_singularities(const kernel::TriangleMesh& mesh, const DirectionField& field,
                                     const View& view, const Buffers& b) {
  std::vector<Vec2> seen;
  for (const Index f : field.singular) {
    const kernel::Triangle& t = mesh.faces()[f];
    const auto& p = mesh.points();
    const Vec3 middle = (1.0 / 3) * (p[t[0]] + p[t[1]] + p[t[2]]);
    const Vec2 place = view.project(middle);
    const auto at = b.at(place);
    const double near = view.see(middle).near;
    const double slack = 3 * b.pixel / view.scale * (view.eye.finite ? -near : 1);
    if (at && b.face[*at] != kNone && near > static_cast<double>(b.near[*at]) - slack)
      seen.push_back(place);
  }
  return seen;
}

/// Of a cross's two directions the one nearest to the line field comes first: it has the ribs.
void align(const kernel::TriangleMesh& mesh, const std::vector<PrincipalFrame>& frames,
           FieldOptions options, DirectionField& field) {
  options.cross = false;
  const DirectionField lines = direction_field(mesh, frames, options);
  for (Index v = 0; v < mesh.vertex_count(); ++v) {
    Vec3& d = field.direction[v];
    const Vec3 turned = kernel::cross(frames[v].n, d);
    if (std::abs(dot(turned, lines.direction[v])) > std::abs(dot(d, lines.direction[v])))
      d = turned;
  }
}

/// Where the first layer runs along the backbones these become its ribs, so that the second crosses
/// it.
void follow_first_layer(const std::vector<Hatch>& hatches, const OwnedArea& owned, Buffers& b) {
  for (std::size_t k = 0; k < b.size(); ++k) {
    const auto [h, v] = owned.owner[k];
    if (h == kNone) continue;
    const auto& p = hatches[h].stroke.points;
    const Vec2 d = p[std::min<std::size_t>(v + 1, p.size() - 1)] - p[v > 0 ? v - 1 : 0];
    const auto along = [&](const std::array<float, 2>& x) {
      return std::abs(static_cast<double>(x[0]) * d[0] + static_cast<double>(x[1]) * d[1]);
    };
    if (along(b.backbone[k]) > along(b.rib[k])) std::swap(b.rib[k], b.backbone[k]);
  }
}

/// The face where each hatch begins; what begins on a side begins a point later.
void name_faces(const Drawing& drawing, std::vector<Hatch>& hatches) {
  const FaceLocator locator(drawing.scene, drawing.view);
  std::vector<Hatch> kept;
  for (Hatch& h : hatches) {
    Stroke& s = h.stroke;
    std::size_t first = 0;
    std::optional<Index> face;
    for (; first + 2 < s.points.size() && !face; ++first) face = locator.at(s.points[first]);
    if (!face) continue;
    const auto skipped = static_cast<std::ptrdiff_t>(first - 1);
    s.points.erase(s.points.begin(), s.points.begin() + skipped);
    if (!s.widths.empty()) s.widths.erase(s.widths.begin(), s.widths.begin() + skipped);
    s.face = *face;
    kept.push_back(std::move(h));
  }
  hatches = std::move(kept);
}

/// Ends at contours run along them.
void cut_ends(const Barriers& barriers, std::vector<Hatch>& hatches) {
  constexpr double kReach = 0.2;  // mm
  for (Hatch& h : hatches) {
    const auto direction = [&](const Vec2& p) {
      const auto near = barriers.nearest(p, kReach);
      return near ? near->direction : Vec2{0, 0};
    };
    if (!h.free_start) h.stroke.start_cut = direction(h.stroke.points.front());
    if (!h.free_end) h.stroke.end_cut = direction(h.stroke.points.back());
  }
}

void make_strokes(const Tracer& tracer, const HatchOptions& options, Drawing& drawing,
                  std::vector<Hatch>& first) {
  const ToneOptions& tone = options.tone;
  if (options.tone_style == ToneStyle::length) {
    first = random_streamlines(tracer, tone.brightest, 0.35 * tone.spacing);
    return;
  }
  if (options.style == HatchStyle::fishbone) {
    Fishbones bones = make_fishbones(tracer, tone.brightest, options.steering.segments);
    drawing.counts.segments = bones.segments.size();
    drawing.counts.key_ribs = bones.key_ribs;
    drawing.counts.blended = bones.blended;
    drawing.segments = std::move(bones.segments);
    first = std::move(bones.ribs);
  }
  // Alone, or in what the fishbones left.
  add_even_streamlines(tracer, tone.brightest, Family::rib, first);
  fill_gaps(tracer, tone.brightest, Family::rib, first);
}

/// Of the first layer.
void measure(const Buffers& b, const std::vector<float>& ink, const std::vector<Hatch>& hatches,
             const OwnedArea& owned, double spacing, HatchCounts& counts) {
  std::vector<double> lengths, spacings;
  for (std::size_t h = 0; h < owned.spacing.size(); ++h)
    spacings.insert(spacings.end(), owned.spacing[h].begin(), owned.spacing[h].end());
  for (const Hatch& h : hatches) lengths.push_back(h.stroke.length());
  const auto quantile = [](std::vector<double>& x, double q) {
    if (x.empty()) return 0.0;
    const auto k = static_cast<std::ptrdiff_t>(q * static_cast<double>(x.size() - 1));
    std::nth_element(x.begin(), x.begin() + k, x.end());
    return x[static_cast<std::size_t>(k)];
  };
  counts.p5 = quantile(spacings, 0.05);
  counts.median = quantile(spacings, 0.5);
  counts.p95 = quantile(spacings, 0.95);
  counts.median_length = quantile(lengths, 0.5);
  double wanted = 0, bare = 0;
  for (std::size_t k = 0; k < b.size(); ++k) {
    if (ink[k] == 0) continue;
    ++wanted;
    const auto [h, v] = owned.owner[k];
    bare += h == kNone || norm(b.centre(k) - hatches[h].stroke.points[v]) > spacing;
  }
  counts.bare = wanted > 0 ? bare / wanted : 0;
}

void count_over_contours(const Barriers& barriers, Drawing& drawing) {
  for (const Stroke& s : drawing.hatches) {
    drawing.counts.length += s.length();
    bool over = false;
    for (std::size_t i = 1; i < s.points.size(); ++i)
      over = over || barriers.crosses(s.points[i - 1], s.points[i]);
    drawing.counts.over_contours += over;
  }
}

/// `unit`: a millimetre of the page in the mesh's units.
FieldOptions field_options(const HatchOptions& options, const View& view, double unit) {
  const double spacing = options.tone.spacing;
  FieldOptions o;
  o.cross = options.cross_field;
  o.spacing = spacing * unit;
  o.smooth = options.smooth * spacing * unit;
  // The page's up, tilted to the right and towards the eye.
  o.axis = 0.35 * view.x + 0.85 * view.y + (-0.4) * view.z;
  o.crease = options.crease;
  return o;
}

}  // namespace

void add_hatches(Drawing& drawing, const kernel::TriangleMesh& mesh,
                 const std::vector<PrincipalFrame>& frames, const HatchOptions& options,
                 const Phase& phase) {
  drawing.regions = options.steering.regions;
  const View& view = drawing.view;
  const double spacing = options.tone.spacing;
  DirectionField field;
  phase("field", [&] {
    const FieldOptions o = field_options(options, view, unit_of(view, drawing.scene));
    field = direction_field(mesh, frames, o);
    if (o.cross) align(mesh, frames, o, field);
  });
  drawing.counts.singularities = field.singular.size();
  drawing.counts.index_sum = static_cast<double>(field.index_sum) / field.symmetry;
  const Barriers barriers(drawing.scene, view, drawing.contours);
  Buffers buffers;
  phase("buffers", [&] {
    buffers = fill_buffers({mesh, frames, field}, view, barriers, options.light, options.crease);
    if (options.look) options.look(buffers);
    steer(options.steering.regions, buffers);
  });
  std::vector<Hatch> first, second;
  OwnedArea owned;
  phase("strokes", [&] {
    const auto singular = seen_singularities(mesh, field, view, buffers);
    make_strokes({buffers, barriers, singular, spacing, options.cross_field}, options, drawing,
                 first);
    name_faces(drawing, first);
    owned = owned_area(buffers, first, 1.5 * spacing);
    if (!options.cross_hatch) return;
    if (options.cross_field) follow_first_layer(first, owned, buffers);
    // Where the families change places its lines end, or they would run along the first.
    const Tracer across(buffers, barriers, singular, spacing, false);
    add_even_streamlines(across, options.tone.darkest, Family::backbone, second);
    fill_gaps(across, options.tone.darkest, Family::backbone, second);
    name_faces(drawing, second);
  });
  // What tone is made of is what will be painted.
  for (std::vector<Hatch>* layer : {&first, &second}) cut_ends(barriers, *layer);
  phase("tone", [&] {
    const ToneOptions& tone = options.tone;
    const bool bands = options.tone_style == ToneStyle::bands;
    const std::vector<float> ink = layer_ink(buffers, tone);
    measure(buffers, ink, first, owned, spacing, drawing.counts);  // before bands change the order
    const std::vector<float> second_ink = crossing_ink(buffers, tone, bands);
    const OwnedArea owned_second = owned_area(buffers, second, 1.5 * spacing);
    std::vector<Layer> layers;
    if (options.tone_style == ToneStyle::width) layers.push_back({first, ink, owned});
    if (bands) set_bands(buffers, ink, tone, first);
    if (options.cross_hatch) layers.push_back({second, second_ink, owned_second});
    set_widths(buffers, layers, tone);
    const auto black = crossed(coverage(buffers, first), coverage(buffers, second));
    const auto wanted = options.cross_hatch ? crossed(ink, second_ink) : ink;
    drawing.counts.tone = tone_error(tone_cells(buffers, black, wanted, owned, spacing));
  });
  for (std::vector<Hatch>* layer : {&first, &second})
    for (Hatch& h : *layer) drawing.hatches.push_back(std::move(h.stroke));
  count_over_contours(barriers, drawing);
}

}  // namespace crest::line_art
