// SPDX-License-Identifier: GPL-3.0-or-later
// The reference table on an unstructured mesh, and counted again from the files that are written;
// chord errors and curvatures.
#include <CGAL/Delaunay_triangulation_3.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Triangulation_vertex_base_with_info_3.h>

#include <catch2/catch.hpp>
#include <map>

#include "algorithms/modes/surface_geometry.hpp"
#include "io/formats/files.hpp"
#include "io/formats/readers.hpp"
#include "io/modes/mode_writer.hpp"
#include "kernel/geometry/disjoint_sets.hpp"
#include "tests/modes/samples.hpp"
#include "tests/support/random.hpp"
#include "tests/support/temporary_folder.hpp"

using namespace crest;
using namespace crest::tests;
using kernel::Index;
using kernel::Vec3;
using modes::Level;

namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Delaunay =
    CGAL::Delaunay_triangulation_3<Kernel,
                                   CGAL::Triangulation_data_structure_3<
                                       CGAL::Triangulation_vertex_base_with_info_3<Index, Kernel>>>;

/// The Delaunay triangulation of random points of [-half, half]^3, its corners, and points of its
/// faces and edges among them.
modes::ModeField unstructured(const Rows& rows, double half, int inner, std::uint64_t seed) {
  Random random(seed);
  std::uniform_real_distribution<double> uniform(-half, half);
  std::vector<Vec3> points;
  for (int corner = 0; corner < 8; ++corner)
    points.push_back(
        {corner & 1 ? half : -half, corner & 2 ? half : -half, corner & 4 ? half : -half});
  for (int i = 0; i < inner; ++i) {
    Vec3 p = {uniform(random), uniform(random), uniform(random)};
    // Every third lies on a face, every ninth on an edge.
    if (i % 3 == 0) p[static_cast<std::size_t>(i / 3 % 3)] = i % 2 == 0 ? half : -half;
    if (i % 9 == 0) p[static_cast<std::size_t>((i / 3 + 1) % 3)] = i % 4 < 2 ? half : -half;
    points.push_back(p);
  }
  Delaunay triangulation;
  std::vector<std::array<double, 6>> tensors;
  for (Index v = 0; v < points.size(); ++v) {
    triangulation.insert({points[v][0], points[v][1], points[v][2]})->info() = v;
    tensors.push_back(value_at(rows, points[v]));
  }
  std::vector<kernel::TetMesh::Tet> tets;
  for (auto c = triangulation.finite_cells_begin(); c != triangulation.finite_cells_end(); ++c)
    tets.push_back(
        {c->vertex(0)->info(), c->vertex(1)->info(), c->vertex(2)->info(), c->vertex(3)->info()});
  return {kernel::TetMesh(std::move(points), std::move(tets)), std::move(tensors)};
}

double mode_at(const Rows& rows, const Vec3& p) {
  const auto t = value_at(rows, p);
  const double det = t[0] * (t[1] * t[2] - t[4] * t[4]) - t[3] * (t[3] * t[2] - t[4] * t[5]) +
                     t[5] * (t[3] * t[4] - t[1] * t[5]);
  const double n =
      t[0] * t[0] + t[1] * t[1] + t[2] * t[2] + 2 * (t[3] * t[3] + t[4] * t[4] + t[5] * t[5]);
  return 3 * std::sqrt(6.0) * det / std::pow(n, 1.5);
}

/// Euler characteristic, components and boundary loops of triangles as a file has them.
ModeCounts counts_of(const std::vector<std::array<Index, 3>>& triangles, std::size_t points) {
  std::map<std::array<Index, 2>, int> edges;
  kernel::DisjointSets parts(static_cast<Index>(points)), rims(static_cast<Index>(points));
  std::vector<char> used(points, 0), on_rim(points, 0);
  for (const auto& t : triangles)
    for (std::size_t k = 0; k < 3; ++k) {
      const auto [a, b] = std::minmax(t[k], t[(k + 1) % 3]);
      ++edges[{a, b}];
      parts.unite(a, b);
      used[a] = used[b] = 1;
    }
  for (const auto& [edge, n] : edges) {
    CHECK(n <= 2);
    if (n != 1) continue;
    rims.unite(edge[0], edge[1]);
    on_rim[edge[0]] = on_rim[edge[1]] = 1;
  }
  ModeCounts c{static_cast<long>(triangles.size()) - static_cast<long>(edges.size()), 0, 0};
  for (Index v = 0; v < points; ++v) {
    c.euler_characteristic += used[v];
    c.components += used[v] != 0 && parts.find(v) == v ? 1 : 0;
    c.loops += on_rim[v] != 0 && rims.find(v) == v ? 1 : 0;
  }
  return c;
}

/// Of one signed mode in a .vtp; of all triangles of an .obj.
ModeCounts counts_in_file(const std::string& path, std::optional<double> mode) {
  const io::Soup soup =
      io::read_soup(path, {.wanted = mode.has_value(), .name = mode ? "mode" : ""});
  std::vector<std::array<Index, 3>> triangles;
  for (std::size_t c = 0; c < soup.cells.size(); ++c) {
    if (mode && std::get<std::vector<double>>(soup.cell_fields.at(0).numbers)[c] != *mode) continue;
    const auto v = soup.cells.nodes(c);
    triangles.push_back(
        {static_cast<Index>(v[0]), static_cast<Index>(v[1]), static_cast<Index>(v[2])});
  }
  return counts_of(triangles, soup.points.size());
}

void check_files(const TemporaryFolder& folder, const modes::ModeResult& r, const ModeCounts& plus,
                 const ModeCounts& minus) {
  const io::ModeScene scene{r.surfaces};
  io::write_modes(folder / "s.vtp", scene);
  io::write_modes(folder / "s.obj", scene);
  CHECK(counts_in_file(folder / "s.vtp", r.surfaces[0].mode) == plus);
  if (r.surfaces.size() == 2) CHECK(counts_in_file(folder / "s.vtp", r.surfaces[1].mode) == minus);
  const ModeCounts all = {plus.euler_characteristic + minus.euler_characteristic,
                          plus.components + minus.components, plus.loops + minus.loops};
  CHECK(counts_in_file(folder / "s.obj", std::nullopt) == all);
}

void check_written_row(const TemporaryFolder& folder, const Row& row,
                       const modes::ModeField& field) {
  constexpr Level levels[] = {{0, 1}, {3, 10}, {3, 5}, {9, 10}};
  for (std::size_t k = 0; k < 4; ++k) {
    const ModeCounts plus = k == 0 ? row.neutral : row.pairs[k - 1][0];
    const ModeCounts minus = k == 0 ? ModeCounts{0, 0, 0} : row.pairs[k - 1][1];
    INFO("field " << row.name << ", level " << k);
    const auto r = modes::extract(field, levels[k]);
    CHECK(r.undecided.empty());
    CHECK(tests::counts_of(r.surfaces[0]) == plus);
    if (k > 0) CHECK(tests::counts_of(r.surfaces[1]) == minus);
    for (const auto& s : r.surfaces) CHECK(s.watertight);
    check_files(folder, r, plus, minus);
  }
}

}  // namespace

TEST_CASE("the reference fields have their counts on unstructured meshes, in files too") {
  const TemporaryFolder folder;
  for (std::size_t f = 0; f < small_boxes().size(); ++f)
    check_written_row(folder, small_boxes()[f],
                      unstructured(small_boxes()[f].rows, 2, 60, kSeed + 80 + f));
}

TEST_CASE("the reference fields have their counts in files from a mirrored grid") {
  const TemporaryFolder folder;
  for (const Row& row : small_boxes())
    check_written_row(folder, row, box(row.rows, 2, 4, Cut::mirrored));
}

TEST_CASE("triangles are as near to the surface as asked, the counts stay") {
  const Row& row = small_boxes()[2];
  const auto field = unstructured(row.rows, 2, 20, kSeed + 90);
  std::size_t last = 0;
  for (const double deviation : {0.0, 0.05, 0.005}) {
    modes::ModeOptions options;
    options.deviation = deviation;
    const auto r = modes::extract(field, {3, 5}, options);
    CHECK(tests::counts_of(r.surfaces[0]) == row.pairs[1][0]);
    CHECK(tests::counts_of(r.surfaces[1]) == row.pairs[1][1]);
    std::size_t triangles = 0;
    double worst = 0;
    for (const auto& s : r.surfaces) {
      CHECK(s.watertight);
      CHECK(s.max_mode_error < 1e-12);
      CHECK(s.unproven_pieces == 0);
      triangles += s.triangles.size();
      // The distance from a triangle's middle by the mode's slope there.
      const auto mode = [&](const Vec3& p) { return mode_at(row.rows, p); };
      for (const auto& [a, b, c] : s.triangles) {
        Vec3 m;
        for (std::size_t k = 0; k < 3; ++k)
          m[k] = (s.points[a][k] + s.points[b][k] + s.points[c][k]) / 3;
        constexpr double h = 1e-5;
        double slope = 0;
        for (std::size_t k = 0; k < 3; ++k) {
          Vec3 up = m, down = m;
          up[k] += h;
          down[k] -= h;
          const double d = (mode(up) - mode(down)) / (2 * h);
          slope += d * d;
        }
        worst = std::max(worst, std::fabs(mode(m) - s.mode) / std::sqrt(slope));
      }
    }
    CHECK(triangles > last);
    last = triangles;
    // Middles are tested before the last points are put; the slope is of first order.
    if (deviation > 0) CHECK(worst < 1.5 * deviation);
  }
}

TEST_CASE("curvatures at the points of a surface are those of the mode's level set") {
  const Row& row = small_boxes()[2];
  const auto field = unstructured(row.rows, 2, 20, kSeed + 90);
  auto r = modes::extract(field, {3, 5});
  for (auto& s : r.surfaces) {
    modes::add_geometry(field, s);
    REQUIRE(s.geometry.size() == s.points.size());
    for (std::size_t v = 0; v < s.points.size(); ++v) {
      const auto& g = s.geometry[v];
      const auto mode = [&](double step, const Vec3& d) {
        Vec3 p = s.points[v];
        for (std::size_t k = 0; k < 3; ++k) p[k] += step * d[k];
        return mode_at(row.rows, p);
      };
      constexpr double h = 1e-4;
      const double slope = (mode(h, g.normal) - mode(-h, g.normal)) / (2 * h);
      CHECK(slope > 0);
      for (const auto& [k, d] : {std::pair{g.k1, g.d1}, {g.k2, g.d2}}) {
        CHECK(std::fabs(mode(h, d) - mode(-h, d)) / (2 * h) < 1e-4 * slope);
        const double second = (mode(h, d) + mode(-h, d) - 2 * mode(0, d)) / (h * h);
        CHECK(-second / slope == Approx(k).margin(2e-3 * (1 + std::fabs(k))));
      }
    }
  }
}
