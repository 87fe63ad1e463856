// SPDX-License-Identifier: GPL-3.0-or-later
// Figure 9.1: a domain of cubes. Figures 9.6 to 9.9: cubic splines of signed distances to meshes at
// random points, exactly C1. A cubic spline is drawn as the quadratic one of its values on a grid.
// Distances are VTK's.
#include <fmt/format.h>
#include <vtkCellArray.h>
#include <vtkImplicitPolyDataDistance.h>
#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>

#include "algorithms/splines/cubic_fit.hpp"
#include "algorithms/splines/local_fit.hpp"
#include "experiments/001-splines/panels.hpp"
#include "experiments/001-splines/test_functions.hpp"
#include "experiments/processor_time.hpp"
#include "experiments/program.hpp"
#include "io/read/mesh_reader.hpp"

namespace crest::experiments {
namespace {

using kernel::operator*;
using kernel::operator+;
using kernel::operator-;
using splines::CubicModel;
using splines::QuadraticSpline;

/// A closed mesh in its box, the longest side scaled to 200, z upwards.
class Shape {
 public:
  explicit Shape(const std::filesystem::path& path, bool y_is_up) {
    const auto mesh = io::read_mesh(path.string()).mesh;
    std::vector<Vec3> corners = mesh.points();
    for (Vec3& p : corners)
      if (y_is_up) p = {p[0], -p[2], p[1]};
    low_ = high_ = corners[0];
    for (const Vec3& p : corners)
      for (std::size_t k = 0; k < 3; ++k) {
        low_[k] = std::min(low_[k], p[k]);
        high_[k] = std::max(high_[k], p[k]);
      }
    const auto side = sides();
    const double scale = 200 / *std::max_element(side.begin(), side.end());
    const Vec3 middle = 0.5 * (low_ + high_);
    vtkNew<vtkPoints> points;
    points->SetDataTypeToDouble();
    for (const Vec3& p : corners) points->InsertNextPoint((scale * (p - middle)).data());
    vtkNew<vtkCellArray> triangles;
    for (const auto& t : mesh.faces()) triangles->InsertNextCell({t[0], t[1], t[2]});
    vtkNew<vtkPolyData> data;
    data->SetPoints(points);
    data->SetPolys(triangles);
    distance_->SetInput(data);
    // A tenth more on each side.
    const Vec3 half = 0.6 * scale * (high_ - low_);
    low_ = -1 * half;
    high_ = half;
  }

  const Vec3& low() const { return low_; }
  const Vec3& high() const { return high_; }
  std::array<double, 3> sides() const {
    return {high_[0] - low_[0], high_[1] - low_[1], high_[2] - low_[2]};
  }
  /// Negative inside.
  double distance(const Vec3& p) const { return distance_->FunctionValue(p.data()); }

  Samples samples(std::size_t count) const {
    Uniform uniform(1);
    Samples s;
    for (std::size_t i = 0; i < count; ++i) {
      const Vec3 x = uniform.point();
      s.points.push_back({low_[0] + x[0] * (high_[0] - low_[0]),
                          low_[1] + x[1] * (high_[1] - low_[1]),
                          low_[2] + x[2] * (high_[2] - low_[2])});
      s.values.push_back(distance(s.points.back()));
    }
    return s;
  }
  /// So many cubes along the longest side, of as equal sides as possible.
  splines::CubicOptions options(double longest) const {
    splines::CubicOptions o;
    const auto side = sides();
    const double h = *std::max_element(side.begin(), side.end()) / longest;
    o.cubes.emplace();
    for (std::size_t k = 0; k < 3; ++k)
      (*o.cubes)[k] = static_cast<kernel::Index>(std::max(1.0, std::round(side[k] / h)));
    o.box = {low_, high_};
    return o;
  }

 private:
  Vec3 low_{}, high_{};
  vtkNew<vtkImplicitPolyDataDistance> distance_;
};

/// To be drawn from values about `spacing` apart.
QuadraticSpline drawable(const CubicModel& model, double spacing) {
  std::array<std::size_t, 3> size;
  for (std::size_t k = 0; k < 3; ++k)
    size[k] = static_cast<std::size_t>((model.domain.high[k] - model.domain.low[k]) / spacing) + 1;
  return on_grid(model, size);
}

Pinhole view_of(const Shape& shape, const Vec3& from, int size, double zoom) {
  Pinhole camera;
  camera.width = camera.height = size;
  const auto side = shape.sides();
  camera.eye = (2.2 * std::hypot(side[0], side[1], side[2]) / kernel::norm(from)) * from;
  camera.angle = 24 / zoom;
  return camera;
}

/// The cubes, `longest` along the longest side, whose centre is inside a shape or less than half a
/// diagonal off it.
class CubeDomain {
 public:
  CubeDomain(const Shape& shape, double longest) {
    box_.low = shape.low();
    box_.high = shape.high();
    box_.cubes = *shape.options(longest).cubes;
    const Vec3 density = box_.density();
    const Vec3 h = {1 / density[0], 1 / density[1], 1 / density[2]};
    splines::for_each_place(box_.cubes, [&](const splines::Place& q) {
      Vec3 centre = box_.low;
      for (std::size_t k = 0; k < 3; ++k) centre[k] += (q[k] + 0.5) * h[k];
      inside_.push_back(shape.distance(centre) < 0.5 * kernel::norm(h));
    });
  }
  /// Black cubes dark.
  void draw(Panels& panels, const Pinhole& camera) const {
    const auto rays = camera.rays();
    std::vector<Hit> hits(rays.size());
    std::vector<Vec3> tints(rays.size(), Vec3{1, 1, 1});
    for (std::size_t i = 0; i < rays.size(); ++i)
      if (trace(rays[i], hits[i])) tints[i] = {0.25, 0.25, 0.25};
    panels.add(camera, hits, tints,
               fmt::format("{} of {} cubes", std::count(inside_.begin(), inside_.end(), true),
                           inside_.size()));
  }

 private:
  /// From cube to cube up to the first of the domain; whether that is black.
  bool trace(const splines::Ray& ray, Hit& hit) const {
    const Vec3 density = box_.density();
    Vec3 o, d;
    double from = 0, to = HUGE_VAL;
    std::size_t axis = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      o[k] = (ray.origin[k] - box_.low[k]) * density[k];
      d[k] = ray.direction[k] * density[k];
      const double a = -o[k] / d[k], b = (box_.cubes[k] - o[k]) / d[k];
      if (std::min(a, b) > from) axis = k;
      from = std::max(from, std::min(a, b));
      to = std::min(to, std::max(a, b));
    }
    splines::Place q;
    for (std::size_t k = 0; k < 3; ++k)
      q[k] = std::clamp(static_cast<int>(std::floor(o[k] + from * d[k])), 0,
                        static_cast<int>(box_.cubes[k]) - 1);
    for (double t = from; t < to && box_.has_cube(q);) {
      if (inside_[box_.cube(q)]) {
        hit.hit = true;
        hit.place = ray.origin + t * ray.direction;
        hit.gradient[axis] = d[axis] > 0 ? -1 : 1;
        return splines::is_black(q);
      }
      t = HUGE_VAL;
      for (std::size_t k = 0; k < 3; ++k) {
        const double next = (q[k] + (d[k] > 0 ? 1 : 0) - o[k]) / d[k];
        if (next < t) axis = k;
        t = std::min(t, next);
      }
      q[axis] += d[axis] > 0 ? 1 : -1;
    }
    return false;
  }

  splines::Domain box_;
  std::vector<bool> inside_;
};

struct Work {
  std::filesystem::path meshes = "../shared/data/meshes", folder = ".";
  int size = 320;
  std::size_t head_samples = 2000000, part_samples = 512000;

  CubicModel fit(const char* what, const Shape& shape, const Samples& s, double longest) const {
    const double start = processor_seconds();
    const auto result = splines::fit_cubic(s.points, s.values, shape.options(longest));
    const double seconds = processor_seconds() - start;
    const auto error = splines::error_at_samples(result.model, s.points, s.values);
    const auto& n = result.model.domain.cubes;
    fmt::print("| {} | {} | {} x {} x {} | {:.1f} s | {:.3f} | {:.2f} |\n", what, s.points.size(),
               n[0], n[1], n[2], seconds, error.mean, error.max);
    return result.model;
  }
  void add(Panels& panels, const QuadraticSpline& spline, const Pinhole& camera, double level,
           const std::string& words) const {
    panels.add(camera, hits_of(spline, level, camera), {}, words);
  }

  void head() const {
    const Shape shape(meshes / "max-planck_decimated.obj", true);
    Panels cubes(2, size);
    for (const double longest : {12.0, 24.0})
      CubeDomain(shape, longest).draw(cubes, view_of(shape, {0.5, -0.8, 0.2}, size, 1));
    cubes.write(folder / "figure-9.1.png");
    const CubicModel model = fit("head", shape, shape.samples(head_samples), 97);
    const QuadraticSpline spline = drawable(model, 1);
    Panels zero(3, size), offsets(3, size);
    add(zero, spline, view_of(shape, {0.5, -0.8, 0.2}, size, 1), 0, "zero set");
    add(zero, spline, view_of(shape, {-0.9, -0.4, 0.3}, size, 1), 0, "zero set");
    slice(zero, model);
    zero.write(folder / "figure-9.6.png");
    for (const double offset : {2.0, -2.0, -4.0})
      add(offsets, spline, view_of(shape, {0.5, -0.8, 0.2}, size, 2.5), offset,
          fmt::format("offset {}", offset));
    offsets.write(folder / "figure-9.7.png");
  }
  /// Distances in the plane x = 0, blue inside and red outside.
  void slice(Panels& panels, const CubicModel& model) const {
    const Vec3 &low = model.domain.low, &high = model.domain.high;
    const double scale = std::max(high[1] - low[1], high[2] - low[2]) / size;
    for (int y = 0; y < size; ++y)
      for (int x = 0; x < size; ++x) {
        const Vec3 p = {0, scale * (x + 0.5 - 0.5 * size), scale * (0.5 * size - y - 0.5)};
        const double d = splines::evaluate(model, p).value;
        if (std::isnan(d)) continue;
        const Vec3 c = 255 * error_colour(0.5 + d / 120);
        const bool line = std::fabs(d - 10 * std::round(d / 10)) < 0.4 * scale;
        const auto channel = [&](double v) { return static_cast<std::uint8_t>(line ? 0 : v); };
        panels.pixel(x, y, {channel(c[0]), channel(c[1]), channel(c[2])});
      }
    panels.note("distances, a line every 10");
  }

  void part() const {
    const Shape shape(meshes / "fandisk.off", false);
    const Samples s = shape.samples(part_samples);
    const Pinhole camera = view_of(shape, {0.5, -0.8, 0.6}, size, 1);
    Panels panels(3, size);
    panels.add(camera, traced(shape, camera), {}, "the mesh");
    const CubicModel fine = fit("part", shape, s, 64), coarse = fit("part", shape, s, 42);
    add(panels, drawable(fine, 1), camera, 0, "64 cubes along it");
    add(panels, drawable(coarse, 1), camera, 0, "42 cubes along it");
    panels.write(folder / "figure-9.8.png");
    local(shape, s, fine);
  }
  /// The mesh itself: steps of the distance along each ray.
  std::vector<Hit> traced(const Shape& shape, const Pinhole& camera) const {
    const auto rays = camera.rays();
    std::vector<Hit> hits(rays.size());
    const double far = 2 * kernel::norm(camera.eye);
    for (std::size_t i = 0; i < rays.size(); ++i)
      for (double t = 0.5 * kernel::norm(camera.eye); t < far;) {
        const Vec3 p = rays[i].origin + t * rays[i].direction;
        const double d = shape.distance(p);
        if (d > 0.02) {
          t += 0.9 * d;
          continue;
        }
        hits[i].hit = true;
        hits[i].place = p;
        for (std::size_t k = 0; k < 3; ++k) {
          Vec3 ahead = p, behind = p;
          ahead[k] += 0.1;
          behind[k] -= 0.1;
          hits[i].gradient[k] = shape.distance(ahead) - shape.distance(behind);
        }
        break;
      }
    return hits;
  }
  /// Figure 9.9: one local fit (red) beside the spline (blue), and the samples of the fit.
  void local(const Shape& shape, const Samples& s, const CubicModel& model) const;
};

/// The black cube nearest to where a line through the middle leaves the shape.
splines::Place black_cube(const Shape& shape, const CubicModel& model) {
  Vec3 p{};
  while (shape.distance(p) < 0) p = p + Vec3{0.3, -0.5, 0.3};
  const Vec3 x = model.domain.cube_coordinates(p);
  splines::Place cube = {static_cast<int>(x[0]), static_cast<int>(x[1]), static_cast<int>(x[2])};
  if (!splines::is_black(cube)) ++cube[0];
  return cube;
}

void Work::local(const Shape& shape, const Samples& s, const CubicModel& model) const {
  const splines::Domain& domain = model.domain;
  const splines::Scattered sorted(domain, s.points, s.values);
  const splines::Place cube = black_cube(shape, model);
  const Vec3 centre = {cube[0] + 0.5, cube[1] + 0.5, cube[2] + 0.5};
  const splines::Scattered::Request request;
  const auto fit = splines::LocalFit(sorted, request)(centre);
  std::vector<splines::Scattered::Near> near;
  sorted.gather(centre, request, near);
  const double h = (domain.high[0] - domain.low[0]) / domain.cubes[0];
  const Vec3 middle = domain.low + h * centre;
  const auto within = [&](const Vec3& p) { return kernel::distance(p, middle) < 2.2 * h; };
  Pinhole camera = view_of(shape, {0.5, -0.8, 0.6}, size, 1);
  camera.target = middle;
  camera.eye = camera.eye + middle;
  const double reach = kernel::distance(camera.eye, middle);
  camera.angle = 360 / std::numbers::pi * std::atan(2.6 * h / reach);
  const auto drawn = [&](const auto& at) {
    return hits_by_steps(
        camera,
        [&](const Vec3& p) {
          return within(p) ? at(p) : splines::ValueAndGradient{NAN, {NAN, NAN, NAN}};
        },
        0, reach - 3 * h, reach + 3 * h, h / 40);
  };
  const auto red = drawn([&](const Vec3& p) {
    const Vec3 x = domain.cube_coordinates(p);
    return splines::ValueAndGradient{fit.value(x), fit.gradient(x)};
  });
  const auto blue = drawn([&](const Vec3& p) { return splines::evaluate(model, p); });
  // Both at once as by a screen: every other pixel.
  std::vector<Hit> both = blue;
  std::vector<Vec3> tints(both.size(), Vec3{0.5, 0.6, 1});
  for (std::size_t i = 0; i < both.size(); ++i) {
    const auto row = i / static_cast<std::size_t>(size);
    if (!red[i].hit || (both[i].hit && (i + row) % 2 == 0)) continue;
    both[i] = red[i];
    tints[i] = {1, 0.5, 0.5};
  }
  const std::vector<Vec3> only_red(both.size(), Vec3{1, 0.5, 0.5}),
      only_blue(both.size(), Vec3{0.5, 0.6, 1});
  Panels panels(3, size);
  const auto axes = camera.axes();
  for (const auto& n : near) {
    const Vec3 p = domain.low + h * sorted[n.sample].x - camera.eye;
    const double scale =
        size / (2 * std::tan(camera.angle * std::numbers::pi / 360)) / kernel::dot(p, axes.forward);
    panels.dot(size / 2 + scale * kernel::dot(p, axes.right),
               size / 2 - scale * kernel::dot(p, axes.up), 2.5, {200, 60, 60});
  }
  panels.add(camera, red, only_red, fmt::format("one fit, {} samples", near.size()));
  panels.add(camera, both, tints, "both");
  panels.add(camera, blue, only_blue, "the spline");
  panels.write(folder / "figure-9.9.png");
}

}  // namespace
}  // namespace crest::experiments

int main(int argc, char** argv) {
  using namespace crest::experiments;
  Work work;
  Program program("Figures 9.1 and 9.6 to 9.9");
  program.option("--meshes", work.meshes, "their folder (../shared/data/meshes)");
  program.option("--pictures", work.folder, "where pictures go (.)");
  program.option("--size", work.size, "of a panel, in pixels (320)");
  program.option("--head-samples", work.head_samples, "of the head (2000000)");
  program.option("--part-samples", work.part_samples, "of the part (512000)");
  return program.run(argc, argv, [&] {
    fmt::print(
        "| mesh | samples | cubes | processor time of the fit | mean error at the samples | max "
        "|\n|---|---|---|---|---|---|\n");
    work.head();
    work.part();
    return 0;
  });
}
