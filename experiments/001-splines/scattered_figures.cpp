// SPDX-License-Identifier: GPL-3.0-or-later
// Figures 9.4 and 9.5: isosurfaces of cubic splines of f_test, without and with noise. A cubic
// spline is drawn as the quadratic one of its values on a grid.
#include <fmt/format.h>

#include <filesystem>

#include "algorithms/splines/cubic_evaluate.hpp"
#include "algorithms/splines/cubic_fit.hpp"
#include "algorithms/splines/pinhole.hpp"
#include "algorithms/splines/rays.hpp"
#include "experiments/001-splines/test_functions.hpp"
#include "experiments/program.hpp"
#include "io/splines/ray_picture.hpp"

namespace crest::experiments {
namespace {

constexpr std::size_t kSamples = 128000;

struct Choice {
  std::filesystem::path folder = ".";
  std::size_t nodes = 161;
  int width = 240;
};

splines::QuadraticSpline on_grid(const splines::CubicModel& model, std::size_t nodes) {
  kernel::SampledGrid grid;
  const double h = 1 / static_cast<double>(nodes - 1);
  grid.size = {nodes, nodes, nodes};
  grid.spacing = {h, h, h};
  std::vector<Vec3> points;
  for (std::size_t k = 0; k < nodes; ++k)
    for (std::size_t j = 0; j < nodes; ++j)
      for (std::size_t i = 0; i < nodes; ++i)
        points.push_back(
            {static_cast<double>(i) * h, static_cast<double>(j) * h, static_cast<double>(k) * h});
  std::vector<double> values;
  for (const auto& at : splines::evaluate(model, points)) values.push_back(at.value);
  grid.samples = std::move(values);
  return splines::QuadraticSpline(std::move(grid));
}

void draw(const splines::QuadraticSpline& spline, double isovalue, const std::string& name,
          const Choice& choice) {
  const splines::Pinhole camera = splines::automatic_view(spline, choice.width);
  const auto rays = camera.rays();
  std::vector<splines::Hit> hits(rays.size());
  const auto counts = splines::RayCaster(spline, isovalue).cast(rays, hits);
  io::write_ray_picture(choice.folder / name, camera, hits);
  fmt::print("| {} | {} | {} |\n", name, isovalue, counts.hits);
}

int work(const Choice& choice) {
  const Samples s = samples_of(f_test, kSamples, 1);
  const splines::CubicOptions options{
      splines::Smoothness::c1, {{29, 29, 29}}, {{Vec3{0, 0, 0}, Vec3{1, 1, 1}}}};
  fmt::print("{} samples, 29^3 cubes, exactly C1; drawn from {}^3 values\n\n", kSamples,
             choice.nodes);
  fmt::print("| picture | isovalue | rays that hit |\n|---|---|---|\n");
  const auto exact = on_grid(splines::fit_cubic(s.points, s.values, options).model, choice.nodes);
  char letter = 'a';
  for (const double isovalue : {-0.1, 0.0, 0.1, 0.3, 0.5, 0.8})
    draw(exact, isovalue, fmt::format("figure-9.4-{}.png", letter++), choice);
  letter = 'a';
  for (const double percent : {0.5, 1.0, 2.5}) {
    Uniform uniform(2);
    std::vector<double> noisy = s.values;
    for (double& x : noisy) x += (2 * uniform() - 1) * percent / 100 * 1.52;
    draw(on_grid(splines::fit_cubic(s.points, noisy, options).model, choice.nodes), 0.3,
         fmt::format("figure-9.5-{}.png", letter++), choice);
  }
  return 0;
}

}  // namespace
}  // namespace crest::experiments

int main(int argc, char** argv) {
  using namespace crest::experiments;
  Choice choice;
  Program program("Figures 9.4 and 9.5");
  program.option("--pictures", choice.folder, "where they go (.)");
  program.option("--nodes", choice.nodes,
                 "values along an axis that a picture is drawn from (161)");
  program.option("--width", choice.width, "of a picture, in pixels (240)");
  return program.run(argc, argv, [&] { return work(choice); });
}
