// SPDX-License-Identifier: GPL-3.0-or-later
// Crest beside VTK's vtkReebGraph on the same linear functions in one run: seconds (medians), peak
// memory, and what comes out. Every measurement is a process of its own; the systems take turns.
#include <fmt/format.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>
#include <vtkCellArray.h>
#include <vtkDoubleArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkReebGraph.h>

#include <algorithm>
#include <chrono>
#include <cmath>

#include "algorithms/reeb/reeb_graph.hpp"
#include "algorithms/sampling/plain_surfaces.hpp"
#include "experiments/program.hpp"

namespace {

using namespace crest;
using Surface = sampling::PlainSurface;

struct Result {
  double seconds = 0, megabytes = 0;
  long nodes = 0, arcs = 0;
};

double seconds_since(std::chrono::steady_clock::time_point start) {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

/// Order and graph; the input is there already.
Result crest_graph(const Surface& s, const std::vector<double>& values) {
  const auto start = std::chrono::steady_clock::now();
  const sampling::VertexOrder o = sampling::order_of(values);
  const reeb::ReebGraph graph = reeb::reeb_graph({s.triangles, o.rank, o.order});
  Result r;
  r.seconds = seconds_since(start);
  r.nodes = static_cast<long>(graph.nodes.size());
  r.arcs = static_cast<long>(graph.arcs.size());
  return r;
}

Result vtk_graph(const Surface& s, const std::vector<double>& values) {
  vtkNew<vtkPolyData> mesh;
  vtkNew<vtkPoints> points;
  for (const auto& p : s.points) points->InsertNextPoint(p.data());
  vtkNew<vtkCellArray> triangles;
  for (const auto& t : s.triangles) triangles->InsertNextCell({t[0], t[1], t[2]});
  mesh->SetPoints(points);
  mesh->SetPolys(triangles);
  vtkNew<vtkDoubleArray> field;
  field->SetName("f");
  for (const double v : values) field->InsertNextValue(v);
  mesh->GetPointData()->AddArray(field);
  vtkNew<vtkReebGraph> graph;
  const auto start = std::chrono::steady_clock::now();
  graph->Build(mesh, field);
  Result r;
  r.seconds = seconds_since(start);
  r.nodes = graph->GetNumberOfVertices();
  r.arcs = graph->GetNumberOfEdges();
  return r;
}

/// Runs it in a child; its peak memory includes the input.
template <class Work>
Result in_child(const Work& work) {
  int ends[2];
  Result r;
  if (pipe(ends) != 0) throw std::runtime_error("no pipe");
  std::fflush(stdout);
  const pid_t child = fork();
  if (child == 0) {
    r = work();
    rusage usage{};
    getrusage(RUSAGE_SELF, &usage);
    r.megabytes = static_cast<double>(usage.ru_maxrss) / 1024;
    const bool sent = write(ends[1], &r, sizeof r) == sizeof r;
    _exit(sent ? 0 : 1);
  }
  close(ends[1]);
  const bool got = child > 0 && read(ends[0], &r, sizeof r) == sizeof r;
  close(ends[0]);
  int status = 0;
  if (child > 0) waitpid(child, &status, 0);
  if (!got) throw std::runtime_error("a measurement failed");
  return r;
}

Result median(std::vector<Result> results) {
  std::sort(results.begin(), results.end(),
            [](const Result& a, const Result& b) { return a.seconds < b.seconds; });
  return results[results.size() / 2];
}

void run(const std::vector<double>& sizes, int repetitions) {
  std::vector<double> ratios;
  fmt::print(
      "| surface | values | triangles | VTK s | Crest s | ratio | VTK MB | Crest MB | "
      "VTK nodes/arcs | Crest nodes/arcs |\n|---|---|---|---|---|---|---|---|---|---|\n");
  for (const double size : sizes) {
    for (const bool torus : {true, false}) {
      const auto n = static_cast<unsigned>(std::lround(std::sqrt(size / (torus ? 2 : 3.6))));
      const Surface s = torus ? sampling::torus_surface(n, n) : sampling::plate(n, 5, true);
      for (const bool smooth : {true, false}) {
        const auto values = smooth ? sampling::smooth_values(s, 1) : sampling::noise_values(s, 1);
        std::vector<Result> vtk, ours;
        for (int i = 0; i < repetitions; ++i) {
          vtk.push_back(in_child([&] { return vtk_graph(s, values); }));
          ours.push_back(in_child([&] { return crest_graph(s, values); }));
        }
        const Result v = median(vtk), c = median(ours);
        ratios.push_back(v.seconds / c.seconds);
        fmt::print(
            "| {} | {} | {} | {:.3f} | {:.4f} | {:.0f} | {:.0f} | {:.0f} | {}/{} | {}/{} |\n",
            torus ? "torus" : "genus 5", smooth ? "smooth" : "noise", s.triangles.size(), v.seconds,
            c.seconds, ratios.back(), v.megabytes, c.megabytes, v.nodes, v.arcs, c.nodes, c.arcs);
      }
    }
  }
  std::sort(ratios.begin(), ratios.end());
  const double middle = 0.5 * (ratios[(ratios.size() - 1) / 2] + ratios[ratios.size() / 2]);
  fmt::print("\nRatio: median {:.0f}, from {:.0f} to {:.0f} in {} rows.\n", middle, ratios.front(),
             ratios.back(), ratios.size());
}

}  // namespace

int main(int argc, char** argv) {
  crest::experiments::Program program("Reeb graphs: Crest beside VTK");
  std::vector<double> sizes = {5e3, 2e4, 8e4};
  int repetitions = 3;
  program.option("--triangles", sizes, "numbers of triangles");
  program.option("--repetitions", repetitions, "runs of each, medians are reported");
  return program.run(argc, argv, [&] {
    run(sizes, repetitions);
    return 0;
  });
}
