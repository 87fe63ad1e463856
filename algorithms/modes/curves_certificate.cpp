// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/modes/curves_certificate.hpp"

#include <algorithm>
#include <set>
#include <vector>

#include "kernel/geometry/disjoint_sets.hpp"

namespace crest::modes {
namespace {

constexpr std::uint32_t kDropped = ~std::uint32_t{0};

/// Faces and points but for those of special faces, of which nothing is claimed. Returns the new
/// number of each point.
std::vector<std::uint32_t> add_points(const DegenerateCurves& curves,
                                      certify::ModesCurvesCertificate& c) {
  std::set<FaceCorners> special;
  for (const SpecialFace& f : curves.special_faces) special.insert(f.face);
  std::vector<std::uint32_t> number;
  std::uint32_t last = kDropped;
  for (const FacePoint& p : curves.points) {
    const FaceCorners& face = curves.faces[p.face];
    number.push_back(kDropped);
    if (special.contains(face)) continue;
    if (p.face != last) c.faces.push_back(face);
    last = p.face;
    number.back() = static_cast<std::uint32_t>(c.face_points.size());
    c.face_points.push_back({static_cast<std::uint32_t>(c.faces.size() - 1),
                             static_cast<std::int8_t>(p.type == DegenerateType::linear ? 1 : -1),
                             p.low, p.high});
  }
  return number;
}

/// Components of the points by the arcs: touched if a point is on a face of a special tetrahedron.
void count_curves(certify::ModesCurvesCertificate& c) {
  std::set<FaceCorners> special;
  for (const std::uint32_t t : c.special_tets) {
    auto k = c.tets[t];
    std::sort(k.begin(), k.end());
    for (std::size_t i = 0; i < 4; ++i)
      special.insert({k[i == 0 ? 1 : 0], k[i <= 1 ? 2 : 1], k[i <= 2 ? 3 : 2]});
  }
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
  const auto number = add_points(curves, c);
  for (const DegenerateArc& a : curves.arcs) {
    const std::uint32_t first = number[a.ends[0]], second = number[a.ends[1]];
    if (first != kDropped && second != kDropped)
      c.arcs.push_back({a.tet, {std::min(first, second), std::max(first, second)}});
  }
  std::sort(c.arcs.begin(), c.arcs.end(), [](const auto& a, const auto& b) {
    return a.tet != b.tet ? a.tet < b.tet : a.points < b.points;
  });
  for (const SpecialFace& f : curves.special_faces) c.special_faces.push_back(f.face);
  for (const SpecialTet& t : curves.special_tets) c.special_tets.push_back(t.tet);
  c.special_tets.insert(c.special_tets.end(), curves.undecided.begin(), curves.undecided.end());
  std::sort(c.special_tets.begin(), c.special_tets.end());
  count_curves(c);
  return c;
}

}  // namespace crest::modes
