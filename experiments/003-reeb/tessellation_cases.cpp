// SPDX-License-Identifier: GPL-3.0-or-later
// Figure 3 of paper 003: the tessellation cases <F, L>, F face-critical and L line-critical points,
// counted over random triangles, one of each drawn with its level lines.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <fstream>
#include <map>
#include <random>
#include <set>
#include <stdexcept>

#include "algorithms/reeb/contours.hpp"
#include "algorithms/reeb/tile_complex.hpp"
#include "experiments/program.hpp"

namespace crest {
namespace {

namespace fs = std::filesystem;
using kernel::QuadraticMesh;
using kernel::Vec3;

/// Equilateral, of height 1.
const std::vector<Vec3>& corners() {
  static const std::vector<Vec3> points = {
      {0, 0, 0}, {1.1547005383792515, 0, 0}, {0.5773502691896257, 1, 0}};
  return points;
}

/// Six values, each uniform in [0, 1): three corners, the middles of the sides (0 1), (1 2), (2 0).
QuadraticMesh random_triangle(std::mt19937_64& random) {
  const auto next = [&] { return static_cast<double>(random() >> 11) * 0x1p-53; };
  std::vector<double> values(3);
  for (double& v : values) v = next();
  const std::array<double, 3> middle = {next(), next(), next()};
  return QuadraticMesh(corners(), {{0, 1, 2}}, values, {middle});
}

/// A picture of 240 x 220, y upwards.
class Svg {
 public:
  void line(const std::vector<Vec3>& points, const char* colour, double width) {
    body_ += fmt::format("<polyline fill=\"none\" stroke=\"{}\" stroke-width=\"{}\" points=\"",
                         colour, width);
    for (const Vec3& p : points) body_ += fmt::format("{:.2f},{:.2f} ", x(p), y(p));
    body_ += "\"/>\n";
  }
  void dot(const Vec3& p, const char* colour) {
    body_ +=
        fmt::format("<circle cx=\"{:.2f}\" cy=\"{:.2f}\" r=\"5\" fill=\"{}\" stroke=\"#222\"/>\n",
                    x(p), y(p), colour);
  }
  void write(const fs::path& path) const {
    std::ofstream file(path);
    file << "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 240 220\">\n"
         << body_ << "</svg>\n";
    if (!file.flush()) throw std::runtime_error(path.string() + ": cannot be written");
  }

 private:
  static double x(const Vec3& p) { return 10 + 190 * p[0]; }
  static double y(const Vec3& p) { return 205 - 190 * p[1]; }
  std::string body_;
};

/// Level lines grey, the tessellation's arcs black; corners white, line-critical points orange, the
/// face-critical one red.
void draw(const QuadraticMesh& mesh, const reeb::TileComplex& tiles, const fs::path& path) {
  const auto places = reeb::node_places(mesh, tiles);
  const auto [low, high] = std::minmax_element(
      places.begin(), places.end(),
      [](const reeb::NodePlace& a, const reeb::NodePlace& b) { return a.value < b.value; });
  constexpr int kLevels = 14;
  Svg svg;
  for (int i = 1; i < kLevels; ++i) {
    const double level = low->value + (high->value - low->value) * i / kLevels;
    for (const reeb::Contour& c : reeb::contours(mesh, tiles, level)) {
      std::vector<Vec3> points = c.points;
      if (c.closed) points.push_back(points.front());
      svg.line(points, "#9db4d0", 1.2);
    }
  }
  std::set<std::pair<kernel::Index, kernel::Index>> arcs;
  for (const kernel::Triangle& t : tiles.tiles)
    for (std::size_t k = 0; k < 3; ++k) arcs.insert(std::minmax(t[k], t[(k + 1) % 3]));
  for (const auto& [a, b] : arcs) svg.line({places[a].point, places[b].point}, "#222222", 2);
  for (kernel::Index v = 0; v < tiles.node_count(); ++v) {
    const bool on_line = v >= 3 && v < 3 + tiles.critical_edges.size();
    svg.dot(places[v].point, v < 3 ? "#ffffff" : on_line ? "#f0a000" : "#d21f1f");
  }
  svg.write(path);
}

void run(int triangles, const std::string& pictures) {
  if (!pictures.empty()) fs::create_directories(pictures);
  std::mt19937_64 random(1);
  std::map<std::pair<std::size_t, std::size_t>, int> cases;
  for (int i = 0; i < triangles; ++i) {
    const QuadraticMesh mesh = random_triangle(random);
    const reeb::TileComplex tiles = reeb::tessellate(mesh);
    const std::pair key(tiles.critical_faces.size(), tiles.critical_edges.size());
    if (++cases[key] == 1 && !pictures.empty())
      draw(mesh, tiles,
           fs::path(pictures) / fmt::format("figure-3-{}-{}.svg", key.first, key.second));
  }
  fmt::print(
      "{} triangles, six uniform values each\n\n| case <F, L> | triangles | % |\n|---|---|---|\n",
      triangles);
  for (std::size_t f = 0; f < 2; ++f)
    for (std::size_t l = 0; l < 4; ++l)
      fmt::print("| {}, {} | {} | {:.3f} |\n", f, l, cases[{f, l}],
                 100.0 * cases[{f, l}] / triangles);
}

}  // namespace
}  // namespace crest

int main(int argc, char** argv) {
  int triangles = 1000000;
  std::string pictures;
  crest::experiments::Program program("The tessellation cases of quadratic triangles");
  program.option("--triangles", triangles, "random ones (default a million)", {1, 1000000000});
  program.option("--pictures", pictures, "folder for a picture of each case (default: none)");
  return program.run(argc, argv, [&] {
    crest::run(triangles, pictures);
    return 0;
  });
}
