// SPDX-License-Identifier: GPL-3.0-or-later
// Figures 8.10 to 8.13 on stand-ins: isosurfaces of volumes, trilinear by steps along the rays
// (left), quadratic super splines by exact rays (middle, and a part of it right); their times and
// the share of cubes that the level may meet.
#include <fmt/format.h>

#include <cstdlib>

#include "algorithms/splines/comparison.hpp"
#include "experiments/001-splines/panels.hpp"
#include "experiments/processor_time.hpp"
#include "experiments/program.hpp"
#include "io/read/volume_reader.hpp"

namespace crest::experiments {
namespace {

using kernel::operator*;
using kernel::operator+;
using kernel::operator-;
using splines::QuadraticSpline;
using splines::ValueAndGradient;

struct StandIn {
  const char* figure;
  const char* file;
  double isovalue;
  const char* for_what;  ///< the thesis' volume, its time and share of cubes
};
constexpr StandIn kStandIns[] = {
    {"8.10", "stent_ct.nrrd.xz", 1200, "aneurism, 11.7 s, 0.66 %"},
    {"8.11", "iguana_ct.nii.gz", 60.37, "bonsai, 9.1 s, 3.1 %"},
    {"8.12", "mri_head_256.nrrd.xz", 60.5, "MRI of a head, 1.97 s, 14.99 %"},
    {"8.13-a", "bolt.nrrd", 60.5, "engine, 2.5 s, 9.7 %"},
    {"8.13-b", "male_head.nrrd.xz", 80.5, "skull, 4.3 s, 5.2 %"},
    {"8.13-c", "nut.nrrd", 40.5, "lobster, 4.2 s"}};

/// Unpacks .xz beside the pictures. Empty if that cannot be done.
std::string unpacked(const std::filesystem::path& path, const std::filesystem::path& folder) {
  if (path.extension() != ".xz") return path.string();
  const auto to = folder / path.stem();
  const std::string command = fmt::format("xz -dc '{}' > '{}'", path.string(), to.string());
  return std::system(command.c_str()) == 0 ? to.string() : std::string();
}

Field trilinear_field(const QuadraticSpline& spline) {
  return [&spline](const Vec3& p) {
    const Vec3 x = spline.frame().to_lattice(p);
    Vec3 v;
    for (std::size_t k = 0; k < 3; ++k) {
      if (!(x[k] >= 0 && x[k] <= 2 * spline.cubes()[k]))
        return ValueAndGradient{NAN, {NAN, NAN, NAN}};
      v[k] = 0.5 * (x[k] - 1) + spline.frame().first();
    }
    const ValueAndGradient s = splines::trilinear_differences(spline.grid(), v);
    return ValueAndGradient{s.value, spline.frame().gradient_to_world(0.5 * s.gradient)};
  };
}

struct Work {
  std::filesystem::path volumes = "../shared/data/volumes", folder = ".";
  int size = 240;

  void draw(const StandIn& one) const {
    const std::string path = unpacked(volumes / one.file, folder);
    if (path.empty()) {
      fmt::print("| {} | {} | cannot be unpacked: skipped |\n", one.figure, one.file);
      return;
    }
    const QuadraticSpline spline(io::read_volume(path).grid);
    if (path != (volumes / one.file).string()) std::filesystem::remove(path);
    const double start = processor_seconds();
    const splines::RayCaster caster(spline, one.isovalue);
    Pinhole camera = splines::automatic_view(spline, size);
    camera.angle *= 0.85;
    const auto rays = camera.rays();
    std::vector<Hit> hits(rays.size());
    const auto counts = caster.cast(rays, hits);
    const double seconds = processor_seconds() - start;
    Panels panels(3, size);
    panels.add(camera, trilinear_hits(spline, camera, one.isovalue), {}, "trilinear");
    panels.add(camera, hits, {}, "quadratic super spline");
    camera.angle /= 4;
    caster.cast(camera.rays(), hits);
    panels.add(camera, hits, {}, "a part");
    panels.write(folder / fmt::format("figure-{}.png", one.figure));
    const auto cubes = static_cast<double>(spline.cube_count());
    const auto& n = spline.grid().size;
    fmt::print("| {} | {}, {} x {} x {} | {} | {:.2f} s | {:.2f} % | {:.1f} % | {} | {} |\n",
               one.figure, one.file, n[0], n[1], n[2], one.isovalue, seconds,
               100 * static_cast<double>(caster.active().count()) / cubes,
               100 * static_cast<double>(counts.hits) / static_cast<double>(rays.size()),
               counts.climbed, one.for_what);
  }
  std::vector<Hit> trilinear_hits(const QuadraticSpline& spline, const Pinhole& camera,
                                  double isovalue) const {
    const double distance = kernel::distance(camera.eye, camera.target);
    double spacing = HUGE_VAL;
    for (const Vec3& step : spline.frame().steps()) spacing = std::min(spacing, kernel::norm(step));
    return hits_by_steps(camera, trilinear_field(spline), isovalue, 0, 2 * distance, spacing / 2);
  }
};

}  // namespace
}  // namespace crest::experiments

int main(int argc, char** argv) {
  using namespace crest::experiments;
  Work work;
  Program program("Figures 8.10 to 8.13 on stand-ins");
  program.option("--volumes", work.volumes, "their folder (../shared/data/volumes)");
  program.option("--pictures", work.folder, "where pictures go (.)");
  program.option("--size", work.size, "of a panel, in pixels (240)");
  return program.run(argc, argv, [&] {
    fmt::print(
        "| figure | volume | isovalue | processor time of hull and rays | cubes it may meet | rays "
        "that hit | by rationals | stands for |\n|---|---|---|---|---|---|---|---|\n");
    for (const StandIn& one : kStandIns) work.draw(one);
    return 0;
  });
}
