// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/modes/curves_certificate.hpp"

#include <algorithm>
#include <array>
#include <set>
#include <vector>

#include "kernel/geometry/disjoint_sets.hpp"

namespace crest::modes {
namespace {

constexpr std::uint32_t kDropped = ~std::uint32_t{0};

std::array<FaceCorners, 4> faces_of(TetCorners k) {
  std::sort(k.begin(), k.end());
  return {{{k[1], k[2], k[3]}, {k[0], k[2], k[3]}, {k[0], k[1], k[3]}, {k[0], k[1], k[2]}}};
}

/// What is special, undecided or beyond the claim, and the tets with such a face.
void add_special(const DegenerateCurves& curves, certify::ModesCurvesCertificate& c) {
  std::set<FaceCorners> faces(curves.multiple_faces.begin(), curves.multiple_faces.end()), planes;
  for (const SpecialFace& f : curves.special_faces) {
    faces.insert(f.face);
    if (f.reason == SpecialReason::zero_quartic) planes.insert(f.face);
  }
  std::set<std::uint32_t> tets(curves.undecided.begin(), curves.undecided.end());
  for (const SpecialTet& t : curves.special_tets) tets.insert(t.tet);
  for (std::uint32_t t = 0; t < c.tets.size(); ++t)
    for (const FaceCorners& f : faces_of(c.tets[t]))
      if (faces.contains(f)) tets.insert(t);
  c.special_faces.assign(faces.begin(), faces.end());
  c.plane_faces.assign(planes.begin(), planes.end());
  c.degenerate_edges = curves.degenerate_edges;
  c.special_tets.assign(tets.begin(), tets.end());
}

/// How far from its enclosure a point's box may reach: the checker need not be as exact as the
/// search was, but boxes of one face must not meet.
double room(const DegenerateCurves& curves, std::size_t point) {
  constexpr double most = 1e-9;
  const FacePoint& p = curves.points[point];
  double r = most;
  const auto keep_from = [&](const FacePoint& q) {
    double gap = 0;
    for (std::size_t k = 0; k < 2; ++k)
      gap = std::max({gap, q.low[k] - p.high[k], p.low[k] - q.high[k]});
    r = std::min(r, gap / 4);
  };
  // Those of one face stand together.
  for (std::size_t i = point; i-- > 0 && curves.points[i].face == p.face;)
    keep_from(curves.points[i]);
  for (std::size_t i = point + 1; i < curves.points.size() && curves.points[i].face == p.face; ++i)
    keep_from(curves.points[i]);
  return r;
}

/// Faces and points but for those of special faces, of which nothing is claimed. Returns the new
/// number of each point.
std::vector<std::uint32_t> add_points(const DegenerateCurves& curves,
                                      certify::ModesCurvesCertificate& c) {
  std::vector<std::uint32_t> number;
  std::uint32_t last = kDropped;
  for (std::size_t i = 0; i < curves.points.size(); ++i) {
    const FacePoint& p = curves.points[i];
    const FaceCorners& face = curves.faces[p.face];
    number.push_back(kDropped);
    if (std::binary_search(c.special_faces.begin(), c.special_faces.end(), face)) continue;
    if (p.face != last) c.faces.push_back(face);
    last = p.face;
    number.back() = static_cast<std::uint32_t>(c.face_points.size());
    const double pad = room(curves, i);
    c.face_points.push_back({static_cast<std::uint32_t>(c.faces.size() - 1),
                             static_cast<std::int8_t>(p.type == DegenerateType::linear ? 1 : -1),
                             {p.low[0] - pad, p.low[1] - pad},
                             {p.high[0] + pad, p.high[1] + pad}});
  }
  return number;
}

/// Components of the points by the arcs: touched if a point is on a face of a special tetrahedron.
void count_curves(certify::ModesCurvesCertificate& c) {
  std::set<FaceCorners> special;
  for (const std::uint32_t t : c.special_tets)
    for (const FaceCorners& f : faces_of(c.tets[t])) special.insert(f);
  kernel::DisjointSets sets(static_cast<std::uint32_t>(c.face_points.size()));
  for (const auto& a : c.arcs) sets.unite(a.points[0], a.points[1]);
  struct Component {
    std::size_t points = 0, arcs = 0;
    bool touched = false;
  };
  std::vector<Component> components(c.face_points.size());
  for (std::uint32_t p = 0; p < c.face_points.size(); ++p) {
    Component& x = components[sets.find(p)];
    ++x.points;
    x.touched = x.touched || special.contains(c.faces[c.face_points[p].face]);
  }
  for (const auto& a : c.arcs) ++components[sets.find(a.points[0])].arcs;
  for (std::uint32_t p = 0; p < c.face_points.size(); ++p) {
    const Component& x = components[p];
    if (x.points == 0) continue;
    auto& counts = c.face_points[p].type > 0 ? c.linear : c.planar;
    ++(x.touched ? counts.touched : x.arcs == x.points ? counts.closed : counts.open);
  }
}

}  // namespace

certify::ModesCurvesCertificate curves_certificate(std::span<const kernel::Vec3> points,
                                                   std::span<const TetCorners> tets,
                                                   std::span<const Tensor> tensors,
                                                   const DegenerateCurves& curves) {
  certify::ModesCurvesCertificate c;
  c.points.assign(points.begin(), points.end());
  c.tets.assign(tets.begin(), tets.end());
  c.tensors.assign(tensors.begin(), tensors.end());
  add_special(curves, c);
  const auto number = add_points(curves, c);
  for (const DegenerateArc& a : curves.arcs) {
    if (std::binary_search(c.special_tets.begin(), c.special_tets.end(), a.tet)) continue;
    const std::uint32_t first = number[a.ends[0]], second = number[a.ends[1]];
    c.arcs.push_back({a.tet, {std::min(first, second), std::max(first, second)}});
  }
  std::sort(c.arcs.begin(), c.arcs.end(), [](const auto& a, const auto& b) {
    return a.tet != b.tet ? a.tet < b.tet : a.points < b.points;
  });
  count_curves(c);
  return c;
}

}  // namespace crest::modes
