// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/clean/clean.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "io/clean/collapse.hpp"
#include "io/clean/drop.hpp"
#include "io/clean/fans.hpp"
#include "io/clean/finite.hpp"
#include "io/clean/orient.hpp"
#include "io/clean/triangulate.hpp"
#include "io/clean/weld.hpp"
#include "io/formats/files.hpp"
#include "kernel/geometry/equal_points.hpp"

namespace crest::io {
namespace {

using kernel::Index;
using kernel::kNone;

class Cleaning {
 public:
  Cleaning(const Soup& soup, const CleanOptions& options, Purpose purpose, CleanUp& done)
      : soup_(soup), options_(options), purpose_(purpose), done_(done) {}

  Surface run() {
    surface_ = triangulate(soup_, purpose_ == Purpose::function, done_);
    leave_out();
    if (options_.weld) {
      done_.welded_vertices = weld(surface_, *options_.weld);
      leave_out();
    }
    separate();
    if (purpose_ != Purpose::function) orient();
    if (purpose_ == Purpose::geometry) collapse();
    count_coincident();
    return std::move(surface_);
  }

 private:
  void leave_out() {
    done_.repeated_corners += drop_repeated_corners(surface_);
    if (surface_.faces.empty())
      fail("faces", "all have repeated corners", "export the mesh with its faces");
    done_.unused_vertices += drop_unused(surface_);
    for (const Index point : surface_.point_of) require_finite(soup_, point);
  }

  /// Afterwards every edge has one or two faces and every vertex one fan.
  void separate() {
    std::vector<Side> sides = sorted_sides(surface_);
    done_.duplicate_faces = drop_duplicates(surface_, sides);
    if (done_.duplicate_faces > 0) sides = sorted_sides(surface_);
    const std::size_t crowded = crowded_edges(sides);
    across_ = neighbours(sides);
    done_.split_vertices = split_fans(surface_, across_);
    // Of a fan that ends on both sides of a cut edge the ends meet again.
    if (crowded > 0) across_ = neighbours(sorted_sides(surface_));
    done_.cut_edges = crowded;
  }

  std::size_t crowded_edges(const std::vector<Side>& sides) const {
    std::size_t crowded = 0, first = 0;
    for (std::size_t i = 0, end = 0; i < sides.size(); i = end) {
      end = edge_end(sides, i);
      if (end - i <= 2) continue;
      if (crowded++ == 0) first = i;
    }
    if (crowded == 0 || options_.split) return crowded;
    std::vector<Index> faces;
    for (std::size_t i = first; i < edge_end(sides, first); ++i) faces.push_back(sides[i].face);
    std::sort(faces.begin(), faces.end());
    const auto tag = [&](std::size_t i) { return soup_.cell_tag(surface_.cell_of[faces[i]]); };
    const auto point = [&](Index v) { return soup_.point_tag(surface_.point_of[v]); };
    fail(fmt::format("edge {}-{}", point(sides[first].low), point(sides[first].high)),
         fmt::format("is in faces {}, {} and {}, {} so in all", tag(0), tag(1), tag(2),
                     crowded == 1 ? "1 edge is" : fmt::format("{} edges are", crowded)),
         "separate the sheets that meet there, or cut them apart with " + splitting());
  }

  /// Who asks for connectivity alone does not split.
  std::string splitting() const {
    return purpose_ == Purpose::connectivity ? "crest clean --split" : "--split";
  }

  void orient() {
    Parts parts = parts_of(across_);
    while (!parts.clashes.empty()) {
      const auto [f, k] = parts.clashes[0];
      if (!options_.split) {
        fail(fmt::format("faces {} and {}", tag(std::min(f, across_[f][k].face)),
                         tag(std::max(f, across_[f][k].face))),
             "the surface is one-sided (not orientable)", "cut it open with " + splitting());
      }
      for (const auto& [face, side] : parts.clashes) {
        const Neighbour n = across_[face][side];
        across_[n.face][n.side] = {};
        across_[face][side] = {};
      }
      done_.cut_edges += parts.clashes.size();
      done_.split_vertices += split_fans(surface_, across_);
      across_ = neighbours(sorted_sides(surface_));
      parts = parts_of(across_);
    }
    done_.turned_faces = turn_minorities(surface_, parts);
    const std::vector<bool> marked = inside_out(surface_, parts);
    const auto count = static_cast<std::size_t>(std::count(marked.begin(), marked.end(), true));
    (options_.outward ? done_.turned_parts : done_.inside_out_parts) = count;
    if (options_.outward) turn(surface_, parts, marked);
  }

  void collapse() {
    surface_.places.clear();  // edges that are flipped mix triangles
    const std::vector<Index> flat = collapse_flat_faces(surface_, done_);
    if (surface_.faces.empty()) fail("faces", "none has an area", "export the mesh again");
    if (flat.empty()) return;
    fail(
        face_name(soup_, surface_, flat[0]),
        fmt::format("its area is exactly zero, and no edge of it can be collapsed without a change "
                    "of the surface's topology ({} such faces)",
                    flat.size()),
        "move its vertices apart, or join those that are equal with --weld 0");
  }

  /// Vertices that are split are no others.
  void count_coincident() {
    const std::vector<Index> first = kernel::first_equal(surface_.points);
    std::vector<std::pair<Index, Index>> equal;  // first vertex, point
    for (Index v = 0; v < first.size(); ++v) {
      if (first[v] == v) continue;
      equal.emplace_back(first[v], surface_.point_of[first[v]]);
      equal.emplace_back(first[v], surface_.point_of[v]);
    }
    std::sort(equal.begin(), equal.end());
    equal.erase(std::unique(equal.begin(), equal.end()), equal.end());
    for (std::size_t i = 1; i < equal.size(); ++i)
      done_.coincident_vertices += equal[i].first == equal[i - 1].first;
  }

  std::int64_t tag(Index f) const { return soup_.cell_tag(surface_.cell_of[f]); }

  const Soup& soup_;
  const CleanOptions& options_;
  Purpose purpose_;
  CleanUp& done_;
  Surface surface_;
  Neighbours across_;
};

}  // namespace

Surface clean(const Soup& soup, const CleanOptions& options, Purpose purpose, CleanUp& done) {
  return Cleaning(soup, options, purpose, done).run();
}

}  // namespace crest::io
