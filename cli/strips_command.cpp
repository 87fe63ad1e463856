// SPDX-License-Identifier: GPL-3.0-or-later
// crest strips: the faces of a mesh as triangle strips (thesis, section 4.4).
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <memory>
#include <stdexcept>

#include "algorithms/strips/strips.hpp"
#include "algorithms/strips/tree_links.hpp"
#include "algorithms/strips/vertex_cache.hpp"
#include "cli/run.hpp"
#include "io/page/scene.hpp"
#include "io/strips/strip_writer.hpp"

namespace crest::cli {
namespace {

struct StripsOptions {
  CommonOptions common;
  strips::StripOptions strips;
  std::string index_buffer;
  bool no_swaps = false, tree = false;
};

strips::Strips make_strips(Run& run, const StripsOptions& o, const kernel::TriangleMesh& mesh) {
  const kernel::CornerTable table(mesh.vertex_count(), mesh.faces());
  strips::Strips found = run.step("strips", "joining faces", [&] {
    return strips::strips_of(table, mesh.faces(), strips::tree_links(table, mesh.faces()),
                             o.strips);
  });
  strips::Strips ordered = run.step("order", "ordering strips", [&] {
    return strips::in_cache_order(found, mesh.vertex_count(), strips::kCacheEntries);
  });
  const bool sound =
      run.step("check", "checking", [&] { return strips::covers(ordered, mesh.faces()); });
  if (!sound) throw std::runtime_error("strips: they are not the faces of the mesh");
  return ordered;
}

Outcome work(Run& run, const StripsOptions& o) {
  const io::MeshFile file = run.read_mesh();
  const kernel::TriangleMesh& mesh = file.mesh;
  const strips::Strips strips = make_strips(run, o, mesh);
  run.step("write", "writing", [&] {
    run.write("-o",
              [&](const std::string& path) { io::write_strips(path, mesh.points(), strips); });
    run.write("--index-buffer",
              [&](const std::string& path) { io::write_index_buffer(path, strips); });
    run.write("--picture", [&](const std::string& path) {
      io::write_strip_picture(path, mesh, strips, o.common.viewpoint);
    });
    run.show_page([&] { return io::strip_scene(mesh, strips, o.common.viewpoint); });
  });
  const auto acmr = [&](std::size_t entries) {
    return strips::average_cache_miss_ratio(strips, mesh.vertex_count(), mesh.face_count(),
                                            entries);
  };
  const double saved = strips::saved_per_cent(strips, mesh.face_count());
  run.report()["vertices"] = mesh.vertex_count();
  run.report()["faces"] = mesh.face_count();
  run.report()["strips"] = {
      {"count", strips.count()}, {"swaps", strips.swaps}, {"vertices_sent", strips.vertices.size()},
      {"saved", saved},          {"acmr_16", acmr(16)},   {"acmr_32", acmr(32)}};
  return {
      fmt::format("{} strips, {} swaps: {} vertices sent for {} faces, {:.1f} % of three a face "
                  "saved\nvertices a face that a cache of 16 misses: {:.3f}\n",
                  strips.count(), strips.swaps, strips.vertices.size(), mesh.face_count(), saved,
                  acmr(16)),
      {"roessl2005surfaces"}};
}

int run_strips(StripsOptions& o) {
  o.strips.swaps = !o.no_swaps;
  if (o.tree) o.strips.effort = 0;
  return run_command({"strips", o.common, {".vtp"}, {{"--index-buffer", o.index_buffer, {".bin"}}}},
                     [&](Run& run) { return work(run, o); });
}

std::function<int()> add_strips(CLI::App& app) {
  auto options = std::make_shared<StripsOptions>();
  CommonOptions& common = options->common;
  app.add_option("INPUT", common.input, fmt::format("mesh ({})", kMeshFormats))->required();
  app.add_option("-o,--output", common.output, "the strips as cells (.vtp)")->type_name("FILE");
  app.add_option("--index-buffer", options->index_buffer,
                 "the strips' vertices as unsigned 32-bit numbers, 0xffffffff between two strips "
                 "(.bin)")
      ->type_name("FILE");
  app.add_option("--picture", common.picture, "the strips by tints (.svg .png)")->type_name("FILE");
  add_page_option(app, common);
  app.add_option("--report", common.report, "counts and times (.json)")->type_name("FILE");
  auto* effort = app.add_option("--effort", options->strips.effort,
                                "sweeps of annealing that improve the tree's strips (default 20)");
  effort->check(CLI::Range(0, 100000))->type_name("N");
  app.add_flag("--tree", options->tree, "the strips of the strip tree as they are")
      ->excludes(effort);
  app.add_flag("--no-swaps", options->no_swaps,
               "start a new strip where a vertex would be sent twice: no triangle is empty");
  app.add_flag("--cite", common.cite, "print the references this run used (BibTeX)");
  add_view_options(app, common.viewpoint);
  add_clean_options(app, common.clean, false);
  add_run_options(app, common);
  return [options] { return run_strips(*options); };
}

}  // namespace

extern const Command strips_command;
const Command strips_command = {
    "strips",
    "the faces of a mesh as triangle strips",
    add_strips,
    {"crest strips ellipsoid.off -o strips.vtp --picture strips.png --page strips.html",
     "crest strips ellipsoid.off --tree -o tree.vtp",
     "crest strips ellipsoid.off --no-swaps --index-buffer strips.bin --report strips.json"}};

}  // namespace crest::cli
