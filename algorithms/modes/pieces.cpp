// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/modes/pieces.hpp"

#include <algorithm>

#include "algorithms/modes/test_all.hpp"
#include "kernel/geometry/mesh_piece.hpp"

namespace crest::modes {
namespace {

using kernel::TetMesh;

bool has_zero(const Vertices& vertices, const TetMesh::Tet& tet) {
  return std::any_of(tet.begin(), tet.end(), [&](Index v) { return vertices.is_zero(v); });
}

/// A tree's root with edges and faces of its own: tests do not ask what neighbours share.
void add_tree(Faces& faces, Cells& cells, Index tet, const TetMesh::Tet& v) {
  Index edges[4][4]{};
  for (std::size_t i = 0; i < 4; ++i)
    for (std::size_t j = i + 1; j < 4; ++j) edges[i][j] = edges[j][i] = faces.add_edge(v[i], v[j]);
  std::array<Index, 4> sides;
  for (std::size_t i = 0; i < 4; ++i) {
    const std::size_t a = i == 0 ? 1 : 0, b = i <= 1 ? 2 : 1, c = i <= 2 ? 3 : 2;
    sides[i] = faces.add_face({v[a], v[b], v[c]}, {edges[a][b], edges[b][c], edges[c][a]}, 0,
                              faces.add_account());
  }
  cells.add(tet, v, sides);
}

/// Grows the trees of which the sign tells nothing.
void test_trees(Vertices& vertices, const TetJob& job, TetRecords& to) {
  Lines lines(vertices, job.level);
  Faces faces(vertices, lines, job.level, job.limits);
  Cells cells(faces, job.level, job.limits);
  for (Index t = 0; t < job.tets.size(); ++t)
    if (to.signs[t].finding == Finding::none && !has_zero(vertices, job.tets[t]))
      add_tree(faces, cells, t, job.tets[t]);
  const auto tests = cells.test_trees();
  std::vector<std::size_t> next(job.tets.size() + 1);
  for (const auto& [tet, test] : tests) {
    ++to.counts[tet];
    ++next[tet + 1];
  }
  for (std::size_t t = 1; t < next.size(); ++t) next[t] += next[t - 1];
  to.tests.resize(tests.size());
  for (const auto& [tet, test] : tests) to.tests[next[tet]++] = test;
}

TetJob job_of(const ModeField& field, const std::vector<Index>& owned, int scale,
              const Level& level, const Limits& limits) {
  TetJob r{{}, {}, scale, level, limits};
  std::vector<Index> number(field.tensors.size(), kNone);
  for (const Index t : owned)
    for (const Index v : field.mesh.tets()[t]) number[v] = 0;
  for (Index v = 0; v < number.size(); ++v) {
    if (number[v] == kNone) continue;
    number[v] = static_cast<Index>(r.tensors.size());
    r.tensors.push_back(field.tensors[v]);
  }
  for (const Index t : owned) {
    const auto [a, b, c, d] = field.mesh.sorted(t);
    r.tets.push_back({number[a], number[b], number[c], number[d]});
  }
  return r;
}

TetRecords join(std::size_t tets, const std::vector<std::vector<Index>>& owned,
                const std::vector<TetRecords>& parts) {
  struct Next {
    std::size_t tet = 0, test = 0;
  };
  std::vector<Index> piece_of(tets);
  for (Index p = 0; p < owned.size(); ++p)
    for (const Index t : owned[p]) piece_of[t] = p;
  std::vector<Next> next(parts.size());
  TetRecords r;
  for (const Index p : piece_of) {
    const TetRecords& from = parts[p];
    Next& at = next[p];
    r.signs.push_back(from.signs[at.tet]);
    r.counts.push_back(from.counts[at.tet++]);
    const auto first = from.tests.begin() + static_cast<std::ptrdiff_t>(at.test);
    r.tests.insert(r.tests.end(), first, first + r.counts.back());
    at.test += r.counts.back();
  }
  return r;
}

}  // namespace

std::vector<CellSign> signs_on(Vertices& vertices, std::span<const TetMesh::Tet> tets,
                               const Level& level) {
  std::vector<CellSign> r(tets.size());
  std::vector<Index> plain;
  std::vector<TetMesh::Tet> corners;
  for (Index t = 0; t < r.size(); ++t) {
    if (has_zero(vertices, tets[t])) continue;
    plain.push_back(t);
    corners.push_back(tets[t]);
  }
  for_all_groups<3>(vertices, corners, [&](std::size_t first, auto cells, const auto& exact) {
    std::array<CellSign, kTogether> signs;
    cell_signs(cells, exact, level, {signs.data(), cells.size()});
    for (std::size_t i = 0; i < cells.size(); ++i) r[plain[first + i]] = signs[i];
  });
  return r;
}

TetRecords work_on(const TetJob& job) {
  Vertices vertices(job.tensors, job.scale, job.level);
  TetRecords r{signs_on(vertices, job.tets, job.level), {}, {}};
  r.counts.resize(job.tets.size());
  test_trees(vertices, job, r);
  return r;
}

Workers workers_here(Index pieces) {
  return {pieces, [](std::size_t jobs, const std::function<TetJob(std::size_t)>& job) {
            std::vector<TetRecords> r;
            for (std::size_t i = 0; i < jobs; ++i) r.push_back(work_on(job(i)));
            return r;
          }};
}

TetRecords test_tets(const ModeField& field, Vertices& vertices, int scale, const Level& level,
                     const Limits& limits, const Workers* workers) {
  const auto count = static_cast<Index>(field.mesh.tets().size());
  if (workers == nullptr || workers->pieces <= 1) {
    std::vector<TetMesh::Tet> tets;
    tets.reserve(count);
    for (Index t = 0; t < count; ++t) tets.push_back(field.mesh.sorted(t));
    return {signs_on(vertices, tets, level), {}, {}};
  }
  std::vector<kernel::Vec3> places;
  for (const auto& tet : field.mesh.tets()) places.push_back(field.mesh.points()[tet[0]]);
  const auto owned = kernel::cut_points(places, workers->pieces);
  return join(count, owned, workers->tests(owned.size(), [&](std::size_t p) {
    return job_of(field, owned[p], scale, level, limits);
  }));
}

}  // namespace crest::modes
