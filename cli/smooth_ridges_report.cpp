// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/smooth_ridges_report.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "algorithms/smooth_ridges/surface.hpp"
#include "cli/written.hpp"
#include "io/ridges/smooth_ridge_lines.hpp"

namespace crest::cli {
namespace {

using smooth_ridges::Colour;
using smooth_ridges::RidgeType;
using smooth_ridges::SmoothRidges;
using smooth_ridges::UmbilicPoint;

constexpr std::size_t kListedCells = 10000;  // in the report
constexpr std::size_t kShownCells = 5;       // on the terminal

const char* colour_name(Colour colour) {
  return colour == Colour::blue ? "blue" : "red";
}

std::string kind_name(const UmbilicPoint& umbilic) {
  return umbilic.branches[0] == 3 ? "3-ridge" : "1-ridge";
}

double index_sum(const SmoothRidges& result) {
  int twice = 0;
  for (const UmbilicPoint& u : result.umbilics) twice += u.twice_index;
  return 0.5 * twice;
}

Json umbilics_json(const SmoothRidges& result) {
  Json items = Json::array();
  for (const UmbilicPoint& u : result.umbilics)
    items.push_back({{"index", 0.5 * u.twice_index}, {"kind", kind_name(u)}, {"point", u.point}});
  return {{"count", result.umbilics.size()},
          {"index_sum", index_sum(result)},
          {"items", std::move(items)}};
}

Json points_json(const std::vector<smooth_ridges::RidgePoint>& points, bool coloured) {
  Json items = Json::array();
  for (const auto& p : points) {
    Json item = {{"point", p.point}};
    if (coloured) item["colour"] = colour_name(p.colour);
    items.push_back(std::move(item));
  }
  return {{"count", points.size()}, {"items", std::move(items)}};
}

Json surface_json(const smooth_ridges::Surface& surface) {
  Json texts = Json::array();
  for (const auto& f : surface.functions()) texts.push_back(f.text());
  Json json = {{"kind", surface.is_implicit() ? "implicit" : "parametric"},
               {"expressions", std::move(texts)}};
  if (surface.is_implicit()) {
    json["box"] = surface.box();
    return json;
  }
  json["domain"] = Json::array();
  for (const auto& bound : surface.domain()) json["domain"].push_back(bound.text());
  json["periodic"] = std::string(surface.periodic(0) ? "u" : "") + (surface.periodic(1) ? "v" : "");
  return json;
}

Json cells_json(const SmoothRidges& result) {
  Json cells = Json::array();
  for (std::size_t i = 0; i < std::min(kListedCells, result.undecided.size()); ++i) {
    const auto& cell = result.undecided[i];
    cells.push_back({{"center", cell.centre}, {"size", cell.size}, {"reason", cell.reason}});
  }
  return cells;
}

/// What the claim states; nothing is filtered.
Json counts_json(const SmoothRidges& result) {
  if (!result.certified) return {};
  Json counts;
  for (const Colour colour : {Colour::blue, Colour::red}) {
    const ColourSummary s = summarise(result, colour);
    counts[colour_name(colour)] = {{"loops", s.loops}, {"segments", s.segments}};
  }
  counts["umbilics"] = result.umbilics.size();
  counts["turning_points"] = result.turning_points.size();
  counts["purple_points"] = result.purple_points.size();
  return counts;
}

void fill_certificate(Json& json, const SmoothRidgesRun& run) {
  const SmoothRidges& result = run.result;
  json["certified"] = result.certified;
  json["undecided"] = result.undecided.size();
  if (run.certificate_bytes == 0) return;
  json["bytes"] = run.certificate_bytes;
  json["bytes_per_triangle"] =
      static_cast<double>(run.certificate_bytes) / static_cast<double>(result.faces.size());
}

std::string count_lines(const SmoothRidges& result) {
  const auto count = [&](auto&& has) {
    return std::count_if(result.umbilics.begin(), result.umbilics.end(), has);
  };
  std::string text = fmt::format(
      "surface: {} triangles, depth {}, Euler characteristic {}, {}, {}\n",
      grouped(result.faces.size()), result.rounds, result.euler_characteristic,
      plural(result.components, "component"), plural(result.boundary_loops, "boundary loop"));
  text += fmt::format(
      "umbilics: {} ({} of index +1/2, {} of -1/2; {} 1-ridge, {} 3-ridge), index sum {}\n",
      result.umbilics.size(), count([](const auto& u) { return u.twice_index > 0; }),
      count([](const auto& u) { return u.twice_index < 0; }),
      count([](const auto& u) { return u.branches[0] == 1; }),
      count([](const auto& u) { return u.branches[0] == 3; }), index_sum(result));
  for (const Colour colour : {Colour::blue, Colour::red}) {
    const ColourSummary s = summarise(result, colour);
    const auto turning = std::count_if(result.turning_points.begin(), result.turning_points.end(),
                                       [&](const auto& p) { return p.colour == colour; });
    text += fmt::format("{}: {}, {}, length {:.6g} ({:.6g} elliptic, {:.6g} hyperbolic), {}\n",
                        colour_name(colour), plural(s.loops, "loop"), plural(s.segments, "segment"),
                        s.length, s.elliptic_length, s.hyperbolic_length,
                        plural(static_cast<std::size_t>(turning), "turning point"));
  }
  return text + fmt::format("purple points: {}\n", result.purple_points.size());
}

std::string refusal(const SmoothRidges& result) {
  std::string text = "NOT CERTIFIED: ";
  for (std::size_t i = 0; i < result.obstacles.size(); ++i)
    text += (i == 0 ? "" : "; ") + result.obstacles[i];
  text += "\n";
  if (result.undecided.empty()) return text;
  text += fmt::format("uncertified cells: {}, among them\n", grouped(result.undecided.size()));
  for (std::size_t i = 0; i < std::min(kShownCells, result.undecided.size()); ++i) {
    const auto& cell = result.undecided[i];
    text += fmt::format("  at ({:.6g}, {:.6g}, {:.6g}), size {:.3g}: {}\n", cell.centre[0],
                        cell.centre[1], cell.centre[2], cell.size, cell.reason);
  }
  return text;
}

}  // namespace

ColourSummary summarise(const SmoothRidges& result, Colour colour) {
  ColourSummary s;
  for (const auto& ridge : result.ridges) {
    if (ridge.colour != colour) continue;
    ++(ridge.loop ? s.loops : s.segments);
    for (const io::RidgeRun& run : io::runs_of(ridge)) {
      double length = 0;
      for (std::size_t i = 0; i + 1 < run.points.size(); ++i)
        length += io::length_of(ridge, run.points[i], run.points[i + 1]);
      s.length += length;
      const double half = run.type == RidgeType::turning ? 0.5 * length : 0;
      s.elliptic_length += run.type == RidgeType::elliptic ? length : half;
      s.hyperbolic_length += run.type == RidgeType::hyperbolic ? length : half;
    }
  }
  return s;
}

void fill_report(Report& report, const SmoothRidgesRun& run) {
  const SmoothRidges& result = run.result;
  const auto& s = result.seconds;
  for (const auto& [phase, seconds] : {std::pair("completeness", s.completeness),
                                       {"start", s.start},
                                       {"faces", s.faces},
                                       {"umbilics", s.umbilics},
                                       {"bisection", s.bisection},
                                       {"graph", s.graph}})
    report.add_seconds(phase, seconds);
  fill_certificate(report["certificate"], run);
  add_written(report, {}, counts_json(result));
  report["surface"] = surface_json(run.surface);
  report["vertices"] = result.points.size();
  report["triangles"] = result.faces.size();
  report["euler_characteristic"] = result.euler_characteristic;
  report["boundary_loops"] = result.boundary_loops;
  report["components"] = result.components;
  report["depth"] = result.rounds;
  report["face_tests"] = result.tests;
  report["umbilics"] = umbilics_json(result);
  report["ridges"] = {{"blue", to_json(summarise(result, Colour::blue))},
                      {"red", to_json(summarise(result, Colour::red))}};
  report["open_ends"] = io::open_ends(result);
  report["turning_points"] = points_json(result.turning_points, true);
  report["purple_points"] = points_json(result.purple_points, false);
  report["stopped"] = result.stopped;
  report["obstacles"] = result.obstacles;
  report["uncertified_cells"] = cells_json(result);
  report["data_digest"] = run.data_digest;
  if (result.undecided.size() > kListedCells) {
    report.warn(fmt::format("uncertified_cells lists the first {} of {} cells", kListedCells,
                            result.undecided.size()));
  }
}

std::string summary_text(const SmoothRidgesRun& run) {
  if (run.result.certified)
    return count_lines(run.result) + "certified: these counts are proven of the surface itself\n";
  if (run.result.faces.empty()) return refusal(run.result);
  return "partial result, only right where it is certified:\n" + count_lines(run.result) +
         refusal(run.result);
}

std::string grouped(std::size_t number) {
  std::string text = std::to_string(number);
  for (std::size_t i = text.size(); i > 3; i -= 3) text.insert(i - 3, " ");
  return text;
}

}  // namespace crest::cli
