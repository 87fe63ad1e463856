// SPDX-License-Identifier: GPL-3.0-or-later
// Processor times of section 8.7 on one thread: coefficients and hull a cube, microseconds a ray,
// the share of cubes a level may meet and of rays that rationals decide; on Marschner and Lobb's
// function or, as stand-ins for figures 8.10 to 8.13, on volumes from files.
#include <fmt/format.h>
#include <tbb/global_control.h>

#include <algorithm>

#include "algorithms/splines/isosurface.hpp"
#include "algorithms/splines/pinhole.hpp"
#include "experiments/001-splines/test_functions.hpp"
#include "experiments/processor_time.hpp"
#include "experiments/program.hpp"
#include "io/read/volume_reader.hpp"

namespace crest::experiments {
namespace {

/// Median processor seconds.
template <class Work>
double timed(int repeat, const Work& work) {
  std::vector<double> seconds;
  for (int i = 0; i < repeat; ++i) {
    const double start = processor_seconds();
    work();
    seconds.push_back(processor_seconds() - start);
  }
  std::sort(seconds.begin(), seconds.end());
  return seconds[seconds.size() / 2];
}

struct Arguments {
  int nodes = 256, size = 512, repeat = 3;
  double isovalue = 0.5;
  std::string volume;
  bool mesh = false;
};

void measure(const Arguments& a) {
  const splines::QuadraticSpline spline(a.volume.empty() ? volume_of(marschner_lobb, a.nodes)
                                                         : io::read_volume(a.volume).grid);
  const auto cubes = static_cast<double>(spline.cube_count());
  std::optional<splines::RayCaster> caster;
  const double prepared = timed(a.repeat, [&] { caster.emplace(spline, a.isovalue); });
  const auto rays = splines::automatic_view(spline, a.size).rays();
  std::vector<splines::Hit> hits(rays.size());
  splines::RayCounts counts;
  const double cast = timed(a.repeat, [&] { counts = caster->cast(rays, hits); });
  const auto all = static_cast<double>(rays.size());
  fmt::print(
      "{:.2f} ns a cube for coefficients and hull, {:.3f} % of {} cubes may meet the level\n",
      1e9 * prepared / cubes, 100 * static_cast<double>(caster->active().count()) / cubes,
      spline.cube_count());
  fmt::print(
      "{:.3f} us a ray, {} rays, {:.1f} % hit, {:.2f} cubes and {:.2f} tetrahedra a ray, {} "
      "climbed\n",
      1e6 * cast / all, rays.size(), 100 * static_cast<double>(counts.hits) / all,
      static_cast<double>(counts.cubes) / all, static_cast<double>(counts.tetrahedra) / all,
      counts.climbed);
  if (!a.mesh) return;
  splines::Isosurface surface;
  const double meshed =
      timed(a.repeat, [&] { surface = splines::extract_isosurface(spline, a.isovalue, 30); });
  fmt::print("{:.2f} us a triangle, {} triangles, {} tetrahedra bisected, {} undecided\n",
             1e6 * meshed / static_cast<double>(surface.triangles.size()), surface.triangles.size(),
             surface.bisected.size(), surface.undecided.size());
}

}  // namespace
}  // namespace crest::experiments

int main(int argc, char** argv) {
  using namespace crest::experiments;
  Program program("times of rays and isosurfaces of quadratic splines on one thread");
  Arguments a;
  program.option("--volume", a.volume, "a volume instead of Marschner and Lobb's function");
  program.option("--nodes", a.nodes, "samples along each axis of the latter");
  program.option("--isovalue", a.isovalue, "the level");
  program.option("--size", a.size, "pixels along each side");
  program.option("--repeat", a.repeat, "runs, of which the median counts");
  program.flag("--mesh", a.mesh, "make the isosurface, too");
  return program.run(argc, argv, [&] {
    const tbb::global_control one(tbb::global_control::max_allowed_parallelism, 1);
    measure(a);
    return 0;
  });
}
