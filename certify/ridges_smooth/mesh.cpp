// SPDX-License-Identifier: GPL-3.0-or-later
#include "certify/ridges_smooth/mesh.hpp"

#include <algorithm>

#include "certify/container/reject.hpp"

namespace crest::certify::smooth {
namespace {

using u32 = std::uint32_t;

void number_components(Mesh& mesh, std::size_t faces) {
  mesh.component.assign(faces, kNone);
  std::vector<u32> stack;
  for (u32 first = 0; first < faces; ++first) {
    if (mesh.component[first] != kNone) continue;
    stack.push_back(first);
    mesh.component[first] = mesh.components;
    while (!stack.empty()) {
      const u32 f = stack.back();
      stack.pop_back();
      for (u32 side = 3 * f; side < 3 * f + 3; ++side) {
        const u32 twin = mesh.topology.twin[side];
        if (twin == kNone || mesh.component[twin / 3] != kNone) continue;
        mesh.component[twin / 3] = mesh.components;
        stack.push_back(twin / 3);
      }
    }
    ++mesh.components;
  }
}

/// Disjoint, ascending, marked; fills patch_of.
void claim_patch_faces(const RidgesSmoothCertificate& c, Mesh& mesh) {
  mesh.patch_of.assign(c.faces.size(), kNone);
  std::size_t marked = 0, claimed = 0;
  for (u32 p = 0; p < c.patches.size(); ++p) {
    const auto& faces = c.patches[p].faces;
    require(!faces.empty(), "patch {}: no faces", p);
    require(p == 0 || c.patches[p - 1].faces.front() < faces.front(), "patch {}: not in order", p);
    for (std::size_t i = 0; i < faces.size(); ++i) {
      const u32 f = faces[i];
      require(f < c.faces.size(), "patch {}: no face {}", p, f);
      require(i == 0 || faces[i - 1] < f, "patch {}: faces not ascending", p);
      require(mesh.patch_of[f] == kNone, "patch {}: face {} is in another patch", p, f);
      require(c.face_records[f].in_patch, "patch {}: face {} is not marked", p, f);
      mesh.patch_of[f] = p;
      ++claimed;
    }
  }
  for (const auto& record : c.face_records) marked += record.in_patch;
  require(marked == claimed, "faces: {} marked as in patches, {} are", marked, claimed);
}

/// Connected through sides, Euler characteristic 1, every vertex with its patch faces in one fan.
void check_disk(const RidgesSmoothCertificate& c, const Mesh& mesh, u32 p) {
  const auto& faces = c.patches[p].faces;
  const auto in = [&](u32 f) { return mesh.patch_of[f] == p; };
  std::vector<u32> stack = {faces.front()}, vertices, fans;
  std::vector<std::uint8_t> seen(faces.size(), 0);
  seen[0] = 1;
  std::size_t reached = 0, shared = 0;
  while (!stack.empty()) {
    const u32 f = stack.back();
    stack.pop_back();
    ++reached;
    for (u32 side = 3 * f; side < 3 * f + 3; ++side) {
      vertices.push_back(c.faces[f][side % 3]);
      const u32 twin = mesh.topology.twin[side];
      if (twin == kNone || !in(twin / 3)) {
        fans.push_back(vertices.back());
        continue;
      }
      ++shared;
      auto& mark = seen[static_cast<std::size_t>(
          std::lower_bound(faces.begin(), faces.end(), twin / 3) - faces.begin())];
      if (mark == 0) stack.push_back(twin / 3);
      mark = 1;
    }
  }
  require(reached == faces.size(), "patch {}: not connected", p);
  std::sort(vertices.begin(), vertices.end());
  vertices.erase(std::unique(vertices.begin(), vertices.end()), vertices.end());
  const auto edges = static_cast<std::int64_t>(3 * faces.size() - shared / 2);
  const auto euler =
      static_cast<std::int64_t>(vertices.size()) - edges + static_cast<std::int64_t>(faces.size());
  require(euler == 1, "patch {}: not a disk", p);
  // A fan begins at a corner whose side is not shared: a full cycle has no beginning.
  std::sort(fans.begin(), fans.end());
  require(std::adjacent_find(fans.begin(), fans.end()) == fans.end(),
          "patch {}: touches itself at a vertex", p);
}

/// The coordinate of a face's corner in direction d, lifted.
template <class Lift>
auto lifted(const RidgesSmoothCertificate& c, u32 f, std::size_t corner, std::size_t d,
            const Lift& lift) {
  return lift(c.vertices[c.faces[f][corner]][d]) + lift(lift_of(c, f, corner, d));
}

void check_edges(const RidgesSmoothCertificate& c, const Mesh& mesh) {
  const bool periodic[] = {(c.surface.periodic & 1U) != 0, (c.surface.periodic & 2U) != 0};
  for (const Edge& e : mesh.topology.edges) {
    if (e.forward == kNone || e.backward == kNone) {
      bool on_side = false;
      for (std::size_t d = 0; d < 2; ++d) {
        const double a = c.vertices[e.low][d], b = c.vertices[e.high][d];
        on_side = on_side || (!periodic[d] && a == b && (a == 0 || a == 1));
      }
      require(on_side, "edge {} {}: boundary inside the domain", e.low, e.high);
      continue;
    }
    for (std::size_t d = 0; d < 2; ++d) {
      // Along the side and along its twin in the same direction.
      const auto step = [&](u32 side) {
        return lift_of(c, side / 3, next_corner(side) % 3, d) - lift_of(c, side / 3, side % 3, d);
      };
      require(step(e.forward) == -step(e.backward), "edge {} {}: lifts differ", e.low, e.high);
    }
  }
}

}  // namespace

Mesh check_mesh(const RidgesSmoothCertificate& c) {
  Mesh mesh;
  mesh.topology = build_topology(c.faces, c.vertices.size());
  const bool may_end = c.surface.kind == 1 && c.surface.periodic != 3;
  require(may_end || mesh.topology.boundary_loops == 0, "triangulation: it has a boundary");
  number_components(mesh, c.faces.size());
  claim_patch_faces(c, mesh);
  for (u32 p = 0; p < c.patches.size(); ++p) check_disk(c, mesh, p);
  return mesh;
}

void check_unit_square(const RidgesSmoothCertificate& c, const Mesh& mesh, SignLadder& sign) {
  const unsigned periodic = c.surface.periodic;
  for (u32 v = 0; v < c.vertices.size(); ++v)
    for (std::size_t d = 0; d < 2; ++d) {
      const double x = c.vertices[v][d];
      const bool open = (periodic >> d & 1U) != 0;
      require(x >= 0 && (open ? x < 1 : x <= 1), "vertex {}: outside the domain", v);
    }
  const unsigned allowed = ((periodic & 1U) != 0 ? 7U : 0U) | ((periodic & 2U) != 0 ? 56U : 0U);
  for (u32 f = 0; f < c.lifts.size(); ++f)
    require((c.lifts[f] & ~allowed) == 0, "face {}: a lift in a direction not periodic", f);
  check_edges(c, mesh);
  const auto twice_area = [&](u32 f, auto lift) {
    const auto at = [&](std::size_t i, std::size_t d) { return lifted(c, f, i, d, lift); };
    return (at(1, 0) - at(0, 0)) * (at(2, 1) - at(0, 1)) -
           (at(2, 0) - at(0, 0)) * (at(1, 1) - at(0, 1));
  };
  for (u32 f = 0; f < c.faces.size(); ++f)
    require(sign([&](auto lift) { return twice_area(f, lift); }) == kernel::Sign::positive,
            "face {}: its area is not positive", f);
  const kernel::RoundUpward guard;
  kernel::Interval sum = 0;
  for (u32 f = 0; f < c.faces.size(); ++f)
    sum += twice_area(f, [](double x) { return kernel::Interval(x); });
  require(sum.inf() > 1 && sum.sup() < 3, "triangulation: it does not cover the domain once");
}

}  // namespace crest::certify::smooth
