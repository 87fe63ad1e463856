// SPDX-License-Identifier: GPL-3.0-or-later
// Figure 7 of paper 004 for one tet: its faces' curves, the region of the sphere of medium
// eigenvectors that they bound with arcs of the complex domain, its triangulation with a quad grid,
// what that is in space; and how far it is from the surface as Crest triangulates it.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <random>
#include <stdexcept>

#include "experiments/004-modes/sphere_picture.hpp"
#include "experiments/004-modes/tet_region.hpp"
#include "experiments/program.hpp"

namespace crest::experiments {
namespace {

using io::Rgb;
using kernel::dot, kernel::norm;
using kernel::operator+, kernel::operator-, kernel::operator*;

constexpr Rgb kBlue{40, 80, 200}, kGreen{30, 140, 60}, kInk{70, 70, 70}, kEdge{150, 150, 158},
    kGrey{190, 190, 190}, kWhite{245, 245, 245}, kYellow{255, 226, 130};

/// A tet in the box from -2 to 2 in which field 3 is shown, with some volume.
std::array<Vec3, 4> random_corners(unsigned seed) {
  std::mt19937_64 draw(seed);
  while (true) {
    std::array<Vec3, 4> c;
    for (Vec3& p : c)
      for (double& x : p)
        x = std::round(static_cast<double>(draw() >> 11) * 0x1p-53 * 40 - 20) / 10;
    const double volume = dot(c[1] - c[0], kernel::cross(c[2] - c[0], c[3] - c[0])) / 6;
    if (volume > 3) return c;
  }
}

double to_triangle(const Vec3& p, const Vec3& a, const Vec3& b, const Vec3& c) {
  const auto to_segment = [&](const Vec3& s, const Vec3& t) {
    const Vec3 d = t - s;
    const double length = dot(d, d);
    const double at = length > 0 ? std::clamp(dot(p - s, d) / length, 0.0, 1.0) : 0;
    return norm(p - s - at * d);
  };
  const Vec3 n = kernel::cross(b - a, c - a);
  const auto inside = [&](const Vec3& s, const Vec3& t) {
    return dot(kernel::cross(t - s, p - s), n) >= 0;
  };
  if (dot(n, n) > 0 && inside(a, b) && inside(b, c) && inside(c, a))
    return std::fabs(dot(p - a, n)) / norm(n);
  return std::min({to_segment(a, b), to_segment(b, c), to_segment(c, a)});
}

double area_of(const Vec3& a, const Vec3& b, const Vec3& c) {
  return 0.5 * norm(kernel::cross(b - a, c - a));
}

double diagonal(const TetField& tet) {
  Vec3 low = tet.corners[0], high = low;
  for (const Vec3& c : tet.corners)
    for (std::size_t k = 0; k < 3; ++k) {
      low[k] = std::min(low[k], c[k]);
      high[k] = std::max(high[k], c[k]);
    }
  return norm(high - low);
}

double mode_error(const TetField& tet, const std::array<double, 4>& w, int sign) {
  const auto corners = field_3_at(tet.corners);
  modes::Tensor t{};
  for (std::size_t i = 0; i < 4; ++i)
    for (std::size_t k = 0; k < 6; ++k) t[k] += w[i] * corners[i][k];
  const auto d = modes::deviator(t);
  const double n = modes::inner(d, d);
  return std::fabs(3 * std::sqrt(6.0) * modes::determinant(d) / (n * std::sqrt(n)) - sign * tet.mu);
}

double to_surfaces(const Vec3& p, const modes::ModeResult& crest) {
  double least = HUGE_VAL;
  for (const auto& s : crest.surfaces)
    for (const auto& [a, b, c] : s.triangles)
      least = std::min(least, to_triangle(p, s.points[a], s.points[b], s.points[c]));
  return least;
}

class Pipeline {
 public:
  Pipeline(const TetField& tet, const modes::ModeResult& crest, const SphereRegion& region,
           const Tessellation& made, int width)
      : tet_(tet), crest_(crest), region_(region), made_(made), width_(width) {
    // The middle of the region, and of the complex domain's boundary on that side.
    Vec3 region_middle{}, arc_middle{};
    for (const auto& p : made.points)
      if (p.twin == SphereRegion::kNone) region_middle = region_middle + in_frame(p.v);
    for (const auto& p : made.points)
      if (p.twin != SphereRegion::kNone && dot(in_frame(p.v), region_middle) > 0)
        arc_middle = arc_middle + in_frame(p.v);
    eye_ = io::normalised(region_middle, {1, 0, 0}) + io::normalised(arc_middle, {0, 0, 0});
  }

  void draw(const std::filesystem::path& folder) const {
    draw_curves(folder / "figure-7-a.png");
    draw_sphere(folder / "figure-7-b.png", false);
    draw_sphere(folder / "figure-7-c.png", true);
    draw_surface(folder / "figure-7-d.png");
  }

  void print() const {
    long euler = 0;
    std::size_t triangles = 0, components = 0;
    double area = 0, own_area = 0, farthest = 0, error = 0;
    for (const auto& s : crest_.surfaces) {
      euler += s.euler_characteristic;
      triangles += s.triangles.size();
      components += s.components.size();
      for (const auto& [a, b, c] : s.triangles)
        area += area_of(s.points[a], s.points[b], s.points[c]);
    }
    for (const auto& [a, b, c] : made_.triangles)
      own_area += area_of(made_.points[a].place, made_.points[b].place, made_.points[c].place);
    for (std::size_t i = region_.points.size(); i < made_.points.size(); ++i) {
      const auto p = tet_.point(made_.points[i].v);
      error = std::max(error, mode_error(tet_, p->weights, made_.points[i].sign));
      farthest = std::max(farthest, to_surfaces(made_.points[i].place, crest_));
    }
    fmt::print(
        "| surface | triangles | components | Euler characteristic | area "
        "|\n|---|---|---|---|---|\n"
        "| Crest | {} | {} | {} | {:.4f} |\n"
        "| from the sphere | {} | | {} | {:.4f} |\n\n"
        "{} points on the tet's faces, {} passages to an antipode, {} points of arcs, {} of the "
        "quad "
        "grid; of these the mode is off by {:.1e} at most, the distance from Crest's triangles is "
        "{:.1e} of the tet's diagonal\n",
        triangles, components, euler, area, made_.triangles.size(), euler_characteristic(made_),
        own_area, on_faces(), region_.crossings, arc_points(), made_.grid_points, error,
        farthest / diagonal(tet_));
  }

 private:
  std::size_t on_faces() const {
    return static_cast<std::size_t>(
        std::count_if(region_.points.begin(), region_.points.end(),
                      [](const auto& p) { return p.twin == SphereRegion::kNone; }));
  }
  std::size_t arc_points() const {
    return (region_.points.size() - on_faces()) / 2 - region_.crossings;
  }
  Vec3 in_frame(const Vec3& v) const {
    const auto& f = tet_.field.frame();
    return {dot(f[0], v), dot(f[1], v), dot(f[2], v)};
  }

  io::Camera camera() const {
    static const std::vector<kernel::Triangle> faces{{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {0, 3, 2}};
    const std::vector<Vec3> corners(tet_.corners.begin(), tet_.corners.end());
    return io::make_camera(io::SurfaceView(corners, faces), {.view = Vec3{-0.5, -0.8, -0.6}},
                           width_);
  }
  void draw_tet(io::Canvas& canvas, const io::Camera& camera) const {
    for (std::size_t i = 0; i < 4; ++i)
      for (std::size_t j = 0; j < i; ++j)
        canvas.draw_stroke(camera.project(tet_.corners[i]), camera.project(tet_.corners[j]),
                           0.004 * width_, kEdge);
  }
  void draw_edges(io::Canvas& canvas, const io::Camera& camera,
                  const std::vector<SphereRegion::Edge>& edges, Rgb colour) const {
    for (const auto& [a, b] : edges)
      canvas.draw_stroke(camera.project(region_.points[a].place),
                         camera.project(region_.points[b].place), 0.01 * width_, colour);
  }
  void draw_curves(const std::filesystem::path& path) const {
    const io::Camera view = camera();
    io::Canvas canvas(view.width, view.height);
    draw_tet(canvas, view);
    draw_edges(canvas, view, region_.face_curves, kBlue);
    for (const auto& [a, b] : region_.face_curves)
      for (const std::size_t p : {a, b})
        if (region_.points[p].twin != SphereRegion::kNone)
          canvas.fill_disk(view.project(region_.points[p].place), 0.014 * width_, kGreen);
    io::write_canvas(path.string(), canvas, view.width, view.height);
  }

  void draw_sphere(const std::filesystem::path& path, bool triangulated) const {
    SpherePicture picture(tet_.field, width_, eye_);
    picture.paint([&](const Vec3& v) {
      const auto p = tet_.point(v);
      return !p ? kGrey : tet_.point_inside(v) ? kYellow : kWhite;
    });
    const auto line = [&](std::size_t a, std::size_t b, double width, Rgb colour) {
      picture.line(in_frame(made_.points[a].v), in_frame(made_.points[b].v), width, colour);
    };
    if (!triangulated) picture.grid();
    if (triangulated)
      for (const auto& t : made_.triangles)
        for (std::size_t k = 0; k < 3; ++k) line(t[k], t[(k + 1) % 3], 0.003, kInk);
    for (const auto& [a, b] : region_.arcs) line(a, b, 0.01, kGreen);
    for (const auto& [a, b] : region_.face_curves) line(a, b, 0.01, kBlue);
    picture.write(path);
  }

  void draw_surface(const std::filesystem::path& path) const {
    const io::Camera view = camera();
    io::Canvas canvas(view.width, view.height);
    draw_tet(canvas, view);
    std::vector<Vec3> places, tints;
    std::vector<kernel::Triangle> faces;
    for (const auto& p : made_.points) {
      places.push_back(p.place);
      tints.push_back(p.sign > 0 ? Vec3{0.2, 0.75, 0.75} : Vec3{1, 0.82, 0.2});
    }
    // Antipodes are one point of the surface.
    const auto glued = [&](std::size_t i) {
      return static_cast<kernel::Index>(std::min(i, made_.points[i].twin));
    };
    for (const auto& [a, b, c] : made_.triangles) faces.push_back({glued(a), glued(b), glued(c)});
    const io::SurfaceView surface(places, faces);
    canvas.draw_surface(view, surface, io::vertex_normals(surface), &tints);
    for (const auto& [a, b, c] : made_.triangles)
      for (const auto& [p, q] : {SphereRegion::Edge{a, b}, {b, c}, {c, a}}) {
        const Vec3 from = view.project(places[p]), to = view.project(places[q]);
        if (canvas.visible(0.5 * (from + to), 3))
          canvas.draw_stroke(from, to, 0.002 * width_, kInk);
      }
    io::write_canvas(path.string(), canvas, view.width, view.height);
  }

  const TetField& tet_;
  const modes::ModeResult& crest_;
  const SphereRegion& region_;
  const Tessellation& made_;
  int width_;
  Vec3 eye_{};  // in Tbar's frame
};

/// False where curves and arcs bound no region.
bool show(unsigned seed, const modes::Level& level, int steps, int width,
          const std::filesystem::path& folder, bool only_count) {
  const auto corners = random_corners(seed);
  const auto tensors = field_3_at(corners);
  const TetField tet{corners, modes::LinearTensors(tensors), level.value()};
  modes::ModeField field{kernel::TetMesh({corners.begin(), corners.end()}, {{0, 1, 2, 3}}),
                         {tensors.begin(), tensors.end()}};
  modes::ModeOptions options;
  options.deviation = 1e-3 * modes::diagonal(field);
  const auto crest = modes::extract(field, level, options);
  const auto region = sphere_region(tet, crest.surfaces);
  if (!region || region->loops().empty()) return false;
  const auto made = tessellate(tet, *region, steps);
  if (!made) return false;
  if (only_count) {
    fmt::print("| {} | {} | {} | {} | {} |\n", seed, crest.surfaces[0].triangles.size(),
               crest.surfaces[1].triangles.size(), region->crossings, region->loops().size());
    return true;
  }
  const Pipeline pipeline(tet, crest, *region, *made, width);
  for (const Vec3& c : corners) fmt::print("corner {} {} {}\n", c[0], c[1], c[2]);
  fmt::print("\n");
  pipeline.print();
  pipeline.draw(folder);
  return true;
}

}  // namespace
}  // namespace crest::experiments

int main(int argc, char** argv) {
  std::filesystem::path folder = ".";
  unsigned seed = 16, tries = 0;
  int p = 7, width = 320, steps = 48;
  crest::experiments::Program program(
      "Figure 7 of paper 004: from the curves of a tet's faces to its surface.");
  program.option("--pictures", folder, "folder of the pictures");
  program.option("--seed", seed, "of the tet's corners");
  program.option("--tries", tries, "list the regions of so many seeds");
  program.option("--tenths", p, "the mode in tenths", {1, 9});
  program.option("--steps", steps, "of the quad grid", {8, 200});
  program.option("--width", width, "pixels", {64, 2000});
  return program.run(argc, argv, [&] {
    using crest::experiments::show;
    const int common = std::gcd(p, 10);
    const crest::modes::Level level{p / common, 10 / common};
    if (tries > 0)
      fmt::print("| seed | triangles, + | - | passages | loops |\n|---|---|---|---|---|\n");
    for (unsigned s = 1; s <= tries; ++s) show(s, level, steps, width, folder, true);
    if (tries == 0 && !show(seed, level, steps, width, folder, false))
      throw std::runtime_error("the curves of this seed bound no region");
    return 0;
  });
}
