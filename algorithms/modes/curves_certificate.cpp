// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/modes/curves_certificate.hpp"

#include <algorithm>

namespace crest::modes {

certify::ModesCurvesCertificate curves_certificate(std::span<const kernel::Vec3> points,
                                                   std::span<const TetCorners> tets,
                                                   std::span<const Tensor> tensors,
                                                   const DegenerateCurves& curves) {
  certify::ModesCurvesCertificate c;
  c.points.assign(points.begin(), points.end());
  c.tets.assign(tets.begin(), tets.end());
  c.tensors.assign(tensors.begin(), tensors.end());
  c.faces = curves.faces;
  for (const FacePoint& p : curves.points)
    c.face_points.push_back({p.face,
                             static_cast<std::int8_t>(p.type == DegenerateType::linear ? 1 : -1),
                             p.low, p.high});
  for (const DegenerateArc& a : curves.arcs)
    c.arcs.push_back({a.tet, {std::min(a.ends[0], a.ends[1]), std::max(a.ends[0], a.ends[1])}});
  std::sort(c.arcs.begin(), c.arcs.end(), [](const auto& a, const auto& b) {
    return a.tet != b.tet ? a.tet < b.tet : a.points < b.points;
  });
  for (const SpecialFace& f : curves.special_faces) c.special_faces.push_back(f.face);
  for (const SpecialTet& t : curves.special_tets) c.special_tets.push_back(t.tet);
  c.special_tets.insert(c.special_tets.end(), curves.undecided.begin(), curves.undecided.end());
  std::sort(c.special_tets.begin(), c.special_tets.end());
  for (const DegenerateCurve& curve : curves.curves) {
    auto& counts = curve.type == DegenerateType::linear ? c.linear : c.planar;
    ++(curve.at_special ? counts.touched : curve.closed ? counts.closed : counts.open);
  }
  return c;
}

}  // namespace crest::modes
