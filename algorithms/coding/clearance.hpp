// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Vertices of valence 3 taken out of a mesh before its connectivity is coded, round by round, and
// put back by one decision a face and round (section 4.3.6; docs/cmc-format.md, "Clearance").
#include <array>
#include <functional>
#include <span>
#include <vector>

#include "algorithms/coding/range_coder.hpp"
#include "algorithms/coding/surface.hpp"

namespace crest::coding {

/// A mesh without interior vertices of valence 3, as far as rounds pay.
class Clearance {
 public:
  explicit Clearance(const Surface& surface);

  /// What is left; as many components, loops and handles as before.
  Index vertices() const { return vertices_; }
  std::span<const Triangle> faces() const { return faces_; }
  bool empty() const { return rounds_ == 0; }

  /// The section's bytes for those of what is left, whose order becomes that of the mesh.
  Bytes finish(const Bytes& base, CodedOrder& order) const;

 private:
  /// A face of some round, from one of its corners on.
  struct Turned {
    Index node, first;
  };
  /// The mesh's faces come first; the others were made of three.
  struct Node {
    int round = 0;                     ///< that made it, from 1; 0: of the mesh
    std::array<Turned, 3> children{};  ///< at its edges, with the lost vertex last
  };
  class Round;

  Index vertices_, mesh_faces_;
  int rounds_ = 0;
  std::vector<Node> nodes_;
  std::vector<Index> left_;      ///< nodes of what is left
  std::vector<Triangle> faces_;  ///< the same, with vertices numbered without gaps
};

/// The faces of such a section. `decode_base` gives those of what is left, of its bytes and counts.
/// Throws: StreamError.
std::vector<Triangle> decode_cleared(
    std::span<const std::uint8_t> bytes, const Counts& counts, Index max_faces,
    const std::function<std::vector<Triangle>(std::span<const std::uint8_t>, const Counts&)>&
        decode_base);

}  // namespace crest::coding
