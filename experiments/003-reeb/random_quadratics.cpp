// SPDX-License-Identifier: GPL-3.0-or-later
// Random piecewise quadratic functions on closed surfaces of genus 0 to 5: loops = genus, Euler's
// relation, an accepted certificate, and which stage decided.
#include <fmt/format.h>

#include <bit>
#include <cmath>
#include <random>

#include "algorithms/reeb/certificate.hpp"
#include "algorithms/reeb/reeb_graph.hpp"
#include "algorithms/reeb/tile_complex.hpp"
#include "algorithms/sampling/handles.hpp"
#include "certify/verify.hpp"
#include "experiments/003-reeb/smooth_field.hpp"
#include "experiments/program.hpp"

namespace crest {
namespace {

using kernel::QuadraticMesh;

/// Every nodal value drawn by itself: uniform, or one of `levels` equally spaced values.
class NoiseField {
 public:
  NoiseField(std::uint64_t seed, int levels) : seed_(seed), levels_(levels) {}
  double operator()(const kernel::Vec3& p) const {
    std::uint64_t h = seed_ * 0x9e3779b97f4a7c15ULL;
    for (const double x : p) {
      h ^= std::bit_cast<std::uint64_t>(x + 0.0) + 0x9e3779b97f4a7c15ULL + (h << 6) + (h >> 2);
      h *= 0xff51afd7ed558ccdULL;
      h ^= h >> 33;
    }
    const double u = static_cast<double>(h >> 11) * 0x1p-53;
    return levels_ > 0 ? std::floor(u * levels_) : u;
  }

 private:
  std::uint64_t seed_;
  int levels_;
};

struct Row {
  int trials = 0, loops = 0, absorbed = 0, euler = 0, accepted = 0;
  std::size_t tiles = 0, nodes = 0, ties = 0;
  kernel::StageCounts counts;
};

void add_trial(Row& row, const QuadraticMesh& mesh, int genus) {
  reeb::PredicateReport report;
  const reeb::TileComplex tiles = reeb::tessellate(mesh, &report);
  const reeb::ReebGraph graph = reeb::reeb_graph({tiles.tiles, tiles.rank, tiles.order});
  int sum = 0;
  bool simple = true;
  for (const reeb::ReebNode& n : graph.nodes) {
    sum += n.index;
    simple = simple && n.multiplicity == 1;
  }
  ++row.trials;
  const int loops = static_cast<int>(graph.loops());
  row.loops += loops == genus;
  row.absorbed += loops < genus && !simple;
  row.euler += sum == 2 - 2 * genus;
  row.accepted +=
      certify::verify(certify::encode(reeb::make_certificate(mesh, tiles, graph))).accepted;
  row.tiles += tiles.tiles.size();
  row.nodes += tiles.node_count();
  for (const auto tied : tiles.tied) row.ties += tied;
  for (const auto& [name, counts] : report) row.counts += counts;
}

void print_row(const std::string& field, int genus, const Row& r) {
  const auto share = [&](std::uint64_t n) {
    return 100.0 * static_cast<double>(n) / static_cast<double>(r.counts.calls);
  };
  fmt::print("| {} | {} | {} | {} | {} | {} | {} | {} | {:.2f} | {:.3f} | {:.3f} | {:.3f} |\n",
             field, genus, r.trials, r.loops, r.absorbed, r.euler, r.accepted, r.tiles,
             100.0 * static_cast<double>(r.ties) / static_cast<double>(r.nodes),
             share(r.counts.interval), share(r.counts.exact), share(r.counts.symbolic));
  std::fflush(stdout);
}

void run(int trials, int vertices) {
  fmt::print(
      "| function | genus | trials | loops = genus | fewer, a multiple saddle absorbing | Euler's "
      "relation | "
      "certificate accepted | tiles | ties % | interval % | exact % | by number % |\n"
      "|---|---|---|---|---|---|---|---|---|---|---|---|\n");
  for (const std::string field : {"smooth", "noise", "5 values", "constant"})
    for (int genus = 0; genus <= 5; ++genus) {
      const auto sample = sampling::sample_handles(genus, vertices, true);
      const double edge = sampling::mean_edge_length(sample.points, sample.faces);
      Row row;
      for (int i = 0; i < trials; ++i) {
        const auto seed = static_cast<std::uint64_t>(1000 * genus + i);
        const auto mesh = [&](const auto& f) {
          return experiments::quadratic_interpolant(sample.points, sample.faces, f);
        };
        if (field == "smooth")
          add_trial(row, mesh(experiments::SmoothField(6 * edge, seed, 16)), genus);
        else
          add_trial(row,
                    mesh(NoiseField(seed, field == "noise"      ? 0
                                          : field == "constant" ? 1
                                                                : 5)),
                    genus);
        if (field == "constant") break;
      }
      print_row(field, genus, row);
    }
}

}  // namespace
}  // namespace crest

int main(int argc, char** argv) {
  int trials = 1000, vertices = 600;
  crest::experiments::Program program(
      "Loops and Euler's relation of random piecewise quadratic functions");
  program.option("--trials", trials, "functions a row (default 1000)");
  program.option("--vertices", vertices, "of each mesh, nearly (default 600)");
  return program.run(argc, argv, [&] {
    crest::run(trials, vertices);
    return 0;
  });
}
