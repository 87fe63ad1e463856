// SPDX-License-Identifier: GPL-3.0-or-later
// The evaluation of paper 001, section 3.3 (figures 3.5, 3.6, 3.9, 3.10), extended by jet and
// normal-cycle: distances of K, H and directions on four meshes, five noise levels, many seeds.
#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "experiments/001-curvature/svg_plot.hpp"
#include "experiments/001-curvature/test_meshes.hpp"
#include "experiments/program.hpp"

namespace crest::experiments {
namespace {

using curvature::Method;

constexpr const char* kMeasures[] = {"dist_K", "dist_H", "dist_P"};

struct Settings {
  int seeds = 20;
  std::vector<double> noise = {0, 0.5, 1, 2, 3};
  std::string plots;
  bool interior = false;
};

struct Spread {
  double low, median, high;  ///< quartiles around the median
};

Spread spread_of(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  const auto at = [&](double q) {
    return values[static_cast<std::size_t>(
        std::lround(q * static_cast<double>(values.size() - 1)))];
  };
  return {at(0.25), at(0.5), at(0.75)};
}

std::vector<TestMesh> meshes_of(std::uint64_t seed) {
  return {random_diagonals(torus(), 100, 100, seed), perturbed_delaunay(torus(), 100, 100, seed),
          random_diagonals(waved_tube(), 100, 50, seed),
          perturbed_delaunay(waved_tube(), 100, 50, seed)};
}

/// [mesh][level][method][measure] -> a value a seed.
using Values = std::vector<std::vector<std::map<Method, std::array<std::vector<double>, 3>>>>;

void measure(const TestMesh& mesh, double s, std::uint64_t seed, bool interior,
             std::map<Method, std::array<std::vector<double>, 3>>& out) {
  const kernel::TriangleMesh noisy(displaced(mesh, s, seed), mesh.faces);
  for (const Method method : curvature::kMethods) {
    curvature::Options o;
    o.method = method;
    if (method == Method::np) o.normals = mesh.normals;
    auto estimates = curvature::estimate(noisy, o).vertices;
    auto exact = mesh.exact;
    if (interior) {
      std::size_t kept = 0;
      for (Index v = 0; v < noisy.vertex_count(); ++v) {
        if (noisy.on_boundary(v)) continue;
        estimates[kept] = estimates[v];
        exact[kept++] = exact[v];
      }
      estimates.resize(kept);
      exact.resize(kept);
    }
    const curvature::Distances d = curvature::distances(estimates, exact);
    const double values[] = {d.K, d.H, d.P};
    for (std::size_t i = 0; i < 3; ++i) out[method][i].push_back(values[i]);
  }
}

void print_table(const std::string& name, const Settings& o, const Values::value_type& levels) {
  for (std::size_t i = 0; i < 3; ++i) {
    fmt::print("\n### {}, {}\n\n| noise s |", name, kMeasures[i]);
    for (const Method m : curvature::kMethods) fmt::print(" {} |", curvature::name_of(m));
    fmt::print("\n|---|---|---|---|---|---|---|---|\n");
    for (std::size_t level = 0; level < o.noise.size(); ++level) {
      fmt::print("| {} |", o.noise[level]);
      for (const Method m : curvature::kMethods) {
        const Spread s = spread_of(levels[level].at(m)[i]);
        fmt::print(" {:.3g} ({:.3g}-{:.3g}) |", s.median, s.low, s.high);
      }
      fmt::print("\n");
    }
  }
}

/// The thesis' statements about one mesh, level and measure, on medians.
void print_ordering(const std::string& name, const Settings& o, const Values::value_type& levels) {
  for (std::size_t level = 0; level < o.noise.size(); ++level) {
    for (std::size_t i = 0; i < 3; ++i) {
      const auto median = [&](Method m) { return spread_of(levels[level].at(m)[i]).median; };
      const double np = median(Method::np), ne = median(Method::ne), cf = median(Method::cf);
      const double qf = median(Method::qf), qt = median(Method::qt);
      const bool best = np <= std::min({ne, cf, qf, qt});
      const bool worst = std::min(qf, qt) >= std::max(ne, cf);
      fmt::print("| {} | {} | {} | {} | {:.2f} | {} |\n", name, o.noise[level], kMeasures[i],
                 best ? "yes" : "NO", ne / cf, worst ? "yes" : "NO");
    }
  }
}

void plot(const std::string& folder, const std::string& name, const Settings& o,
          const Values::value_type& levels) {
  for (std::size_t i = 0; i < 3; ++i) {
    std::vector<PlotLine> lines;
    for (const Method m : curvature::kMethods) {
      PlotLine line{curvature::name_of(m), {}, {}, {}};
      for (std::size_t level = 0; level < o.noise.size(); ++level) {
        const Spread s = spread_of(levels[level].at(m)[i]);
        line.low.push_back(s.low);
        line.median.push_back(s.median);
        line.high.push_back(s.high);
      }
      lines.push_back(std::move(line));
    }
    std::string file = name;
    std::replace(file.begin(), file.end(), ' ', '-');
    write_plot(folder + "/" + file + "-" + kMeasures[i] + ".svg", name + ": " + kMeasures[i],
               "noise s (per cent of the diagonal)", o.noise, lines);
  }
}

void run(const Settings& o) {
  Values values(4, Values::value_type(o.noise.size()));
  std::vector<std::string> names(4);
  for (int seed = 1; seed <= o.seeds; ++seed) {
    const auto meshes = meshes_of(static_cast<std::uint64_t>(seed));
    for (std::size_t m = 0; m < meshes.size(); ++m) {
      names[m] = fmt::format("{} ({} triangles)", meshes[m].name, meshes[m].faces.size());
      for (std::size_t level = 0; level < o.noise.size(); ++level) {
        measure(meshes[m], o.noise[level], static_cast<std::uint64_t>(seed), o.interior,
                values[m][level]);
      }
    }
  }
  fmt::print("Median (quartiles) over {} seeds (triangulation and noise); {}.\n", o.seeds,
             o.interior ? "interior vertices" : "all vertices");
  for (std::size_t m = 0; m < 4; ++m) print_table(names[m], o, values[m]);
  fmt::print("\n### The thesis' ordering, on medians\n\n");
  fmt::print("| mesh | noise | measure | np best of the five | ne / cf | qf, qt worst |\n");
  fmt::print("|---|---|---|---|---|---|\n");
  for (std::size_t m = 0; m < 4; ++m) print_ordering(names[m], o, values[m]);
  if (o.plots.empty()) return;
  for (std::size_t m = 0; m < 4; ++m)
    plot(o.plots, names[m].substr(0, names[m].find(" (")), o, values[m]);
}

}  // namespace
}  // namespace crest::experiments

int main(int argc, char** argv) {
  crest::experiments::Settings o;
  crest::experiments::Program program("Paper 001, section 3.3: curvature estimates under noise");
  program.option("--seeds", o.seeds, "triangulations and noises (default 20)");
  program.list("--noise", o.noise, "levels s (default 0,0.5,1,2,3)");
  program.option("--plots", o.plots, "folder for plots like figures 3.5 to 3.10 (.svg)");
  program.flag("--interior", o.interior, "leave boundary vertices out");
  return program.run(argc, argv, [&] {
    crest::experiments::run(o);
    return 0;
  });
}
