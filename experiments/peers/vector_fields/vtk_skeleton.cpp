// SPDX-License-Identifier: GPL-3.0-or-later
// Crest beside VTK's vtkVectorFieldTopology on the same fields in one run: zeros, separatrices,
// how many of these end nowhere, seconds.
#include <fmt/format.h>
#include <vtkCellArray.h>
#include <vtkDoubleArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkUnstructuredGrid.h>
#include <vtkVectorFieldTopology.h>

#include <algorithm>
#include <chrono>
#include <cmath>

#include "algorithms/sampling/planar_fields.hpp"
#include "algorithms/vector_fields/vector_fields.hpp"
#include "experiments/program.hpp"

namespace {

using namespace crest;
using namespace crest::vector_fields;

double seconds_since(std::chrono::steady_clock::time_point start) {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

double distance(const Vec2& a, const Vec2& b) {
  return std::hypot(a[0] - b[0], a[1] - b[1]);
}

double distance_to_boundary(const Skeleton& s, const Vec2& x) {
  double least = HUGE_VAL;
  for (const BoundaryPiece& p : s.boundary) {
    const Vec2 e = {p.to[0] - p.from[0], p.to[1] - p.from[1]};
    const double t =
        ((x[0] - p.from[0]) * e[0] + (x[1] - p.from[1]) * e[1]) / (e[0] * e[0] + e[1] * e[1]);
    const double u = std::clamp(t, 0.0, 1.0);
    least = std::min(least, distance(x, {p.from[0] + u * e[0], p.from[1] + u * e[1]}));
  }
  return least;
}

struct VtkSkeleton {
  long zeros = 0, missed = 0, lines = 0, nowhere = 0;
  double seconds = 0;
};

/// `cell`: the size of a cell. A line ends nowhere that has neither a sink, a source nor the
/// boundary within 1.5 cells of its last point, and in the truth nothing ends in a closed orbit
/// there.
VtkSkeleton vtk_skeleton(const PlanarField& field, const Skeleton& truth, double cell, int steps) {
  vtkNew<vtkUnstructuredGrid> grid;
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  for (const Vec2& p : field.points) points->InsertNextPoint(p[0], p[1], 0);
  vtkNew<vtkCellArray> triangles;
  for (const auto& t : field.triangles) triangles->InsertNextCell({t[0], t[1], t[2]});
  vtkNew<vtkDoubleArray> vectors;
  vectors->SetName("v");
  vectors->SetNumberOfComponents(3);
  for (const Vec2& v : field.vectors) vectors->InsertNextTuple3(v[0], v[1], 0);
  grid->SetPoints(points);
  grid->SetCells(VTK_TRIANGLE, triangles);
  grid->GetPointData()->SetVectors(vectors);
  vtkNew<vtkVectorFieldTopology> topology;
  topology->SetInputData(grid);
  if (steps > 0) topology->SetMaxNumSteps(steps);
  const auto start = std::chrono::steady_clock::now();
  topology->Update();
  VtkSkeleton r;
  r.seconds = seconds_since(start);
  auto* zeros = vtkPolyData::SafeDownCast(topology->GetOutputDataObject(0));
  r.zeros = zeros->GetNumberOfPoints();
  for (const CriticalPoint& c : truth.critical_points) {
    bool found = false;
    for (vtkIdType i = 0; i < zeros->GetNumberOfPoints() && !found; ++i) {
      const double* x = zeros->GetPoint(i);
      found = distance(c.point, {x[0], x[1]}) < cell;
    }
    r.missed += found ? 0 : 1;
  }
  auto* lines = vtkPolyData::SafeDownCast(topology->GetOutputDataObject(1));
  r.lines = lines->GetNumberOfCells();
  for (vtkIdType i = 0; i < lines->GetNumberOfCells(); ++i) {
    vtkIdType n = 0;
    const vtkIdType* ids = nullptr;
    lines->GetCellPoints(i, n, ids);
    if (n == 0) continue;
    const double* x = lines->GetPoint(ids[n - 1]);
    const Vec2 end = {x[0], x[1]};
    const bool near_zero = std::any_of(
        truth.critical_points.begin(), truth.critical_points.end(), [&](const CriticalPoint& c) {
          return c.kind != ZeroKind::saddle && distance(c.point, end) < 1.5 * cell;
        });
    r.nowhere += near_zero || distance_to_boundary(truth, end) < 1.5 * cell ? 0 : 1;
  }
  return r;
}

void row(const std::string& name, const sampling::PlanarSample& sample, double cell, int steps) {
  const PlanarField field{sample.points, sample.vectors, sample.triangles};
  const auto start = std::chrono::steady_clock::now();
  const Skeleton s = extract_skeleton(field);
  const double seconds = seconds_since(start);
  const VtkSkeleton v = vtk_skeleton(field, s, cell, steps);
  const auto ends = [&](EndKind e) {
    return std::count_if(s.separatrices.begin(), s.separatrices.end(),
                         [&](const Separatrix& l) { return l.end == e; });
  };
  fmt::print(
      "| {} | {} | {} | {} ({} missed) | {} ({} in orbits, {} undecided) | {} ({} nowhere) | "
      "{:.3f} | {:.2f} |\n",
      name, field.triangles.size(), s.critical_points.size(), v.zeros, v.missed,
      s.separatrices.size(), ends(EndKind::closed_orbit), ends(EndKind::undecided), v.lines,
      v.nowhere, seconds, v.seconds);
}

/// Positions a hundred thousandth of the size.
sampling::PlanarSample shrunk(sampling::PlanarSample s) {
  for (auto& p : s.points)
    for (double& x : p) x *= 1e-5;
  return s;
}

void table(int large, int steps) {
  fmt::print(
      "| field | triangles | zeros | VTK's | separatrices | VTK's | Crest, s | VTK, s |\n"
      "|---|---|---|---|---|---|---|---|\n");
  row("L(5), 40 x 40", sampling::lattice_field(5, 40), 1.0 / 40, steps);
  row("the same times 1e-5", shrunk(sampling::lattice_field(5, 40)), 1e-5 / 40, steps);
  row("Bodden (twin)", sampling::twin_bodden(), 1, steps);
  row("L(30), 256 x 256", sampling::lattice_field(30, 256), 1.0 / 256, steps);
  if (large > 0)
    row(fmt::format("L(30), {0} x {0}", large), sampling::lattice_field(30, large), 1.0 / large,
        steps);
}

}  // namespace

int main(int argc, char** argv) {
  int large = 1024, steps = 0;
  crest::experiments::Program program("Skeletons by Crest and by VTK.");
  program.option("--large", large, "cells a side of the last row; 0: none", {0, 4096});
  program.option("--steps", steps, "VTK's MaxNumSteps; 0: its own", {0, 1'000'000});
  return program.run(argc, argv, [&] {
    table(large, steps);
    return 0;
  });
}
