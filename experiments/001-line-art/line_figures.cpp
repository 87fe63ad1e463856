// SPDX-License-Identifier: GPL-3.0-or-later
// Figures 3.20 to 3.26 of paper 001 as crest draws them, each beside a shaded rendering, and the
// numbers behind them.
#include <fmt/format.h>

#include <filesystem>
#include <string>

#include "algorithms/curvature/curvature.hpp"
#include "algorithms/line_art/line_art.hpp"
#include "experiments/program.hpp"
#include "io/line_art/buffer_files.hpp"
#include "io/line_art/drawing_writer.hpp"
#include "io/picture/rasteriser.hpp"
#include "io/read/mesh_reader.hpp"
#include "io/write/atomic_file.hpp"

namespace crest::experiments {
namespace {

using namespace line_art;
namespace fs = std::filesystem;

struct Figure {
  const char* name;
  const char* mesh;
  Vec3 eye;
  bool cross_field = false, cross_hatch = false;
  HatchStyle style = HatchStyle::fishbone;
  ToneStyle tone = ToneStyle::width;
  bool buffers = false;
};

constexpr Figure kFigures[] = {
    {"3.20",
     "stanford-bunny.obj",
     {1, 0.5, 4},
     false,
     false,
     HatchStyle::streamlines,
     ToneStyle::width,
     true},
    {"3.21-a", "spot.obj", {2, 1, 3}, false, false, HatchStyle::streamlines, ToneStyle::length},
    {"3.21-b",
     "stanford-bunny.obj",
     {1, 0.5, 4},
     false,
     false,
     HatchStyle::streamlines,
     ToneStyle::length},
    {"3.21-c",
     "armadillo.off",
     {-1, 0.5, -3},
     false,
     false,
     HatchStyle::streamlines,
     ToneStyle::length},
    {"3.22",
     "rocker-arm.obj",
     {2, 1, 3},
     true,
     false,
     HatchStyle::fishbone,
     ToneStyle::width,
     true},
    {"3.23", "rocker-arm.obj", {2, 1, 3}, true, true, HatchStyle::fishbone, ToneStyle::bands},
    {"3.24", "torus.obj", {2, 1, 3}, false, false, HatchStyle::fishbone, ToneStyle::bands},
    {"3.25", "rocker-arm.obj", {2, 1, 3}, true, true},
    {"3.26-a", "stanford-bunny.obj", {1, 0.5, 4}},
    {"3.26-b", "stanford-bunny.obj", {1, 0.5, 4}, false, true},
    {"3.26-c", "armadillo.off", {-1, 0.5, -3}, false, true}};

std::vector<PrincipalFrame> frames_of(const kernel::TriangleMesh& mesh) {
  const auto estimate = curvature::estimate(mesh, {});
  std::vector<PrincipalFrame> frames;
  for (Index v = 0; v < mesh.vertex_count(); ++v) {
    const auto& c = estimate.vertices[v];
    frames.push_back({c.k1, c.k2, c.d1, c.d2, estimate.normals[v]});
  }
  return frames;
}

void shade(const fs::path& path, const kernel::TriangleMesh& mesh, const View& view) {
  const io::Camera camera = io::make_camera(mesh, {view.z, view.up}, 640);
  io::Canvas canvas(camera.width, camera.height);
  canvas.draw_surface(camera, mesh, io::vertex_normals(mesh));
  io::write_atomically(path.string(), canvas.png());
}

void draw(const Figure& figure, const std::string& meshes, const fs::path& out, double width) {
  const kernel::TriangleMesh mesh = io::read_mesh(meshes + "/" + figure.mesh).mesh;
  Drawing drawing;
  drawing.title = fmt::format("figure {}: {}", figure.name, figure.mesh);
  drawing.scene = weld(mesh.points(), mesh.faces());
  ViewRequest request;
  request.towards = figure.eye;
  request.width = width;
  drawing.view = make_view(request, drawing.scene);
  drawing.contours = find_contours(drawing.scene, drawing.view);
  drawing.lines = draw_contours(drawing.scene, drawing.view, drawing.contours);
  HatchOptions options;
  options.style = figure.style;
  options.cross_field = figure.cross_field;
  options.cross_hatch = figure.cross_hatch;
  options.tone_style = figure.tone;
  const std::string base = fmt::format("figure-{}", figure.name);
  if (figure.buffers && !out.empty())
    options.look = [&](Buffers& b) {
      for (const char* file : {"-curvature.png", "-lic.png"})
        io::write_atomically((out / (base + file)).string(),
                             io::buffer_file(file, b, drawing.lines.strokes));
    };
  add_hatches(drawing, mesh, frames_of(mesh), options,
              [](const char*, const std::function<void()>& work) { work(); });
  if (!out.empty()) {
    io::write_drawing((out / (base + ".svg")).string(), drawing);
    shade(out / (base + "-shaded.png"), mesh, drawing.view);
  }
  const HatchCounts& c = drawing.counts;
  fmt::print(
      "| {} | {} | {} | {} | {} | {} | {} + {} | {:.2f}, {:.2f}, {:.2f} | {} | {:.4f}, {:.4f}, "
      "{:.3f} |\n",
      figure.name, figure.mesh, mesh.face_count(), c.singularities, c.index_sum,
      drawing.hatches.size(), c.key_ribs, c.blended, c.p5, c.median, c.p95, c.over_contours,
      c.tone.mean, c.tone.p95, c.tone.max);
}

}  // namespace
}  // namespace crest::experiments

int main(int argc, char** argv) {
  using namespace crest::experiments;
  Program program("Figures 3.20 to 3.26: drawings and their numbers.");
  std::string meshes = "../shared/data/meshes", only;
  std::filesystem::path out;
  double width = 160;
  program.option("--meshes", meshes, "folder of the meshes");
  program.option("--pictures", out, "folder for .svg and .png (default: none)");
  program.option("--width", width, "of the page, mm");
  program.option("--only", only, "one figure, such as 3.25");
  return program.run(argc, argv, [&] {
    fmt::print(
        "\n| figure | mesh | triangles | singularities | index sum | strokes | ribs: key + blended "
        "| "
        "spacing 5 %, median, 95 % (mm) | over contours | tone error mean, 95 %, max |\n"
        "|---|---|---|---|---|---|---|---|---|---|\n");
    for (const Figure& figure : kFigures)
      if (only.empty() || only == figure.name) draw(figure, meshes, out, width);
    return 0;
  });
}
