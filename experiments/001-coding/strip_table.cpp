// SPDX-License-Identifier: GPL-3.0-or-later
// Triangle strips (thesis 4.4): what the strip tree saves, what annealing adds, the vertex cache.
#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <filesystem>

#include "algorithms/strips/strips.hpp"
#include "algorithms/strips/tree_links.hpp"
#include "algorithms/strips/vertex_cache.hpp"
#include "experiments/program.hpp"
#include "io/read/mesh_reader.hpp"
#include "kernel/geometry/input_error.hpp"

namespace crest {
namespace {

void print(const std::string& name, const std::vector<kernel::Triangle>& faces,
           kernel::Index vertices) {
  const kernel::CornerTable mesh(vertices, faces);
  const strips::Links tree = strips::tree_links(mesh, faces);
  const auto made = [&](int effort, bool swaps) {
    return strips::strips_of(mesh, faces, tree, {effort, swaps});
  };
  const auto saved = [&](const strips::Strips& s) {
    if (!strips::covers(s, faces)) throw std::runtime_error(name + ": strips are not the faces");
    return strips::saved_per_cent(s, faces.size());
  };
  const auto start = std::chrono::steady_clock::now();
  const strips::Strips improved = made(20, true);
  const std::chrono::duration<double, std::micro> time = std::chrono::steady_clock::now() - start;
  const strips::Strips plain = made(0, true);
  const strips::Strips ordered = strips::in_cache_order(improved, vertices, 16);
  const auto acmr = [&](const strips::Strips& s, std::size_t entries) {
    return strips::average_cache_miss_ratio(s, vertices, faces.size(), entries);
  };
  fmt::print(
      "| {} | {} | {} | {} | {:.2f} | {} | {} | {:.2f} | {:.2f} | {:.2f} | {:.3f} | {:.3f} | "
      "{:.3f} | {:.2f} |\n",
      name, faces.size(), plain.count(), plain.swaps, saved(plain), improved.count(),
      improved.swaps, saved(improved), saved(made(100, true)), saved(made(20, false)),
      acmr(improved, 16), acmr(ordered, 16), acmr(ordered, 32),
      time.count() / static_cast<double>(faces.size()));
}

/// Two triangles a square, rows of 2 side.
std::vector<kernel::Triangle> terrain(kernel::Index side) {
  std::vector<kernel::Triangle> faces;
  for (kernel::Index j = 0; j + 1 < side; ++j)
    for (kernel::Index i = 0; i + 1 < side; ++i) {
      const kernel::Index a = i + side * j;
      faces.push_back({a, a + 1, a + side + 1});
      faces.push_back({a, a + side + 1, a + side});
    }
  return faces;
}

int table(const std::string& data) {
  fmt::print(
      "| mesh | triangles | strips, tree | swaps | saved % | strips, 20 sweeps | swaps | saved % | "
      "100 sweeps: saved % | no swaps, 20 sweeps | ACMR 16 | ... ordered | ACMR 32, ordered | "
      "us a triangle |\n|---|---|---|---|---|---|---|---|---|---|---|---|---|---|\n");
  std::vector<std::filesystem::path> files;
  for (const char* folder : {"thesis-meshes", "meshes"})
    if (const auto path = std::filesystem::path(data) / folder; std::filesystem::exists(path))
      for (const auto& entry : std::filesystem::directory_iterator(path))
        if (entry.is_regular_file()) files.push_back(entry.path());
  std::sort(files.begin(), files.end());
  for (const auto& file : files) {
    try {
      const auto mesh = io::read_mesh(file.string()).mesh;
      print(file.filename().string(), mesh.faces(), mesh.vertex_count());
    } catch (const kernel::InputError& error) {
      fmt::print("| {} | refused: {} |\n", file.filename().string(),
                 std::string(error.what()).substr(file.string().size() + 2));
    }
  }
  if (files.empty()) fmt::print("{}: no meshes there, skipped\n", data);
  print("grid of 200 x 200 vertices", terrain(200), 40000);
  return 0;
}

}  // namespace
}  // namespace crest

int main(int argc, char** argv) {
  std::string data = "../shared/data";
  crest::experiments::Program program(
      "Triangle strips: the tree's, improved, and the vertex cache");
  program.option("--data", data, "folder with thesis-meshes/ and meshes/");
  return program.run(argc, argv, [&] { return crest::table(data); });
}
