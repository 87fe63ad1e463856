// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The numbers and sections of Gmsh files, text or binary.
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "io/formats/text_scan.hpp"

namespace crest::io {

/// Positions by tag: a table where the tags are dense, as they mostly are.
class TagTable {
 public:
  /// Throws for a tag that is there twice; `what` names its owner.
  TagTable(const std::vector<std::int64_t>& tags, const char* what);
  /// Nothing for a tag that is not there.
  std::optional<std::size_t> find(std::int64_t tag) const;

 private:
  std::int64_t first_ = 0;
  std::vector<std::size_t> table_;  ///< from first_ on
  std::unordered_map<std::int64_t, std::size_t> map_;
};

class MshSource {
 public:
  explicit MshSource(std::string_view bytes) : bytes_(bytes), scan_(bytes) {}

  /// Takes the next "$NAME"; empty at the file's end.
  std::string next_section();
  const std::string& section() const { return section_; }
  /// Moves behind the section's end. Throws if it has none.
  void end_section();
  /// The numbers that follow are binary; the mark tells their byte order.
  void set_binary();
  bool binary() const { return binary_; }

  /// To be called before the first word of a line. Throws at the section's end.
  void begin_line();
  void end_line() { scan_.next_line(); }
  bool in_line() { return scan_.in_line(); }
  std::string_view rest_of_line() { return scan_.rest_of_line(); }
  /// A word of this line, in binary files, too.
  std::int64_t word_integer();
  double word_real();

  /// Before and after the binary part of a section, which follows its lines.
  void begin_record() {
    if (!binary_) begin_line();
  }
  void end_record() {
    if (!binary_) end_line();
  }
  std::int64_t integer() { return binary_ ? load<std::int32_t>() : word_integer(); }
  std::int64_t size() { return binary_ ? load<std::int64_t>() : word_integer(); }
  double real() { return binary_ ? load<double>() : word_real(); }

  std::size_t line_number() const { return scan_.line(); }
  std::string line() const;
  /// "element 7 (line 12)"; "element 7" in a binary file.
  std::string name_of(const char* what, std::int64_t tag) const;

 private:
  [[noreturn]] void fail_end() const;
  void require_word();
  template <class T>
  T load();

  std::string_view bytes_;
  TextScan scan_;
  std::string section_;
  bool binary_ = false, big_endian_ = false;
};

}  // namespace crest::io
