// SPDX-License-Identifier: GPL-3.0-or-later
#include "certify/modes/cells.hpp"

#include <algorithm>

#include "certify/container/reject.hpp"
#include "certify/surface/union_find.hpp"

namespace crest::certify::modes {
namespace {

/// Leaf edges along a face's edge, in its direction.
void list_leaf_edges(const Trees& trees, Side side, std::vector<Side>& leaves) {
  const EdgeNode& edge = trees.edges[side.node];
  if (edge.leaf()) {
    leaves.push_back(side);
    return;
  }
  const Side low = {side.node + 1, side.reversed}, high = {edge.other, side.reversed};
  list_leaf_edges(trees, side.reversed ? high : low, leaves);
  list_leaf_edges(trees, side.reversed ? low : high, leaves);
}

/// The segments of the leaf edges on some leaf faces of a cell's boundary, joined within faces:
/// which of them are in one region of the faces' union.
class Regions {
 public:
  Regions(const LevelContext& context, Worker& worker, int level)
      : context_(context), worker_(worker), level_(level) {}

  /// Components of the part where mode is above the level (or is not). `level` -1: turned round.
  u32 count(const std::vector<u32>& faces, bool above) {
    sides_.clear();
    for (const u32 face : faces)
      for (const Side& side : context_.trees.faces[face].edges)
        list_leaf_edges(context_.trees, side, sides_);
    number_segments();
    UnionFind classes(first_.back());
    for (const u32 face : faces) join_face(context_.trees.faces[face], classes);
    std::vector<u32> found;
    for (std::size_t i = 0; i < edges_.size(); ++i) {
      const EdgeNode& edge = context_.trees.edges[edges_[i]];
      State state = context_.state(edge.first, worker_);
      for (u32 k = 0; k <= edge.roots; ++k) {
        if ((state == level_) == above) found.push_back(classes.find(first_[i] + k));
        if (k < edge.roots)
          state = state != 0 ? State{0} : context_.stated.roots[edge.root + k].level;
      }
    }
    std::ranges::sort(found);
    return static_cast<u32>(std::unique(found.begin(), found.end()) - found.begin());
  }

 private:
  void number_segments() {
    edges_.clear();
    for (const Side& side : sides_) edges_.push_back(side.node);
    std::ranges::sort(edges_);
    edges_.erase(std::unique(edges_.begin(), edges_.end()), edges_.end());
    first_.assign(1, 0);
    for (const u32 edge : edges_)
      first_.push_back(first_.back() + context_.trees.edges[edge].roots + 1);
  }

  void join_face(const FaceNode& face, UnionFind& classes) {
    sides_.clear();
    for (const Side& side : face.edges) list_leaf_edges(context_.trees, side, sides_);
    // The segments before and after each root, round the face.
    std::vector<std::array<u32, 2>> beside;
    std::vector<u32> roots;
    u32 last = 0, start = 0;
    for (std::size_t i = 0; i < sides_.size(); ++i) {
      const EdgeNode& edge = context_.trees.edges[sides_[i].node];
      const auto at = std::ranges::lower_bound(edges_, sides_[i].node) - edges_.begin();
      const u32 base = first_[static_cast<std::size_t>(at)];
      const bool reversed = sides_[i].reversed;
      const u32 here = reversed ? base + edge.roots : base;
      if (i == 0)
        start = here;
      else
        classes.join(last, here);  // a vertex between them is in one region
      last = here;
      for (u32 k = 0; k < edge.roots; ++k) {
        const u32 next = reversed ? last - 1 : last + 1;
        beside.push_back({last, next});
        roots.push_back(edge.root + (reversed ? edge.roots - 1U - k : k));
        last = next;
      }
    }
    classes.join(last, start);
    for (u32 i = 0; i < face.arcs; ++i) {
      const auto [a, b] = context_.stated.arcs[face.arc + i];
      classes.join(beside[a][0], beside[b][1]);
      classes.join(beside[a][1], beside[b][0]);
      if (context_.stated.roots[roots[a]].level != level_) classes.join(beside[a][0], beside[a][1]);
    }
  }

  const LevelContext& context_;
  Worker& worker_;
  int level_;
  std::vector<Side> sides_;
  std::vector<u32> edges_, first_;
};

Direction<4> direction(const LevelContext& context, const Cell& cell) {
  const auto& w = context.stated.tet_witnesses[cell.witness].w;
  return {w[0], w[1], w[2], -(w[0] + w[1] + w[2])};
}

/// Pieces of a cell whose witness holds.
class CellCheck {
 public:
  CellCheck(const LevelContext& context, const Cell& cell, Worker& worker)
      : context_(context), cell_(cell), worker_(worker), w_(direction(context, cell)) {}

  CellPieces run() {
    const TetWitness& witness = context_.stated.tet_witnesses[cell_.witness];
    for (unsigned i = 0; i < 4; ++i) list_leaves(context_.trees, cell_.facets[i], leaves_[i]);
    number_roots();
    find_loops();
    add_pieces(1, witness.pieces[0]);
    add_pieces(-1, witness.pieces[1]);
    return std::move(pieces_);
  }

 private:
  template <class... Arguments>
  void require_here(bool condition, fmt::format_string<Arguments...> text,
                    Arguments&&... arguments) const {
    if (!condition) {
      const auto& v = cell_.corners;
      throw Reject(fmt::format("cell ({}, {}, {}, {}): {}", v[0], v[1], v[2], v[3],
                               fmt::format(text, std::forward<Arguments>(arguments)...)));
    }
  }

  void number_roots() {
    for (const auto& leaves : leaves_)
      for (const u32 leaf : leaves) list_arcs(context_, leaf, arcs_);
    for (const FaceArc& arc : arcs_) {
      roots_.push_back(arc.first);
      roots_.push_back(arc.second);
    }
    std::ranges::sort(roots_);
    for (std::size_t i = 0; i < roots_.size(); ++i)
      require_here((i % 2 == 0) != (i > 0 && roots_[i] == roots_[i - 1]),
                   "a root without two arcs");
    roots_.erase(std::unique(roots_.begin(), roots_.end()), roots_.end());
    require_here(2 * roots_.size() == 2 * arcs_.size(), "a root without two arcs");
    pieces_.roots = static_cast<u32>(roots_.size());
  }
  u32 local(u32 root) const {
    return static_cast<u32>(std::ranges::lower_bound(roots_, root) - roots_.begin());
  }

  /// A loop is named by its least root.
  void find_loops() {
    UnionFind classes(roots_.size());
    for (const FaceArc& arc : arcs_) classes.join(local(arc.first), local(arc.second));
    for (u32 i = 0; i < roots_.size(); ++i) loop_of_.push_back(classes.find(i));
  }

  void add_pieces(std::int8_t level, u32 stated) {
    std::vector<u32> loops;
    for (const FaceArc& arc : arcs_)
      if (arc.level == level) loops.push_back(loop_of_[local(arc.first)]);
    std::ranges::sort(loops);
    loops.erase(std::unique(loops.begin(), loops.end()), loops.end());
    const auto count = static_cast<u32>(loops.size());
    const u32 found = count <= 1 ? count : count_pieces(count, level);
    require_here(stated == found, "{} pieces of level {} listed, {} found", stated, int{level},
                 found);
    require_here(is_pairing_known(count, found),
                 "{} loops bound {} pieces: which of them bound one is not known", count, found);
    const auto first = static_cast<u32>(pieces_.levels.size());
    for (u32 i = 0; i < found; ++i) {
      pieces_.levels.push_back(level);
      pieces_.loops.push_back(found == count ? 1 : count);
    }
    for (const FaceArc& arc : arcs_) {
      if (arc.level != level) continue;
      const u32 loop = loop_of_[local(arc.first)];
      const auto at = static_cast<u32>(std::ranges::lower_bound(loops, loop) - loops.begin());
      pieces_.arcs.push_back(
          {arc.arc, first + (found == count ? at : 0), local(arc.first), local(arc.second)});
    }
  }

  u32 count_pieces(u32 loops, int level) const {
    std::vector<u32> left, entered;
    for (unsigned i = 0; i < 4; ++i) {
      const int turn = level * (w_[i] > 0 ? 1 : w_[i] < 0 ? -1 : 0);
      if (turn == 0) continue;
      auto& half = turn < 0 ? left : entered;
      half.insert(half.end(), leaves_[i].begin(), leaves_[i].end());
    }
    Regions regions(context_, worker_, level);
    const u32 above = regions.count(left, true);
    return count_components(loops, above, regions.count(entered, false));
  }

  const LevelContext& context_;
  const Cell& cell_;
  Worker& worker_;
  Direction<4> w_;
  std::array<std::vector<u32>, 4> leaves_;
  std::vector<FaceArc> arcs_;
  std::vector<u32> roots_, loop_of_;
  CellPieces pieces_;
};

}  // namespace

void list_leaves(const Trees& trees, u32 face, std::vector<u32>& leaves) {
  const FaceNode& node = trees.faces[face];
  if (!node.leaf()) {
    list_leaves(trees, node.near, leaves);
    list_leaves(trees, node.far, leaves);
    return;
  }
  require(node.code != modes_code::kOpenFace, "face ({}, {}, {}): open, yet at a cell that is not",
          node.corners[0], node.corners[1], node.corners[2]);
  leaves.push_back(face);
}

void list_arcs(const LevelContext& context, u32 leaf, std::vector<FaceArc>& arcs) {
  const FaceNode& face = context.trees.faces[leaf];
  if (face.arcs == 0) return;
  std::vector<Side> sides;
  for (const Side& side : face.edges) list_leaf_edges(context.trees, side, sides);
  std::vector<u32> roots;
  for (const Side& side : sides) {
    const EdgeNode& edge = context.trees.edges[side.node];
    for (u32 k = 0; k < edge.roots; ++k)
      roots.push_back(edge.root + (side.reversed ? edge.roots - 1U - k : k));
  }
  for (u32 i = face.arc; i < face.arc + face.arcs; ++i) {
    const auto [a, b] = context.stated.arcs[i];
    // Numbers too large are refused where the face is checked, which may be later.
    require(a < roots.size() && b < roots.size(), "arcs: no root {} of {}", std::max(a, b),
            roots.size());
    arcs.push_back({i, roots[a], roots[b], context.stated.roots[roots[a]].level});
  }
}

void check_cells(const LevelContext& context, std::span<const Cell> cells,
                 std::span<CellPieces> pieces, Worker& worker) {
  std::vector<std::array<u32, 4>> rejected;
  std::vector<Witnessed<4>> graphs;
  std::vector<std::size_t> with_pieces;
  for (std::size_t i = 0; i < cells.size(); ++i) {
    const Cell& cell = cells[i];
    if (cell.code == modes_code::kRejectedTet) rejected.push_back(cell.corners);
    if (cell.code == modes_code::kRejectedTet || cell.code == modes_code::kOpenTet) continue;
    const double lambda = context.stated.tet_witnesses[cell.witness].lambda;
    const bool plain = cell.code == modes_code::kPlainTet;
    const auto [a, b, c, d] = cell.corners;
    require(!plain || lambda == 0, "cell ({}, {}, {}, {}): lambda is not 0", a, b, c, d);
    graphs.push_back(
        {cell.corners, direction(context, cell), plain ? std::nullopt : std::optional(lambda)});
    with_pieces.push_back(i);
  }
  check_rejected(context, rejected, worker);
  check_witnesses(context, graphs, worker);
  for (const std::size_t i : with_pieces) pieces[i] = CellCheck(context, cells[i], worker).run();
}

}  // namespace crest::certify::modes
