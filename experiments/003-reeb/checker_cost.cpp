// SPDX-License-Identifier: GPL-3.0-or-later
// `crest reeb` with a certificate beside `crest-verify`, as programs, files and all: what the proof
// costs its reader.
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
#include <vtkUnstructuredGrid.h>
#include <vtkXMLPolyDataWriter.h>
#include <vtkXMLUnstructuredGridWriter.h>

#include <algorithm>
#include <chrono>
#include <filesystem>

#include "experiments/003-reeb/plate_functions.hpp"
#include "experiments/program.hpp"

namespace crest {
namespace {

namespace fs = std::filesystem;
using experiments::PlateFunction;

struct Options {
  double triangles = 1e6;
  int runs = 5;
  std::string programs = "build/cli";
  std::string folder = fs::temp_directory_path() / "crest-checker-cost";
};

void write_raw(vtkXMLWriter& writer, vtkDataObject& data, const fs::path& file) {
  writer.SetInputDataObject(&data);
  writer.SetFileName(file.c_str());
  writer.SetDataModeToBinary();
  writer.SetCompressorTypeToNone();
  if (writer.Write() != 1) throw std::runtime_error(file.string() + ": cannot be written");
}

/// A VTP (degree 1) or VTU (degree 2) with the field f. Returns its place.
fs::path write_input(const PlateFunction& in, int degree, const fs::path& folder) {
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkDoubleArray> field;
  field->SetName("f");
  for (const auto& p : in.surface.points) points->InsertNextPoint(p.data());
  for (const double v : in.values) field->InsertNextValue(v);
  const auto& triangles = in.surface.triangles;
  if (degree == 1) {
    vtkNew<vtkCellArray> cells;
    for (const auto& t : triangles) cells->InsertNextCell({t[0], t[1], t[2]});
    vtkNew<vtkPolyData> mesh;
    mesh->SetPoints(points);
    mesh->SetPolys(cells);
    mesh->GetPointData()->AddArray(field);
    vtkNew<vtkXMLPolyDataWriter> writer;
    write_raw(*writer, *mesh, folder / "input.vtp");
    return folder / "input.vtp";
  }
  const kernel::QuadraticMesh edges(in.surface.points, triangles, in.values);
  const auto vertices = static_cast<vtkIdType>(in.values.size());
  std::vector<double> at_edge(edges.edge_count());
  for (std::size_t f = 0; f < triangles.size(); ++f)
    for (std::size_t k = 0; k < 3; ++k) at_edge[edges.face_edges()[f][k]] = in.midside[f][k];
  for (std::size_t e = 0; e < at_edge.size(); ++e) {
    const auto middle = experiments::middle(in.surface.points[edges.edges()[e].v0],
                                            in.surface.points[edges.edges()[e].v1]);
    points->InsertNextPoint(middle.data());
    field->InsertNextValue(at_edge[e]);
  }
  vtkNew<vtkUnstructuredGrid> mesh;
  mesh->SetPoints(points);
  mesh->GetPointData()->AddArray(field);
  for (std::size_t f = 0; f < triangles.size(); ++f) {
    const auto& t = triangles[f];
    const auto& e = edges.face_edges()[f];
    const vtkIdType nodes[] = {t[0], t[1], t[2], vertices + e[0], vertices + e[1], vertices + e[2]};
    mesh->InsertNextCell(VTK_QUADRATIC_TRIANGLE, 6, nodes);
  }
  vtkNew<vtkXMLUnstructuredGridWriter> writer;
  write_raw(*writer, *mesh, folder / "input.vtu");
  return folder / "input.vtu";
}

/// Processor time and time by the clock.
struct Seconds {
  double cpu, wall;
};
Seconds run_program(const std::vector<std::string>& words) {
  std::fflush(stdout);  // else the child would write it too
  const auto start = std::chrono::steady_clock::now();
  const pid_t child = fork();
  if (child == 0) {
    std::vector<char*> arguments;
    for (const std::string& word : words) arguments.push_back(const_cast<char*>(word.c_str()));
    arguments.push_back(nullptr);
    if (std::freopen("/dev/null", "w", stdout) != nullptr) execv(arguments[0], arguments.data());
    _exit(127);
  }
  int status = 0;
  rusage usage{};
  if (child < 0 || wait4(child, &status, 0, &usage) < 0 || status != 0)
    throw std::runtime_error(words[0] + " failed; --programs names its folder");
  const std::chrono::duration<double> wall = std::chrono::steady_clock::now() - start;
  const auto seconds = [](const timeval& t) {
    return static_cast<double>(t.tv_sec) + 1e-6 * static_cast<double>(t.tv_usec);
  };
  return {seconds(usage.ru_utime) + seconds(usage.ru_stime), wall.count()};
}

double median(std::vector<double> x) {
  std::sort(x.begin(), x.end());
  return x[x.size() / 2];
}

void row(int degree, const std::string& kind, const Options& o) {
  const PlateFunction input = experiments::plate_function(o.triangles, degree, kind);
  const std::string file = write_input(input, degree, o.folder);
  const std::string certificate = fs::path(o.folder) / "c.crest";
  std::vector<double> crest, verify, cpu_quotient, wall_quotient;
  for (int i = 0; i < o.runs; ++i) {
    const Seconds a = run_program(
        {o.programs + "/crest", "reeb", file, "--field", "f", "--certificate", certificate});
    const Seconds b = run_program({o.programs + "/crest-verify", certificate});
    crest.push_back(a.cpu);
    verify.push_back(b.cpu);
    cpu_quotient.push_back(b.cpu / a.cpu);
    wall_quotient.push_back(b.wall / a.wall);
  }
  fmt::print("| {} | {} | {} | {:.2f} | {:.2f} | {:.2f} | {:.2f} |\n",
             input.surface.triangles.size(), degree, kind, median(crest), median(verify),
             median(cpu_quotient), median(wall_quotient));
  std::fflush(stdout);
}

void run(const Options& o) {
  fs::create_directories(o.folder);
  fmt::print(
      "Closed surface of genus 16; processor seconds of the whole programs, medians of {} runs in "
      "turns.\n\n| triangles | degree | values | crest reeb | crest-verify | quotient | by the "
      "clock |\n|---|---|---|---|---|---|---|\n",
      o.runs);
  for (const int degree : {1, 2})
    for (const char* kind : {"smooth", "noise", "16 values"}) row(degree, kind, o);
  fs::remove_all(o.folder);
}

}  // namespace
}  // namespace crest

int main(int argc, char** argv) {
  crest::Options o;
  crest::experiments::Program program("What checking a Reeb graph costs");
  program.option("--triangles", o.triangles, "nearly (default a million)");
  program.option("--runs", o.runs, "of each (default 5)", {1, 100});
  program.option("--programs", o.programs, "the folder of crest and crest-verify");
  program.option("--folder", o.folder, "for the files, removed in the end");
  return program.run(argc, argv, [&] {
    crest::run(o);
    return 0;
  });
}
