// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/smooth_ridges/smooth_ridges.hpp"

#include <algorithm>
#include <cstdio>
#include <stdexcept>

#include "algorithms/smooth_ridges/certificate.hpp"
#include "algorithms/smooth_ridges/completeness.hpp"
#include "algorithms/smooth_ridges/graph.hpp"
#include "algorithms/smooth_ridges/initial_mesh.hpp"
#include "algorithms/smooth_ridges/timed.hpp"
#include "algorithms/smooth_ridges/undefined.hpp"
#include "certify/smooth_witness/record.hpp"

namespace crest::smooth_ridges {
namespace {

constexpr std::size_t kMostCells = 2000000;  // of the completeness tree

const char* likely_reason(FaceStatus status) {
  switch (status) {
    case FaceStatus::chart:
      return "the map to the surface is not proven: the surface may be singular here";
    case FaceStatus::regular:
      return "k1 - k2 is zero within its enclosure: an umbilic that is not generic, or many";
    case FaceStatus::ridge:
      return "an extremality and its derivative are zero within their enclosures: ridges that "
             "touch or end, or a surface of revolution";
    case FaceStatus::type:
      return "the type of a ridge is not decided: a turning point that is not generic";
    case FaceStatus::purple:
      return "blue and red ridges touch within their enclosures";
    case FaceStatus::untested:
      return "not tested before the run was stopped";
    default:
      return "a ridge touches an edge, or runs along the boundary";
  }
}

std::vector<std::string> obstacles_of(const RefinedSurface& refined) {
  std::vector<std::string> lines;
  if (refined.uncertified.empty()) return lines;
  if (const auto& all = refined.singularities; !all.empty()) {
    const std::string more =
        all.size() > 1 ? " and " + std::to_string(all.size() - 1) + " places more" : "";
    lines.push_back((all[0].colour == Colour::blue ? "blue" : "red") +
                    std::string(" ridges cross, touch or are degenerate at ") + text(all[0].place) +
                    more +
                    ": the extremality and its gradient vanish there, so the surface is not "
                    "generic (a symmetry?)");
  }
  lines.push_back((refined.stopped ? "stopped: " : "") +
                  std::to_string(refined.uncertified.size()) + " of " +
                  std::to_string(refined.mesh.faces().size()) + " cells are not certified");
  return lines;
}

class Run {
 public:
  Run(const Surface& surface, const Options& options) : surface_(surface), options_(options) {}

  SmoothRidges run() {
    if (!start()) return std::move(out_);
    refined_ = refine(surface_, std::move(mesh_), options_.refinement, options_.stop);
    out_.seconds.faces = refined_.seconds.faces;
    out_.seconds.umbilics = refined_.seconds.umbilics;
    out_.seconds.bisection = refined_.seconds.bisection;
    out_.rounds = refined_.rounds;
    out_.tests = refined_.tests;
    describe_mesh();
    timed(out_.seconds.graph, [&] { assemble_graph(surface_, refined_, out_); });
    for (const UncertifiedCell& cell : refined_.uncertified) {
      UndecidedCell& open = out_.undecided.emplace_back();  // push_back makes GCC 12 warn of bounds
      open.centre = cell.centre;
      open.size = cell.size;
      open.reason = likely_reason(cell.status);
    }
    out_.stopped = refined_.stopped;
    out_.obstacles = obstacles_of(refined_);
    if (!out_.obstacles.empty()) return std::move(out_);
    if (close()) {
      const auto open = timed(out_.seconds.graph, [&] {
        out_.certificate = make_certificate(surface_, refined_, out_, cover_, sheets_);
        return certify::record_witnesses(out_.certificate);
      });
      out_.certified = !open;
      if (open) out_.obstacles.push_back("the checker's enclosures leave open: " + *open);
    }
    return std::move(out_);
  }

 private:
  /// The first triangulation; implicit: after the box is searched.
  bool start() {
    if (const auto undefined = find_undefined(surface_)) {
      out_.obstacles.push_back(undefined->text);
      return false;
    }
    if (surface_.is_implicit()) {
      const CoverResult covered = timed(out_.seconds.completeness, [&] {
        return cover_box(surface_, kMostCells, options_.stop);
      });
      if (!covered.cover) {
        out_.stopped = covered.failure->reason == CoverFailure::Reason::stopped;
        out_.obstacles.push_back(covered.failure->text);
        return false;
      }
      cover_ = *covered.cover;
    }
    try {
      timed(out_.seconds.start, [&] { triangulate(); });
    } catch (const MeshError& error) {
      out_.stopped = error.reason() == MeshError::Reason::stopped;
      out_.obstacles.push_back(error.what());
    }
    return out_.obstacles.empty();
  }

  /// The first triangulation; implicit: with a vertex in each graph box.
  void triangulate() {
    const int target = options_.start_faces.value_or(surface_.is_implicit() ? 1500 : 400);
    StartPoints points{known_points(cover_), {}};
    for (;;) {
      mesh_ = initial_mesh(surface_, target, points, options_.stop);
      if (!surface_.is_implicit()) return;
      const auto lacking = place_vertices(cover_, mesh_);
      if (!lacking) return;
      // A vertex is near, but of another component: smaller cells there show both.
      const FineSpot& spot = points.known[*lacking];
      const bool tried = std::any_of(points.fine.begin(), points.fine.end(),
                                     [&](const FineSpot& s) { return s.place == spot.place; });
      if (tried) {
        out_.obstacles.push_back("the triangulation lacks the component at " + text(spot.place) +
                                 ": start with more faces");
        return;
      }
      points.fine.push_back({spot.place, spot.size / 2});
    }
  }

  void describe_mesh() {
    Places places(surface_);
    const Triangulation& mesh = refined_.mesh;
    for (const Vertex& v : mesh.vertices()) out_.points.push_back(places(v));
    out_.faces = mesh.faces();
    for (const Index p : refined_.patch_of) out_.in_patch.push_back(p != kNone);
    out_.euler_characteristic = mesh.euler_characteristic();
    for (const Index c : mesh.face_components())
      out_.components = std::max<std::size_t>(out_.components, c + 1);
    out_.boundary_loops = boundary_loops();
  }

  /// A rectangle has one, an annulus two; implicit surfaces and tori none.
  std::size_t boundary_loops() const {
    if (surface_.is_implicit()) return 0;
    return 1 + (surface_.any_period() ? 1 : 0) -
           (surface_.periodic(0) && surface_.periodic(1) ? 2 : 0);
  }

  /// What the faces' proofs leave open.
  bool close() {
    if (surface_.is_implicit()) {
      const std::vector<std::uint8_t> skip(out_.in_patch.begin(), out_.in_patch.end());
      FaceImages images;
      for (const FaceResult& r : refined_.faces) images.push_back(r.image);
      sheets_ = timed(out_.seconds.completeness, [&] {
        return one_sheet(surface_, refined_.mesh, skip, images, options_.stop);
      });
      if (sheets_.stopped) {
        out_.stopped = true;
        out_.obstacles.emplace_back(
            "stopped before it was shown that each component is covered once");
        return false;
      }
      if (sheets_.failed) {
        out_.obstacles.emplace_back("no face shows that its component is covered once");
        return false;
      }
    }
    int sum = 0;
    for (const UmbilicPoint& u : out_.umbilics) sum += u.twice_index;
    if (out_.boundary_loops == 0 && sum != 2 * out_.euler_characteristic) {
      out_.obstacles.emplace_back("the umbilics' indices do not sum to the Euler characteristic");
      return false;
    }
    return true;
  }

  const Surface& surface_;
  const Options& options_;
  SmoothRidges out_;
  Cover cover_;
  Triangulation mesh_;
  RefinedSurface refined_;
  OneSheet sheets_;
};

}  // namespace

SmoothRidges smooth_ridges(const Surface& surface, const Options& options) {
  if (options.start_faces && (*options.start_faces < 8 || *options.start_faces > 10000000))
    throw std::invalid_argument("start faces: a number from 8 to 10000000 is expected");
  return Run(surface, options).run();
}

}  // namespace crest::smooth_ridges
