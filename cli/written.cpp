// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/written.hpp"

#include <fmt/format.h>

namespace crest::cli {

std::string whole(const std::string& what, bool certifies) {
  return (certifies ? "certified " : "") + what;
}

void add_written(Report& report, const std::vector<std::string>& by, Json counts) {
  Json& certificate = report["certificate"];
  certificate["subset"] = !by.empty();
  certificate["subset_by"] = by;
  certificate["counts"] = std::move(counts);
}

std::string written_line(const Written& written) {
  if (written.by.empty()) return {};
  return fmt::format("written: a {} of the {}: {} ({})\n", written.kind, written.whole,
                     written.share, fmt::join(written.by, ", "));
}

std::string legend_note(const std::string& kind, const std::vector<std::string>& by) {
  return by.empty() ? std::string() : fmt::format("{} by {}", kind, fmt::join(by, ", "));
}

}  // namespace crest::cli
