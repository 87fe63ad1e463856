// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/clean/sound_mesh.hpp"

#include <tbb/blocked_range.h>

#include <functional>
#include <span>
#include <utility>
#include <vector>

#include "kernel/geometry/disjoint_sets.hpp"
#include "kernel/geometry/equal_points.hpp"
#include "kernel/geometry/input_error.hpp"
#include "kernel/geometry/parallel.hpp"
#include "kernel/predicates/enclosed_volume.hpp"

namespace crest::io {
namespace {

using kernel::Index;
using kernel::kNone;
using kernel::Triangle;
using kernel::TriangleMesh;

/// Empty if there are other cells, or a node is no point.
std::vector<Triangle> triangles_of(const Soup& soup) {
  std::vector<Triangle> faces(soup.cells.size());
  const auto points = static_cast<Cells::Node>(soup.points.size());
  const bool all = kernel::parallel_reduce(
      tbb::blocked_range<std::size_t>(0, faces.size(), 16384), true,
      [&](const auto& range, bool good) {
        for (std::size_t c = range.begin(); good && c != range.end(); ++c) {
          const std::span<const Cells::Node> nodes = soup.cells.nodes(c);
          good = soup.cells.type(c) == CellType::triangle && nodes.size() == 3;
          for (std::size_t k = 0; good && k < 3; ++k) {
            good = nodes[k] >= 0 && nodes[k] < points;
            faces[c][k] = static_cast<Index>(nodes[k]);
          }
        }
        return good;
      },
      std::logical_and<>());
  return all ? std::move(faces) : std::vector<Triangle>();
}

bool encloses_negative_volume(const TriangleMesh& mesh, const std::vector<Triangle>& faces) {
  return kernel::enclosed_volume(mesh.points(), faces) == kernel::Sign::negative;
}

/// Closed components of negative volume.
std::size_t inside_out_parts(const TriangleMesh& mesh) {
  if (mesh.components() == 1) return mesh.closed() && encloses_negative_volume(mesh, mesh.faces());
  kernel::DisjointSets parts(mesh.vertex_count());
  for (const kernel::Edge& e : mesh.edges()) parts.unite(e.v0, e.v1);
  std::vector<bool> open(mesh.vertex_count(), false);  // by the part's name
  for (const kernel::Edge& e : mesh.edges())
    if (e.f0 == kNone || e.f1 == kNone) open[parts.find(e.v0)] = true;
  std::vector<Index> number(mesh.vertex_count(), kNone);
  std::vector<std::vector<Triangle>> closed;
  for (const Triangle& face : mesh.faces()) {
    const Index part = parts.find(face[0]);
    if (open[part]) continue;
    if (number[part] == kNone) {
      number[part] = static_cast<Index>(closed.size());
      closed.emplace_back();
    }
    closed[number[part]].push_back(face);
  }
  std::size_t count = 0;
  for (const auto& faces : closed) count += encloses_negative_volume(mesh, faces);
  return count;
}

}  // namespace

std::optional<TriangleMesh> sound_mesh(const Soup& soup, const CleanOptions& options,
                                       CleanUp& done) {
  if (options.weld || options.outward) return std::nullopt;
  if (soup.points.size() >= kNone || soup.cells.size() >= kNone / 3) return std::nullopt;
  std::vector<Triangle> faces = triangles_of(soup);
  if (faces.empty()) return std::nullopt;
  try {
    TriangleMesh mesh(soup.points, std::move(faces));
    kernel::parallel_invoke([&] { done.inside_out_parts = inside_out_parts(mesh); },
                            [&] { done.coincident_vertices = kernel::count_equal(mesh.points()); });
    return mesh;
  } catch (const kernel::InputError&) {
    return std::nullopt;  // cleaning mends it, or says what is wrong in the file's words
  }
}

}  // namespace crest::io
