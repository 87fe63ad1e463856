// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// SPEC.md, "Triangulation" (the manifold of ridges_mesh/SPEC.md) and "What the checker proves", 2.
#include "certify/second/certificate.hpp"

namespace crest::recheck {

class UnionFind {
 public:
  explicit UnionFind(Index n);
  Index find(Index a);
  /// Whether they were apart.
  bool join(Index a, Index b);

 private:
  std::vector<Index> parent_;
};

/// Side i of a face is the edge from its corner i to the next.
struct Edge {
  std::array<Index, 2> face, side;  ///< those of its faces
  int faces = 0;
};

struct Complex {
  static constexpr Index kNone = static_cast<Index>(-1);

  /// Proves that the faces are an oriented manifold, with the numbers of the claim, and that the
  /// patches are disjoint disks and marked.
  explicit Complex(const Certificate& c);

  bool closed() const { return boundary_edges == 0; }
  /// Two faces of one patch.
  bool interior_to_patch(const Edge& e) const {
    return e.faces == 2 && patch_of[e.face[0]] != kNone &&
           patch_of[e.face[0]] == patch_of[e.face[1]];
  }

  std::vector<Edge> edges;
  std::vector<std::array<Index, 3>> edge_of;  ///< by face and side
  std::vector<Index> patch_of;                ///< by face
  std::vector<Index> component_of;            ///< by face
  Index boundary_edges = 0;

 private:
  void glue(const Certificate& c);
  void check_vertices(const Certificate& c);
  void check_counts(const Certificate& c);
  void check_patches(const Certificate& c);
  void check_disk(const Certificate& c, const PatchRecord& p);
};

}  // namespace crest::recheck
