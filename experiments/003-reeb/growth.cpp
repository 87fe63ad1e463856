// SPDX-License-Identifier: GPL-3.0-or-later
// Time and memory of the Reeb graph of a function linear on each triangle (sort and graph, one
// thread), from 10 k to 2 M triangles of a closed surface of genus 16; smooth and noise.
#include <fmt/format.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdlib>
#include <functional>
#include <string>

#include "algorithms/reeb/cuts.hpp"
#include "algorithms/reeb/reeb_graph.hpp"
#include "algorithms/sampling/plain_surfaces.hpp"

namespace {

using namespace crest;

double seconds_of(const std::function<void()>& work) {
  const auto start = std::chrono::steady_clock::now();
  work();
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

double peak_megabytes() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return static_cast<double>(usage.ru_maxrss) / 1024;
}

/// One line of the table; peak memory is that of a process of its own.
void measure(double triangles, bool smooth, int repeats) {
  const auto n = static_cast<unsigned>(std::lround(std::sqrt(triangles / (4 * (1 - 1 / 9.0)))));
  const sampling::PlainSurface s = sampling::plate(n, 16, true);
  const auto values = smooth ? sampling::smooth_values(s, 1, 12) : sampling::noise_values(s, 1);
  const double before = peak_megabytes();
  std::vector<double> sorts, graphs;
  reeb::ReebGraph graph;
  for (int i = 0; i < repeats; ++i) {
    sampling::VertexOrder o;
    sorts.push_back(seconds_of([&] { o = sampling::order_of(values); }));
    graphs.push_back(seconds_of([&] { graph = reeb::reeb_graph({s.triangles, o.rank, o.order}); }));
  }
  const auto median = [](std::vector<double> x) {
    std::nth_element(x.begin(), x.begin() + static_cast<std::ptrdiff_t>(x.size() / 2), x.end());
    return x[x.size() / 2];
  };
  fmt::print("{:>9} {:>7} {:>9.3f} {:>9.3f} {:>8.0f} {:>8.0f} {:>9} {:>9} {:>5} {:>5}\n",
             s.triangles.size(), smooth ? "smooth" : "noise", median(sorts), median(graphs), before,
             peak_megabytes(), graph.nodes.size(), graph.arcs.size(), graph.loops(),
             reeb::choose_cuts(graph).size());
}

}  // namespace

int main(int argc, char** argv) {
  const double most = argc > 1 ? std::atof(argv[1]) : 2e6;
  fmt::print("{:>9} {:>7} {:>9} {:>9} {:>8} {:>8} {:>9} {:>9} {:>5} {:>5}\n", "triangles", "values",
             "sort s", "graph s", "input MB", "peak MB", "nodes", "arcs", "loops", "cuts");
  for (const bool smooth : {true, false}) {
    for (const double size : {1e4, 3e4, 1e5, 3e5, 1e6, 2e6}) {
      if (size > most) continue;
      std::fflush(stdout);
      const pid_t child = fork();
      if (child == 0) {
        measure(size, smooth, 5);
        std::fflush(stdout);
        _exit(0);
      }
      int status = 0;
      if (child < 0 || waitpid(child, &status, 0) < 0 || status != 0) return 1;
    }
  }
  return 0;
}
