// SPDX-License-Identifier: GPL-3.0-or-later
// Claim 14, coding: a stream decodes to a mesh (SPEC.md).
#include <algorithm>
#include <bit>
#include <cmath>

#include "certify/coding/decode.hpp"
#include "certify/coding/stream.hpp"
#include "certify/container/checker.hpp"
#include "certify/container/prove.hpp"
#include "certify/container/reject.hpp"
#include "certify/container/sha256.hpp"
#include "certify/surface/input_tie.hpp"
#include "certify/surface/mesh_checks.hpp"
#include "certify/surface/union_find.hpp"
#include "kernel/arithmetic/rational.hpp"

namespace crest::certify {
namespace {

using u32 = std::uint32_t;
using kernel::Rational;

/// Step 2. What the mesh is, counted from its faces. Returns whether every component is a sphere or
/// a disc.
bool check_counts(const CodingCertificate& c, const Topology& topology) {
  UnionFind parts(c.positions.size());
  for (const Edge& edge : topology.edges) parts.join(edge.low, edge.high);
  std::vector<std::int64_t> euler(c.positions.size(), 0);
  for (u32 v = 0; v < c.positions.size(); ++v) ++euler[parts.find(v)];
  for (const Edge& edge : topology.edges) --euler[parts.find(edge.low)];
  for (const auto& face : c.faces) ++euler[parts.find(face[0])];
  u32 components = 0;
  bool simple = true;
  for (u32 v = 0; v < c.positions.size(); ++v) {
    if (parts.find(v) != v) continue;
    ++components;
    simple = simple && euler[v] >= 1;
  }
  require_equal(c.components, components, "components");
  require_equal(c.loops, topology.boundary_loops, "boundary loops");
  // V - E + F = 2 components - 2 handles - loops.
  const std::int64_t twice =
      2 * std::int64_t{components} - topology.boundary_loops - topology.euler_characteristic;
  require_equal(2 * std::int64_t{c.handles}, twice, "handles, twice");
  return simple;
}

/// The faces in the mesh's numbers, each with its least corner first.
FaceList in_place(const FaceList& faces, const std::vector<u32>& permutation) {
  FaceList list = faces;
  for (auto& face : list) {
    for (u32& v : face) v = permutation[v];
    std::rotate(face.begin(), std::min_element(face.begin(), face.end()), face.end());
  }
  return list;
}

/// Step 4.
void check_isomorphism(const CodingCertificate& c, const DecodedMesh& decoded) {
  std::vector<bool> seen(c.positions.size(), false);
  for (u32 i = 0; i < c.permutation.size(); ++i) {
    const u32 v = c.permutation[i];
    require(v < seen.size() && !seen[v], "permutation: {} at place {} is no new vertex", v, i);
    require(!c.keep_order || v == i, "permutation: the order is to be kept, {} is {}", i, v);
    seen[v] = true;
  }
  std::vector<u32> same(c.positions.size());
  for (u32 v = 0; v < same.size(); ++v) same[v] = v;
  FaceList stated = in_place(c.faces, same), found = in_place(decoded.faces, c.permutation);
  if (!c.keep_order) {
    std::sort(stated.begin(), stated.end());
    std::sort(found.begin(), found.end());
  }
  for (std::size_t f = 0; f < stated.size(); ++f)
    require(stated[f] == found[f], "faces: {} {} {} is not among those of the stream", stated[f][0],
            stated[f][1], stated[f][2]);
}

bool within(const std::array<std::uint64_t, 3>& p, const std::array<std::uint64_t, 3>& q,
            const Rational& square) {
  Rational sum = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    const Rational d =
        Rational(std::bit_cast<double>(p[k])) - Rational(std::bit_cast<double>(q[k]));
    sum += d * d;
  }
  return sum <= square;
}

/// Step 5.
void check_positions(const CodingCertificate& c, const DecodedMesh& decoded) {
  if (c.mode == CodingMode::connectivity) return;
  const Rational square = Rational(c.tolerance) * Rational(c.tolerance);
  for (u32 i = 0; i < c.permutation.size(); ++i) {
    const auto &found = decoded.positions[i], &stated = c.positions[c.permutation[i]];
    if (c.mode == CodingMode::exact)
      require(found == stated, "vertex {}: its place is another in the stream", c.permutation[i]);
    else
      require(within(found, stated, square), "vertex {}: is moved by more than the tolerance",
              c.permutation[i]);
  }
}

/// Step 6: 5 log2 phi = 3.4713 bits a vertex.
bool is_small(const CodingCertificate& c, const DecodedMesh& decoded) {
  const std::uint64_t flags = c.components > 1 ? (c.components + 7) / 8 : 0;
  const std::uint64_t bytes = (34713 * std::uint64_t{c.positions.size()} + 79999) / 80000;
  return decoded.connectivity_bytes <= bytes + 8 + flags;
}

const char* name_of(int method) {
  constexpr std::array names = {"valence", "fan", "zigzag", "static"};
  return names[static_cast<std::size_t>(method)];
}

/// Cost: linear but for sorting faces; a rational comparison a vertex for a tolerance.
void verify_coding(std::span<const std::uint8_t> data, std::span<const std::uint8_t> claims,
                   const VerifyOptions& options, Verdict& verdict) {
  const CodingCertificate c = decode_coding(data, claims);
  verdict.fields = {sha256({std::span<const std::uint8_t>(c.stream)})};
  const bool tolerant = c.mode == CodingMode::tolerance;
  require(tolerant ? c.tolerance > 0 : c.tolerance == 0, "tolerance: does not fit the mode");
  const Topology topology = build_topology(c.faces, c.positions.size());
  prove(verdict, "data: an oriented manifold of {} vertices, {} faces; {} unused vertices left out",
        c.positions.size(), c.faces.size(), c.dropped);
  if (options.input) {
    std::vector<std::array<double, 3>> places;
    for (const auto& p : c.positions)
      places.push_back(
          {std::bit_cast<double>(p[0]), std::bit_cast<double>(p[1]), std::bit_cast<double>(p[2])});
    const std::string oriented = check_input(*options.input, places, c.faces);
    prove(verdict, "input: {} holds the same positions and faces, {}", options.input->name,
          oriented);
  }
  const bool simple = check_counts(c, topology);
  prove(verdict, "topology: {} components, {} handles, {} boundary loops", c.components, c.handles,
        c.loops);
  const DecodedMesh decoded = decode_stream(c.stream, c.positions.size(), c.faces.size());
  require(decoded.components == c.components && decoded.handles == c.handles &&
              decoded.loops == c.loops,
          "stream: components, handles or loops are others");
  require(decoded.positions_mode == static_cast<int>(c.mode), "stream: is of another mode");
  require(decoded.ordered == c.keep_order, "stream: the order is kept or not, unlike the claim");
  prove(verdict, "stream: {} bytes, method {}, decoded{}", c.stream.size(), name_of(decoded.method),
        decoded.has_attributes ? " without its attributes section; whether a decoder accepts that "
                                 "section is not claimed"
                               : "");
  check_isomorphism(c, decoded);
  prove(verdict, "connectivity: the decoded faces are those of the mesh, turned as they are{}",
        c.keep_order ? ", in its order" : "");
  check_positions(c, decoded);
  if (c.mode == CodingMode::exact)
    prove(verdict, "positions: equal to the last bit");
  else if (tolerant)
    prove(verdict, "positions: every vertex within {} of its place", c.tolerance);
  if (simple && is_small(c, decoded))
    prove(verdict, "size: {} bytes of connectivity, at most 3.4713 bits a vertex and 8 bytes{}",
          decoded.connectivity_bytes, c.components > 1 ? ", and a bit a component" : "");
}

}  // namespace

extern const ClaimChecker coding_claim;
const ClaimChecker coding_claim = {kCoding, kCodingVersion, "coding", verify_coding};

}  // namespace crest::certify
