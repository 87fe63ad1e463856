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

/// Where the lines' names go: beside their last points, apart from one another.
template <class Place>
std::vector<double> label_places(const std::vector<PlotLine>& lines, const Place& place) {
  std::vector<double> at;
  std::vector<std::size_t> order;
  for (const PlotLine& l : lines) {
    order.push_back(at.size());
    at.push_back(place(l.median.back()));
  }
  std::ranges::sort(order, {}, [&](std::size_t k) { return at[k]; });
  constexpr double apart = 18;
  for (std::size_t i = 1; i < order.size(); ++i)
    at[order[i]] = std::max(at[order[i]], at[order[i - 1]] + apart);
  return at;
}

inline void write_plot(const std::string& path, const std::string& title, const std::string& axis,
                       const std::vector<double>& xs, const std::vector<PlotLine>& lines) {
  constexpr const char* kColours[] = {"#1b7837", "#d6604d", "#2166ac", "#b8860b",
                                      "#762a83", "#4d4d4d", "#00a0a0"};
  constexpr double left = 90, right = 690, top = 50, bottom = 500;
  double low = 1e300, high = 1e-300;
  for (const PlotLine& l : lines)
    for (std::size_t i = 0; i < xs.size(); ++i) {
      if (l.low[i] > 0) low = std::min(low, l.low[i]);
      high = std::max(high, l.high[i]);
    }
  const double first = std::floor(std::log10(low)), last = std::ceil(std::log10(high) + 1e-9);
  const double step = std::ceil((last - first) / 8);  // decades between two named ones
  const auto px = [&](double x) {
    return left + (right - left) * (x - xs.front()) / (xs.back() - xs.front());
  };
  const auto at_decade = [&](double e) {
    return bottom - (bottom - top) * (e - first) / (last - first);
  };
  const auto py = [&](double y) { return at_decade(std::log10(std::max(y, low))); };
  std::string svg =
      "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"860\" height=\"560\" "
      "font-family=\"Helvetica, Arial, sans-serif\" font-size=\"15\">\n"
      "<rect width=\"860\" height=\"560\" fill=\"#ffffff\"/>\n";
  svg += fmt::format("<text x=\"{}\" y=\"30\" font-size=\"18\">{}</text>\n", left, title);
  for (double e = first; e <= last; e += step) {
    const double y = at_decade(e);
    svg += fmt::format(
        "<path d=\"M{} {:.1f}H{}\" stroke=\"#dddddd\"/>"
        "<text x=\"{}\" y=\"{:.1f}\" text-anchor=\"end\">10<tspan dy=\"-6\" "
        "font-size=\"11\">{}</tspan></text>\n",
        left, y, right, left - 8, y + 5, e);
  }
  for (const double x : xs) {
    svg += fmt::format("<text x=\"{:.1f}\" y=\"{}\" text-anchor=\"middle\">{}</text>\n", px(x),
                       bottom + 22, x);
  }
  svg += fmt::format("<text x=\"{}\" y=\"{}\" text-anchor=\"middle\">{}</text>\n",
                     0.5 * (left + right), bottom + 46, axis);
  const std::vector<double> label_at = label_places(lines, py);
  for (std::size_t k = 0; k < lines.size(); ++k) {
    const PlotLine& l = lines[k];
    const char* colour = kColours[k % std::size(kColours)];
    std::string band = "M", curve = "M", dots;
    for (std::size_t i = 0; i < xs.size(); ++i) {
      band += fmt::format("{}{:.1f} {:.1f}", i > 0 ? "L" : "", px(xs[i]), py(l.high[i]));
      curve += fmt::format("{}{:.1f} {:.1f}", i > 0 ? "L" : "", px(xs[i]), py(l.median[i]));
      dots += fmt::format("<circle cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"3.5\" fill=\"{}\"/>\n",
                          px(xs[i]), py(l.median[i]), colour);
    }
    for (std::size_t i = xs.size(); i-- > 0;)
      band += fmt::format("L{:.1f} {:.1f}", px(xs[i]), py(l.low[i]));
    svg += fmt::format("<path d=\"{}Z\" fill=\"{}\" opacity=\"0.13\"/>\n", band, colour);
    // The methods of the paper in full lines.
    svg += fmt::format("<path d=\"{}\" fill=\"none\" stroke=\"{}\" stroke-width=\"2.4\"{}/>\n{}",
                       curve, colour, k < 5 ? "" : " stroke-dasharray=\"7 5\"", dots);
    svg += fmt::format("<text x=\"{:.0f}\" y=\"{:.1f}\" fill=\"{}\">{}</text>\n", right + 12,
                       label_at[k] + 5, colour, l.label);
  }
  io::write_atomically(path, svg + "</svg>\n");
}

}  // namespace crest::experiments
