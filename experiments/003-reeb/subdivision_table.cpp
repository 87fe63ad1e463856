// SPDX-License-Identifier: GPL-3.0-or-later
// How finely must a linear method cut each quadratic triangle to see the same Reeb graph?
#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <map>

#include "algorithms/reeb/reeb_graph.hpp"
#include "algorithms/reeb/tile_complex.hpp"
#include "algorithms/sampling/mesh_surface.hpp"
#include "experiments/003-reeb/smooth_field.hpp"
#include "experiments/program.hpp"

namespace crest {
namespace {

using experiments::SmoothField;
using kernel::Index;
using kernel::QuadraticMesh;
using kernel::Triangle;
using kernel::Vec3;

struct Answer {
  reeb::ReebGraph graph;
  std::vector<Vec3> places;  ///< of the graph's nodes
  double seconds = 0;
};

Answer answer(const QuadraticMesh& mesh) {
  const auto start = std::chrono::steady_clock::now();
  const reeb::TileComplex tiles = reeb::tessellate(mesh);
  Answer a;
  a.graph = reeb::reeb_graph({tiles.tiles, tiles.rank, tiles.order});
  a.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  const auto places = reeb::node_places(mesh, tiles);
  for (const reeb::ReebNode& n : a.graph.nodes) a.places.push_back(places[n.vertex].point);
  return a;
}

/// The quadratic function sampled at the corners of n^2 triangles a face.
class Subdivision {
 public:
  Subdivision(const QuadraticMesh& mesh, int n) : mesh_(mesh), n_(n) {
    points_ = mesh.points();
    values_ = mesh.values();
    for (Index f = 0; f < mesh.face_count(); ++f) cut(f);
  }
  QuadraticMesh linear() const { return {points_, faces_, values_}; }

 private:
  void cut(Index f) {
    std::map<std::array<int, 2>, Index> at;
    for (int j = 0; j <= n_; ++j)
      for (int i = 0; i + j <= n_; ++i) at[{i, j}] = vertex(f, i, j);
    for (int j = 0; j < n_; ++j)
      for (int i = 0; i + j < n_; ++i) {
        faces_.push_back({at[{i, j}], at[{i + 1, j}], at[{i, j + 1}]});
        if (i + j + 1 < n_) faces_.push_back({at[{i + 1, j}], at[{i + 1, j + 1}], at[{i, j + 1}]});
      }
  }
  /// Barycentric coordinates (n - i - j, i, j) / n.
  Index vertex(Index f, int i, int j) {
    const Triangle& c = mesh_.faces()[f];
    const int b[3] = {n_ - i - j, i, j};
    for (std::size_t k = 0; k < 3; ++k)
      if (b[k] == n_) return c[k];
    for (std::size_t k = 0; k < 3; ++k) {
      const std::size_t l = (k + 1) % 3, m = (k + 2) % 3;
      if (b[m] != 0) continue;
      // Side k, from the smaller of its ends.
      const Index e = mesh_.face_edges()[f][k];
      const int step = c[k] < c[l] ? b[l] : b[k];
      const auto [place, added] = on_edges_.try_emplace({e, static_cast<Index>(step)});
      if (added) place->second = add(f, b);
      return place->second;
    }
    return add(f, b);
  }
  Index add(Index f, const int (&b)[3]) {
    const Triangle& c = mesh_.faces()[f];
    Vec3 p{};
    double value = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      const double x = static_cast<double>(b[k]) / n_;
      const double y = static_cast<double>(b[(k + 1) % 3]) / n_;
      for (std::size_t d = 0; d < 3; ++d) p[d] += x * mesh_.points()[c[k]][d];
      value += x * (2 * x - 1) * mesh_.values()[c[k]] +
               4 * x * y * mesh_.edge_values()[mesh_.face_edges()[f][k]];
    }
    points_.push_back(p);
    values_.push_back(value);
    return static_cast<Index>(points_.size() - 1);
  }

  const QuadraticMesh& mesh_;
  int n_;
  std::vector<Vec3> points_;
  std::vector<Triangle> faces_;
  std::vector<double> values_;
  std::map<std::array<Index, 2>, Index> on_edges_;
};

struct Difference {
  std::size_t nodes = 0, arcs = 0;  ///< in one graph and not in the other
};

/// Nodes of one kind are matched one to one, nearest first, up to distance `reach`; arcs by their
/// ends.
Difference difference(const Answer& a, const Answer& b, double reach) {
  struct Pair {
    double distance;
    std::size_t i, j;
    auto operator<=>(const Pair&) const = default;
  };
  std::vector<Pair> pairs;
  for (std::size_t i = 0; i < a.places.size(); ++i)
    for (std::size_t j = 0; j < b.places.size(); ++j) {
      if (a.graph.nodes[i].kind != b.graph.nodes[j].kind) continue;
      const double d = kernel::distance(a.places[i], b.places[j]);
      if (d <= reach) pairs.push_back({d, i, j});
    }
  std::sort(pairs.begin(), pairs.end());
  constexpr std::size_t kAlone = ~std::size_t{0};
  std::vector<std::size_t> partner(a.places.size(), kAlone), taken(b.places.size(), kAlone);
  Difference d{a.places.size() + b.places.size(), 0};
  for (const Pair& p : pairs) {
    if (partner[p.i] != kAlone || taken[p.j] != kAlone) continue;
    partner[p.i] = p.j;
    taken[p.j] = p.i;
    d.nodes -= 2;
  }
  std::map<std::array<std::size_t, 2>, long> arcs;
  for (const reeb::ReebArc& arc : b.graph.arcs) ++arcs[{arc.lower, arc.upper}];
  for (const reeb::ReebArc& arc : a.graph.arcs) {
    const std::size_t lower = partner[arc.lower], upper = partner[arc.upper];
    if (lower == kAlone || upper == kAlone)
      ++d.arcs;
    else
      --arcs[{lower, upper}];
  }
  for (const auto& [ends, count] : arcs) d.arcs += static_cast<std::size_t>(std::abs(count));
  return d;
}

struct Options {
  int vertices = 2500, seeds = 20;
  std::vector<double> wave_lengths = {12, 8, 5};
};

template <class T>
T median(std::vector<T> v) {
  std::sort(v.begin(), v.end());
  return v[v.size() / 2];
}

void print_rows(const std::string& surface, double wave_length, const Options& o) {
  const auto sample = sampling::sample(surface, {}, o.vertices, true);
  const double edge = sampling::mean_edge_length(sample.points, sample.faces);
  struct Row {
    std::vector<std::size_t> nodes, arcs, wrong_nodes, wrong_arcs;
    std::vector<double> seconds;
    int same = 0;
  };
  std::map<int, Row> rows;  // by cuts a side; 0: quadratic
  for (int seed = 1; seed <= o.seeds; ++seed) {
    const QuadraticMesh mesh = experiments::quadratic_interpolant(
        sample.points, sample.faces,
        SmoothField(wave_length * edge, static_cast<std::uint64_t>(seed)));
    const Answer quadratic = answer(mesh);
    for (const int n : {0, 1, 2, 4, 8}) {
      const Answer a = n == 0 ? quadratic : answer(Subdivision(mesh, n).linear());
      const Difference d = difference(a, quadratic, edge);
      Row& row = rows[n];
      row.nodes.push_back(a.graph.nodes.size());
      row.arcs.push_back(a.graph.arcs.size());
      row.wrong_nodes.push_back(d.nodes);
      row.wrong_arcs.push_back(d.arcs);
      row.seconds.push_back(a.seconds);
      row.same += d.nodes == 0 && d.arcs == 0;
    }
  }
  for (const auto& [n, row] : rows)
    fmt::print("| {} | {:g} | {} | {} | {} | {} | {} | {} of {} | {:.4f} |\n", surface, wave_length,
               n == 0 ? "quadratic" : fmt::format("{} linear", n * n), median(row.nodes),
               median(row.arcs), median(row.wrong_nodes), median(row.wrong_arcs), row.same, o.seeds,
               median(row.seconds));
  std::fflush(stdout);
}

void run(const Options& o) {
  fmt::print(
      "Medians over {} seeds; about {} vertices; wave lengths from the given one to four times it, "
      "in mean edges.\nWrong: in one graph and not in the other; nodes are matched by kind within "
      "a "
      "mean edge.\n\n| surface | shortest wave | triangles a face | nodes | arcs | wrong nodes | "
      "wrong arcs | same graph | seconds |\n|---|---|---|---|---|---|---|---|---|\n",
      o.seeds, o.vertices);
  for (const char* surface : {"ellipsoid", "torus", "handles"})
    for (const double w : o.wave_lengths) print_rows(surface, w, o);
}

}  // namespace
}  // namespace crest

int main(int argc, char** argv) {
  crest::Options o;
  crest::experiments::Program program("Linear subdivision against the quadratic Reeb graph");
  program.option("--vertices", o.vertices, "of each mesh (default 2500)");
  program.option("--seeds", o.seeds, "functions a row (default 20)");
  program.list("--waves", o.wave_lengths, "shortest wave lengths in mean edges");
  return program.run(argc, argv, [&] {
    crest::run(o);
    return 0;
  });
}
