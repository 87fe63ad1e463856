// SPDX-License-Identifier: GPL-3.0-or-later
// Figure 3.24 of paper 001: strokes that converge, painted in five ways, and the luminance of each.
#include <fmt/format.h>

#include <filesystem>

#include "algorithms/line_art/tone.hpp"
#include "experiments/program.hpp"
#include "io/line_art/drawing_writer.hpp"

namespace crest::experiments {
namespace {

using namespace line_art;

constexpr Index kStrokes = 31;
constexpr double kLength = 50, kSpacing = 1.6, kLeft = 4;  // mm; the spacing falls to a quarter
constexpr double kHeight = kStrokes * kSpacing;

std::vector<Hatch> converging() {
  std::vector<Hatch> strokes;
  for (Index i = 0; i < kStrokes; ++i) {
    Hatch h;
    for (int k = 0; k <= 250; ++k) {
      const double t = k / 250.0, off = (i + 0.5) * kSpacing - 0.5 * kHeight;
      h.stroke.points.push_back({kLeft + t * kLength, 0.5 * kHeight + off * (1 - 0.75 * t)});
    }
    strokes.push_back(std::move(h));
  }
  return strokes;
}

/// Lines with the index 2^k i - 1 + 2^(k - 1).
Index level_of(Index i) {
  Index k = 1;
  for (; (i & 1U) != 0; i >>= 1) ++k;
  return k;
}

struct Panel {
  const char* name;
  bool bands, reversed;
  Index levels;  ///< painted; more than there are: all
};
constexpr Panel kPanels[] = {{"black strokes of constant width", false, false, 99},
                             {"bands from top to bottom", true, false, 99},
                             {"bands, lines 2 i", true, true, 1},
                             {"and 4 i + 1", true, true, 2},
                             {"and all others", true, true, 99}};

std::vector<Hatch> painted(const Panel& panel, double ink) {
  std::vector<Hatch> all = converging(), strokes;
  std::vector<Index> order = bit_reversed(kStrokes);
  if (!panel.reversed) std::sort(order.begin(), order.end());
  for (const Index i : order) {
    if (level_of(i) > panel.levels) continue;
    Stroke& s = all[i].stroke;
    s.rank = static_cast<Index>(strokes.size());
    if (panel.bands) s.band = kSpacing;
    s.widths.assign(s.points.size(), ink * kSpacing);
    strokes.push_back(std::move(all[i]));
  }
  return strokes;
}

/// Between the outer strokes, in equal columns.
std::vector<double> luminances(const std::vector<Hatch>& strokes) {
  constexpr int kColumns = 6;
  Buffers b;
  b.pixel = 0.04;
  b.width = static_cast<int>((2 * kLeft + kLength) / b.pixel);
  b.height = static_cast<int>(kHeight / b.pixel);
  b.face.assign(static_cast<std::size_t>(b.width) * static_cast<std::size_t>(b.height), 0);
  const std::vector<float> black = coverage(b, strokes);
  std::vector<double> sum(kColumns, 0), count(kColumns, 0);
  for (std::size_t k = 0; k < b.size(); ++k) {
    const Vec2 p = b.centre(k);
    const double t = (p[0] - kLeft) / kLength;
    if (t < 0 || t >= 1) continue;
    const double reach = (0.5 * kHeight - 2 * kSpacing) * (1 - 0.75 * t);
    if (std::abs(p[1] - 0.5 * kHeight) > reach) continue;
    const auto column = static_cast<std::size_t>(t * kColumns);
    sum[column] += 1 - static_cast<double>(black[k]);
    ++count[column];
  }
  for (std::size_t c = 0; c < sum.size(); ++c) sum[c] /= count[c];
  return sum;
}

void draw(const std::filesystem::path& out, double ink) {
  Drawing drawing;
  drawing.title = "figure 3.24: the order of painting";
  drawing.view.page = {5 * (kLength + kLeft) + kLeft, kHeight};
  double shift = 0;
  for (const Panel& panel : kPanels) {
    for (Hatch& h : painted(panel, ink)) {
      for (Vec2& p : h.stroke.points) p[0] += shift;
      drawing.hatches.push_back(std::move(h.stroke));
    }
    shift += kLength + kLeft;
  }
  io::write_drawing((out / "figure-3.24-order.svg").string(), drawing);
}

}  // namespace
}  // namespace crest::experiments

int main(int argc, char** argv) {
  using namespace crest::experiments;
  Program program("Figure 3.24: strokes that converge, painted in five ways.");
  std::filesystem::path out;
  program.option("--pictures", out, "folder for the .svg (default: none)");
  return program.run(argc, argv, [&] {
    fmt::print("\n| painted | luminance wanted | six columns, spacing w to w/4 |\n|---|---|---|\n");
    for (const double ink : {0.5, 0.7})
      for (const Panel& panel : kPanels) {
        std::string row;
        for (const double x : luminances(painted(panel, ink))) row += fmt::format(" {:.2f}", x);
        fmt::print("| {} | {:.1f} |{} |\n", panel.name, 1 - ink, row);
      }
    if (!out.empty()) draw(out, 0.5);
    return 0;
  });
}
