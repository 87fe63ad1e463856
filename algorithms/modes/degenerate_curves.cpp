// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/modes/degenerate_curves.hpp"

#include <tbb/blocked_range.h>

#include <algorithm>
#include <cmath>

#include "algorithms/modes/degenerate_arcs.hpp"
#include "algorithms/modes/degenerate_exact.hpp"
#include "algorithms/modes/degenerate_faces.hpp"
#include "kernel/geometry/parallel.hpp"

namespace crest::modes {

namespace {

using kernel::Vec3;
using kernel::operator+;
using kernel::operator*;

constexpr std::uint32_t kNone = 0xffffffff;

template <class F>
void in_parallel(std::size_t n, const F& f) {
  kernel::parallel_for(tbb::blocked_range<std::size_t>(0, n, 256), [&](const auto& range) {
    for (std::size_t i = range.begin(); i < range.end(); ++i) f(i);
  });
}

using Interior = std::vector<std::array<double, 4>>;

/// Arcs to curves.
class Tracer {
 public:
  Tracer(std::span<const Vec3> vertices, std::span<const TetCorners> tets, DegenerateCurves& result,
         const std::vector<Interior>& interiors, const std::vector<bool>& at_special)
      : vertices_(vertices),
        tets_(tets),
        result_(result),
        interiors_(interiors),
        at_special_(at_special) {}

  void trace() {
    arcs_at_.assign(result_.points.size(), {kNone, kNone});
    for (std::size_t a = 0; a < result_.arcs.size(); ++a)
      for (const std::uint32_t p : result_.arcs[a].ends) {
        auto& at = arcs_at_[p];
        at[at[0] != kNone] = static_cast<std::uint32_t>(a);
      }
    used_.assign(result_.arcs.size(), false);
    // From loose ends first; what is left are loops. A point without arcs is a piece of its own.
    for (const bool ends : {true, false})
      for (std::uint32_t p = 0; p < arcs_at_.size(); ++p) {
        const auto& at = arcs_at_[p];
        if (ends && at[1] != kNone) continue;
        if (at[0] == kNone ? ends : !used_[at[0]]) follow(p);
      }
  }

 private:
  void follow(std::uint32_t start) {
    DegenerateCurve curve;
    curve.type = result_.points[start].type;
    curve.face_points.push_back(start);
    curve.polyline.push_back(result_.points[start].point);
    std::uint32_t p = start;
    for (;;) {
      std::uint32_t a = arcs_at_[p][0];
      if (a != kNone && used_[a]) a = arcs_at_[p][1];
      if (a == kNone || used_[a]) break;
      used_[a] = true;
      const auto& ends = result_.arcs[a].ends;
      const bool forward = ends[0] == p;
      append(a, forward, curve.polyline);
      p = forward ? ends[1] : ends[0];
      curve.polyline.push_back(result_.points[p].point);
      if (p == start) {
        curve.closed = true;
        break;
      }
      curve.face_points.push_back(p);
    }
    curve.at_special = at_special_[curve.face_points.front()] || at_special_[p];
    for (std::size_t k = 1; k < curve.polyline.size(); ++k)
      curve.length += kernel::distance(curve.polyline[k - 1], curve.polyline[k]);
    result_.curves.push_back(std::move(curve));
  }

  void append(std::uint32_t arc, bool forward, std::vector<Vec3>& polyline) const {
    const TetCorners& c = tets_[result_.arcs[arc].tet];
    const auto& interior = interiors_[arc];
    for (std::size_t k = 0; k < interior.size(); ++k) {
      const auto& w = interior[forward ? k : interior.size() - 1 - k];
      polyline.push_back(w[0] * vertices_[c[0]] + w[1] * vertices_[c[1]] + w[2] * vertices_[c[2]] +
                         w[3] * vertices_[c[3]]);
    }
  }

  std::span<const Vec3> vertices_;
  std::span<const TetCorners> tets_;
  DegenerateCurves& result_;
  const std::vector<Interior>& interiors_;
  const std::vector<bool>& at_special_;
  std::vector<std::array<std::uint32_t, 2>> arcs_at_;
  std::vector<bool> used_;
};

/// Faces of excluded tets have no points.
void drop_excluded(std::span<const TetCorners> tets, const std::vector<std::uint8_t>& excluded,
                   const std::vector<FaceCorners>& faces, std::vector<FaceRoots>& roots) {
  for (std::size_t t = 0; t < tets.size(); ++t) {
    if (!excluded[t]) continue;
    for (std::size_t k = 0; k < 4; ++k) {
      const FaceCorners face = face_of(tets[t], k);
      const auto at = std::lower_bound(faces.begin(), faces.end(), face);
      if (at != faces.end() && *at == face)
        roots[static_cast<std::size_t>(at - faces.begin())] = {{}, 0, FaceStage::cone, {}};
    }
  }
}

/// The edges of these faces that are degenerate all along, ascending.
std::vector<std::array<std::uint32_t, 2>> degenerate_edges(const std::vector<SpecialFace>& faces,
                                                           std::span<const Tensor> tensors) {
  std::vector<std::array<std::uint32_t, 2>> edges;
  for (const SpecialFace& f : faces) {
    const auto [a, b, c] = f.face;
    edges.insert(edges.end(), {{a, b}, {b, c}, {a, c}});
  }
  std::sort(edges.begin(), edges.end());
  edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
  std::erase_if(edges,
                [&](const auto& e) { return !is_degenerate_edge(tensors[e[0]], tensors[e[1]]); });
  return edges;
}

class Extraction {
 public:
  Extraction(std::span<const Vec3> points, std::span<const TetCorners> tets,
             std::span<const Tensor> tensors, const FaceWorkers* workers)
      : points_(points), tets_(tets), tensors_(tensors) {
    FaceTests tests = test_faces(points, tets, tensors, workers);
    excluded_ = std::move(tests.excluded);
    faces_ = std::move(tests.faces);
    roots_ = std::move(tests.roots);
    for (std::uint32_t t = 0; t < tets_.size(); ++t)
      if (!excluded_[t]) active_.push_back(t);
    result_.counts.rejected_tets = tets_.size() - active_.size();
  }

  DegenerateCurves run() {
    number_faces();
    take_roots();
    result_.degenerate_edges = degenerate_edges(result_.special_faces, tensors_);
    join_in_tets();
    Tracer(points_, tets_, result_, interiors_, at_special_).trace();
    return std::move(result_);
  }

 private:
  void number_faces() {
    faces_of_tet_.resize(active_.size());
    in_parallel(active_.size(), [&](std::size_t i) {
      for (std::size_t k = 0; k < 4; ++k) {
        const FaceCorners face = face_of(tets_[active_[i]], k);
        const auto place = std::lower_bound(faces_.begin(), faces_.end(), face);
        faces_of_tet_[i][k] = static_cast<std::uint32_t>(place - faces_.begin());
      }
    });
  }

  void take_roots() {
    drop_excluded_faces();
    first_point_.resize(faces_.size());
    for (std::size_t i = 0; i < faces_.size(); ++i) {
      const FaceRoots& r = roots_[i];
      auto& counts = result_.counts;
      ++(r.stage == FaceStage::cone     ? counts.rejected_faces
         : r.stage == FaceStage::triage ? counts.triage_faces
                                        : counts.exact_faces);
      if (r.special) result_.special_faces.push_back({faces_[i], *r.special});
      if (r.multiple && !r.special) result_.multiple_faces.push_back(faces_[i]);
      first_point_[i] = static_cast<std::uint32_t>(result_.points.size());
      if (r.count) result_.faces.push_back(faces_[i]);
      for (std::size_t k = 0; k < r.count; ++k) add_point(faces_[i], r.root[k]);
    }
  }

  /// A face that is not decided by itself, but is one of a tet that a cone excludes, has no points.
  void drop_excluded_faces() {
    std::vector<int> uses(faces_.size(), 0);
    for (const auto& faces : faces_of_tet_)
      for (const std::uint32_t f : faces) ++uses[f];
    for (std::size_t i = 0; i < faces_.size(); ++i)
      if (roots_[i].special && uses[i] == 1) return drop_excluded(tets_, excluded_, faces_, roots_);
  }

  void add_point(const FaceCorners& f, const FaceRoot& root) {
    FacePoint p;
    p.face = static_cast<std::uint32_t>(result_.faces.size() - 1);
    p.type = root.type;
    p.weights = {root.weights[0].mid, root.weights[1].mid, root.weights[2].mid};
    for (std::size_t k = 0; k < 2; ++k) {
      const Ball& w = root.weights[k];
      p.low[k] = std::max(0.0, std::nextafter(w.mid - w.rad, -1.0));
      p.high[k] = std::min(1.0, std::nextafter(w.mid + w.rad, 2.0));
    }
    p.direction = {root.v[0].mid, root.v[1].mid, root.v[2].mid};
    p.direction = (1 / kernel::norm(p.direction)) * p.direction;
    p.point =
        p.weights[0] * points_[f[0]] + p.weights[1] * points_[f[1]] + p.weights[2] * points_[f[2]];
    result_.points.push_back(p);
  }

  void join_in_tets() {
    std::vector<TetArcs> found(active_.size());
    at_special_.assign(result_.points.size(), false);
    in_parallel(active_.size(), [&](std::size_t i) { found[i] = join(i); });
    for (std::size_t i = 0; i < active_.size(); ++i) {
      if (found[i].special || !found[i].decided)
        for (const std::uint32_t f : faces_of_tet_[i])
          for (std::uint32_t k = 0; k < roots_[f].count; ++k)
            at_special_[first_point_[f] + k] = true;
      if (found[i].special) result_.special_tets.push_back({active_[i], *found[i].special});
      if (!found[i].decided) result_.undecided.push_back(active_[i]);
      for (TetArc& arc : found[i].arcs) {
        result_.arcs.push_back({active_[i], arc.ends});
        interiors_.push_back(std::move(arc.interior));
      }
    }
  }

  TetArcs join(std::size_t i) const {
    const TetCorners& c = tets_[active_[i]];
    std::vector<TetPoint> points;
    std::optional<SpecialReason> special;
    for (std::size_t opposite = 0; opposite < 4; ++opposite) {
      const std::uint32_t f = faces_of_tet_[i][opposite];
      const FaceRoots& r = roots_[f];
      if (r.special) special = r.special;
      for (std::uint32_t k = 0; k < r.count; ++k)
        points.push_back({first_point_[f] + k, opposite, r.root[k].type, r.root[k].v});
    }
    if (special) return {{}, special, true};
    const std::array<const Tensor*, 4> corners{&tensors_[c[0]], &tensors_[c[1]], &tensors_[c[2]],
                                               &tensors_[c[3]]};
    const std::array<Vec3, 4> places{points_[c[0]], points_[c[1]], points_[c[2]], points_[c[3]]};
    return tet_arcs(corners, places, points);
  }

  std::span<const Vec3> points_;
  std::span<const TetCorners> tets_;
  std::span<const Tensor> tensors_;
  DegenerateCurves result_;
  std::vector<std::uint8_t> excluded_;
  std::vector<std::uint32_t> active_;
  std::vector<FaceCorners> faces_;
  std::vector<std::array<std::uint32_t, 4>> faces_of_tet_;
  std::vector<FaceRoots> roots_;
  std::vector<std::uint32_t> first_point_;
  std::vector<Interior> interiors_;
  std::vector<bool> at_special_;
};

}  // namespace

DegenerateCurves degenerate_curves(std::span<const Vec3> points, std::span<const TetCorners> tets,
                                   std::span<const Tensor> tensors, const FaceWorkers* workers) {
  return Extraction(points, tets, tensors, workers).run();
}

}  // namespace crest::modes
