// SPDX-License-Identifier: GPL-3.0-or-later
// Claim 7, modes-curves: where a piecewise linear tensor field is degenerate (SPEC.md). The
// library compares no file with it; the program compares digests (cli/crest_verify.cpp).
#include <algorithm>
#include <cmath>
#include <functional>
#include <memory>
#include <tuple>

#include "certify/container/checker.hpp"
#include "certify/container/parallel.hpp"
#include "certify/container/prove.hpp"
#include "certify/container/reject.hpp"
#include "certify/modes_curves/decode.hpp"
#include "certify/modes_curves/tet_arcs.hpp"
#include "certify/surface/tetrahedra.hpp"
#include "certify/surface/union_find.hpp"

namespace crest::certify {
namespace {

using namespace curves;
using modes::ExactTensors;
using modes::Field;

/// Whether |mode| < 1 everywhere on the simplex, clearly.
template <std::size_t n>
bool is_free(const Field& field, const std::array<u32, n>& corners) {
  const auto products = modes::approximate_products<n>(field, corners);
  const auto norm = norm_form(products);
  const auto cube = cube_form(products);
  const auto f = scaled(3.0, cube * cube) - scaled(2.0, norm * norm * norm);
  return hull(f) == modes::Hull::negative;
}

/// The same of parts, cut in halves until it is clear, or `budget` parts are looked at.
template <std::size_t n>
bool is_free_in_parts(Field& field, const std::array<u32, n>& corners, unsigned depth,
                      unsigned& budget) {
  if (is_free(field, corners)) return true;
  if (depth == modes::kMostGenerations || budget == 0) return false;
  --budget;
  // All edges in turn: between the first corners, the others move up.
  const u32 middle = field.split(corners[0], corners[1], 32);
  for (unsigned k = 0; k < 2; ++k) {
    std::array<u32, n> part = corners;
    part[k] = middle;
    std::ranges::rotate(part, part.begin() + 1);
    if (!is_free_in_parts(field, part, depth + 1, budget)) return false;
  }
  return true;
}
template <std::size_t n>
bool is_free_in_parts(const ModesCurvesCertificate& c, const std::array<u32, n>& corners) {
  std::vector<std::array<double, 6>> tensors;
  std::array<u32, n> local{};
  for (unsigned i = 0; i < n; ++i) local[i] = i, tensors.push_back(c.tensors[corners[i]]);
  Field field(tensors);
  unsigned budget = 4096;
  return is_free_in_parts(field, local, 0, budget);
}

/// Points of faces, arcs of tetrahedra.
class PlaceCheck {
 public:
  PlaceCheck(const ModesCurvesCertificate& c, Verdict& verdict)
      : c_(c), verdict_(verdict), field_(c.tensors) {}

 protected:
  void build() {
    require(c_.points.size() >= 4 && !c_.tets.empty() && c_.tets.size() < modes::kNone / 16,
            "data: no tetrahedra, or too many");
    tets_ = c_.tets;
    for (auto& t : tets_) {
      std::ranges::sort(t);
      require(t[3] < c_.points.size(), "data: no vertex {}", t[3]);
      require(t[0] != t[1] && t[1] != t[2] && t[2] != t[3],
              "data: a tetrahedron has a corner twice");
    }
    faces_ = list_faces(tets_, c_.points.size());
    prove(verdict_, "data: {} vertices, {} tetrahedra; digests match", c_.points.size(),
          c_.tets.size());
  }

  void check_lists() {
    for (const auto* list : {&c_.faces, &c_.special_faces}) {
      require(std::ranges::is_sorted(*list, std::less_equal<>()), "faces: not ascending");
      for (const auto& f : *list)
        require(find_face(faces_, f) != kNoTet, "faces: no face ({}, {}, {})", f[0], f[1], f[2]);
    }
    require(std::ranges::is_sorted(c_.special_tets, std::less_equal<>()) &&
                (c_.special_tets.empty() || c_.special_tets.back() < tets_.size()),
            "special tetrahedra: not ascending, or not there");
    special_.assign(tets_.size(), 0);
    for (const u32 t : c_.special_tets) special_[t] = 1;
    boxes_.resize(c_.faces.size());
    for (u32 i = 0; i < c_.face_points.size(); ++i) {
      const DegeneratePoint& p = c_.face_points[i];
      require(p.face < c_.faces.size() && (i == 0 || c_.face_points[i - 1].face <= p.face),
              "points: not by face");
      require(p.type == 1 || p.type == -1, "points: type {}", int{p.type});
      for (unsigned k = 0; k < 2; ++k)
        require(std::isfinite(p.low[k]) && std::isfinite(p.high[k]), "points: {} has no box", i);
      for (const Box& box : boxes_[p.face]) {
        bool apart = false;
        for (unsigned k = 0; k < 2; ++k)
          apart |= box.high[k] <= p.low[k] || p.high[k] <= box.low[k];
        require(apart, "points: the boxes of {} and {} overlap", box.listed, i);
      }
      require(boxes_[p.face].size() < 4, "points: more than four on a face");
      boxes_[p.face].push_back({p.low, p.high, p.type, i});
    }
    for (std::size_t f = 0; f < boxes_.size(); ++f)
      require(!boxes_[f].empty(), "faces: {} has no point", f);
  }

  bool is_special(const std::array<u32, 3>& face) const {
    return std::ranges::binary_search(c_.special_faces, face);
  }

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

  void check_faces() {
    free_.assign(tets_.size(), 0);
    for_all(tets_.size(),
            [&](std::size_t t, ExactTensors&) { free_[t] = is_free(field_, tets_[t]); });
    points_.resize(faces_.size());
    for_all(faces_.size(), [&](std::size_t f, ExactTensors& exact) {
      const TetFace& face = faces_[f];
      const auto at = std::ranges::lower_bound(c_.faces, face.corners);
      const bool listed = at != c_.faces.end() && *at == face.corners;
      if (is_special(face.corners)) return require(!listed, "special faces: one has points");
      static const std::vector<Box> none;
      const auto& boxes = listed ? boxes_[static_cast<std::size_t>(at - c_.faces.begin())] : none;
      const bool away =
          std::ranges::any_of(face.tets, [&](u32 t) { return t != kNoTet && free_[t] != 0; });
      if (boxes.empty() && (away || is_free(field_, face.corners))) return;
      auto found = find_points(exact, face.corners, boxes);
      if (!found) {
        require(boxes.empty() && is_free_in_parts(c_, face.corners),
                "face ({}, {}, {}): no quartic with simple roots, not listed as special",
                face.corners[0], face.corners[1], face.corners[2]);
        return;
      }
      points_[f] = std::move(*found);
    });
    prove(verdict_, "faces: {} degenerate points on {} faces; {} special ones",
          c_.face_points.size(), c_.faces.size(), c_.special_faces.size());
  }

  void check_tets() {
    std::vector<std::size_t> first(tets_.size() + 1, 0);
    for (std::size_t i = 0; i < c_.arcs.size(); ++i) {
      const auto key = [](const DegenerateArc& a) { return std::tuple(a.tet, a.points); };
      require(c_.arcs[i].tet < tets_.size() && (i == 0 || key(c_.arcs[i - 1]) < key(c_.arcs[i])),
              "arcs: not ascending");
      ++first[c_.arcs[i].tet + 1];
    }
    for (std::size_t t = 0; t < tets_.size(); ++t) first[t + 1] += first[t];
    for_all(tets_.size(), [&](std::size_t t, ExactTensors& exact) {
      const auto stated = std::span(c_.arcs).subspan(first[t], first[t + 1] - first[t]);
      if (special_[t] != 0 || free_[t] != 0)
        return require(stated.empty(), "arcs: one in tetrahedron {}", t);
      check_tet(t, stated, exact);
    });
    prove(verdict_, "tetrahedra: {} arcs; {} special ones", c_.arcs.size(), c_.special_tets.size());
  }

  void check_tet(std::size_t t, std::span<const DegenerateArc> stated, ExactTensors& exact) {
    std::vector<TetPoint> points;
    for (unsigned i = 0; i < 4; ++i) {
      std::array<u32, 3> corners{};
      for (unsigned k = 0, at = 0; k < 4; ++k)
        if (k != i) corners[at++] = tets_[t][k];
      require(!is_special(corners), "tetrahedron {}: a face is special, it is not", t);
      for (const FacePoint& point : points_[find_face(faces_, corners)])
        points.push_back({point, i});
    }
    const auto arcs = find_arcs(exact, tets_[t], points);
    if (!arcs) {
      require(points.empty() && stated.empty() && is_free_in_parts(c_, tets_[t]),
              "tetrahedron {}: dependent tensors or a pair of lines, not listed as special", t);
      return;
    }
    std::vector<std::array<u32, 2>> found;
    for (const auto& [a, b] : *arcs) {
      require(points[a].point.type == points[b].point.type, "tetrahedron {}: an arc of two types",
              t);
      const auto [low, high] = std::minmax(points[a].point.listed, points[b].point.listed);
      found.push_back({low, high});
    }
    std::ranges::sort(found);
    require(std::ranges::equal(stated, found, {}, &DegenerateArc::points),
            "tetrahedron {}: the arcs listed are not those found", t);
  }

  const ModesCurvesCertificate& c_;
  Verdict& verdict_;
  Field field_;
  std::vector<std::array<u32, 4>> tets_;
  std::vector<TetFace> faces_;
  std::vector<std::uint8_t> special_, free_;
  std::vector<std::vector<Box>> boxes_;         ///< of listed faces
  std::vector<std::vector<FacePoint>> points_;  ///< of all faces
};

class CurveCheck : public PlaceCheck {
 public:
  using PlaceCheck::PlaceCheck;

  void run() {
    build();
    check_lists();
    check_faces();
    check_tets();
    count_curves();
  }

 private:
  void count_curves() {
    const auto& points = c_.face_points;
    modes::UnionFind curves(points.size());
    std::vector<std::uint8_t> ends(points.size(), 0), touched(points.size(), 0), open = touched;
    for (const DegenerateArc& arc : c_.arcs) {
      curves.join(arc.points[0], arc.points[1]);
      for (const u32 p : arc.points) ++ends[p];
    }
    for (u32 p = 0; p < points.size(); ++p) {
      const TetFace& face = faces_[find_face(faces_, c_.faces[points[p].face])];
      unsigned sides = 0;
      for (const u32 t : face.tets) {
        if (t == kNoTet) continue;
        ++sides;
        touched[curves.find(p)] |= special_[t];
        sides -= special_[t];
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
    const auto compare = [&](const CurveCounts& stated, const CurveCounts& found,
                             const char* name) {
      require_equal(stated.open, found.open, name);
      require_equal(stated.closed, found.closed, name);
      require_equal(stated.touched, found.touched, name);
      prove(verdict_, "{}: {} open, {} closed; {} that touch special places", name, found.open,
            found.closed, found.touched);
    };
    compare(c_.linear, counts[0], "linear curves");
    compare(c_.planar, counts[1], "planar curves");
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
