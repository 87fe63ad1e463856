// SPDX-License-Identifier: GPL-3.0-or-later
// Claim 7, modes-curves: where a piecewise linear tensor field is degenerate (SPEC.md). The
// library compares no file with it; the program compares digests (cli/crest_verify.cpp).
#include <algorithm>
#include <atomic>
#include <functional>
#include <memory>

#include "certify/container/checker.hpp"
#include "certify/container/parallel.hpp"
#include "certify/container/prove.hpp"
#include "certify/container/reject.hpp"
#include "certify/modes_curves/cones.hpp"
#include "certify/modes_curves/decode.hpp"
#include "certify/modes_curves/free.hpp"
#include "certify/modes_curves/near.hpp"
#include "certify/modes_curves/places.hpp"
#include "certify/modes_curves/tet_arcs.hpp"
#include "certify/surface/union_find.hpp"

namespace crest::certify {
namespace {

using namespace curves;
using modes::ExactTensors;
using modes::Field;

/// A ball around numbers between two rationals.
Ball enclosing(const Range& r, const Rational& unit) {
  const auto low = static_cast<double>(Rational(r.low / unit));
  const auto high = static_cast<double>(Rational(r.high / unit));
  const double mid = low + (high - low) / 2;
  return {mid, (high - low) + 0x1p-50 * (std::fabs(low) + std::fabs(high)) + 0x1p-1000};
}
NearPoint enclosing(const FacePoint& point) {
  const auto v = point.direction();
  Rational unit = 0;
  for (const Range& r : v) unit = std::max({unit, Rational(abs(r.low)), Rational(abs(r.high))});
  return {point.type,
          point.listed,
          {WideBall(enclosing(v[0], unit)), WideBall(enclosing(v[1], unit)),
           WideBall(enclosing(v[2], unit))}};
}

/// Points of faces.
class FaceCheck {
 public:
  FaceCheck(const ModesCurvesCertificate& c, Verdict& verdict)
      : c_(c), verdict_(verdict), places_(c, verdict), field_(c.tensors), cones_(field_) {}

 protected:
  template <class Check>
  void for_all(std::size_t count, const Check& check) {
    constexpr std::size_t kBatch = 64;
    parallel_for((count + kBatch - 1) / kBatch,
                 [&] { return std::make_unique<ExactTensors>(field_); },
                 [&](auto& exact, std::size_t batch) {
                   const std::size_t end = std::min(count, (batch + 1) * kBatch);
                   for (std::size_t i = batch * kBatch; i < end; ++i) check(i, *exact);
                 });
  }

  template <std::size_t n>
  Corners<n> tensors(const std::array<u32, n>& corners) const {
    Corners<n> list;
    for (std::size_t i = 0; i < n; ++i) list[i] = &c_.tensors[corners[i]];
    return list;
  }

  void check_faces() {
    const auto& tets = places_.tets();
    const auto& faces = places_.faces();
    free_.assign(tets.size(), 0);
    for_all(tets.size(), [&](std::size_t t, ExactTensors&) {
      free_[t] = cones_.free(tets[t]) || is_free(field_, tets[t]);
    });
    points_.resize(c_.faces.size());
    for_all(faces.size(), [&](std::size_t f, ExactTensors& exact) {
      if (places_.special_face(f)) return;
      const u32 listed = places_.listed(f);
      if (listed != kNoTet) return check_listed(listed, exact);
      const bool away =
          std::ranges::any_of(faces[f].tets, [&](u32 t) { return t != kNoTet && free_[t] != 0; });
      if (!away && !is_free(field_, faces[f].corners)) check_empty(faces[f].corners, exact);
    });
    prove(verdict_, "faces: {} degenerate points on {} faces; {} special ones",
          c_.face_points.size(), c_.faces.size(), c_.special_faces.size());
    for_all(c_.plane_faces.size(),
            [&](std::size_t i, ExactTensors& exact) { check_plane(c_.plane_faces[i], exact); });
    if (!c_.plane_faces.empty())
      prove(verdict_, "{} faces whose conics have a line in common", c_.plane_faces.size());
  }

  void check_listed(u32 listed, ExactTensors& exact) {
    const auto& corners = c_.faces[listed];
    ++calls_;
    auto near = find_near_points(tensors(corners), places_.boxes(listed));
    if (near) {
      points_[listed] = std::move(*near);
      return;
    }
    ++exact_;
    const auto found = find_points(exact, corners, places_.boxes(listed));
    require_listed(corners, found.has_value());
    for (const FacePoint& point : *found) points_[listed].push_back(enclosing(point));
  }

  void check_empty(const std::array<u32, 3>& corners, ExactTensors& exact) {
    static const std::vector<Box> none;
    ++calls_;
    if (find_near_points(tensors(corners), none)) return;
    ++exact_;
    if (find_points(exact, corners, none)) return;
    if (complement(matrices(exact, corners)).empty()) {
      // Dependent tensors: a degenerate one inside implies one on an edge.
      const auto [a, b, c] = corners;
      return require_listed(
          corners, is_free(exact, {a, b}) && is_free(exact, {b, c}) && is_free(exact, {a, c}));
    }
    std::array<std::array<double, 6>, 3> of_corners;
    for (unsigned i = 0; i < 3; ++i) of_corners[i] = c_.tensors[corners[i]];
    require_listed(corners, is_free_in_parts(of_corners));
  }
  static void require_listed(const std::array<u32, 3>& corners, bool decided) {
    require(decided,
            "face ({}, {}, {}): dependent tensors, conics with a common line or a multiple point, "
            "not listed as special",
            corners[0], corners[1], corners[2]);
  }

  void check_plane(const std::array<u32, 3>& corners, ExactTensors& exact) {
    const u32 face = find_face(places_.faces(), corners);
    require(face != kNoTet && places_.special_face(face),
            "plane faces: ({}, {}, {}) is no special face", corners[0], corners[1], corners[2]);
    const auto conics = complement(matrices(exact, corners));
    require(!conics.empty() && share_line(conics[0], conics[1]),
            "plane faces: the conics of ({}, {}, {}) have no line in common", corners[0],
            corners[1], corners[2]);
  }

  const ModesCurvesCertificate& c_;
  Verdict& verdict_;
  Places places_;
  Field field_;
  Cones cones_;
  std::vector<std::uint8_t> free_;              ///< tetrahedra far from degenerate tensors
  std::vector<std::vector<NearPoint>> points_;  ///< of listed faces
  std::atomic<std::uint64_t> calls_{0}, exact_{0};
};

/// Named edges, arcs of tetrahedra.
class TetCheck : public FaceCheck {
 public:
  using FaceCheck::FaceCheck;

 protected:
  void check_edges() {
    const auto& list = c_.degenerate_edges;
    require(std::ranges::is_sorted(list, std::less_equal<>()) &&
                std::ranges::is_sorted(c_.plane_faces, std::less_equal<>()),
            "degenerate edges, plane faces: not ascending");
    if (list.empty()) return;
    std::vector<std::array<u32, 2>> edges;
    for (const TetFace& face : places_.faces()) {
      const auto [a, b, c] = face.corners;
      edges.insert(edges.end(), {{a, b}, {b, c}, {a, c}});
    }
    std::ranges::sort(edges);
    for_all(list.size(), [&](std::size_t i, ExactTensors& exact) {
      require(std::ranges::binary_search(edges, list[i]), "degenerate edges: no edge ({}, {})",
              list[i][0], list[i][1]);
      require(is_degenerate(exact, list[i]),
              "degenerate edges: not all tensors of ({}, {}) are degenerate", list[i][0],
              list[i][1]);
    });
    prove(verdict_, "{} edges of degenerate tensors", list.size());
  }

  void check_tets() {
    const auto& faces = places_.faces();
    for (std::size_t f = 0; f < faces.size(); ++f) {
      if (!places_.special_face(f)) continue;
      for (const u32 t : faces[f].tets)
        require(t == kNoTet || places_.special_tet(t) || free_[t] != 0,
                "tetrahedron {}: a face is special, it is not", t);
    }
    for_all(places_.tets().size(), [&](std::size_t t, ExactTensors& exact) {
      const auto around = places_.around(t);
      const bool listed = std::ranges::any_of(around, [](u32 f) { return f != kNoTet; });
      if (places_.special_tet(t) || !listed)
        return require(places_.arcs(t).empty(), "arcs: one in tetrahedron {}", t);
      check_tet(t, around, exact);
    });
    prove(verdict_, "tetrahedra: {} arcs; {} special ones", c_.arcs.size(), c_.special_tets.size());
    verdict_.signs.calls += calls_;
    verdict_.signs.exact += exact_;
  }

  void check_tet(std::size_t t, const std::array<u32, 4>& around, ExactTensors& exact) {
    std::vector<NearTetPoint> points;
    for (unsigned i = 0; i < 4; ++i)
      if (around[i] != kNoTet)
        for (const NearPoint& point : points_[around[i]]) points.push_back({&point, i});
    const auto& corners = places_.tets()[t];
    require(points.size() % 2 == 0, "tetrahedron {}: an odd number of points", t);
    ++calls_;
    auto arcs = find_near_arcs(tensors(corners), points);
    if (!arcs) {
      ++exact_;
      arcs = find_exact_arcs(corners, around, exact);
      require(arcs.has_value(),
              "tetrahedron {}: dependent tensors or a pair of lines, not listed as special", t);
    }
    std::vector<std::array<u32, 2>> found;
    for (const auto& [a, b] : *arcs) {
      require(points[a].point->type == points[b].point->type, "tetrahedron {}: an arc of two types",
              t);
      const auto [low, high] = std::minmax(points[a].point->listed, points[b].point->listed);
      found.push_back({low, high});
    }
    std::ranges::sort(found);
    require(std::ranges::equal(places_.arcs(t), found, {}, &DegenerateArc::points),
            "tetrahedron {}: the arcs listed are not those found", t);
  }

  /// The points in the order of the faces, and within each as `points_` has them.
  std::optional<std::vector<std::array<std::size_t, 2>>> find_exact_arcs(
      const std::array<u32, 4>& corners, const std::array<u32, 4>& around, ExactTensors& exact) {
    std::vector<TetPoint> points;
    for (unsigned i = 0; i < 4; ++i) {
      if (around[i] == kNoTet) continue;
      const auto found = find_points(exact, c_.faces[around[i]], places_.boxes(around[i]));
      if (!found) throw Undecided("a face decided by doubles that integers leave open");
      for (const NearPoint& point : points_[around[i]])
        points.push_back({*std::ranges::find(*found, point.listed, &FacePoint::listed), i});
    }
    return find_arcs(exact, corners, points);
  }
};

class CurveCheck : public TetCheck {
 public:
  using TetCheck::TetCheck;

  void run() {
    check_faces();
    check_edges();
    check_tets();
    count_curves();
  }

 private:
  void count_curves() {
    const auto& points = c_.face_points;
    UnionFind curves(points.size());
    std::vector<std::uint8_t> ends(points.size(), 0), touched(points.size(), 0), open = touched;
    for (const DegenerateArc& arc : c_.arcs) {
      curves.join(arc.points[0], arc.points[1]);
      for (const u32 p : arc.points) ++ends[p];
    }
    for (u32 p = 0; p < points.size(); ++p) {
      const TetFace& face = places_.faces()[places_.face(points[p].face)];
      unsigned sides = 0;
      for (const u32 t : face.tets) {
        if (t == kNoTet) continue;
        ++sides;
        touched[curves.find(p)] |= static_cast<std::uint8_t>(places_.special_tet(t));
        sides -= places_.special_tet(t);
      }
      require(ends[p] == sides, "point {}: {} arcs at {} tetrahedra", p, ends[p], sides);
      open[curves.find(p)] |= face.tets[1] == kNoTet;
    }
    std::array<CurveCounts, 2> counts;
    for (u32 p = 0; p < points.size(); ++p) {
      if (curves.find(p) != p) continue;
      CurveCounts& of_type = counts[points[p].type > 0 ? 0 : 1];
      ++(touched[p] != 0 ? of_type.touched : open[p] != 0 ? of_type.open : of_type.closed);
    }
    compare(c_.linear, counts[0], "linear curves");
    compare(c_.planar, counts[1], "planar curves");
  }
  void compare(const CurveCounts& stated, const CurveCounts& found, const char* name) {
    require_equal(stated.open, found.open, name);
    require_equal(stated.closed, found.closed, name);
    require_equal(stated.touched, found.touched, name);
    prove(verdict_, "{}: {} open, {} closed; {} that touch special places", name, found.open,
          found.closed, found.touched);
  }
};

void verify_modes_curves(std::span<const std::uint8_t> data, std::span<const std::uint8_t> claims,
                         const VerifyOptions& options, Verdict& verdict) {
  const ModesCurvesCertificate c = decode_modes_curves(data, claims);
  if (options.input)
    throw TieUnavailable(options.input->name +
                         ": --input cannot compare tensors; compare the data digest with the one "
                         "in the output");
  CurveCheck(c, verdict).run();
}

}  // namespace

extern const ClaimChecker modes_curves_claim;
const ClaimChecker modes_curves_claim = {kModesCurves, kModesCurvesVersion, "modes-curves",
                                         verify_modes_curves};

}  // namespace crest::certify
