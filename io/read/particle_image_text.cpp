// SPDX-License-Identifier: GPL-3.0-or-later
// Velocities of particle image velocimetry as texts: DaVis (tabs, decimal commas), Insight (commas,
// a flag), OpenPIV (blanks, a mask).
#include <fmt/format.h>

#include <charconv>
#include <cmath>

#include "io/formats/files.hpp"
#include "io/read/plane_grid.hpp"

namespace crest::io {
namespace {

enum class Dialect { davis, insight, openpiv };

/// The numbers of a line; nothing if something else stands there.
std::vector<double> numbers_of(std::string line, Dialect dialect) {
  if (dialect == Dialect::davis)
    for (char& c : line)
      if (c == ',') c = '.';
  if (dialect == Dialect::insight)
    for (char& c : line)
      if (c == ',') c = ' ';
  std::vector<double> row;
  const char* at = line.data();
  const char* const end = at + line.size();
  const auto blank = [](char c) { return c == ' ' || c == '\t' || c == '\r'; };
  while (true) {
    while (at != end && blank(*at)) ++at;
    if (at == end) return row;
    if (*at == '+') ++at;
    double x = 0;
    const auto [stop, error] = std::from_chars(at, end, x);
    if (error == std::errc::result_out_of_range || error == std::errc::invalid_argument) return {};
    if (stop != end && !blank(*stop)) return {};
    row.push_back(x);
    at = stop;
  }
}

}  // namespace

PlaneGrid read_particle_image_text(const std::string& path, const VectorRequest& request,
                                   PlanarFieldFile& file) {
  const FileBytes bytes = load(path);
  const std::string_view text = bytes;
  const Dialect dialect = text.substr(0, 6) == "#DaVis"   ? Dialect::davis
                          : text.substr(0, 6) == "TITLE=" ? Dialect::insight
                                                          : Dialect::openpiv;
  std::vector<std::array<double, 4>> points;
  std::size_t line_number = 0, dropped = 0, columns = 0;
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t end = std::min(text.find('\n', at), text.size());
    const std::string line(text.substr(at, end - at));
    at = end + 1;
    ++line_number;
    if (line.find_first_not_of(" \t\r") == line.npos || line[0] == '#') continue;
    const auto row = numbers_of(line, dialect);
    if (row.size() < 4 || (columns > 0 && row.size() != columns)) {
      if (points.empty() && dropped == 0 && line_number <= 10) continue;  // headings
      fail(fmt::format("line {}", line_number), "has not the numbers x y u v", "write it again");
    }
    columns = row.size();
    const bool bad = (dialect == Dialect::insight && columns > 4 && row[4] <= 0) ||
                     (dialect == Dialect::openpiv && columns > 5 && row[5] != 0);
    if (bad && !request.all)
      ++dropped;
    else
      points.push_back({row[0], row[1], row[2], row[3]});
  }
  if (dropped > 0)
    file.warnings.push_back(
        fmt::format("{} points left out that the file flags as bad (--all keeps them)", dropped));
  file.field = "velocity";
  return grid_of_points(points);
}

}  // namespace crest::io
