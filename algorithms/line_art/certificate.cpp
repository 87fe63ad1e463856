// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/line_art/certificate.hpp"

#include <algorithm>

namespace crest::line_art {
namespace {

using certify::LineArtCertificate, certify::LineEdge, certify::LineEvent;
using kernel::cross, kernel::norm;

certify::LineView view_of(const View& view) {
  certify::LineView v;
  if (view.eye.finite) {
    v.axes = {view.x, view.y, view.z};
    v.origin = view.origin;
    v.scale = {view.scale, view.scale};
    return v;
  }
  const Vec3 x = cross(view.up, view.eye.at);
  v.axes[1] = view.up;
  v.scale = {view.scale / norm(x), view.scale / (norm(view.eye.at) * norm(x))};
  v.origin = {view.origin[0] * view.scale, view.origin[1] * view.scale};
  return v;
}

/// Breaks between pieces: groups of equal places strictly inside, without those that change
/// nothing.
LineEdge edge_of(const Contours& contours, const kernel::Sight& sight, const ContourEdge& e,
                 kernel::SightCounts& counts) {
  LineEdge edge{e.a, e.b, {}, {}};
  if (e.end_on) return edge;
  const auto event = [&](Index i) -> const SightEvent& {
    return contours.events[e.first_event + i];
  };
  for (Index i = 0, end = 0; i < e.events; i = end) {
    std::vector<LineEvent> group;
    int contact = 0;
    for (end = i; end < e.events &&
                  (end == i || sight.event_order(e.a, e.b, event(i).place, event(end).place,
                                                 counts) == kernel::Sign::zero);
         ++end) {
      const SightEvent& x = event(end);
      if (x.kind == SightEvent::Kind::contact) {
        contact += x.change;
      } else if (x.kind == SightEvent::Kind::crossing) {
        const ContourEdge& other = contours.edges[x.partner];
        group.push_back({LineEvent::kCrossing, other.a, other.b});
      } else {
        group.push_back({LineEvent::kPiercing, x.partner, 0});
      }
    }
    if (event(i).place.at_start() || event(i).place.at_end()) continue;
    if (group.empty() && contact == 0) continue;
    std::sort(group.begin(), group.end());
    edge.breaks.push_back(std::move(group));
  }
  for (Index i = 0; i < e.pieces; ++i) {
    const Piece& p = contours.pieces[e.first_piece + i];
    edge.pieces.push_back({p.in_front, p.in_front - p.touching});
  }
  return edge;
}

}  // namespace

LineArtCertificate line_art_record(const Drawing& drawing) {
  LineArtCertificate c;
  c.points = drawing.scene.points;
  c.faces = drawing.scene.faces;
  c.eye = drawing.view.eye.at;
  c.parallel = !drawing.view.eye.finite;
  c.view = view_of(drawing.view);
  const kernel::Sight sight(drawing.view.eye, drawing.scene.points);
  kernel::SightCounts counts;
  for (const ContourEdge& e : drawing.contours.edges) {
    if (e.crease) c.creases.push_back({e.a, e.b});
    c.edges.push_back(edge_of(drawing.contours, sight, e, counts));
  }
  for (const Stroke& s : drawing.hatches) {
    c.hatches.emplace_back(s.points.begin(), s.points.end());
    c.hatch_faces.push_back(s.face);
  }
  return c;
}

}  // namespace crest::line_art
