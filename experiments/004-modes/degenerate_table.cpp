// SPDX-License-Identifier: GPL-3.0-or-later
// Degenerate curves: processor time of a face by stage (tensor-lines: mean 115 to 170 us a random
// face, 5 to 8 us where it rejects at once), and the curves of the four blocks.
#include <fmt/format.h>

#include <chrono>
#include <random>

#include "algorithms/modes/degenerate_curves.hpp"
#include "algorithms/modes/degenerate_face.hpp"
#include "algorithms/sampling/loaded_block.hpp"
#include "experiments/median.hpp"
#include "experiments/processor_time.hpp"
#include "experiments/program.hpp"

namespace crest::experiments {
namespace {

using namespace modes;

/// Faces whose corners differ by `spread` from a common degenerate tensor; 0: independent corners.
std::vector<Tensor> faces(std::size_t n, double spread) {
  std::mt19937_64 random(1);
  std::normal_distribution<double> normal;
  std::vector<Tensor> t(3 * n);
  for (std::size_t i = 0; i < n; ++i) {
    const std::array<double, 3> v{normal(random), normal(random), normal(random)};
    const double s = spread == 0 ? 0 : normal(random) > 0 ? 1 : -1;
    const Tensor common{s * v[0] * v[0], s * v[1] * v[1], s * v[2] * v[2],
                        s * v[0] * v[1], s * v[1] * v[2], s * v[0] * v[2]};
    for (std::size_t c = 0; c < 3; ++c)
      for (std::size_t k = 0; k < 6; ++k)
        t[3 * i + c][k] = common[k] + (spread == 0 ? 1 : spread) * normal(random);
  }
  return t;
}

void face_times(std::size_t n, int times) {
  fmt::print(
      "{} faces a row, one thread, processor time, medians of {} runs; spread: of the corners "
      "around a common degenerate tensor\n\n| spread | cone, ns | excluded | triage, us | not "
      "decided | points 0, 1, 2, 3, 4 "
      "| exact, "
      "us |\n|---|---|---|---|---|---|---|\n",
      n, times);
  for (const double spread : {0.0, 0.3, 0.05, 0.01, 0.001}) {
    const auto t = faces(n, spread);
    std::vector<Direction> u;
    for (const Tensor& x : t) u.push_back(direction(x));
    std::vector<char> open(n);
    std::size_t excluded = 0, undecided = 0;
    std::array<std::size_t, 5> points{};
    const double cone = median_of(times, [&] {
      const double start = processor_seconds();
      for (std::size_t i = 0; i < n; ++i) open[i] = !cone_excludes({&u[3 * i], 3});
      return processor_seconds() - start;
    });
    for (const char o : open) excluded += !o;
    const double triage = median_of(times, [&] {
      undecided = 0;
      points.fill(0);
      const double start = processor_seconds();
      for (std::size_t i = 0; i < n; ++i) {
        if (!open[i]) continue;
        const auto r = triage_face_roots({&t[3 * i], &t[3 * i + 1], &t[3 * i + 2]});
        r ? ++points[r->count] : ++undecided;
      }
      return processor_seconds() - start;
    });
    const double last = processor_seconds();
    const std::size_t few = std::min<std::size_t>(n, 100);
    for (std::size_t i = 0; i < few; ++i)
      (void)exact_face_roots({&t[3 * i], &t[3 * i + 1], &t[3 * i + 2]});
    const double exact = processor_seconds() - last;
    fmt::print("| {} | {:.0f} | {} | {:.2f} | {} | {}, {}, {}, {}, {} | {:.0f} |\n",
               spread == 0 ? "independent" : fmt::format("{}", spread),
               1e9 * cone / static_cast<double>(n), excluded,
               1e6 * triage / static_cast<double>(n - excluded), undecided, points[0], points[1],
               points[2], points[3], points[4], 1e6 * exact / static_cast<double>(few));
  }
}

void block_curves() {
  fmt::print(
      "\n| block | load | tets | excluded | faces tested | exact | face points | linear: pieces, "
      "length | planar: "
      "pieces, length | closed | special faces | tets with such | undecided | seconds "
      "|\n|---|---|---|---|---|---|"
      "---|---|---|---|---|---|---|---|\n");
  for (const sampling::Scenario& s : sampling::scenarios())
    for (const bool exact : {false, true}) {
      if (exact && s.name == "twist") continue;
      const auto [block, stress, steps] = sampling::load_block(s, 1, exact);
      const auto tets = block.tets();
      std::vector<kernel::Vec3> points;
      const auto& n = block.size();
      for (int k = 0; k <= n[2]; ++k)
        for (int j = 0; j <= n[1]; ++j)
          for (int i = 0; i <= n[0]; ++i)
            points.push_back(
                {static_cast<double>(i), static_cast<double>(j), static_cast<double>(k)});
      const auto start = std::chrono::steady_clock::now();
      const DegenerateCurves r = degenerate_curves(points, tets, stress);
      const std::chrono::duration<double> time = std::chrono::steady_clock::now() - start;
      std::array<std::size_t, 2> pieces{};
      std::array<double, 2> length{};
      std::size_t closed = 0;
      for (const auto& c : r.curves) {
        ++pieces[static_cast<std::size_t>(c.type)];
        length[static_cast<std::size_t>(c.type)] += c.length;
        closed += c.closed;
      }
      fmt::print(
          "| {} | {} | {} | {} | {} | {} | {} | {}, {:.1f} | {}, {:.1f} | {} | {} | {} | {} | "
          "{:.2f} |\n",
          s.name, exact ? "exactly symmetric" : "as solved", tets.size(), r.counts.rejected_tets,
          r.counts.rejected_faces + r.counts.triage_faces + r.counts.exact_faces,
          r.counts.exact_faces, r.points.size(), pieces[0], length[0], pieces[1], length[1], closed,
          r.special_faces.size(), r.special_tets.size(), r.undecided.size(), time.count());
      std::fflush(stdout);
    }
}

}  // namespace
}  // namespace crest::experiments

int main(int argc, char** argv) {
  int faces = 20000, times = 5;
  bool blocks = false;
  crest::experiments::Program program(
      "Degenerate curves: speed of a face, curves of the four blocks.");
  program.option("--faces", faces, "random faces a row", {1, 10000000});
  program.option("--times", times, "runs of a row", {1, 1000});
  program.flag("--blocks", blocks, "the four blocks, too");
  return program.run(argc, argv, [&] {
    crest::experiments::face_times(static_cast<std::size_t>(faces), times);
    if (blocks) crest::experiments::block_curves();
    return 0;
  });
}
