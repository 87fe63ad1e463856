// SPDX-License-Identifier: GPL-3.0-or-later
// Figures 8.1, 8.4 and 8.6 to 8.9 as pictures: isosurfaces of Marschner and Lobb's function and of
// a sphere in quadratic super splines and in the models of section 8.6.3, coloured by the error of
// the value or the angle of the gradient. The splines' surfaces by exact rays, the others' by
// steps.
#include <fmt/format.h>

#include <array>
#include <numbers>

#include "algorithms/splines/comparison.hpp"
#include "experiments/001-splines/panels.hpp"
#include "experiments/001-splines/test_functions.hpp"
#include "experiments/program.hpp"

namespace crest::experiments {
namespace {

using kernel::operator*;
using kernel::operator+;
using kernel::operator-;
using splines::QuadraticSpline;
using splines::ValueAndGradient;

double radius_of(const Vec3& p) {
  return kernel::norm(p);
}

using Model = ValueAndGradient (*)(const kernel::SampledGrid&, const Vec3&);

/// A model of section 8.6.3 in the world, on the cubes that the splines have.
Field field_of(const QuadraticSpline& spline, Model model) {
  return [&spline, model](const Vec3& p) {
    const kernel::SampledGrid& grid = spline.grid();
    const double h = grid.spacing[0];
    const Vec3 v = (1 / h) * (p - grid.origin);
    for (std::size_t k = 0; k < 3; ++k)
      if (!(v[k] >= 0.5 && v[k] <= static_cast<double>(grid.size[k]) - 1.5))
        return ValueAndGradient{NAN, {NAN, NAN, NAN}};
    ValueAndGradient s = model(grid, v);
    s.gradient = (1 / h) * s.gradient;
    return s;
  };
}

struct Scene {
  Function f;
  double level, half;
};
constexpr Scene kLobb{marschner_lobb, 0.5, 1};
constexpr Scene kSphere{radius_of, 0.4, 0.5};

/// What a panel shows of `model`, or of the spline itself if there is none.
std::vector<Hit> hits_of(const QuadraticSpline& spline, const Scene& scene, const Pinhole& camera,
                         Model model) {
  if (model == nullptr) return experiments::hits_of(spline, scene.level, camera);
  const double distance = kernel::distance(camera.eye, Vec3{}), reach = 2 * scene.half;
  return hits_by_steps(camera, field_of(spline, model), scene.level,
                       std::max(0.0, distance - reach), distance + reach,
                       spline.grid().spacing[0] / 8);
}

double angle(const Vec3& a, const Vec3& b) {
  return std::atan2(kernel::norm(kernel::cross(a, b)), kernel::dot(a, b)) * 180 / std::numbers::pi;
}

Pinhole view_of(const QuadraticSpline& spline, int size, double zoom) {
  Pinhole camera = splines::automatic_view(spline, size);
  camera.angle /= zoom;
  return camera;
}

struct Named {
  const char* name;
  Model model;
};
constexpr Named kOurs{"quadratic super spline", nullptr},
    kTrilinear{"trilinear", splines::trilinear},
    kLinear{"linear on the partition", splines::linear_on_partition},
    kFreudenthal{"Freudenthal quadratic", splines::freudenthal_quadratic},
    kTriquadratic{"triquadratic", splines::triquadratic};

struct Work {
  std::filesystem::path folder = ".";
  int size = 240;

  /// Values of Marschner and Lobb's function on a model's surface, less the level.
  void value_panel(Panels& panels, int n, const Named& model, double red, double zoom) const {
    const QuadraticSpline spline(volume_of(kLobb.f, n, kLobb.half));
    const Pinhole camera = view_of(spline, size, zoom);
    const auto hits = hits_of(spline, kLobb, camera, model.model);
    double largest = 0;
    const auto tints = error_tints(hits, red, [&](const Hit& hit) {
      const double e = std::fabs(kLobb.f(hit.place) - kLobb.level);
      largest = std::max(largest, e);
      return e;
    });
    panels.add(camera, hits, tints, fmt::format("{}, {}^3: {:.4f}", model.name, n, largest));
    fmt::print("| {} | {}^3 | {} | at most {:.4f} | {} |\n", model.name, n,
               zoom > 1 ? "part" : "all", largest, red);
  }
  void gradient_panel(Panels& panels, int n, const Named& model) const {
    const QuadraticSpline spline(volume_of(kSphere.f, n, kSphere.half));
    const Pinhole camera = view_of(spline, size, 1.6);
    const auto hits = hits_of(spline, kSphere, camera, model.model);
    double sum = 0, largest = 0, count = 0;
    const auto tints = error_tints(hits, 1, [&](const Hit& hit) {
      const double a = angle(hit.gradient, hit.place);
      sum += a;
      largest = std::max(largest, a);
      ++count;
      return a;
    });
    panels.add(camera, hits, tints, fmt::format("{}, {}^3", model.name, n));
    fmt::print("| {} | {}^3 | all | {:.2f} degrees, at most {:.2f} | 1 degree |\n", model.name, n,
               sum / count, largest);
  }

  void figure_8_1() const {
    for (const double zoom : {1.0, 5.0}) {
      Panels panels(3, size);
      value_panel(panels, 41, kTrilinear, 0.075, zoom);
      value_panel(panels, 164, kOurs, 0.075, zoom);
      value_panel(panels, 41, kOurs, 0.075, zoom);
      panels.write(folder / (zoom == 1 ? "figure-8.1.png" : "figure-8.4.png"));
    }
  }
  void figure_8_6() const {
    for (const int n : {8, 16}) {
      Panels panels(4, size);
      for (const Named& model : {kFreudenthal, kTrilinear, kTriquadratic, kOurs})
        gradient_panel(panels, n, model);
      panels.write(folder / fmt::format("figure-8.6-{}.png", n));
    }
  }
  void figure_8_7() const {
    Panels panels(4, size);
    for (const int n : {33, 65, 129, 257}) value_panel(panels, n, kOurs, 0.03, 1);
    panels.write(folder / "figure-8.7.png");
  }
  void figure_8_8() const {
    for (const double zoom : {1.0, 5.0}) {
      Panels panels(3, size);
      for (const Named& model : {kLinear, kFreudenthal, kTriquadratic})
        value_panel(panels, 41, model, 0.075, zoom);
      panels.write(folder / (zoom == 1 ? "figure-8.8.png" : "figure-8.8-part.png"));
    }
  }
  void figure_8_9() const {
    Panels panels(4, size);
    for (const Named& model : {kLinear, kFreudenthal, kTriquadratic, kOurs})
      value_panel(panels, 164, model, 0.075, 1);
    panels.write(folder / "figure-8.9.png");
  }
};

}  // namespace
}  // namespace crest::experiments

int main(int argc, char** argv) {
  using namespace crest::experiments;
  Work work;
  Program program("Figures 8.1, 8.4 and 8.6 to 8.9");
  program.option("--pictures", work.folder, "where they go (.)");
  program.option("--size", work.size, "of a panel, in pixels (240)");
  return program.run(argc, argv, [&] {
    fmt::print("| model | samples | surface | error | red |\n|---|---|---|---|---|\n");
    work.figure_8_1();
    work.figure_8_6();
    work.figure_8_7();
    work.figure_8_8();
    work.figure_8_9();
    return 0;
  });
}
