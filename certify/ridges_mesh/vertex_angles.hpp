// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Angles around vertices in MPFR intervals: what decides where doubles do not.
#include <memory>
#include <optional>
#include <vector>

#include "certify/container/verdict.hpp"
#include "certify/ridges_mesh/records.hpp"
#include "certify/surface/mesh_checks.hpp"
#include "kernel/arithmetic/mp_interval.hpp"

namespace crest::certify {

/// At one vertex with n faces: a(v, w_k) for k = 0..n (the last is the full scaled angle), phi.
struct VertexAngles {
  std::vector<kernel::MpInterval> sums;
  kernel::MpInterval phi;
};

/// The stages. `rational` feeds the 256-bit intervals with exact products, so that every angle has
/// a relative error below 2^-240 whatever the exponents of the data.
enum class AngleStage : std::size_t { bits128 = 0, bits256 = 1, rational = 2 };

/// Empty if this stage cannot tell whether a direction (x, y) of phi is (0, 0).
std::optional<VertexAngles> enclose_vertex(const MeshData& data, const Topology& topology,
                                           std::uint32_t vertex, AngleStage stage);

/// Rotations omega and face indices by MPFR, for some edges and faces or for all. Enclosures are
/// kept, failures too: a vertex is visited once a stage, an edge once. Throws Undecided.
class MpAngles {
 public:
  MpAngles(const MeshData& data, const Topology& topology, const std::vector<std::int8_t>& acute,
           AngleStage first, AngleCounts& counts);

  /// omega(low, high) of an edge.
  const kernel::MpInterval& rotation(std::uint32_t edge);
  int twice_index(std::uint32_t face);

 private:
  const VertexAngles* vertex(std::uint32_t v, AngleStage stage);
  const kernel::MpInterval& sum_before(const VertexAngles& angles, std::uint32_t side) const;
  std::optional<kernel::MpInterval> try_rotation(std::uint32_t edge, AngleStage stage);

  const MeshData& data_;
  const Topology& topology_;
  const std::vector<std::int8_t>& acute_;
  AngleStage first_;
  AngleCounts& counts_;
  std::array<std::vector<std::unique_ptr<std::optional<VertexAngles>>>, 3> vertices_;
  std::vector<std::unique_ptr<kernel::MpInterval>> rotations_;
};

}  // namespace crest::certify
