// SPDX-License-Identifier: GPL-3.0-or-later
// Figures 3.15 to 3.19 of paper 001 on fandisk: the region, closing, thinning step by step, and the
// graph's elements.
#include <fmt/format.h>

#include <filesystem>

#include "algorithms/feature_lines/skeleton.hpp"
#include "experiments/001-features/feature_field.hpp"
#include "experiments/close_up.hpp"
#include "experiments/program.hpp"
#include "io/curvature/curvature_picture.hpp"
#include "io/features/feature_writer.hpp"
#include "io/read/mesh_reader.hpp"

namespace crest {
namespace {

namespace fl = feature_lines;
using experiments::CloseUp;
using kernel::Index;

constexpr const char* kMarked = "#d21f1f";
constexpr const char* kSimple = "#f0a000";

/// One colour for all marked vertices, and the edges between them.
CloseUp marked_view(const kernel::TriangleMesh& mesh, const fl::Marks& marks, CloseUp view) {
  const auto normals = curvature::area_weighted_normals(mesh);
  view.dots.resize(mesh.vertex_count());
  for (Index v = 0; v < mesh.vertex_count(); ++v)
    if (marks[v]) view.dots[v] = kMarked;
  for (const auto& e : mesh.edges())
    if (marks[e.v0] && marks[e.v1])
      view.lines.push_back({mesh.points()[e.v0], mesh.points()[e.v1], normals[e.v0], kMarked, 2.5});
  return view;
}

/// By the elements of section 3.4.4.
CloseUp labelled_view(const kernel::TriangleMesh& mesh, const fl::FeatureGraph& graph,
                      CloseUp view) {
  constexpr const char* kColours[] = {"", "#1e1e1e", "#1c46de", "#da1a20", "#169e3c", "#e0b000"};
  view = marked_view(mesh, fl::Marks(mesh.vertex_count(), 0), view);
  const auto normals = curvature::area_weighted_normals(mesh);
  for (Index v = 0; v < mesh.vertex_count(); ++v)
    view.dots[v] = kColours[static_cast<std::size_t>(graph.labels[v])];
  for (const auto& line : graph.lines)
    for (std::size_t i = 0; i + 1 < line.vertices.size(); ++i) {
      const Index a = line.vertices[i], b = line.vertices[i + 1];
      view.lines.push_back({mesh.points()[a], mesh.points()[b], normals[a],
                            kColours[2 + static_cast<std::size_t>(line.kind)], 2.5});
    }
  for (const auto& [a, b] : graph.node_edges)
    view.lines.push_back({mesh.points()[a], mesh.points()[b], normals[a], kColours[1], 2.5});
  return view;
}

void picture(const std::string& path, const kernel::TriangleMesh& mesh,
             const std::vector<double>& values, const std::string& label) {
  io::ColourPicture options;
  options.label = label;
  options.width = 480;
  io::write_colour_picture(path, mesh, values, options);
}

std::vector<double> as_values(const fl::Marks& marks) {
  return {marks.begin(), marks.end()};
}

/// A strip two vertices wide on a flat sheet: each of its vertices may go, but not all.
void figure_19a(const std::string& folder) {
  constexpr Index side = 9;
  std::vector<kernel::Vec3> points;
  std::vector<kernel::Triangle> faces;
  for (Index j = 0; j < side; ++j)
    for (Index i = 0; i < side; ++i)
      points.push_back({i + 0.5 * j - 6, 0.8660254037844386 * (j - 4.0), 0});
  for (Index j = 0; j + 1 < side; ++j)
    for (Index i = 0; i + 1 < side; ++i) {
      const Index a = i + side * j;
      faces.push_back({a, a + 1, a + side});
      faces.push_back({a + 1, a + side + 1, a + side});
    }
  const kernel::TriangleMesh mesh(points, faces);
  fl::Marks marks(mesh.vertex_count(), 0);
  for (Index i = 1; i <= 7; ++i) marks[i + side * 4] = 1;
  for (Index i = 1; i <= 6; ++i) marks[i + side * 5] = 1;
  CloseUp view;
  view.radius = 4.5;
  CloseUp before = marked_view(mesh, marks, view);
  for (Index v = 0; v < mesh.vertex_count(); ++v)
    if (marks[v] && fl::marked_neighbours(mesh, marks, v) >= 2 && fl::is_simple(mesh, marks, v))
      before.dots[v] = kSimple;
  experiments::write_close_up(folder + "/figure-3.19-a-before.svg", mesh, before);
  fl::Thinner thinner(mesh, marks);
  thinner.pre_prune();
  experiments::write_close_up(folder + "/figure-3.19-a-after.svg", mesh,
                              marked_view(mesh, thinner.marks(), view));
}

int run(const std::string& file, const std::string& folder, Index centre) {
  if (!std::filesystem::exists(file)) {
    fmt::print("{}: not there, skipped\n", file);
    return 0;
  }
  std::filesystem::create_directories(folder);
  const auto mesh = io::read_mesh(file).mesh;
  const auto at = [&](const char* name) { return folder + "/figure-3." + name; };
  const auto field = experiments::curvature_field(mesh);
  const fl::Marks region = fl::threshold_by_value(field, fl::field_quantile(field, 0.85));
  CloseUp view;
  view.centre = mesh.points().at(centre);
  view.radius = 0.11;
  const auto close_up = [&](const char* name, const fl::Marks& marks) {
    experiments::write_close_up(at(name), mesh, marked_view(mesh, marks, view));
  };
  picture(at("15-a.png"), mesh, field, "larger principal curvature");
  picture(at("15-b.png"), mesh, as_values(region), "feature region");

  const fl::Structure ring{fl::Neighbourhood::rings, 1};
  const fl::Marks dilated = fl::dilate(mesh, region, ring);
  close_up("16-a.svg", region);
  close_up("16-b.svg", dilated);
  close_up("16-c.svg", fl::erode(mesh, dilated, ring));

  fl::Thinner thinner(mesh, region, field);
  thinner.skeletonize();
  picture(at("17-a.png"), mesh, as_values(thinner.marks()), "skeletonize");
  close_up("18-a.svg", thinner.marks());
  thinner.pre_prune();
  picture(at("17-b.png"), mesh, as_values(thinner.marks()), "preprune");
  close_up("18-b.svg", thinner.marks());
  thinner.prune(4);
  picture(at("17-c.png"), mesh, as_values(thinner.marks()), "prune");
  close_up("18-c.svg", thinner.marks());

  figure_19a(folder);
  const fl::FeatureGraph graph = fl::build_feature_graph(mesh, thinner.marks());
  experiments::write_close_up(at("19-b.svg"), mesh, labelled_view(mesh, graph, view));
  io::write_feature_picture(at("19-c.png"), mesh, graph, false);
  fl::Options options;
  options.quantile = 0.885;
  options.prune = 4;
  const auto lines =
      fl::extract_feature_lines(mesh, experiments::curvature_field(mesh, "ne"), options);
  io::write_feature_picture(at("15-c.png"), mesh, lines.graph, false);
  fmt::print("Pictures of {} in {}\n", file, folder);
  return 0;
}

}  // namespace
}  // namespace crest

int main(int argc, char** argv) {
  std::string file = "../shared/data/meshes/fandisk.off", folder = "figures-001-features";
  crest::kernel::Index centre = 4037;
  crest::experiments::Program program("Figures 3.15 to 3.19 of paper 001");
  program.option("--mesh", file, "(default ../shared/data/meshes/fandisk.off)");
  program.option("--pictures", folder, "folder for the pictures (default figures-001-features)");
  program.option("--centre", centre, "vertex in the middle of the close-ups (default 4037)");
  return program.run(argc, argv, [&] { return crest::run(file, folder, centre); });
}
