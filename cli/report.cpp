// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/report.hpp"

#include <sys/resource.h>

#include "cli/version.hpp"

namespace crest::cli {
namespace {

std::int64_t peak_rss_bytes() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return std::int64_t{usage.ru_maxrss} * 1024;
}

}  // namespace

Json to_json(const io::CleanUp& done) {
  std::size_t other_cells = 0;
  for (const auto& [type, count] : done.other_cells) other_cells += count;
  return {{"other_cells", other_cells},
          {"polygons", done.polygons},
          {"curved_faces", done.curved_faces},
          {"repeated_corners", done.repeated_corners},
          {"duplicate_faces", done.duplicate_faces},
          {"unused_vertices", done.unused_vertices},
          {"welded_vertices", done.welded_vertices},
          {"split_vertices", done.split_vertices},
          {"cut_edges", done.cut_edges},
          {"collapsed_edges", done.collapsed_edges},
          {"flipped_edges", done.flipped_edges},
          {"trimmed_faces", done.trimmed_faces},
          {"turned_faces", done.turned_faces},
          {"turned_components", done.turned_parts},
          {"coincident_vertices", done.coincident_vertices},
          {"inside_out_components", done.inside_out_parts}};
}

Report::Report(const std::string& command, const std::string& input, int threads)
    : json_{
          {"crest", CREST_VERSION},
          {"command", command},
          {"input", input},
          {"seconds", Json::object()},
          {"peak_rss_bytes", 0},
          {"threads", threads},
          {"predicates", Json::object()},
          {"certificate",
           {{"written", false}, {"certified", false}, {"undecided", 0}, {"claims", Json::array()}}},
          {"warnings", Json::array()}} {}

void Report::set_certificate(const std::string& claim, std::size_t undecided) {
  Json& certificate = json_["certificate"];
  certificate["written"] = true;
  certificate["certified"] = undecided == 0;
  certificate["undecided"] = undecided;
  certificate["claims"].push_back(claim);
}

void Report::add_seconds(const std::string& phase, double seconds) {
  for (auto& [name, sum] : seconds_) {
    if (name != phase) continue;
    sum += seconds;
    return;
  }
  seconds_.emplace_back(phase, seconds);
}

std::string Report::text() {
  Json& seconds = json_["seconds"];
  for (const auto& [phase, sum] : seconds_) seconds[phase] = sum;
  seconds["total"] = elapsed();
  json_["peak_rss_bytes"] = peak_rss_bytes();
  json_["warnings"] = warnings_;
  return json_.text();
}

}  // namespace crest::cli
