// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/report.hpp"

#include <sys/resource.h>

#include "cli/version.hpp"

namespace crest::cli {
namespace {

std::uint64_t peak_rss_bytes() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return static_cast<std::uint64_t>(usage.ru_maxrss) * 1024;
}

}  // namespace

Report::Report(const std::string& command, const std::string& input, int threads) {
  json_["crest"] = CREST_VERSION;
  json_["command"] = command;
  json_["input"] = input;
  json_["seconds"] = Json::object();
  json_["peak_rss_bytes"] = 0;
  json_["threads"] = threads;
  json_["predicates"] = Json::object();
  json_["certificate"] = {
      {"written", false}, {"certified", false}, {"undecided", 0}, {"claims", Json::array()}};
  json_["warnings"] = Json::array();
}

void Report::set_certificate(const std::string& claim) {
  json_["certificate"]["written"] = true;
  json_["certificate"]["certified"] = true;
  json_["certificate"]["claims"].push_back(claim);
}

void Report::add_seconds(const std::string& phase, Clock::duration time) {
  Json& seconds = json_["seconds"];
  seconds[phase] = seconds.value(phase, 0.0) + std::chrono::duration<double>(time).count();
}

double Report::elapsed() const {
  return std::chrono::duration<double>(Clock::now() - start_).count();
}

std::string Report::text() {
  json_["seconds"]["total"] = elapsed();
  json_["peak_rss_bytes"] = peak_rss_bytes();
  return json_.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace crest::cli
