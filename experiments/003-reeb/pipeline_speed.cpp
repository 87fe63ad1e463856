// SPDX-License-Identifier: GPL-3.0-or-later
// The whole way from nodal values to a verified certificate, phase by phase, degree 1 and 2, with
// exact decisions and in plain double.
#include <fmt/format.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>

#include "algorithms/reeb/certificate.hpp"
#include "algorithms/reeb/reeb_graph.hpp"
#include "algorithms/reeb/tile_complex.hpp"
#include "certify/verify.hpp"
#include "experiments/003-reeb/plate_functions.hpp"
#include "experiments/program.hpp"

namespace crest {
namespace {

using experiments::PlateFunction;
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

constexpr const char* kPhases[] = {"mesh", "tessellate", "graph", "certificate", "verify"};
using Times = std::array<double, 6>;  // and the peak memory in MB

Times measure(const PlateFunction& input, bool guarded) {
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
Times measure_in_child(const PlateFunction& input, bool guarded) {
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
  const PlateFunction input = experiments::plate_function(triangles, degree, kind);
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
  crest::experiments::Program program("From nodal values to a verified Reeb graph");
  program.option("--triangles", triangles, "nearly (default a million)");
  program.option("--repetitions", repetitions, "of each (default 5)");
  return program.run(argc, argv, [&] {
    crest::run(triangles, repetitions);
    return 0;
  });
}
