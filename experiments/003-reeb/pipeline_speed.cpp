// SPDX-License-Identifier: GPL-3.0-or-later
// The whole way from nodal values to a verified certificate, phase by phase, degree 1 and 2, with
// exact decisions and in plain double.
#include <fmt/format.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <chrono>
#include <cmath>
#include <iostream>
#include <random>

#include "algorithms/reeb/certificate.hpp"
#include "algorithms/reeb/reeb_graph.hpp"
#include "algorithms/reeb/tile_complex.hpp"
#include "algorithms/sampling/plain_surfaces.hpp"
#include "certify/verify.hpp"
#include "experiments/003-reeb/smooth_field.hpp"

namespace crest {
namespace {

using kernel::QuadraticMesh;

class Watch {
 public:
  double lap() {
    const auto now = std::chrono::steady_clock::now();
    const std::chrono::duration<double> d = now - last_;
    last_ = now;
    return d.count();
  }

 private:
  std::chrono::steady_clock::time_point last_ = std::chrono::steady_clock::now();
};

struct Input {
  sampling::PlainSurface surface;
  std::vector<double> values;
  std::vector<std::array<double, 3>> midside;
};

Input make_input(double triangles, int degree, const std::string& kind) {
  const auto n = static_cast<unsigned>(std::lround(std::sqrt(triangles / (4 * (1 - 1 / 9.0)))));
  Input in{sampling::plate(n, 16, true), {}, {}};
  const auto& points = in.surface.points;
  if (kind == "smooth") {
    const experiments::SmoothField field(0.1, 1);  // the plate is one unit wide
    for (const auto& p : points) in.values.push_back(field(p));
    if (degree == 2)
      for (const auto& t : in.surface.triangles) {
        in.midside.emplace_back();
        for (std::size_t k = 0; k < 3; ++k)
          in.midside.back()[k] = field(experiments::middle(points[t[k]], points[t[(k + 1) % 3]]));
      }
    return in;
  }
  std::mt19937_64 draw(1);
  const auto value = [&] {
    const double x = static_cast<double>(draw() >> 11) * 0x1p-53;
    return kind == "noise" ? x : std::floor(16 * x) / 16;
  };
  for (std::size_t v = 0; v < points.size(); ++v) in.values.push_back(value());
  if (degree == 2) {
    const QuadraticMesh edges(points, in.surface.triangles, in.values);
    std::vector<double> at_edge(edges.edge_count());
    for (double& x : at_edge) x = value();
    for (const auto& e : edges.face_edges())
      in.midside.push_back({at_edge[e[0]], at_edge[e[1]], at_edge[e[2]]});
  }
  return in;
}

constexpr const char* kPhases[] = {"mesh", "tessellate", "graph", "certificate", "verify"};
using Times = std::array<double, 6>;  // and the peak memory in MB

Times measure(const Input& input, bool guarded) {
  Times t{};
  Watch watch;
  const QuadraticMesh mesh(input.surface.points, input.surface.triangles, input.values,
                           input.midside);
  t[0] = watch.lap();
  const reeb::TileComplex tiles = reeb::tessellate(mesh, nullptr, guarded);
  t[1] = watch.lap();
  const reeb::ReebGraph graph = reeb::reeb_graph({tiles.tiles, tiles.rank, tiles.order});
  t[2] = watch.lap();
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  t[5] = static_cast<double>(usage.ru_maxrss) / 1024;
  if (!guarded) return t;
  const certify::Bytes bytes = certify::encode(reeb::make_certificate(mesh, tiles, graph));
  t[3] = watch.lap();
  if (!certify::verify(bytes).accepted) throw std::runtime_error("a certificate is rejected");
  t[4] = watch.lap();
  return t;
}

/// In a process of its own, for its own peak memory.
Times measure_in_child(const Input& input, bool guarded) {
  int ends[2];
  if (pipe(ends) != 0) throw std::runtime_error("pipe failed");
  const pid_t child = fork();
  if (child == 0) {
    const Times t = measure(input, guarded);
    _exit(write(ends[1], &t, sizeof t) == sizeof t ? 0 : 1);
  }
  close(ends[1]);
  Times t{};
  const bool good = child > 0 && read(ends[0], &t, sizeof t) == sizeof t;
  close(ends[0]);
  int status = 0;
  if (child < 0 || waitpid(child, &status, 0) < 0 || status != 0 || !good)
    throw std::runtime_error("a measurement died");
  return t;
}

void print_row(double triangles, int degree, const std::string& kind, int repetitions) {
  const Input input = make_input(triangles, degree, kind);
  std::vector<Times> guarded, plain;
  for (int i = 0; i < repetitions; ++i) {
    guarded.push_back(measure_in_child(input, true));
    plain.push_back(measure_in_child(input, false));
  }
  const auto median = [](const std::vector<Times>& all, auto&& of) {
    std::vector<double> x;
    for (const Times& t : all) x.push_back(of(t));
    std::sort(x.begin(), x.end());
    return x[x.size() / 2];
  };
  const auto answer = [](const Times& t) { return t[0] + t[1] + t[2]; };
  fmt::print("| {} | {} | {} |", input.surface.triangles.size(), degree, kind);
  for (std::size_t p = 0; p < std::size(kPhases); ++p)
    fmt::print(" {:.3f} |", median(guarded, [&](const Times& t) { return t[p]; }));
  fmt::print(" {:.3f} | {:.2f} | {:.2f} | {:.0f} |\n", median(guarded, answer),
             median(guarded, answer) / median(plain, answer),
             median(guarded, [&](const Times& t) { return t[4] / (answer(t) + t[3]); }),
             median(guarded, [](const Times& t) { return t[5]; }));
  std::fflush(stdout);
}

void run(double triangles, int repetitions) {
  fmt::print(
      "Closed surface of genus 16, one thread, medians of {}; seconds.\n\n| triangles | degree | "
      "values |",
      repetitions);
  for (const char* phase : kPhases) fmt::print(" {} |", phase);
  fmt::print(
      " mesh to graph | exact / plain double | verify / all before | peak MB at the graph |\n"
      "|---|---|---|---|---|---|---|---|---|---|---|---|\n");
  for (const int degree : {1, 2})
    for (const char* kind : {"smooth", "noise", "16 values"})
      print_row(triangles, degree, kind, repetitions);
}

}  // namespace
}  // namespace crest

int main(int argc, char** argv) {
  double triangles = 1e6;
  int repetitions = 5;
  CLI::App app{"From nodal values to a verified Reeb graph"};
  app.add_option("--triangles", triangles, "nearly (default a million)");
  app.add_option("--repetitions", repetitions, "of each (default 5)");
  CLI11_PARSE(app, argc, argv);
  try {
    crest::run(triangles, repetitions);
  } catch (const std::exception& error) {
    std::cerr << error.what() << '\n';
    return 3;
  }
  return 0;
}
