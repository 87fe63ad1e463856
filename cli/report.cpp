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

void Report::set_certificate(const std::string& claim) {
  Json& certificate = json_["certificate"];
  certificate["written"] = true;
  certificate["certified"] = true;
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
