// SPDX-License-Identifier: GPL-3.0-or-later
// Claim 1, ridges-mesh: the steps of SPEC.md, "What the checker proves, in order".

#include <algorithm>

#include "certify/container/checker.hpp"
#include "certify/container/prove.hpp"
#include "certify/container/reject.hpp"
#include "certify/ridges_mesh/angle_index.hpp"
#include "certify/ridges_mesh/checks.hpp"
#include "certify/ridges_mesh/decode.hpp"
#include "certify/ridges_mesh/geometry.hpp"
#include "certify/surface/input_tie.hpp"

namespace crest::certify {
namespace {

/// Step 4: the list is exactly the faces of non-zero index; returns twice their sum.
std::int64_t check_indices(const RidgesMeshCertificate& c, const Topology& topology,
                           const std::vector<std::int8_t>& twice_index) {
  std::size_t listed = 0;
  std::int64_t sum = 0;
  for (std::size_t f = 0; f < twice_index.size(); ++f) {
    if (twice_index[f] == 0) continue;
    sum += twice_index[f];
    require(listed < c.face_indices.size() && c.face_indices[listed].face == f,
            "face {}: its index is not zero and not listed in its place", f);
    require(c.face_indices[listed].twice_index == twice_index[f],
            "face {}: twice the index is {}, {} stated", f, twice_index[f],
            c.face_indices[listed].twice_index);
    ++listed;
  }
  require(listed == c.face_indices.size(), "face indices: a face of index zero is listed");
  require_equal(c.twice_index_sum, sum, "sum of twice the indices");
  // Theorem 1 says so for any data: a difference would be an error of the checker.
  if (topology.boundary_loops == 0 && sum != 2 * topology.euler_characteristic)
    throw std::logic_error("index sum and Euler characteristic contradict theorem 1");
  return sum;
}

void check_counts(const RidgesMeshCertificate& c, const MeshSigns& signs) {
  require_equal(c.conflict_triangles, signs.conflict_triangles, "conflict triangles");
  require_equal(c.ambiguous_edges, signs.ambiguous_edges, "ambiguous edges");
  require_equal(c.zero_extremalities[blue], signs.zero_extremalities[blue], "zeros of b0");
  require_equal(c.zero_extremalities[red], signs.zero_extremalities[red], "zeros of b3");
}

/// In words: what frames of a surface would not have.
std::string check_frames(const RidgesMeshCertificate& c, const FrameCounts& found) {
  require_equal(c.against_faces, found.against_faces, "vertices with n against the faces");
  require_equal(c.equal_curvatures, found.equal_curvatures, "vertices with k1 = k2");
  require_equal(c.parallel_frames, found.parallel_frames, "vertices with n x d1 = 0");
  std::string words;
  const auto add = [&](const char* what, std::uint32_t count) {
    if (count > 0) words += fmt::format("; {} at {}", what, count);
  };
  add("n against the faces", found.against_faces);
  add("k1 = k2", found.equal_curvatures);
  add("n x d1 = 0", found.parallel_frames);
  return words;
}

std::string half(std::int64_t twice) {
  return twice % 2 == 0 ? fmt::format("{}", twice / 2) : fmt::format("{}/2", twice);
}

/// Steps 1 (data) to 7.
void verify_ridges_mesh(std::span<const std::uint8_t> data, std::span<const std::uint8_t> claims,
                        const VerifyOptions& options, Verdict& verdict) {
  RidgesMeshCertificate c;
  c.data = decode_data(data);
  decode_claims(claims, c);
  SignLadder sign(options.arithmetic);
  const Topology topology = build_topology(c.data.faces, c.data.positions.size());
  check_geometry(c.data, sign);
  prove(verdict, "data: an oriented manifold of {} vertices, {} faces; digests match",
        c.data.positions.size(), c.data.faces.size());
  if (options.input) {
    const std::string oriented = check_input(*options.input, c.data.positions, c.data.faces);
    prove(verdict,
          "input: {} holds the same positions and faces, {}; nothing ties the Monge data to it",
          options.input->name, oriented);
  }
  require_equal(c.euler_characteristic, topology.euler_characteristic, "Euler characteristic");
  require_equal(c.boundary_loops, topology.boundary_loops, "boundary loops");
  prove(verdict, "topology: Euler characteristic {}, {} boundary loops",
        topology.euler_characteristic, topology.boundary_loops);

  const MeshSigns signs = decide_signs(c.data, topology, sign);
  check_counts(c, signs);
  const std::string frames = check_frames(c, count_frames(c.data, topology, sign));
  prove(verdict,
        "signs: acute rule on {} edges, {} ambiguous; {} conflict triangles; b0 = 0 at {}, b3 = 0 "
        "at {} vertices{}",
        topology.edges.size(), signs.ambiguous_edges, signs.conflict_triangles,
        signs.zero_extremalities[blue], signs.zero_extremalities[red], frames);

  const auto twice_index =
      face_indices(c.data, topology, signs, options.arithmetic, verdict.angles);
  const std::int64_t sum = check_indices(c, topology, twice_index);
  prove(verdict, "indices: {} faces of non-zero index, sum {}{}", c.face_indices.size(), half(sum),
        topology.boundary_loops == 0 ? ", the Euler characteristic" : "");

  const CheckedMesh mesh{c.data, topology, signs, twice_index};
  const auto patch_of = check_patches(mesh, c.patches, sign);
  prove(verdict,
        "umbilics (for the stated patches): {} disjoint disks of non-zero index, {} coherent, hold "
        "every conflict triangle",
        c.patches.size(),
        std::count_if(c.patches.begin(), c.patches.end(),
                      [](const PatchRecord& p) { return p.coherent == 1; }));
  check_ridges(mesh, patch_of, c.ridges, c.counts, sign);
  prove(verdict,
        "ridges (outside the stated patches): blue {} loops, {} paths; red {} loops, {} paths; all "
        "crossings, no open end",
        c.counts[0], c.counts[1], c.counts[2], c.counts[3]);
  verdict.signs = sign.counts();
}

}  // namespace

extern const ClaimChecker ridges_mesh_claim;
const ClaimChecker ridges_mesh_claim = {kRidgesMesh, kRidgesMeshVersion, "ridges-mesh",
                                        verify_ridges_mesh};

}  // namespace crest::certify
