// SPDX-License-Identifier: GPL-3.0-or-later
// Figures 3.20 to 3.26 of paper 001 as crest draws them, each beside a shaded rendering, and the
// numbers behind them.
#include <fmt/format.h>

#include <filesystem>
#include <string>

#include "algorithms/sampling/plain_surfaces.hpp"
#include "experiments/001-line-art/painted.hpp"
#include "experiments/001-line-art/surface.hpp"
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
    {"3.25-a", "cycloidal.ply", {2, 1.5, 3}, true, true},
    {"3.25-b", "rocker-arm.obj", {2, 1, 3}, true, true},
    {"3.26-a", "stanford-bunny.obj", {1, 0.5, 4}},
    {"3.26-b", "stanford-bunny.obj", {1, 0.5, 4}, false, true},
    {"3.26-c", "armadillo.off", {-1, 0.5, -3}, false, true},
    {"fandisk", "fandisk.off", {2, 1, 3}, true, true},
    {"sphere", "icosphere", {2, 1, 3}, false, true}};

kernel::TriangleMesh read(const Figure& figure, const std::string& folder) {
  if (figure.mesh == std::string("icosphere")) {
    sampling::PlainSurface sphere = sampling::icosphere(5);
    for (Vec3& p : sphere.points) p = io::normalised(p, p);
    return {std::move(sphere.points), std::move(sphere.triangles)};
  }
  io::MeshRequest request;
  request.clean.split = true;
  return io::read_mesh(folder + "/" + figure.mesh, request).mesh;
}

void shade(const fs::path& path, const kernel::TriangleMesh& mesh, const View& view) {
  const io::Camera camera = io::make_camera(mesh, {view.z, view.up}, 640);
  io::Canvas canvas(camera.width, camera.height);
  canvas.draw_surface(camera, mesh, io::vertex_normals(mesh));
  io::write_atomically(path.string(), canvas.png());
}

/// Of what the strokes are like, the second layer included.
struct StrokeNumbers {
  double shortest, median;  ///< mm: of 5 % and of half of the strokes
  double long_share;        ///< of strokes of three spacings and more
  double change;            ///< 95 % of the changes of width along a spacing are less
};

StrokeNumbers numbers_of(const Drawing& drawing, double spacing) {
  const auto quantile = [](std::vector<double>& x, double q) {
    std::sort(x.begin(), x.end());
    return x.empty() ? 0 : x[static_cast<std::size_t>(q * static_cast<double>(x.size() - 1))];
  };
  std::vector<double> lengths, changes;
  double longer = 0;
  for (const Stroke& s : drawing.hatches) {
    lengths.push_back(s.length());
    longer += lengths.back() >= 3 * spacing;
    // Within the tapers widths are meant to change.
    const auto step = static_cast<std::size_t>(std::lround(spacing / Tracer::kStep));
    const std::size_t taper = 2 * step;
    for (std::size_t i = taper; i + step + taper < s.widths.size(); ++i) {
      const auto [low, high] = std::minmax(s.widths[i], s.widths[i + step]);
      changes.push_back((high - low) / high);
    }
  }
  const auto count = static_cast<double>(std::max<std::size_t>(lengths.size(), 1));
  return {quantile(lengths, 0.05), quantile(lengths, 0.5), longer / count, quantile(changes, 0.95)};
}

/// The borders of the segments and, instead of hatches, stream lines at six spacings: figure 3.22
/// c.
void probe(const Drawing& drawing, const Buffers& b, const fs::path& path) {
  Drawing probed = drawing;
  probed.title = "segments and probed stream lines";
  std::vector<Hatch> ribs, lines;
  for (const Stroke& s : drawing.hatches)
    if (s.kind == StrokeKind::rib) ribs.push_back({s});
  const OwnedArea owned = owned_area(b, ribs, 2);
  const Barriers barriers(drawing.scene, drawing.view, drawing.contours);
  add_even_streamlines(Tracer(b, barriers, {}, 4.8, true), 2, Family::rib, lines);
  probed.hatches.clear();
  const auto add = [&](std::vector<Vec2> points, double width) {
    Stroke s;
    s.kind = StrokeKind::streamline;
    s.widths.assign(points.size(), width);
    s.points = std::move(points);
    probed.hatches.push_back(std::move(s));
  };
  for (const Hatch& h : lines) add(h.stroke.points, 0.15);
  const auto segment = [&](std::size_t k) {
    const Index h = owned.owner[k].first;
    return h == kNone ? kNone : ribs[h].stroke.segment;
  };
  const auto w = static_cast<std::size_t>(b.width);
  const double half = 0.5 * b.pixel;
  for (std::size_t k = 0; k + w < b.size(); ++k) {
    if (b.face[k] == kNone || segment(k) == kNone) continue;
    const auto differs = [&](std::size_t other) {
      return segment(other) != kNone && segment(other) != segment(k);
    };
    const Vec2 c = b.centre(k);
    if (differs(k + 1)) add({{c[0] + half, c[1] - half}, {c[0] + half, c[1] + half}}, 0.3);
    if (differs(k + w)) add({{c[0] - half, c[1] + half}, {c[0] + half, c[1] + half}}, 0.3);
  }
  io::write_drawing(path.string(), probed);
}

/// Of what is painted, contours left out, against the target; with white bands nothing.
ToneError painted_error(const Drawing& drawing, const Buffers& b, const HatchOptions& o) {
  if (o.tone_style == ToneStyle::bands) return {};
  Painting painting(b);
  for (const Stroke& s : drawing.hatches) painting.fill(simplified(outline(s), 0.01));
  std::vector<float> wanted = layer_ink(b, o.tone);
  if (o.cross_hatch) wanted = crossed(std::move(wanted), crossing_ink(b, o.tone, false));
  OwnedArea nobodys;
  nobodys.owner.assign(b.size(), {kNone, 0});
  return tone_error(tone_cells(b, painting.shares(), wanted, nobodys, o.tone.spacing));
}

Drawing draw(const Figure& figure, const kernel::TriangleMesh& mesh, const fs::path& out,
             double width, ToneError& painted) {
  Drawing drawing = contour_drawing(mesh, figure.eye, width);
  drawing.title = fmt::format("figure {}: {}", figure.name, figure.mesh);
  HatchOptions options;
  options.style = figure.style;
  options.cross_field = figure.cross_field;
  options.cross_hatch = figure.cross_hatch;
  options.tone_style = figure.tone;
  const std::string base = fmt::format("figure-{}", figure.name);
  Buffers buffers;
  options.look = [&](Buffers& b) { buffers = b; };
  add_hatches(drawing, mesh, frames_of(mesh), options,
              [](const char*, const std::function<void()>& work) { work(); });
  painted = painted_error(drawing, buffers, options);
  if (out.empty()) return drawing;
  io::write_drawing((out / (base + ".svg")).string(), drawing);
  shade(out / (base + "-shaded.png"), mesh, drawing.view);
  if (!figure.buffers) return drawing;
  for (const char* file : {"-curvature.png", "-lic.png"})
    io::write_atomically((out / (base + file)).string(),
                         io::buffer_file(file, buffers, drawing.lines.strokes));
  if (!drawing.segments.empty()) probe(drawing, buffers, out / (base + "-probed.svg"));
  return drawing;
}

void print_row(const Figure& figure, const kernel::TriangleMesh& mesh, const Drawing& drawing,
               const ToneError& painted) {
  const HatchCounts& c = drawing.counts;
  const StrokeNumbers n = numbers_of(drawing, ToneOptions{}.spacing);
  fmt::print(
      "| {} | {} | {} | {}, {} | {} | {} + {} | {:.1f}, {:.1f} | {:.0f} | {:.2f}, {:.2f}, {:.2f} | "
      "{:.1f} | {:.0f} | {} | {:.2f}, {:.1f}, {:.1f} | {} |\n",
      figure.name, figure.mesh, mesh.face_count(), c.singularities, c.index_sum,
      drawing.hatches.size(), c.key_ribs, c.blended, n.shortest, n.median, 100 * n.long_share, c.p5,
      c.median, c.p95, 100 * c.bare, 100 * n.change, c.over_contours, 100 * c.tone.mean,
      100 * c.tone.p95, 100 * c.tone.max,
      painted.cells.empty() ? ""
                            : fmt::format("{:.2f}, {:.1f}, {:.1f}", 100 * painted.mean,
                                          100 * painted.p95, 100 * painted.max));
}

void print_cells(const ToneError& tone, std::size_t most) {
  for (std::size_t k = 0; k < std::min(most, tone.cells.size()); ++k) {
    const ToneCell& cell = tone.cells[k];
    fmt::print("  at ({:.1f}, {:.1f}) mm: {:.3f} black for {:.3f}, bare {:.2f}\n", cell.corner[0],
               cell.corner[1], cell.black, cell.ink, cell.bare);
  }
}

}  // namespace
}  // namespace crest::experiments

int main(int argc, char** argv) {
  using namespace crest::experiments;
  Program program("Figures 3.20 to 3.26: drawings and their numbers.");
  std::string meshes = "../shared/data/meshes", only;
  std::filesystem::path out;
  double width = 160;
  unsigned cells = 0;
  program.option("--meshes", meshes, "folder of the meshes");
  program.option("--pictures", out, "folder for .svg and .png (default: none)");
  program.option("--width", width, "of the page, mm");
  program.option("--only", only, "one figure, such as 3.25");
  program.option("--cells", cells, "so many of the cells whose tone is worst", {0, 1000});
  return program.run(argc, argv, [&] {
    fmt::print(
        "\n| figure | mesh | triangles | singularities, index sum | strokes | ribs: key + blended "
        "| "
        "length 5 %, median (mm) | of 3 spacings and more (%) | spacing 5 %, median, 95 % (mm) | "
        "no stroke near (%) | width changes in a spacing, 95 % (%) | over contours | tone error "
        "mean, 95 %, max (%) | the same of what is painted (%) "
        "|\n|---|---|---|---|---|---|---|---|---|---|---|---|---|---|\n");
    for (const Figure& figure : kFigures) {
      if (!only.empty() && only != figure.name) continue;
      const crest::kernel::TriangleMesh mesh = read(figure, meshes);
      crest::line_art::ToneError painted;
      const crest::line_art::Drawing drawing = draw(figure, mesh, out, width, painted);
      print_row(figure, mesh, drawing, painted);
      print_cells(drawing.counts.tone, cells);
      if (cells > 0) fmt::print("  painted:\n");
      print_cells(painted, cells);
    }
    return 0;
  });
}
