// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// A slow producer of certificates written straight from certify/ridges_mesh/SPEC.md: exact
// rationals for every sign, 100 digits for angles where 64 bits are not clear. It shares no code
// with the checker or with algorithms/. For meshes of up to a few hundred faces.
#include <map>
#include <optional>
#include <utility>
#include <vector>

#include "certify/ridges_mesh/encode.hpp"
#include "tests/support/random.hpp"

namespace crest::tests {

/// A patch before its numbers are known: the central face and all faces, ascending.
struct PatchFaces {
  std::uint32_t centre;
  std::vector<std::uint32_t> faces;
};

class ReferenceRidges {
 public:
  explicit ReferenceRidges(const certify::MeshData& data);

  /// Do the data meet the requirements? Nothing below may be called otherwise.
  bool valid() const { return valid_; }
  const std::vector<int>& twice_index() const { return twice_index_; }

  /// One face for each face of non-zero index.
  std::vector<PatchFaces> single_faces() const;
  /// As single_faces(), each grown at random by up to `size` faces of index zero where the result
  /// is a coherent disk.
  std::vector<PatchFaces> grown(std::size_t size, Random& random) const;
  /// The certificate with these patches; empty if they do not meet the definition.
  std::optional<certify::RidgesMeshCertificate> certificate(
      const std::vector<PatchFaces>& patches) const;

 private:
  using Pair = std::pair<std::uint32_t, std::uint32_t>;
  struct Ring {
    std::vector<std::uint32_t> neighbours, faces;  ///< w_0.., the face of w_k and w_(k+1)
    bool closed = false;
  };
  struct Side {
    std::size_t edge;
    std::uint32_t from, to;
  };

  bool build_edges();
  bool build_rings();
  bool check_numbers() const;
  void decide_signs();
  template <class Real>
  bool find_indices(Real clear);
  int beta(std::size_t colour, std::uint32_t v) const;
  bool crossed(std::size_t colour, std::size_t edge) const;
  std::array<Side, 3> sides(std::uint32_t face) const;
  unsigned crossing_type(std::size_t colour, std::size_t edge) const;
  unsigned segment_type(std::size_t colour, std::uint32_t face) const;
  std::uint32_t least_gap_corner(std::uint32_t face) const;
  unsigned kind(std::uint32_t face) const;
  std::uint32_t central_face(const std::vector<std::uint32_t>& faces) const;
  void count_frames(certify::RidgesMeshCertificate& out) const;
  bool is_disk(const std::vector<std::uint32_t>& faces) const;
  bool is_coherent(const std::vector<std::uint32_t>& faces) const;
  void trace(std::size_t colour, const std::vector<int>& patch_of,
             certify::RidgesMeshCertificate& out) const;
  std::uint32_t boundary_loops() const;

  const certify::MeshData data_;
  bool valid_ = false;
  std::vector<Pair> edges_;
  std::map<Pair, std::size_t> edge_number_;
  std::vector<std::vector<std::uint32_t>> edge_faces_;
  std::vector<Ring> rings_;
  std::vector<int> acute_, twice_index_;
  std::uint32_t ambiguous_ = 0;
};

}  // namespace crest::tests
