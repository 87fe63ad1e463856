// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The words and arrays of VTK's legacy files, text or binary.
#include <string>
#include <vector>

#include "io/formats/binary.hpp"
#include "io/formats/text_scan.hpp"

namespace crest::io {

/// The type of an array: one of NumberType's or bits, of which binary files pack eight in a byte.
struct LegacyType {
  NumberType number = NumberType::f64;
  bool bits = false;
};

class LegacySource {
 public:
  /// Reads the header.
  explicit LegacySource(std::string_view bytes);
  bool binary() const { return binary_; }
  double version() const { return version_; }

  /// Takes the keyword of the next section, in lower case; false at the file's end.
  bool next_section();
  const std::string& section() const { return section_; }
  /// "points (line 5)".
  std::string where() const;

  /// Words of the line; each throws if it is not what is wanted.
  std::string_view take_word();
  std::string take_name();  ///< with %20 and the like decoded
  std::size_t take_count();
  double take_real();
  LegacyType take_type();
  bool in_line() { return scan_.in_line(); }
  /// Whether the next word, on this line or a later one, is `lower` in any case; takes its line.
  bool take_line_of(std::string_view lower);
  /// Passes over the lines up to a blank one, which ends METADATA.
  void skip_block();
  void skip_lines(std::size_t count);
  /// Moves to the next word of a later line. Throws at the file's end.
  void require_more();

  /// Takes `count` numbers from here, or from the next line in a binary file.
  Field::Numbers take(LegacyType type, std::size_t count);
  std::vector<std::int64_t> take_integers(LegacyType type, std::size_t count);
  void skip(LegacyType type, std::size_t count);
  /// a b. Throws where that overflows.
  std::size_t product(std::size_t a, std::size_t b) const;

 private:
  std::string_view take_bytes(LegacyType type, std::size_t count);
  [[noreturn]] void fail_end() const;
  void require_words(std::size_t count) const;
  template <class T>
  std::vector<T> take_words(std::size_t count);

  TextScan scan_;
  std::string section_ = "header";
  bool binary_ = false;
  double version_ = 0;
};

}  // namespace crest::io
