// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/extremal/trim.hpp"

#include <algorithm>
#include <utility>

namespace crest::extremal {
namespace {

void count(TrimmedMesh& r, std::size_t valence, std::uint8_t reason) {
  ++r.valence[std::min<std::size_t>(valence, 4) - 1];
  if (valence != 2 && static_cast<Reason>(reason) == kUnexplained)
    ++r.unexplained;
  else if (valence == 1)
    ++r.reasons[reason - 1U];
}

bool kept(double x) {
  return x >= 0;
}

class Trimmer {
 public:
  Trimmer(SheetMesh& mesh, const LevelValues& values)
      : mesh_(mesh), values_(values), plane_(mesh.dimension == 2) {}

  TrimmedMesh run() {
    r_.points = std::exchange(mesh_.points, {});
    r_.partly.assign(mesh_.polygons.size(), false);
    cut_of_.assign(mesh_.edges.size(), kernel::kNone);
    middle_of_.assign(mesh_.edges.size(), kernel::kNone);
    plane_ ? end_features() : edge_features();
    for (Index p = 0; p < mesh_.polygons.size(); ++p) add_polygon(p);
    return std::move(r_);
  }

 private:
  double corner(Index v) const { return values_.corners.empty() ? 0 : values_.corners[v]; }
  double centre(Index p) const { return values_.centres.empty() ? 0 : values_.centres[p]; }
  Index add_point(const Vec3& x) {
    r_.points.push_back(x);
    return static_cast<Index>(r_.points.size() - 1);
  }
  /// Between a kept and a dropped place.
  Index add_cut(const Vec3& a, double fa, const Vec3& b, double fb) {
    return add_point(a + (fa / (fa - fb)) * (b - a));
  }

  void edge_features() {
    for (std::size_t i = 0; i < mesh_.edges.size(); ++i) {
      const SheetEdge& e = mesh_.edges[i];
      Index a = e.ends[0], b = e.ends[1];
      if (!kept(corner(a))) std::swap(a, b);
      if (!kept(corner(a))) continue;
      const bool whole = kept(corner(b));
      if (!whole)
        cut_of_[i] = add_cut(r_.points[a], corner(a), r_.points[b], corner(b));
      else if (e.middle != kernel::kNone)
        middle_of_[i] = add_point(mesh_.middles[e.middle]);
      count(r_, e.valence, e.reason);
      if (e.valence == 2 || static_cast<Reason>(e.reason) == kUnexplained) continue;
      const auto why = static_cast<Reason>(e.reason);
      if (middle_of_[i] != kernel::kNone) {
        r_.features.push_back({a, middle_of_[i], why});
        r_.features.push_back({middle_of_[i], b, why});
      } else {
        r_.features.push_back({a, whole ? b : cut_of_[i], why});
      }
    }
  }
  void end_features() {
    for (Index v = 0; v < mesh_.vertices.size(); ++v) {
      if (!kept(corner(v))) continue;
      const auto [valence, reason] = mesh_.ends[v];
      count(r_, valence, reason);
      if (valence != 2) r_.features.push_back({v, v, static_cast<Reason>(reason)});
    }
  }
  void trim_feature(Index a, Index b) {
    r_.features.push_back({a, b, Reason::trim});
    count(r_, 1, static_cast<std::uint8_t>(Reason::trim));
  }

  void close(Index p) {
    r_.first.push_back(static_cast<Index>(r_.corners.size()));
    r_.source.push_back(p);
  }

  void add_polygon(Index p) {
    const SheetPolygon& q = mesh_.polygons[p];
    std::size_t inside = kept(centre(p)) ? 1 : 0;
    for (std::size_t i = 0; i < q.count; ++i) inside += kept(corner(q.corners[i])) ? 1 : 0;
    r_.partly[p] = inside != q.count + 1U;
    if (inside == 0) return;
    if (inside == q.count + 1U) {
      for (std::size_t i = 0; i < q.count; ++i) {
        r_.corners.push_back(q.corners[i]);
        if (!plane_ && middle_of_[q.sides[i]] != kernel::kNone)
          r_.corners.push_back(middle_of_[q.sides[i]]);
      }
      close(p);
      return;
    }
    plane_ ? cut_segment(p) : cut_fan(p);
  }

  /// The vertex at the centre, and those where spokes from it are cut.
  struct Spokes {
    Index centre = kernel::kNone;
    std::array<Index, 4> cut{kernel::kNone, kernel::kNone, kernel::kNone, kernel::kNone};
  };
  Spokes spokes(Index p) {
    const SheetPolygon& q = mesh_.polygons[p];
    const Vec3& z = q.zero;
    Spokes r;
    if (kept(centre(p))) r.centre = add_point(z);
    for (std::size_t i = 0; i < q.count; ++i) {
      const Index v = q.corners[i];
      if (kept(corner(v)) == kept(centre(p))) continue;
      r.cut[i] = kept(corner(v)) ? add_cut(r_.points[v], corner(v), z, centre(p))
                                 : add_cut(z, centre(p), r_.points[v], corner(v));
    }
    return r;
  }

  void cut_fan(Index p) {
    const SheetPolygon& q = mesh_.polygons[p];
    const Spokes s = spokes(p);
    for (std::size_t i = 0; i < q.count; ++i) {
      const std::size_t k = (i + 1) % q.count;
      const Index a = q.corners[i], b = q.corners[k];
      // Round the triangle: what is kept, and a cut where that changes.
      std::array<Index, 2> cuts{};
      std::size_t cut_count = 0, begin = r_.corners.size();
      const auto put_cut = [&](Index c) {
        if (c == kernel::kNone) return;
        r_.corners.push_back(c);
        cuts[cut_count++] = c;
      };
      if (s.centre != kernel::kNone) r_.corners.push_back(s.centre);
      put_cut(s.cut[i]);
      if (kept(corner(a))) r_.corners.push_back(a);
      if (middle_of_[q.sides[i]] != kernel::kNone) r_.corners.push_back(middle_of_[q.sides[i]]);
      if (kept(corner(a)) != kept(corner(b))) put_cut(cut_of_[q.sides[i]]);
      if (kept(corner(b))) r_.corners.push_back(b);
      put_cut(s.cut[k]);
      if (r_.corners.size() == begin) continue;
      close(p);
      if (cut_count == 2) trim_feature(cuts[0], cuts[1]);
    }
  }

  void cut_segment(Index p) {
    const SheetPolygon& q = mesh_.polygons[p];
    const Spokes s = spokes(p);
    for (std::size_t i = 0; i < 2; ++i) {
      const Index v = q.corners[i];
      if (kept(corner(v))) r_.corners.push_back(v);
      if (s.cut[i] != kernel::kNone) {
        r_.corners.push_back(s.cut[i]);
        trim_feature(s.cut[i], s.cut[i]);
      }
      if (s.centre != kernel::kNone) r_.corners.push_back(s.centre);
      if (r_.corners.size() > r_.first.back()) close(p);
    }
  }

  SheetMesh& mesh_;
  const LevelValues& values_;
  bool plane_;
  std::vector<Index> cut_of_, middle_of_;  ///< an edge's
  TrimmedMesh r_;
};

}  // namespace

TrimmedMesh trim(SheetMesh& mesh, const LevelValues& values) {
  return Trimmer(mesh, values).run();
}

}  // namespace crest::extremal
