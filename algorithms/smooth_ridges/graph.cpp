// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/smooth_ridges/graph.hpp"

#include <cmath>

namespace crest::smooth_ridges {
namespace {

/// An edge as a face sees it.
struct Side {
  Index face;
  std::size_t edge;
};

class Assembly {
 public:
  Assembly(const Surface& surface, const RefinedSurface& refined, SmoothRidges& out)
      : mesh_(refined.mesh), refined_(refined), places_(surface), out_(out) {
    if (surface.is_implicit()) projection_.emplace(surface);
  }

  void run() {
    for (const UmbilicPatch& p : refined_.patches) {
      const SurfacePoint& c = p.umbilic.centre;
      out_.umbilics.push_back({projection_ ? in_space(c) : places_({c.z[0], c.z[1]}),
                               p.umbilic.branches.twice_index, p.umbilic.branches.count});
    }
    for (std::size_t j = 0; j < 2; ++j) trace(j);
    for (Index f = 0; f < mesh_.faces().size(); ++f) {
      if (!usable(f)) continue;
      const FaceResult& r = refined_.faces[f];
      for (std::size_t j = 0; j < 2; ++j)
        if (r.colour[j].type == RidgeType::turning)
          out_.turning_points.push_back({at(f, arc_middle(r.colour[j])), static_cast<Colour>(j)});
      if (r.purple) out_.purple_points.push_back({at(f, meeting(r))});
    }
  }

 private:
  using Barycentric = std::array<double, 3>;

  /// Outside patches and proven.
  bool usable(Index f) const {
    return refined_.patch_of[f] == kNone && refined_.faces[f].status == FaceStatus::proven;
  }
  bool crossed(const Side& s, std::size_t j) const {
    return usable(s.face) && refined_.faces[s.face].colour[j].crossed[s.edge];
  }
  Side opposite(const Side& s) const {
    const Index n = mesh_.neighbours()[s.face][s.edge];
    return n == kNone ? Side{kNone, 0} : Side{n, mesh_.edge_towards(n, s.face)};
  }
  Side other_crossing(const Side& s, std::size_t j) const {
    for (std::size_t k = 0; k < 3; ++k)
      if (k != s.edge && refined_.faces[s.face].colour[j].crossed[k]) return {s.face, k};
    return {kNone, 0};
  }
  /// Whether a ridge that leaves its face here ends: at a patch, the boundary, or an unproven face.
  bool ends_at(const Side& s) const {
    const Index n = mesh_.neighbours()[s.face][s.edge];
    return n == kNone || !usable(n);
  }

  void trace(std::size_t j) {
    seen_.assign(mesh_.faces().size(), false);
    // Paths from their ends first; what is left are loops.
    for (const bool loops : {false, true})
      for (Index f = 0; f < mesh_.faces().size(); ++f)
        for (std::size_t k = 0; k < 3; ++k)
          if (crossed({f, k}, j) && !seen_[f] && (loops || ends_at({f, k})))
            follow({f, k}, j, loops);
  }

  void follow(const Side& start, std::size_t j, bool loop) {
    SmoothRidge ridge;
    ridge.colour = static_cast<Colour>(j);
    ridge.loop = loop;
    if (!loop) enter(ridge, start, 0);
    Side in = start;
    for (;;) {
      ridge.points.push_back(at(in.face, on_edge(in, j)));
      seen_[in.face] = true;
      ridge.types.push_back(refined_.faces[in.face].colour[j].type);
      const Side out = other_crossing(in, j);
      if (ends_at(out)) {
        ridge.points.push_back(at(out.face, on_edge(out, j)));
        enter(ridge, out, 1);
        break;
      }
      in = opposite(out);
      if (seen_[in.face]) break;
    }
    out_.ridges.push_back(std::move(ridge));
  }

  /// The ridge's end beyond a side: the umbilic, if there is one.
  void enter(SmoothRidge& ridge, const Side& s, std::size_t end) {
    const Index n = mesh_.neighbours()[s.face][s.edge];
    if (n == kNone || refined_.patch_of[n] == kNone) return;
    ridge.ends[end] = refined_.patch_of[n];
    const Vec3& umbilic = out_.umbilics[ridge.ends[end]].point;
    ridge.points.push_back(umbilic);
    ridge.types.push_back(RidgeType::none);
  }

  Barycentric on_edge(const Side& s, std::size_t j) const {
    // Both faces of an edge name one point: that of the lower face that knows it.
    const Side o = opposite(s);
    const bool mine = o.face == kNone || !usable(o.face) || s.face < o.face ||
                      !refined_.faces[o.face].colour[j].crossed[o.edge];
    const double t = mine ? refined_.faces[s.face].colour[j].at[s.edge]
                          : 1 - refined_.faces[o.face].colour[j].at[o.edge];
    Barycentric l{};
    l[s.edge] = 1 - t;
    l[(s.edge + 1) % 3] = t;
    return l;
  }
  static std::array<Barycentric, 2> arc(const ColourResult& c) {
    std::array<Barycentric, 2> ends{};
    std::size_t n = 0;
    for (std::size_t k = 0; k < 3; ++k)
      if (c.crossed[k] && n < 2) {
        ends[n][k] = 1 - c.at[k];
        ends[n++][(k + 1) % 3] = c.at[k];
      }
    return ends;
  }
  static Barycentric arc_middle(const ColourResult& c) {
    const auto [a, b] = arc(c);
    return {(a[0] + b[0]) / 2, (a[1] + b[1]) / 2, (a[2] + b[2]) / 2};
  }
  /// Where the straight arcs of the two colours meet.
  static Barycentric meeting(const FaceResult& r) {
    const auto [a, b] = arc(r.colour[0]);
    const auto [c, d] = arc(r.colour[1]);
    const double u1 = b[1] - a[1], u2 = b[2] - a[2], v1 = d[1] - c[1], v2 = d[2] - c[2];
    const double det = u1 * v2 - u2 * v1;
    double t = ((c[1] - a[1]) * v2 - (c[2] - a[2]) * v1) / det;
    if (!(t >= 0 && t <= 1)) t = 0.5;
    return {a[0] + t * (b[0] - a[0]), a[1] + t * u1, a[2] + t * u2};
  }

  /// A point of the surface from barycentric coordinates.
  Vec3 at(Index face, const Barycentric& l) {
    const auto corners = mesh_.corners(face);
    Vertex m{};
    for (std::size_t k = 0; k < 6; ++k)
      m[k] = l[0] * corners[0][k] + l[1] * corners[1][k] + l[2] * corners[2][k];
    if (!projection_) return places_(m);
    const Vec3 p = position(m);
    double size = 0;
    for (const Vertex& c : corners) size = std::fmax(size, norm(position(c) - p));
    const auto on = projection_->along(p, normal(m), size);
    return on ? *on : p;
  }

  const Triangulation& mesh_;
  const RefinedSurface& refined_;
  Places places_;
  std::optional<Projection> projection_;
  SmoothRidges& out_;
  std::vector<bool> seen_;  ///< faces whose arc of the present colour is drawn
};

}  // namespace

void assemble_graph(const Surface& surface, const RefinedSurface& refined, SmoothRidges& out) {
  Assembly(surface, refined, out).run();
}

}  // namespace crest::smooth_ridges
