// SPDX-License-Identifier: GPL-3.0-or-later
// Claim 2, features-mesh: thinning keeps the topology (SPEC.md). No number decides anything: the
// arithmetic option has no effect.
#include "certify/container/checker.hpp"
#include "certify/container/prove.hpp"
#include "certify/container/reject.hpp"
#include "certify/features_mesh/decode.hpp"
#include "certify/surface/input_tie.hpp"
#include "certify/surface/mesh_checks.hpp"

namespace crest::certify {
namespace {

using u8 = std::uint8_t;
using u32 = std::uint32_t;

/// Runs of marked and of unmarked vertices on a vertex's link.
struct LinkRuns {
  u32 marked = 0, unmarked = 0, marked_vertices = 0;
  /// A run is a path unless it is all of the cycle: then it has no first vertex and is not counted.
  bool simple() const { return marked == 1 && unmarked == 1; }
};

/// The link of v: a cycle w_0 .. w_n-1, or at the boundary a path with one vertex more than faces.
LinkRuns link_runs(Faces faces, const Topology& t, const std::vector<u8>& marked, u32 v) {
  const u32 begin = t.ring_start[v], end = t.ring_start[v + 1];
  const u32 last = vertex_of(faces, previous_corner(t.ring[end - 1]));
  LinkRuns runs;
  // A run is counted at its first vertex: on a cycle the one before w_0 is w_n-1, on a path none.
  int before = t.on_boundary[v] ? -1 : marked[vertex_of(faces, next_corner(t.ring[end - 1]))];
  const auto visit = [&](u32 w) {
    const int now = marked[w];
    if (now != before) ++(now ? runs.marked : runs.unmarked);
    runs.marked_vertices += marked[w];
    before = now;
  };
  for (u32 at = begin; at < end; ++at) visit(vertex_of(faces, next_corner(t.ring[at])));
  if (t.on_boundary[v]) visit(last);
  return runs;
}

/// Components of the subcomplex with the given mark by a search of its own; loops from the Euler
/// characteristic.
BettiRecord count_betti(Faces faces, const Topology& t, const std::vector<u8>& marked, u8 mark) {
  std::int64_t euler = 0, components = 0, closed = 0;
  for (const u8 m : marked) euler += m == mark;
  for (const Edge& e : t.edges) euler -= marked[e.low] == mark && marked[e.high] == mark;
  for (const auto& f : faces)
    euler += marked[f[0]] == mark && marked[f[1]] == mark && marked[f[2]] == mark;
  std::vector<u8> seen(marked.size(), 0);
  std::vector<u32> stack;
  for (u32 seed = 0; seed < marked.size(); ++seed) {
    if (marked[seed] != mark || seen[seed]) continue;
    ++components;
    bool whole = true;  // a closed surface all of whose vertices have the mark
    stack.assign(1, seed);
    seen[seed] = 1;
    while (!stack.empty()) {
      const u32 v = stack.back();
      stack.pop_back();
      whole = whole && !t.on_boundary[v];
      for (u32 at = t.ring_start[v]; at < t.ring_start[v + 1]; ++at)
        for (const u32 c : {next_corner(t.ring[at]), previous_corner(t.ring[at])}) {
          const u32 w = vertex_of(faces, c);
          whole = whole && marked[w] == mark;
          if (marked[w] != mark || seen[w]) continue;
          seen[w] = 1;
          stack.push_back(w);
        }
    }
    closed += whole;
  }
  return {static_cast<std::int32_t>(euler), static_cast<u32>(components),
          static_cast<u32>(components + closed - euler), static_cast<u32>(closed)};
}

void require_betti(const BettiRecord& stated, const BettiRecord& found, const char* what) {
  require(stated.euler == found.euler && stated.components == found.components &&
              stated.loops == found.loops && stated.closed == found.closed,
          "{}: Euler characteristic {}, {} components, {} loops, {} closed surfaces stated; "
          "{}, {}, {}, {} found",
          what, stated.euler, stated.components, stated.loops, stated.closed, found.euler,
          found.components, found.loops, found.closed);
}

void require_ascending(const std::vector<u32>& list, std::size_t vertices, const char* what) {
  for (std::size_t i = 0; i < list.size(); ++i) {
    require(list[i] < vertices, "{}: no vertex {}", what, list[i]);
    require(i == 0 || list[i - 1] < list[i], "{}: not ascending", what);
  }
}

/// Step 3. Returns the marks after all removals.
std::vector<u8> replay(const FeaturesMeshCertificate& c, const Topology& t) {
  std::vector<u8> marked = c.marked_before;
  for (std::size_t i = 0; i < c.removed.size(); ++i) {
    const u32 v = c.removed[i];
    require(v < marked.size(), "removal {}: no vertex {}", i, v);
    require(marked[v] == 1, "removal {}: vertex {} is not marked", i, v);
    require(link_runs(c.faces, t, marked, v).simple(), "removal {}: vertex {} is not simple", i, v);
    marked[v] = 0;
  }
  return marked;
}

/// Step 4: the stated set, thin; what is dropped is isolated.
void check_after(const FeaturesMeshCertificate& c, const Topology& t,
                 const std::vector<u8>& marked) {
  require_ascending(c.marked_after, marked.size(), "marked after");
  std::size_t count = 0;
  for (const u8 m : marked) count += m;
  require(count == c.marked_after.size(), "marked after: {} vertices stated, {} found",
          c.marked_after.size(), count);
  for (const u32 v : c.marked_after) {
    require(marked[v] == 1, "marked after: vertex {} was removed", v);
    const LinkRuns runs = link_runs(c.faces, t, marked, v);
    require(!runs.simple() || runs.marked_vertices == 1,
            "marked after: vertex {} is simple and no tip: not thin", v);
  }
  require_ascending(c.dropped, marked.size(), "dropped");
  for (const u32 v : c.dropped)
    require(marked[v] == 1 && link_runs(c.faces, t, marked, v).marked_vertices == 0,
            "dropped: vertex {} is not an isolated marked vertex", v);
}

/// Cost: linear.
void verify_features_mesh(std::span<const std::uint8_t> data, std::span<const std::uint8_t> claims,
                          const VerifyOptions& options, Verdict& verdict) {
  const FeaturesMeshCertificate c = decode_features_mesh(data, claims);
  const Topology t = build_topology(c.faces, c.positions.size());
  prove(verdict, "data: an oriented manifold of {} vertices, {} faces; digests match",
        c.positions.size(), c.faces.size());
  if (options.input) {
    const std::string oriented = check_input(*options.input, c.positions, c.faces);
    prove(verdict, "input: {} holds the same positions and faces, {}; nothing ties the marks to it",
          options.input->name, oriented);
  }
  require_equal(c.euler_characteristic, t.euler_characteristic, "Euler characteristic");
  require_equal(c.boundary_loops, t.boundary_loops, "boundary loops");
  prove(verdict, "topology: Euler characteristic {}, {} boundary loops", t.euler_characteristic,
        t.boundary_loops);

  const std::vector<u8> after = replay(c, t);
  prove(verdict, "removals: {}, each of a simple vertex: homotopy types kept", c.removed.size());
  check_after(c, t, after);
  prove(verdict, "lines: {} vertices left, thin; {} isolated ones dropped", c.marked_after.size(),
        c.dropped.size());

  const BettiRecord marked = count_betti(c.faces, t, after, 1),
                    other = count_betti(c.faces, t, after, 0);
  require_betti(c.betti[0], count_betti(c.faces, t, c.marked_before, 1), "marked before");
  require_betti(c.betti[1], count_betti(c.faces, t, c.marked_before, 0), "complement before");
  require_betti(c.betti[2], marked, "marked after");
  require_betti(c.betti[3], other, "complement after");
  // Simple removals keep them (lemma 3): a difference is an error of the checker.
  require_betti(c.betti[0], marked, "marked, before and after");
  require_betti(c.betti[1], other, "complement, before and after");
  std::vector<u8> lines = after;
  for (const u32 v : c.dropped) lines[v] = 0;
  require_equal(c.components, count_betti(c.faces, t, lines, 1).components,
                "components without the dropped vertices");
  prove(verdict,
        "kept: marked {} components, {} loops, Euler characteristic {}; complement {}, {}, {}; "
        "without the dropped vertices {} components are left",
        marked.components, marked.loops, marked.euler, other.components, other.loops, other.euler,
        c.components);
}

}  // namespace

extern const ClaimChecker features_mesh_claim;
const ClaimChecker features_mesh_claim = {kFeaturesMesh, kFeaturesMeshVersion, "features-mesh",
                                          verify_features_mesh};

}  // namespace crest::certify
