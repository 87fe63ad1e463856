// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Line plots with a logarithmic vertical axis, as SVG.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "io/write/atomic_file.hpp"

namespace crest::experiments {

/// One value of each kind per horizontal position; low and high span a band.
struct PlotLine {
  std::string label;
  std::vector<double> low, median, high;
};

inline void write_plot(const std::string& path, const std::string& title, const std::string& axis,
                       const std::vector<double>& xs, const std::vector<PlotLine>& lines) {
  constexpr const char* kColours[] = {"#1b7837", "#d6604d", "#2166ac", "#b8860b",
                                      "#762a83", "#4d4d4d", "#00a0a0"};
  constexpr double left = 70, right = 480, top = 40, bottom = 320;
  double low = 1e300, high = 1e-300;
  for (const PlotLine& l : lines)
    for (std::size_t i = 0; i < xs.size(); ++i) {
      if (l.low[i] > 0) low = std::min(low, l.low[i]);
      high = std::max(high, l.high[i]);
    }
  const double first = std::floor(std::log10(low)), last = std::ceil(std::log10(high) + 1e-9);
  const auto px = [&](double x) {
    return left + (right - left) * (x - xs.front()) / (xs.back() - xs.front());
  };
  const auto py = [&](double y) {
    const double t = (std::log10(std::max(y, low)) - first) / (last - first);
    return bottom - (bottom - top) * t;
  };
  std::string svg =
      "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"600\" height=\"370\" "
      "font-family=\"Helvetica, Arial, sans-serif\" font-size=\"12\">\n"
      "<rect width=\"600\" height=\"370\" fill=\"#ffffff\"/>\n";
  svg += fmt::format("<text x=\"{}\" y=\"24\" font-size=\"14\">{}</text>\n", left, title);
  for (double e = first; e <= last; ++e) {
    const double y = py(std::pow(10, e));
    svg += fmt::format(
        "<path d=\"M{} {:.1f}H{}\" stroke=\"#dddddd\"/>"
        "<text x=\"{}\" y=\"{:.1f}\" text-anchor=\"end\">1e{}</text>\n",
        left, y, right, left - 6, y + 4, e);
  }
  for (const double x : xs) {
    svg += fmt::format("<text x=\"{:.1f}\" y=\"{}\" text-anchor=\"middle\">{}</text>\n", px(x),
                       bottom + 18, x);
  }
  svg += fmt::format("<text x=\"{}\" y=\"{}\" text-anchor=\"middle\">{}</text>\n",
                     0.5 * (left + right), bottom + 38, axis);
  for (std::size_t k = 0; k < lines.size(); ++k) {
    const PlotLine& l = lines[k];
    const char* colour = kColours[k % std::size(kColours)];
    std::string band = "M", curve = "M";
    for (std::size_t i = 0; i < xs.size(); ++i) {
      band += fmt::format("{}{:.1f} {:.1f}", i > 0 ? "L" : "", px(xs[i]), py(l.high[i]));
      curve += fmt::format("{}{:.1f} {:.1f}", i > 0 ? "L" : "", px(xs[i]), py(l.median[i]));
    }
    for (std::size_t i = xs.size(); i-- > 0;)
      band += fmt::format("L{:.1f} {:.1f}", px(xs[i]), py(l.low[i]));
    svg += fmt::format("<path d=\"{}Z\" fill=\"{}\" opacity=\"0.15\"/>\n", band, colour);
    svg += fmt::format("<path d=\"{}\" fill=\"none\" stroke=\"{}\" stroke-width=\"1.6\"/>\n", curve,
                       colour);
    const double y = top + 16 + 18 * static_cast<double>(k);
    svg += fmt::format(
        "<path d=\"M496 {0:.0f}H516\" stroke=\"{1}\" stroke-width=\"2\"/>"
        "<text x=\"522\" y=\"{2:.0f}\">{3}</text>\n",
        y, colour, y + 4, l.label);
  }
  io::write_atomically(path, svg + "</svg>\n");
}

}  // namespace crest::experiments
