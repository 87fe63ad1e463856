// SPDX-License-Identifier: GPL-3.0-or-later
// Claim 15, lineart: what is visible of the contours of a set of triangles, and that hatches are
// images of continuous curves on it (SPEC.md).
#include "certify/container/checker.hpp"
#include "certify/container/parallel.hpp"
#include "certify/container/prove.hpp"
#include "certify/container/reject.hpp"
#include "certify/lineart/contours.hpp"
#include "certify/lineart/decode.hpp"
#include "certify/lineart/page.hpp"
#include "certify/surface/input_tie.hpp"

namespace crest::certify {
namespace {

using u32 = std::uint32_t;

/// Step 1.
void check_data(const LineArtCertificate& c) {
  std::vector<bool> used(c.points.size(), false);
  for (u32 f = 0; f < c.faces.size(); ++f) {
    const auto [p, q, r] = c.faces[f];
    require(std::max({p, q, r}) < c.points.size(), "face {}: a vertex is out of range", f);
    require(p != q && q != r && r != p, "face {}: repeats a vertex", f);
    used[p] = used[q] = used[r] = true;
  }
  for (u32 v = 0; v < c.points.size(); ++v) require(used[v], "vertex {}: is in no face", v);
  std::vector<std::array<double, 3>> sorted = c.points;
  std::sort(sorted.begin(), sorted.end());
  require(std::adjacent_find(sorted.begin(), sorted.end()) == sorted.end(),
          "vertices: two have the same place");
  for (std::size_t i = 0; i < c.creases.size(); ++i)
    require(c.creases[i][0] < c.creases[i][1], "crease {}: its ends are not in order", i);
  check_view(c);
}

void compare(const LineEdge& stated, const FoundEdge& found) {
  const auto [low, high] = std::array{found.edge.low, found.edge.high};
  require(stated.low == low && stated.high == high, "edge {}-{}: is to be drawn, not {}-{}", low,
          high, stated.low, stated.high);
  require(stated.pieces.size() == found.pieces.size(), "edge {}-{}: {} pieces stated, {} found",
          low, high, stated.pieces.size(), found.pieces.size());
  for (std::size_t i = 0; i < found.pieces.size(); ++i) {
    require(stated.pieces[i] == found.pieces[i],
            "edge {}-{}: piece {} has {} faces in front, {} of them hiding it, not {} and {}", low,
            high, i, found.pieces[i].front, found.pieces[i].hiding, stated.pieces[i].front,
            stated.pieces[i].hiding);
    if (i < found.breaks.size())
      require(stated.breaks[i] == found.breaks[i].events,
              "edge {}-{}: other events between pieces {} and {}", low, high, i, i + 1);
  }
}

/// Steps 2 to 4.
std::vector<FoundEdge> check_edges(const LineArtCertificate& c, const Contours& contours) {
  const std::vector<SceneEdge>& drawn = contours.drawn();
  require(c.edges.size() == drawn.size(), "edges: {} stated, {} are to be drawn", c.edges.size(),
          drawn.size());
  std::vector<FoundEdge> found(drawn.size());
  parallel_for(
      drawn.size(), [] { return 0; },
      [&](int, std::size_t i) {
        found[i] = contours.find(drawn[i]);
        compare(c.edges[i], found[i]);
      });
  return found;
}

/// Cost: linear for meshes whose faces are small in the picture; 0.1 ms a degeneracy.
void verify_line_art(std::span<const std::uint8_t> data, std::span<const std::uint8_t> claims,
                     const VerifyOptions& options, Verdict& verdict) {
  const LineArtCertificate c = decode_line_art(data, claims);
  check_data(c);
  prove(verdict,
        "data: {} vertices at different places, {} faces, a {} view of them; digests match",
        c.points.size(), c.faces.size(), c.parallel ? "parallel" : "central");
  if (options.input) {
    const std::string oriented = check_input(*options.input, c.points, c.faces);
    prove(verdict, "input: {} holds the same positions and faces, {}", options.input->name,
          oriented);
  }
  const Contours contours(c);
  const std::vector<FoundEdge> found = check_edges(c, contours);
  std::size_t pieces = 0, visible = 0, events = 0;
  for (const FoundEdge& edge : found) {
    for (const LineBreak& at : edge.breaks) events += at.events.size();
    pieces += edge.pieces.size();
    for (const LinePiece& piece : edge.pieces) visible += piece.hiding == 0;
  }
  prove(verdict,
        "contours: {} edges to be drawn, {} occluding ones, {} events on them, {} pieces, {} of "
        "them visible",
        found.size(), contours.occluding(), events, pieces, visible);
  if (contours.symbolic() == 0)
    prove(verdict, "perturbation: not needed, theorem 23 holds for the scene itself");
  else
    prove(verdict,
          "perturbation: {} signs are those of the perturbed scene (theorem 23); of the scene "
          "itself theorem 24 holds",
          contours.symbolic());
  check_hatches(c, found);
  prove(verdict, "hatches: {} curves, each continuous on the surface, none over a contour",
        c.hatches.size());
}

}  // namespace

extern const ClaimChecker lineart_claim;
const ClaimChecker lineart_claim = {kLineArt, kLineArtVersion, "lineart", verify_line_art};

}  // namespace crest::certify
