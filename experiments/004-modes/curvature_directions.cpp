// SPDX-License-Identifier: GPL-3.0-or-later
// Figure 2 of paper 004: the major principal directions of a block's mode surfaces as a texture
// (line integral convolution in the picture), on the triangles of marching tets and on Crest's;
// there from the Hessian of the mode, too. Major: where the surface bends most towards larger
// |mode|, so that both signs of a mirrored load look alike.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <map>
#include <numbers>
#include <numeric>

#include "algorithms/curvature/curvature.hpp"
#include "algorithms/modes/surface_geometry.hpp"
#include "algorithms/sampling/loaded_block.hpp"
#include "experiments/004-modes/marching.hpp"
#include "experiments/program.hpp"
#include "io/picture/picture_file.hpp"
#include "io/read/mesh_reader.hpp"

namespace crest::experiments {
namespace {

using kernel::dot, kernel::norm, kernel::Vec3;
using kernel::operator+, kernel::operator-, kernel::operator*;

/// A surface with a direction at each point; zero: unknown.
struct Part {
  int sign;
  std::vector<Vec3> points;
  std::vector<kernel::Triangle> faces;
  std::vector<Vec3> directions;
};

/// From the triangles alone, as a file of them would be read with --weld 0 --split.
/// sign: of the mode; triangles are anticlockwise seen from higher ones.
template <class Triangles>
Part estimated(const std::vector<Vec3>& points, const Triangles& triangles, int sign) {
  io::Soup soup;
  soup.points = points;
  for (const auto& [a, b, c] : triangles)
    soup.cells.add(io::CellType::triangle, std::array<io::Cells::Node, 3>{a, b, c});
  const kernel::TriangleMesh mesh =
      io::mesh_of_soup(soup, {.clean = {.weld = 0.0, .split = true}}).mesh;
  Part part{sign, mesh.points(), mesh.faces(), {}};
  for (const auto& c : curvature::estimate(mesh, {}).vertices)
    part.directions.push_back(sign > 0 ? c.d1 : c.d2);
  return part;
}

std::vector<Vec3> closed_form(const modes::ModeSurface& s) {
  std::vector<Vec3> directions;
  for (const auto& g : s.geometry) directions.push_back(s.sign > 0 ? g.d1 : g.d2);
  return directions;
}

/// Degrees between two lines.
double angle(const Vec3& a, const Vec3& b) {
  const double c = std::fabs(dot(a, b)) / std::sqrt(dot(a, a) * dot(b, b));
  return std::acos(std::min(1.0, c)) * 180 / std::numbers::pi;
}

struct Quantiles {
  double half, ninety;
};
Quantiles quantiles(std::vector<double>& x) {
  if (x.empty()) return {0, 0};
  std::sort(x.begin(), x.end());
  return {x[x.size() / 2], x[x.size() * 9 / 10]};
}

/// Degrees between the directions at the ends of each triangle's sides.
Quantiles changes(const std::vector<Part>& parts) {
  std::vector<double> turns;
  for (const Part& p : parts)
    for (const auto& f : p.faces)
      for (std::size_t k = 0; k < 3; ++k) {
        const Vec3 &a = p.directions[f[k]], &b = p.directions[f[(k + 1) % 3]];
        if (dot(a, a) > 0 && dot(b, b) > 0) turns.push_back(angle(a, b));
      }
  return quantiles(turns);
}

/// What is seen at every pixel.
class Picture {
 public:
  Picture(const io::Camera& camera)
      : camera_(camera), pixels_(static_cast<std::size_t>(camera.width * camera.height)) {}

  void add(const Part& part) {
    const auto normals = io::vertex_normals(io::SurfaceView(part.points, part.faces));
    std::vector<Corner> corners;
    for (std::size_t i = 0; i < part.points.size(); ++i)
      corners.push_back(
          {camera_.project(part.points[i]), on_page(normals[i]), on_page(part.directions[i])});
    for (const auto& f : part.faces) add({corners[f[0]], corners[f[1]], corners[f[2]]}, part.sign);
  }

  void write(const std::filesystem::path& path) const {
    io::Canvas canvas(camera_.width, camera_.height);
    for (int y = 0; y < camera_.height; ++y)
      for (int x = 0; x < camera_.width; ++x) {
        const Pixel& p = at(x, y);
        if (p.sign == 0) continue;
        const io::Rgb grey = io::shaded(p.normal);
        const double light = (0.35 + 0.75 * convolved(x, y)) * grey.green;
        const Vec3 tint = p.sign > 0 ? Vec3{0.25, 0.8, 0.8} : Vec3{1, 0.84, 0.25};
        const auto tone = [&](double t) {
          return static_cast<std::uint8_t>(std::clamp(light * t, 0.0, 255.0));
        };
        canvas.fill_box(x, y, x + 1, y + 1, {tone(tint[0]), tone(tint[1]), tone(tint[2])});
      }
    io::write_canvas(path.string(), canvas, camera_.width, camera_.height);
  }

 private:
  struct Corner {
    Vec3 place, normal, direction;
  };
  struct Pixel {
    int sign = 0;  ///< 0: paper
    double depth = HUGE_VAL;
    Vec3 normal{};
    double along[2] = {0, 0};
  };

  /// In the picture's axes: right, up, towards the eye.
  Vec3 on_page(const Vec3& v) const {
    return {dot(camera_.right, v), dot(camera_.up, v), -dot(camera_.forward, v)};
  }
  const Pixel& at(int x, int y) const {
    return pixels_[static_cast<std::size_t>(y * camera_.width + x)];
  }

  void add(std::array<Corner, 3> c, int sign) {
    // A line has no sense: the corners' are made one.
    for (std::size_t k = 1; k < 3; ++k)
      if (dot(c[0].direction, c[k].direction) < 0) c[k].direction = -1.0 * c[k].direction;
    const auto area = [](double ax, double ay, double bx, double by) { return ax * by - ay * bx; };
    const Vec3 &p = c[0].place, &q = c[1].place, &r = c[2].place;
    const double whole = area(q[0] - p[0], q[1] - p[1], r[0] - p[0], r[1] - p[1]);
    if (whole == 0) return;
    const auto first = [](double x) { return std::max(0, static_cast<int>(std::floor(x))); };
    const int x1 = std::min(camera_.width - 1, static_cast<int>(std::max({p[0], q[0], r[0]})));
    const int y1 = std::min(camera_.height - 1, static_cast<int>(std::max({p[1], q[1], r[1]})));
    for (int y = first(std::min({p[1], q[1], r[1]})); y <= y1; ++y)
      for (int x = first(std::min({p[0], q[0], r[0]})); x <= x1; ++x) {
        const double px = x + 0.5 - p[0], py = y + 0.5 - p[1];
        const double w2 = area(q[0] - p[0], q[1] - p[1], px, py) / whole;
        const double w1 = area(px, py, r[0] - p[0], r[1] - p[1]) / whole, w0 = 1 - w1 - w2;
        if (w0 < 0 || w1 < 0 || w2 < 0) continue;
        const double depth = w0 * p[2] + w1 * q[2] + w2 * r[2];
        Pixel& pixel = pixels_[static_cast<std::size_t>(y * camera_.width + x)];
        if (depth >= pixel.depth) continue;
        const Vec3 n = w0 * c[0].normal + w1 * c[1].normal + w2 * c[2].normal;
        const Vec3 d = w0 * c[0].direction + w1 * c[1].direction + w2 * c[2].direction;
        const double length = std::hypot(d[0], d[1]), scale = length > 0 ? 1 / length : 0;
        pixel = {sign, depth, io::normalised(n, {0, 0, 1}), {scale * d[0], -scale * d[1]}};
      }
  }

  static double noise(int x, int y) {
    const auto key = (static_cast<std::uint64_t>(y) << 32) + static_cast<std::uint64_t>(x);
    return static_cast<double>(mixed(mixed(key + 1) + 0x9e3779b97f4a7c15) >> 11) * 0x1p-53;
  }
  /// The mean noise along the direction, its contrast restored.
  double convolved(int x, int y) const {
    constexpr int kReach = 12;
    double sum = noise(x, y);
    int count = 1;
    for (const double sense : {1.0, -1.0}) {
      double px = x + 0.5, py = y + 0.5, dx = sense * at(x, y).along[0],
             dy = sense * at(x, y).along[1], depth = at(x, y).depth;
      for (int step = 0; step < kReach; ++step) {
        px += dx;
        py += dy;
        const int i = static_cast<int>(std::floor(px)), j = static_cast<int>(std::floor(py));
        if (i < 0 || j < 0 || i >= camera_.width || j >= camera_.height) break;
        const Pixel& next = at(i, j);
        const double along = next.along[0] * dx + next.along[1] * dy;
        // Where the surface is another, or its lines are.
        if (next.sign == 0 || std::fabs(next.depth - depth) > 6 || std::fabs(along) < 0.5) break;
        depth = next.depth;
        dx = along < 0 ? -next.along[0] : next.along[0];
        dy = along < 0 ? -next.along[1] : next.along[1];
        sum += noise(i, j);
        ++count;
      }
    }
    return std::clamp(0.5 + (sum / count - 0.5) * std::sqrt(static_cast<double>(count)), 0.0, 1.0);
  }

  io::Camera camera_;
  std::vector<Pixel> pixels_;
};

class Figure {
 public:
  Figure(const std::string& block, double scale, const modes::Level& level) : level_(level) {
    for (const sampling::Scenario& s : sampling::scenarios()) {
      if (s.name != block) continue;
      const auto [solid, stress, steps] = sampling::load_block(s, scale, true);
      std::vector<kernel::TetMesh::Tet> tets;
      for (const auto& t : solid.tets()) tets.push_back({t[0], t[1], t[2], t[3]});
      field_ = {kernel::TetMesh(sampling::points(solid), std::move(tets)), stress};
    }
    result_ = modes::extract(field_, level);
    for (auto& s : result_.surfaces) modes::add_geometry(field_, s);
  }

  void run(const std::filesystem::path& folder, int width, int parts) const {
    fmt::print(
        "| directions | triangles | turn along a side, half, 90 % (degrees) |\n|---|---|---|\n");
    const auto marching = marched(parts);
    std::vector<Part> own, exact;
    std::vector<double> apart;
    for (const auto& s : result_.surfaces) {
      own.push_back(estimated(s.points, s.triangles, s.sign));
      exact.push_back({s.sign, s.points, s.triangles, closed_form(s)});
      std::map<Vec3, Vec3> at;
      for (std::size_t i = 0; i < own.back().points.size(); ++i)
        at[own.back().points[i]] = own.back().directions[i];
      for (std::size_t i = 0; i < s.points.size(); ++i) {
        const auto found = at.find(s.points[i]);
        const Vec3& b = exact.back().directions[i];
        if (found != at.end() && dot(found->second, found->second) > 0 && dot(b, b) > 0)
          apart.push_back(angle(found->second, b));
      }
    }
    const io::Camera camera = whole(width);
    show("marching tets", marching, camera, folder / "figure-2-marching.png");
    show("Crest, from the triangles", own, camera, folder / "figure-2-triangles.png");
    show("Crest, from the mode's Hessian", exact, camera, folder / "figure-2.png");
    const Quantiles q = quantiles(apart);
    fmt::print(
        "\ntriangles and Hessian: {:.1f} degrees apart at half of the vertices, {:.1f} at 90 %\n",
        q.half, q.ninety);
  }

 private:
  void show(const char* name, const std::vector<Part>& parts, const io::Camera& camera,
            const std::filesystem::path& path) const {
    std::size_t triangles = 0;
    Picture picture(camera);
    for (const Part& p : parts) {
      picture.add(p);
      triangles += p.faces.size();
    }
    picture.write(path);
    const Quantiles q = changes(parts);
    fmt::print("| {} | {} | {:.1f}, {:.1f} |\n", name, triangles, q.half, q.ninety);
  }
  io::Camera whole(int width) const {
    const std::vector<kernel::Triangle> none;
    std::vector<Vec3> points = field_.mesh.points();
    return io::make_camera(io::SurfaceView(points, none),
                           {.view = Vec3{-0.15, 0.55, -0.8}, .up = Vec3{0, 0, 1}}, width);
  }
  std::vector<Part> marched(int parts) const {
    std::vector<Part> both;
    const Lattice lattice(parts);
    for (const auto& s : result_.surfaces) {
      Marching marching(field_.tensors, field_.mesh.points(), s.sign * level_.value());
      for (const auto& t : field_.mesh.tets())
        marching.add({t[0], t[1], t[2], t[3]}, lattice, parts);
      both.push_back(estimated(marching.places(), marching.triangles(), s.sign));
    }
    return both;
  }

  modes::Level level_;
  modes::ModeField field_;
  modes::ModeResult result_;
};

}  // namespace
}  // namespace crest::experiments

int main(int argc, char** argv) {
  std::filesystem::path folder = ".";
  std::string block = "push_pull";
  int p = 99, width = 640, parts = 1;
  double scale = 1;
  crest::experiments::Program program(
      "Principal directions of mode surfaces, figure 2 of paper 004.");
  program.option("--pictures", folder, "folder of the pictures");
  program.option("--block", block, "single, push_pull, three, twist");
  program.option("--scale", scale, "of the block; 1 is the paper's size");
  program.option("--hundredths", p, "the mode in hundredths", {1, 99});
  program.option("--parts", parts, "marching tets cut a tet's edge in so many", {1, 4});
  program.option("--width", width, "pixels", {64, 2000});
  return program.run(argc, argv, [&] {
    const int common = std::gcd(p, 100);
    crest::experiments::Figure(block, scale, {p / common, 100 / common}).run(folder, width, parts);
    return 0;
  });
}
