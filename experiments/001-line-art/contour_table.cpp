// SPDX-License-Identifier: GPL-3.0-or-later
// Exact contours: the reference counts, what a z-buffer says of the same pieces, growth.
#include <fmt/format.h>
#include <time.h>

#include <algorithm>
#include <limits>
#include <map>
#include <string>

#include "algorithms/line_art/contours.hpp"
#include "experiments/program.hpp"
#include "io/clean/triangulate.hpp"
#include "io/formats/readers.hpp"

namespace crest::experiments {
namespace {

using namespace line_art;
using kernel::operator+, kernel::operator*;

double seconds() {
  timespec t;
  clock_gettime(CLOCK_MONOTONIC, &t);
  return static_cast<double>(t.tv_sec) + 1e-9 * static_cast<double>(t.tv_nsec);
}

struct Case {
  const char* mesh;
  Vec3 eye;
  bool perspective = false;
};

constexpr Case kCases[] = {{"rocker-arm.obj", {2, 1, 3}},
                           {"rocker-arm.obj", {2, 1, 3}, true},
                           {"stanford-bunny.obj", {1, 0.5, 4}},
                           {"armadillo.off", {-1, 0.5, -3}},
                           {"torus.obj", {2, 1, 3}},
                           {"moebius.obj", {2, 1, 3}},
                           {"suzanne.obj", {2, 1, 3}},
                           {"cow.obj", {2, 1, 3}},
                           {"teapot.obj", {2, 1, 3}},
                           {"fandisk.off", {0, 0, 1}}};

/// Polygons as fans: what the reference counts were made with.
Scene read_fans(const std::string& path) {
  const io::Soup soup = io::read_soup(path, {});
  std::vector<Triangle> faces;
  for (std::size_t c = 0; c < soup.cells.size(); ++c) {
    const auto corners = io::corners_of(soup, c);
    for (std::size_t k = 2; k < corners.size(); ++k)
      faces.push_back({corners[0], corners[k - 1], corners[k]});
  }
  return weld(soup.points, faces);
}

View view_of(const Scene& scene, const Case& c) {
  ViewRequest request;
  request.towards = c.eye;
  if (c.perspective) request.eye = c.eye;
  return make_view(request, scene);
}

/// Nearness at the centres of a square raster, as a graphics card has it.
class ZBuffer {
 public:
  ZBuffer(const Scene& scene, const View& view, int size)
      : scene_(scene),
        view_(view),
        size_(size),
        scale_(size / std::max(view.page[0], view.page[1])) {
    near_.assign(static_cast<std::size_t>(size) * static_cast<std::size_t>(size),
                 -std::numeric_limits<float>::infinity());
    for (const Triangle& f : scene.faces) draw(f);
  }
  /// Of a share of the scene's depth.
  bool visible(const Vec3& p, double bias) const {
    const Vec2 at = view_.project(p);
    const int i = static_cast<int>(at[0] * scale_), j = static_cast<int>(at[1] * scale_);
    if (i < 0 || j < 0 || i >= size_ || j >= size_) return true;
    return view_.see(p).near + bias >= static_cast<double>(near_[index(i, j)]);
  }

 private:
  std::size_t index(int i, int j) const {
    return static_cast<std::size_t>(j) * static_cast<std::size_t>(size_) +
           static_cast<std::size_t>(i);
  }
  void draw(const Triangle& f) {
    double x[3], y[3], z[3];
    for (std::size_t k = 0; k < 3; ++k) {
      const Vec2 at = view_.project(scene_.points[f[k]]);
      x[k] = at[0] * scale_ - 0.5;
      y[k] = at[1] * scale_ - 0.5;
      z[k] = view_.see(scene_.points[f[k]]).near;
    }
    const double area = (x[1] - x[0]) * (y[2] - y[0]) - (x[2] - x[0]) * (y[1] - y[0]);
    if (area == 0) return;
    const auto low = [&](const double* v) {
      return std::max(0, static_cast<int>(std::ceil(std::min({v[0], v[1], v[2]}))));
    };
    const auto high = [&](const double* v) {
      return std::min(size_ - 1, static_cast<int>(std::floor(std::max({v[0], v[1], v[2]}))));
    };
    for (int j = low(y); j <= high(y); ++j)
      for (int i = low(x); i <= high(x); ++i) {
        const double b = ((i - x[0]) * (y[2] - y[0]) - (j - y[0]) * (x[2] - x[0])) / area;
        const double c = ((x[1] - x[0]) * (j - y[0]) - (y[1] - y[0]) * (i - x[0])) / area;
        if (b < 0 || c < 0 || b + c > 1) continue;
        float& near = near_[index(i, j)];
        near = std::max(near, static_cast<float>((1 - b - c) * z[0] + b * z[1] + c * z[2]));
      }
  }

  const Scene& scene_;
  const View& view_;
  int size_;
  double scale_;
  std::vector<float> near_;
};

/// Pieces whose middle the buffer judges otherwise, at the bias with the fewest.
std::size_t misjudged(const Scene& scene, const View& view, const Contours& contours, int size) {
  const ZBuffer buffer(scene, view, size);
  double nearest = -HUGE_VAL, farthest = HUGE_VAL;
  for (const Vec3& p : scene.points) {
    nearest = std::max(nearest, view.see(p).near);
    farthest = std::min(farthest, view.see(p).near);
  }
  std::size_t best = std::numeric_limits<std::size_t>::max();
  for (int k = -20; k <= -4; ++k) {
    const double bias = std::ldexp(nearest - farthest, k);
    std::size_t wrong = 0;
    for (const ContourEdge& e : contours.edges)
      for (Index i = e.first_piece; i < e.first_piece + e.pieces; ++i) {
        const Piece& p = contours.pieces[i];
        const double t = 0.5 * (p.from + p.to);
        const Vec3 middle = (1 - t) * scene.points[e.a] + t * scene.points[e.b];
        wrong += buffer.visible(middle, bias) != p.drawn();
      }
    best = std::min(best, wrong);
  }
  return best;
}

/// Each face in four.
Scene subdivided(const Scene& scene) {
  std::vector<Vec3> points = scene.points;
  std::vector<Triangle> faces;
  std::map<std::pair<Index, Index>, Index> middles;
  for (const Triangle& f : scene.faces) {
    Triangle m;
    for (std::size_t k = 0; k < 3; ++k) {
      const Index a = std::min(f[k], f[(k + 1) % 3]), b = std::max(f[k], f[(k + 1) % 3]);
      const auto [at, fresh] = middles.try_emplace({a, b}, static_cast<Index>(points.size()));
      if (fresh) points.push_back(0.5 * points[a] + 0.5 * points[b]);
      m[k] = at->second;
    }
    faces.push_back({f[0], m[0], m[2]});
    faces.push_back({m[0], f[1], m[1]});
    faces.push_back({m[2], m[1], f[2]});
    faces.push_back(m);
  }
  return weld(points, faces);
}

void print_counts(const std::string& folder) {
  fmt::print(
      "\n| mesh | eye | edges | crossings | piercings | cusps | pieces | visible | edge-on | "
      "contact "
      "| z-buffer, 1400 pixels: misjudged |\n|---|---|---|---|---|---|---|---|---|---|---|\n");
  for (const Case& c : kCases) {
    const Scene scene = read_fans(folder + "/" + c.mesh);
    const View view = view_of(scene, c);
    const Contours found = find_contours(scene, view, {std::nullopt});
    const ContourCounts& n = found.counts;
    fmt::print("| {} | {},{},{}{} | {} | {} | {} | {} | {} | {} | {} | {} | {} |\n", c.mesh,
               c.eye[0], c.eye[1], c.eye[2], c.perspective ? ", perspective" : "", n.edges,
               n.crossings, n.piercings, n.cusps, n.pieces, n.visible, n.edge_on, n.contact,
               misjudged(scene, view, found, 1400));
  }
}

void print_growth(const std::string& folder, int repeats) {
  fmt::print("\n| triangles | edges | pieces | decisions | exact | symbolic | seconds |\n");
  fmt::print("|---|---|---|---|---|---|---|\n");
  Scene scene = read_fans(folder + "/stanford-bunny.obj");
  for (int level = 0; level < 3; ++level) {
    const View view = view_of(scene, {"", {1, 0.5, 4}});
    std::vector<double> times;
    Contours found;
    for (int k = 0; k < repeats; ++k) {
      const double start = seconds();
      found = find_contours(scene, view, {std::nullopt});
      times.push_back(seconds() - start);
    }
    std::sort(times.begin(), times.end());
    const auto& d = found.decisions;
    fmt::print("| {} | {} | {} | {} | {} | {} | {:.3f} |\n", scene.faces.size(), found.counts.edges,
               found.counts.pieces, d.side.calls + d.volume.calls + d.order.calls,
               d.side.exact + d.volume.exact + d.order.exact,
               d.side.symbolic + d.volume.symbolic + d.order.symbolic, times[times.size() / 2]);
    if (level < 2) scene = subdivided(scene);
  }
}

}  // namespace
}  // namespace crest::experiments

int main(int argc, char** argv) {
  using namespace crest::experiments;
  Program program("Counts of exact contours, a z-buffer's errors, growth.");
  std::string folder = "../shared/data/meshes";
  int repeats = 0;
  program.option("--meshes", folder, "folder of the meshes");
  program.option("--growth", repeats, "times of growth, medians of so many (0: none)", {0, 100});
  return program.run(argc, argv, [&] {
    print_counts(folder);
    if (repeats > 0) print_growth(folder, repeats);
    return 0;
  });
}
