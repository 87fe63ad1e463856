// SPDX-License-Identifier: GPL-3.0-or-later
// crest clean: the mesh that the other commands make of a file. `crest-verify --input` asks for it.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <memory>

#include "cli/run.hpp"
#include "io/write/mesh_writer.hpp"

namespace crest::cli {
namespace {

Outcome work(Run& run) {
  const io::MeshFile file = run.read_mesh();
  const kernel::TriangleMesh& mesh = file.mesh;
  run.step("write", "writing", [&] {
    run.write("-o",
              [&](const std::string& path) { io::write_mesh(path, mesh.points(), mesh.faces()); });
  });
  Report& report = run.report();
  report["vertices"] = mesh.vertex_count();
  report["faces"] = mesh.face_count();
  report["euler_characteristic"] = mesh.euler_characteristic();
  report["boundary_loops"] = mesh.boundary_loops();
  report["components"] = mesh.components();
  std::vector<std::int64_t> vertices(mesh.vertex_count()), faces(mesh.face_count());
  for (kernel::Index v = 0; v < vertices.size(); ++v) vertices[v] = file.numbers.vertex(v);
  for (kernel::Index f = 0; f < faces.size(); ++f) faces[f] = file.numbers.face(f);
  report["vertex_numbers"] = vertices;
  report["face_numbers"] = faces;
  return {
      fmt::format("mesh: {} vertices, {} faces, Euler characteristic {}, {} boundary loops, {} "
                  "components\n",
                  mesh.vertex_count(), mesh.face_count(), mesh.euler_characteristic(),
                  mesh.boundary_loops(), mesh.components())};
}

std::function<int()> add_clean(CLI::App& app) {
  auto options = std::make_shared<CommonOptions>();
  app.add_option("INPUT", options->input, fmt::format("mesh ({})", kMeshFormats))->required();
  app.add_option("-o,--output", options->output, "the cleaned mesh (.off .obj .ply .vtp)")
      ->type_name("FILE");
  app.add_option("--report", options->report,
                 "what was cleaned, the file's number of each vertex and face (.json)")
      ->type_name("FILE");
  add_clean_options(app, options->clean, true);
  add_run_options(app, *options);
  return [options] {
    return run_command({"clean", *options, {".off", ".obj", ".ply", ".vtp"}}, work);
  };
}

}  // namespace

extern const Command clean_command;
const Command clean_command = {
    "clean",
    "the mesh that the other commands make of a file",
    add_clean,
    {"crest clean ellipsoid.off -o clean.ply --report clean.json",
     "crest clean ellipsoid.off --weld 0 --split --outward -o welded.off"}};

}  // namespace crest::cli
