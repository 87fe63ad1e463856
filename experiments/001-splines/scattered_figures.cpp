// SPDX-License-Identifier: GPL-3.0-or-later
// Figures 9.4 and 9.5: isosurfaces of cubic splines of f_test, without and with noise, coloured by
// the spline's error at the points drawn. A cubic spline is drawn as the quadratic one of its
// values on a grid.
#include <fmt/format.h>

#include "algorithms/splines/cubic_fit.hpp"
#include "experiments/001-splines/panels.hpp"
#include "experiments/001-splines/test_functions.hpp"
#include "experiments/program.hpp"

namespace crest::experiments {
namespace {

constexpr std::size_t kSamples = 128000;

struct Choice {
  std::filesystem::path folder = ".";
  std::size_t nodes = 161;
  int width = 240;
};

/// Red is an error of `red`.
void draw(Panels& panels, const splines::CubicModel& model, const splines::QuadraticSpline& spline,
          double isovalue, double red, const Choice& choice) {
  const Pinhole camera = splines::automatic_view(spline, choice.width);
  const auto hits = hits_of(spline, isovalue, camera);
  const auto count = std::count_if(hits.begin(), hits.end(), [](const Hit& h) { return h.hit; });
  double sum = 0, largest = 0;
  const auto tints = error_tints(hits, red, [&](const Hit& hit) {
    const double s = splines::evaluate(model, hit.place).value;
    // Rounded, a point of the border may be outside.
    const double e = std::isnan(s) ? 0 : std::fabs(s - f_test(hit.place));
    sum += e;
    largest = std::max(largest, e);
    return e;
  });
  panels.add(camera, hits, tints, fmt::format("{}", isovalue));
  fmt::print("| {} | {} | {:.2e} | {:.2e} | {} |\n", isovalue, count,
             sum / static_cast<double>(count), largest, red);
}

int work(const Choice& choice) {
  const Samples s = samples_of(f_test, kSamples, 1);
  const splines::CubicOptions options{
      splines::Smoothness::c1, {{29, 29, 29}}, {{Vec3{0, 0, 0}, Vec3{1, 1, 1}}}};
  fmt::print("{} samples, 29^3 cubes, exactly C1; drawn from {}^3 values\n\n", kSamples,
             choice.nodes);
  fmt::print(
      "| isovalue | rays that hit | mean error there | max | red |\n|---|---|---|---|---|\n");
  const auto model = splines::fit_cubic(s.points, s.values, options).model;
  const std::array<std::size_t, 3> nodes = {choice.nodes, choice.nodes, choice.nodes};
  const auto exact = on_grid(model, nodes);
  Panels plain(6, choice.width), noise(3, choice.width);
  for (const double isovalue : {-0.1, 0.0, 0.1, 0.3, 0.5, 0.8})
    draw(plain, model, exact, isovalue, 2e-5, choice);
  plain.write(choice.folder / "figure-9.4.png");
  for (const double percent : {0.5, 1.0, 2.5}) {
    Uniform uniform(2);
    std::vector<double> noisy = s.values;
    for (double& x : noisy) x += (2 * uniform() - 1) * percent / 100 * 1.52;
    const auto rough = splines::fit_cubic(s.points, noisy, options).model;
    draw(noise, rough, on_grid(rough, nodes), 0.3, 0.02, choice);
  }
  noise.write(choice.folder / "figure-9.5.png");
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
