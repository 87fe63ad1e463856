// SPDX-License-Identifier: GPL-3.0-or-later

// From the decisions on a piece, in its own numbers, to its records.
#include <tbb/blocked_range.h>
#include <tbb/parallel_sort.h>

#include <algorithm>
#include <numeric>
#include <span>

#include "algorithms/extremal/dual.hpp"
#include "algorithms/extremal/extraction.hpp"
#include "algorithms/extremal/placing.hpp"
#include "kernel/geometry/parallel.hpp"

namespace crest::extremal {
namespace {

/// The piece and the numbers that its records have: those of the whole grid.
class OnPiece {
 protected:
  OnPiece(const Extraction& e, const kernel::GridPiece& piece)
      : e_(e),
        grid_(e.fields().grid()),
        whole_(piece.size, grid_.spacing, {}),
        piece_(piece),
        dual_(grid_) {}

  Node moved(const Node& v) const {
    return {v[0] + static_cast<int>(piece_.all.low[0]), v[1] + static_cast<int>(piece_.all.low[1]),
            v[2] + static_cast<int>(piece_.all.low[2])};
  }
  bool owns(const Node& v) const {
    const Node w = moved(v);
    return piece_.owned.has(
        {static_cast<Index>(w[0]), static_cast<Index>(w[1]), static_cast<Index>(w[2])});
  }
  Index global(const Node& v) const { return static_cast<Index>(whole_.index(moved(v))); }
  /// Of an edge or a face: three times its node, and more.
  Index global(Index x) const { return 3 * global(grid_.node(x / 3)) + x % 3; }

  bool owned_edge(Index e) const { return owns(grid_.node(e / 3)); }
  bool is_whole(Index e) const {
    const auto cells = dual_.cells_at(e);
    return std::all_of(cells.begin(), cells.begin() + dual_.sides,
                       [&](const Node& c) { return dual_.inside(c); });
  }

  const Extraction& e_;
  const Grid& grid_;
  const Grid whole_;
  const kernel::GridPiece& piece_;
  const Dual dual_;
};

/// Of cells, edges and faces.
class Recorder : OnPiece {
 public:
  Recorder(const Extraction& e, const kernel::GridPiece& piece) : OnPiece(e, piece) {}

  Records run() {
    record_cells();
    record_edges();
    record_faces();
    return std::move(r_);
  }

 private:
  void record_cells() {
    // Lists that grow are held twice, and these are the longest.
    const std::size_t regular =
        e_.cells().count(CellState::regular) + e_.cells().count(CellState::regular_extremal);
    const std::size_t proven =
        e_.cells().count(CellState::cone) + e_.cells().count(CellState::empty) + regular;
    r_.cells.codes.reserve(proven + e_.cells().count(CellState::open));
    r_.cells.directions.reserve(proven);
    const kernel::GridBox& own = piece_.owned;
    const auto at = [&](std::size_t k, Index x) {
      return static_cast<int>(x) - static_cast<int>(piece_.all.low[k]);
    };
    for (int z = at(2, own.low[2]); z < at(2, own.high[2]); ++z)
      for (int y = at(1, own.low[1]); y < at(1, own.high[1]); ++y)
        for (int x = at(0, own.low[0]); x < at(0, own.high[0]); ++x) record_cell({x, y, z});
  }

  void record_cell(const Node& v) {
    const std::size_t at = grid_.index(v);
    ++r_.counts.nodes[static_cast<std::size_t>(e_.nodes().state(at))];
    const CellState s = e_.cells().state(at);
    ++r_.counts.cells[static_cast<std::size_t>(s)];
    if (s == CellState::unlisted) return;
    CellRecords& to = r_.cells;
    const Index id = global(v);
    if (!to.runs.empty() && to.runs.back().first + to.runs.back().length == id)
      ++to.runs.back().length;
    else
      to.runs.push_back({id, 1});
    // By the definition by Hess regular cells prove nothing.
    const bool regular = e_.cells().regular(at) && e_.fields().structure();
    const bool cone = e_.cells().regular(at) && !e_.fields().structure();
    to.codes.push_back(static_cast<std::uint8_t>(cone ? CellState::cone : s));
    if (s == CellState::open) return;
    to.directions.push_back(e_.cells().direction(at));
    if (!regular) return;
    to.gradients.push_back(e_.cells().proof(at).gradient);
    const bool good = e_.cells().proof(at).boxed && neighbours_proven(v) && !several_sheets(v);
    to.fit.push_back(good ? 1 : 0);
  }

  /// Are all cells that the cell touches regular or empty, and none missing?
  bool neighbours_proven(const Node& v) const {
    const int reach = dual_.plane() ? 0 : 1;
    for (int z = -reach; z <= reach; ++z)
      for (int y = -1; y <= 1; ++y)
        for (int x = -1; x <= 1; ++x) {
          const Node other = {v[0] + x, v[1] + y, v[2] + z};
          if (!dual_.inside(other)) return false;
          const std::size_t n = grid_.index(other);
          if (!e_.cells().regular(n) && e_.cells().state(n) != CellState::empty) return false;
        }
    return true;
  }

  /// Has the cell more than one sheet, or an ambiguous face?
  bool several_sheets(const Node& v) const {
    const Faces& faces = e_.faces();
    if (dual_.plane()) return faces.face(v, 2).critical > 2;
    const auto in = edges_of_cell(grid_, v);
    if (std::none_of(in.begin(), in.end(), [&](Index e) { return e_.edges().critical(e); }))
      return false;
    const auto found = faces.sheets(v);
    if (*std::max_element(found.begin(), found.end()) > 0) return true;
    for (std::size_t normal = 0; normal < 3; ++normal)
      for (int far = 0; far < 2; ++far) {
        Node p = v;
        p[normal] += far;
        if (faces.face(p, normal).critical == 4) return true;
      }
    return false;
  }

  void record_edges() {
    const BisectedEdges& bisected = e_.edges().bisected();
    for (BisectedEdges::Place p{}; p.edge < bisected.edges.size(); p = bisected.after(p)) {
      const Index e = bisected.edges[p.edge];
      if (owned_edge(e)) r_.bisected.add(global(e), bisected, p);
    }
    for (const Index e : e_.edges().undecided())
      if (owned_edge(e)) r_.undecided.push_back(global(e));
    r_.critical.reserve(e_.edges().critical_edges().size());
    for (const CriticalEdge& c : e_.edges().critical_edges()) {
      if (!owned_edge(c.edge)) continue;
      const std::uint16_t place = snapped(c.place);
      r_.critical.push_back({global(c.edge), place, e_.edges().state(c.edge), is_whole(c.edge), 0});
    }
    const Levels levels{e_.options().min_value, e_.options().min_strength};
    if (levels.any()) {
      std::vector<Index> own;
      for (const CriticalEdge& c : e_.edges().critical_edges())
        if (owned_edge(c.edge)) own.push_back(c.edge);
      kernel::parallel_for(std::size_t{0}, own.size(), [&](std::size_t i) {
        Vec3 t{};
        t[own[i] % 3] = r_.critical[i].place / kPlaces;
        r_.critical[i].level = level_at(e_.fields(), levels, grid_.node(own[i] / 3), t);
      });
    }
    r_.counts.tests = e_.edges().tests();
    std::copy(e_.edges().depths().begin(), e_.edges().depths().end(), r_.counts.depths.begin());
  }

  bool at_listed_cell(Index e) const {
    for (const Node& c : dual_.cells_at(e))
      if (dual_.inside(c) && e_.cells().state(grid_.index(c)) != CellState::unlisted) return true;
    return false;
  }

  void record_faces() {
    const std::vector<Index> crossed = crossed_faces(e_.fields(), e_.edges());
    r_.faces.reserve(crossed.size());
    for (const Index f : crossed) {
      const Node v = grid_.node(f / 3);
      if (!owns(v)) continue;
      const Face face = e_.faces().face(v, f % 3);
      FaceRecord to{global(f),   face.group,   static_cast<std::uint8_t>(face.critical),
                    face.tested, face.swapped, false};
      if (!face.tested)
        for (const Index e : face.edges)
          to.listed = to.listed || (!e_.edges().tested(e) && at_listed_cell(e));
      r_.faces.push_back(to);
    }
  }

  Records r_;
};

/// Of the sheets in cells.
class SheetRecorder : OnPiece {
 public:
  SheetRecorder(const Extraction& e, const kernel::GridPiece& piece) : OnPiece(e, piece) {}

  void run(const Meshes& meshes, Records& r) const {
    const auto cells = crossed_cells();
    if (!dual_.plane()) r.counts.sheets_split = count_split(cells);
    if (meshes.extremal) r.sheets[0] = sheets(cells, false);
    if (meshes.critical) r.sheets[1] = sheets(cells, true);
  }

 private:
  /// Owned cells (an image: squares) with critical edges, ascending.
  std::vector<Node> crossed_cells() const {
    std::vector<Index> found;
    for (const CriticalEdge& c : e_.edges().critical_edges()) {
      const auto round = dual_.cells_at(c.edge);
      for (std::size_t i = 0; i < dual_.sides; ++i)
        if (dual_.inside(round[i]) && owns(round[i]))
          found.push_back(static_cast<Index>(grid_.index(round[i])));
    }
    tbb::parallel_sort(found.begin(), found.end());
    found.erase(std::unique(found.begin(), found.end()), found.end());
    std::vector<Node> r;
    r.reserve(found.size());
    for (const Index c : found) r.push_back(grid_.node(c));
    return r;
  }

  std::uint64_t count_split(const std::vector<Node>& cells) const {
    std::uint64_t count = 0;
    for (const Node& c : cells) {
      const auto found = e_.faces().sheets(c);
      count += *std::max_element(found.begin(), found.end()) > 0 ? 1 : 0;
    }
    return count;
  }

  std::vector<SheetRecord> sheets(const std::vector<Node>& cells, bool critical) const {
    std::vector<SheetRecord> r;
    r.reserve(cells.size());
    for (const Node& c : cells) add_sheets(c, critical, r);
    const Levels levels{e_.options().min_value, e_.options().min_strength};
    kernel::parallel_for(tbb::blocked_range<std::size_t>(0, r.size(), 256), [&](const auto& range) {
      for (std::size_t i = range.begin(); i < range.end(); ++i) place(r[i], levels);
    });
    return r;
  }

  bool has_polygon(Index e, bool critical) const {
    const EdgeState s = e_.edges().state(e);
    return (critical ? e_.edges().critical(e) : s == EdgeState::extremal) && is_whole(e);
  }

  /// Polygons of the cell's edges, joined where they share a side.
  void add_sheets(const Node& cell, bool critical, std::vector<SheetRecord>& to) const {
    const std::size_t count = dual_.plane() ? 4 : 12;
    const auto edges = edges_of_cell(grid_, cell);
    std::array<std::int8_t, 12> set;
    set.fill(-1);
    for (std::size_t i = 0; i < count; ++i)
      set[i] = static_cast<std::int8_t>(has_polygon(edges[i], critical) ? static_cast<int>(i) : -1);
    const auto find = [&](Index e) {
      return static_cast<std::size_t>(std::find(edges.begin(), edges.end(), e) - edges.begin());
    };
    const auto join_in = [&](const Face& f) {
      for (std::size_t i = 0; i < 4; ++i)
        for (std::size_t k = 0; k < i; ++k) {
          if (f.group[i] < 0 || f.group[i] != f.group[k]) continue;
          const auto a = set[find(f.edges[i])], b = set[find(f.edges[k])];
          if (a < 0 || b < 0) continue;
          for (std::size_t n = 0; n < count; ++n)
            if (set[n] == std::max(a, b)) set[n] = std::min(a, b);
        }
    };
    if (dual_.plane()) {
      join_in(e_.faces().face(cell, 2));
    } else {
      for (std::size_t normal = 0; normal < 3; ++normal)
        for (int far = 0; far < 2; ++far) {
          Node p = cell;
          p[normal] += far;
          join_in(e_.faces().face(p, normal));
        }
    }
    // By their lowest edge.
    std::array<std::size_t, 12> order;
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::sort(order.begin(), order.end(),
              [&](std::size_t a, std::size_t b) { return edges[a] < edges[b]; });
    std::array<int, 12> number;
    number.fill(-1);
    for (const std::size_t i : order) {
      if (set[i] < 0) continue;
      int& at = number[static_cast<std::size_t>(set[i])];
      if (at < 0) {
        at = static_cast<int>(to.size());
        to.push_back({global(cell), 0, {}, 0});
      }
      auto& mask = to[static_cast<std::size_t>(at)].edges;
      mask = static_cast<std::uint16_t>(mask | 1U << i);
    }
  }

  /// On the surface, if it can be, and on the branch of n that the zeros are on.
  void place(SheetRecord& sheet, const Levels& levels) const {
    const Node there = whole_.node(sheet.cell);
    const Node cell = {there[0] - static_cast<int>(piece_.all.low[0]),
                       there[1] - static_cast<int>(piece_.all.low[1]),
                       there[2] - static_cast<int>(piece_.all.low[2])};
    const auto edges = edges_of_cell(grid_, cell);
    std::array<Index, 12> own;
    own.fill(kernel::kNone);  // last of all
    std::size_t count = 0;
    for (std::size_t i = 0; i < 12; ++i)
      if ((sheet.edges >> i & 1) != 0) own[count++] = edges[i];
    std::sort(own.begin(), own.end());
    Vec3 sum{};
    std::array<Vec3, 12> zeros;
    for (std::size_t i = 0; i < count; ++i) {
      const Vec3 zero =
          zero_at(whole_, global(own[i]),
                  snapped(e_.edges().critical_edges()[e_.edges().find(own[i])].place));
      sum = sum + zero;
      zeros[i] = zero - as_vector(there);
    }
    const bool cone = e_.cells().decides(grid_.index(cell));
    const Vec3 t =
        vertex_place(e_.fields(), cell, (1.0 / static_cast<int>(count)) * sum - as_vector(there),
                     std::span(zeros).first(cone ? 0 : count));
    Vec3 written;
    for (std::size_t k = 0; k < 3; ++k) {
      sheet.place[k] = snapped(t[k]);
      written[k] = sheet.place[k] / kPlaces;
    }
    if (levels.any()) sheet.level = level_at(e_.fields(), levels, cell, written);
  }
};

}  // namespace

Records Extraction::records(const Meshes& meshes) const {
  Records records = Recorder(*this, piece_).run();
  SheetRecorder(*this, piece_).run(meshes, records);
  return records;
}

}  // namespace crest::extremal
