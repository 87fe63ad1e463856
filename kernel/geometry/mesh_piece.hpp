// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Pieces of a triangle mesh: the vertices that a piece owns, and rings of others' round them.
//
// Numbers ascend as in the whole mesh. So the fan of a vertex all of whose faces are there starts
// where it does in the whole, edges and faces come in the same order, sums run alike: what is
// decided of an owned vertex by looking at owned and inner ones is what the whole mesh decides. No
// more than that is a manifold's: at the rim faces are missing.
#include <cstdint>
#include <span>
#include <vector>

#include "kernel/geometry/triangle_mesh.hpp"

namespace crest::kernel {

/// Of a piece's vertex. rim: faces of it are missing; inner: none is, but another piece owns it.
enum class Role : std::uint8_t { rim, inner, owned };

/// A piece by itself, to be sent to whoever works on it.
struct MeshPart {
  std::vector<Vec3> points;
  std::vector<Triangle> faces;
  std::vector<Role> roles;      ///< a vertex
  std::vector<Index> vertices;  ///< their numbers in the whole mesh, ascending
};

/// What a piece's rules look at. An edge is its lower end's owner's, a face its lowest corner's.
class MeshPiece {
 public:
  /// All of a mesh is a piece of it.
  MeshPiece(const TriangleMesh& mesh) : mesh_(mesh) {}
  /// `mesh`: of the part's points and faces. Both must outlive this.
  MeshPiece(const TriangleMesh& mesh, const MeshPart& part) : mesh_(mesh), roles_(part.roles) {}

  const TriangleMesh& mesh() const { return mesh_; }
  bool is_whole() const { return roles_.empty(); }
  bool owns(Index v) const { return is_whole() || roles_[v] == Role::owned; }
  /// Owned or inner: all its faces are there.
  bool is_inner(Index v) const { return is_whole() || roles_[v] != Role::rim; }
  /// Ascending.
  std::vector<Index> owned_vertices() const;

 private:
  const TriangleMesh& mesh_;
  std::span<const Role> roles_;
};

/// Owned vertices, with all faces of what is fewer than `rings` (at least 1) edges away from one,
/// and those without which the part were no manifold: of vertices with several fans. Requires:
/// owned ascending, not empty. Cost: O(V) for marks, besides the part.
MeshPart mesh_part(const TriangleMesh& mesh, std::span<const Index> owned, Index rings);

/// The points in `count` parts (fewer, if there are fewer points) of nearly the same size, each
/// ascending: cut across the longest side of their box, again and again. Cost: O(V log count).
std::vector<std::vector<Index>> cut_points(std::span<const Vec3> points, Index count);

/// Leaves in `owned` those at the places `left` (ascending), whom a halo was too thin for, and
/// returns the others.
std::vector<Index> take_done(std::vector<Index>& owned, std::span<const Index> left);

}  // namespace crest::kernel
