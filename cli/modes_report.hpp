// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The report and the summary of crest modes.
#include <string>
#include <vector>

#include "algorithms/modes/zero_set.hpp"
#include "cli/report.hpp"
#include "io/read/tet_reader.hpp"

namespace crest::cli {

class ModesReport {
 public:
  ModesReport(Report& report, const modes::ModeField& field, const io::TensorFile& file,
              const modes::ZeroSet& zeros);
  void add(const modes::ModeResult& result);
  void finish();

  const std::vector<std::string>& warnings() const { return warnings_; }
  const std::string& summary() const { return summary_; }
  std::size_t undecided() const { return undecided_; }
  bool exhausted() const { return exhausted_; }

 private:
  std::int64_t cell(kernel::Index tet) const;
  Report& report_;
  const io::TensorFile& file_;
  const modes::ZeroSet& zeros_;
  Json surfaces_ = Json::array();
  modes::ModeCounts counts_;
  std::vector<std::string> warnings_;
  std::string summary_;
  std::size_t undecided_ = 0;
  bool exhausted_ = false;
};

}  // namespace crest::cli
