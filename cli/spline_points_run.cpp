// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/spline_points_run.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "io/splines/table.hpp"

namespace crest::cli {

std::vector<kernel::Vec3> points_of(const std::vector<std::vector<double>>& columns) {
  std::vector<kernel::Vec3> points(columns[0].size());
  for (std::size_t i = 0; i < points.size(); ++i)
    points[i] = {columns[0][i], columns[1][i], columns[2][i]};
  return points;
}

void evaluate_points(Run& run, const SplineOptions& o, const SplineValues& evaluate) {
  if (o.evaluate.empty()) return;
  const io::Table table = run.step("read", "reading " + o.evaluate, [&] {
    return io::read_table(o.evaluate, {"x", "y", "z"});
  });
  const auto values =
      run.step("evaluate", "evaluating", [&] { return evaluate(points_of(table.columns)); });
  std::array<std::vector<double>, 4> out;
  for (const auto& v : values) {
    out[0].push_back(v.value);
    for (std::size_t d = 0; d < 3; ++d) out[d + 1].push_back(v.gradient[d]);
  }
  const auto outside =
      std::count_if(out[0].begin(), out[0].end(), [](double x) { return std::isnan(x); });
  if (outside > 0)
    run.warn(fmt::format("{} of {} points lie outside of the domain: their values are nan", outside,
                         values.size()));
  run.report()["evaluated"]["points"] = values.size();
  run.report()["evaluated"]["outside"] = static_cast<std::size_t>(outside);
  const std::array<std::span<const double>, 7> columns{
      table.columns[0], table.columns[1], table.columns[2], out[0], out[1], out[2], out[3]};
  run.step("write", "writing " + o.values, [&] {
    run.write("--values", [&](const std::string& path) {
      io::write_table(path, {"x", "y", "z", "value", "gx", "gy", "gz"}, columns);
    });
  });
}

}  // namespace crest::cli
