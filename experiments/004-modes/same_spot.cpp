// SPDX-License-Identifier: GPL-3.0-or-later
// Figure 3 of paper 004: one spot of a block, the surface by marching tets and by Crest. The spot
// is the window of cubes with the most tets where marching tets, each tet in one, see no surface.
#include <fmt/format.h>

#include <filesystem>
#include <map>

#include "algorithms/modes/modes.hpp"
#include "algorithms/sampling/loaded_block.hpp"
#include "experiments/004-modes/marching.hpp"
#include "experiments/program.hpp"
#include "io/modes/domain_outline.hpp"
#include "io/modes/mode_writer.hpp"

namespace crest::experiments {
namespace {

using kernel::Index;

struct Window {
  std::array<int, 3> low;
  int size;
  bool holds(const kernel::Vec3& p) const {
    for (std::size_t k = 0; k < 3; ++k)
      if (p[k] < low[k] || p[k] > low[k] + size) return false;
    return true;
  }
};

/// The tets in a window, with the points they use.
modes::ModeField part_of(const modes::ModeField& field, const Window& window) {
  std::vector<Index> number(field.tensors.size(), ~Index{0});
  std::vector<kernel::Vec3> points;
  std::vector<kernel::TetMesh::Tet> tets;
  std::vector<std::array<double, 6>> tensors;
  for (const auto& t : field.mesh.tets()) {
    if (!std::all_of(t.begin(), t.end(),
                     [&](Index v) { return window.holds(field.mesh.points()[v]); }))
      continue;
    auto& to = tets.emplace_back(t);
    for (Index& v : to) {
      if (number[v] == ~Index{0}) {
        number[v] = static_cast<Index>(points.size());
        points.push_back(field.mesh.points()[v]);
        tensors.push_back(field.tensors[v]);
      }
      v = number[v];
    }
  }
  return {kernel::TetMesh(std::move(points), std::move(tets)), std::move(tensors)};
}

const modes::ModeSurface& side(const modes::ModeResult& r, double level) {
  return r.surfaces.size() == 2 && level < 0 ? r.surfaces[1] : r.surfaces[0];
}

/// The window with the most tets of which marching tets see no surface.
Window worst_window(const modes::ModeField& field, const modes::ModeSurface& surface, double level,
                    int size) {
  std::vector<char> has(field.mesh.tets().size(), 0);
  for (const Index t : surface.tets) has[t] = 1;
  const Lattice lattice(1);
  Marching marching(field.tensors, {}, level);
  std::map<std::array<int, 3>, std::size_t> missed;  // by cube
  for (Index t = 0; t < has.size(); ++t) {
    const auto& v = field.mesh.tets()[t];
    if (marching.add({v[0], v[1], v[2], v[3]}, lattice, 1) || has[t] == 0) continue;
    kernel::Vec3 low = field.mesh.points()[v[0]];
    for (const Index x : v)
      for (std::size_t k = 0; k < 3; ++k) low[k] = std::fmin(low[k], field.mesh.points()[x][k]);
    ++missed[{static_cast<int>(low[0]), static_cast<int>(low[1]), static_cast<int>(low[2])}];
  }
  Window best{{0, 0, 0}, size};
  std::size_t most = 0;
  for (const auto& [cube, n] : missed) {
    const Window w{{cube[0] - size / 2, cube[1] - size / 2, cube[2] - size / 2}, size};
    std::size_t sum = 0;
    for (const auto& [other, count] : missed) {
      bool inside = true;
      for (std::size_t k = 0; k < 3; ++k)
        inside = inside && other[k] >= w.low[k] && other[k] < w.low[k] + size;
      sum += inside ? count : 0;
    }
    if (sum > most) {
      most = sum;
      best = w;
    }
  }
  return best;
}

void run(const std::string& name, const modes::Level& level, int sign, int size,
         const std::filesystem::path& folder) {
  for (const sampling::Scenario& s : sampling::scenarios()) {
    if (s.name != name) continue;
    const auto [block, stress, steps] = sampling::load_block(s, 1, true);
    std::vector<kernel::TetMesh::Tet> tets;
    for (const auto& t : block.tets()) tets.push_back({t[0], t[1], t[2], t[3]});
    const modes::ModeField field{kernel::TetMesh(points(block), std::move(tets)), stress};
    const double mode = sign * level.value();
    const auto whole = modes::extract(field, level);
    const Window window = worst_window(field, side(whole, mode), mode, size);
    const modes::ModeField spot = part_of(field, window);
    fmt::print(
        "| by | parts of a tet | triangles | components | Euler characteristic |\n"
        "|---|---|---|---|---|\n");
    io::ModeScene scene;
    scene.outline = io::domain_outline(spot.mesh);
    const io::Viewpoint viewpoint{.view = kernel::Vec3{1, 2, -1}, .up = kernel::Vec3{0, 0, 1}};
    for (const int n : {1, 3}) {
      const Lattice lattice(n);
      Marching marching(spot.tensors, spot.mesh.points(), mode);
      for (const auto& t : spot.mesh.tets()) marching.add({t[0], t[1], t[2], t[3]}, lattice, n);
      const auto c = marching.count();
      fmt::print("| marching tets | {} | {} | {} | {} |\n", n * n * n, c.triangles, c.components,
                 c.euler);
      modes::ModeSurface surface;
      surface.sign = sign;
      surface.points = marching.places();
      surface.triangles = marching.triangles();
      surface.tensors.resize(surface.points.size());
      scene.surfaces = {surface};
      io::write_mode_picture((folder / fmt::format("figure-3-marching-{}.png", n)).string(), scene,
                             viewpoint);
    }
    const auto r = modes::extract(spot, level);
    const modes::ModeSurface& surface = side(r, mode);
    fmt::print("| Crest | 1 | {} | {} | {} |\n\nwindow from {}, {}, {}, {} cubes wide\n",
               surface.triangles.size(), surface.components.size(), surface.euler_characteristic,
               window.low[0], window.low[1], window.low[2], window.size);
    scene.surfaces = {surface};
    io::write_mode_picture((folder / "figure-3-crest.png").string(), scene, viewpoint);
  }
}

}  // namespace
}  // namespace crest::experiments

int main(int argc, char** argv) {
  std::filesystem::path folder = ".";
  std::string block = "single";
  int p = 97, q = 100, size = 6;
  bool minus = false;
  crest::experiments::Program program("One spot by marching tets and by Crest.");
  program.option("--output", folder, "folder of the pictures");
  program.option("--block", block, "single, push_pull, three, twist");
  program.option("--p", p, "the mode is p / q", {0, 1000});
  program.option("--q", q, "the mode is p / q", {1, 1000});
  program.option("--size", size, "cubes along an edge of the window", {2, 20});
  program.flag("--minus", minus, "the level -p / q");
  return program.run(argc, argv, [&] {
    crest::experiments::run(block, {p, q}, minus ? -1 : p == 0 ? 0 : 1, size, folder);
    return 0;
  });
}
