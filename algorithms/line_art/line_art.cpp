// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/line_art/line_art.hpp"

#include <algorithm>

#include "algorithms/line_art/face_locator.hpp"
#include "algorithms/line_art/fishbone.hpp"

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
    s.points.erase(s.points.begin(), s.points.begin() + static_cast<std::ptrdiff_t>(first - 1));
    s.widths.erase(s.widths.begin(), s.widths.begin() + static_cast<std::ptrdiff_t>(first - 1));
    s.face = *face;
    kept.push_back(std::move(h));
  }
  hatches = std::move(kept);
}

void measure(const Buffers& b, const Barriers& barriers, const std::vector<float>& ink,
             const std::vector<Hatch>& hatches, const OwnedArea& owned, double spacing,
             HatchCounts& counts) {
  std::vector<double> lengths, spacings;
  for (std::size_t h = 0; h < hatches.size(); ++h) {
    const Stroke& s = hatches[h].stroke;
    lengths.push_back(s.length());
    counts.length += lengths.back();
    bool over = false;
    for (std::size_t i = 1; i < s.points.size(); ++i)
      over = over || barriers.crosses(s.points[i - 1], s.points[i]);
    counts.over_contours += over;
    spacings.insert(spacings.end(), owned.spacing[h].begin(), owned.spacing[h].end());
  }
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
    bare += owned.covered[k] == 0;
  }
  counts.bare = wanted > 0 ? bare / wanted : 0;
  (void)spacing;
}

}  // namespace

void add_hatches(Drawing& drawing, const kernel::TriangleMesh& mesh,
                 const std::vector<PrincipalFrame>& frames, const HatchOptions& options,
                 const Phase& phase) {
  const View& view = drawing.view;
  const double unit = unit_of(view, drawing.scene), spacing = options.tone.spacing;
  DirectionField field;
  phase("field", [&] {
    FieldOptions o;
    o.cross = options.cross_field;
    o.spacing = spacing * unit;
    o.smooth = options.smooth * spacing * unit;
    // The page's up, tilted to the right and towards the eye.
    o.axis = 0.35 * view.x + 0.85 * view.y + (-0.4) * view.z;
    o.crease = options.crease;
    field = direction_field(mesh, frames, o);
  });
  drawing.counts.singularities = field.singular.size();
  drawing.counts.index_sum = static_cast<double>(field.index_sum) / field.symmetry;
  const Barriers barriers(drawing.scene, view, drawing.contours);
  Buffers buffers;
  phase("buffers", [&] {
    buffers = fill_buffers({mesh, frames, field}, view, barriers, options.light, options.crease);
  });
  std::vector<Hatch> hatches;
  phase("strokes", [&] {
    const Tracer tracer(buffers, barriers, seen_singularities(mesh, field, view, buffers), spacing);
    if (options.style == HatchStyle::fishbone) {
      Fishbones bones = make_fishbones(tracer, options.tone.brightest);
      drawing.counts.segments = bones.segments.size();
      drawing.counts.key_ribs = bones.key_ribs;
      drawing.counts.blended = bones.blended;
      hatches = std::move(bones.ribs);
    }
    // Alone, or in what the fishbones left.
    add_even_streamlines(tracer, options.tone.brightest, Family::rib, hatches);
  });
  phase("tone", [&] {
    const std::vector<float> ink = layer_ink(buffers, options.tone);
    OwnedArea owned = owned_area(buffers, hatches, 1.5 * spacing);
    drawing.counts.tone = set_widths(buffers, ink, options.tone, hatches, owned);
    measure(buffers, barriers, ink, hatches, owned, spacing, drawing.counts);
  });
  name_faces(drawing, hatches);
  for (Hatch& h : hatches) drawing.hatches.push_back(std::move(h.stroke));
}

}  // namespace crest::line_art
