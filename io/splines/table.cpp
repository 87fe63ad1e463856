// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/splines/table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <iterator>

#include "io/formats/files.hpp"
#include "io/formats/text_scan.hpp"
#include "io/write/atomic_file.hpp"

namespace crest::io {
namespace {

constexpr std::string_view kByteOrderMark = "\xef\xbb\xbf";

std::string_view trimmed(std::string_view text) {
  constexpr const char* blanks = " \t\r";
  const std::size_t first = std::min(text.find_first_not_of(blanks), text.size());
  text.remove_prefix(first);
  return text.substr(0, text.find_last_not_of(blanks) + 1);
}

/// Takes the lines of a table one by one.
class Lines {
 public:
  explicit Lines(std::string_view bytes) : left_(bytes) {
    if (left_.starts_with(kByteOrderMark)) left_.remove_prefix(kByteOrderMark.size());
  }
  /// Moves to the next line that is not blank.
  bool next() {
    while (!left_.empty()) {
      const std::size_t end = std::min(left_.find('\n'), left_.size());
      line_ = left_.substr(0, end);
      left_.remove_prefix(std::min(end + 1, left_.size()));
      ++number_;
      if (!trimmed(line_).empty()) return true;
    }
    return false;
  }
  std::string_view line() const { return line_; }
  std::size_t number() const { return number_; }

 private:
  std::string_view left_, line_;
  std::size_t number_ = 0;
};

/// Takes a field and the separator behind it off a line.
std::string_view take_field(std::string_view& line, char separator) {
  std::size_t at = 0;
  while (at < line.size() && line[at] != separator && line[at] != '"') ++at;
  if (at < line.size() && line[at] == '"') {
    const std::size_t close = line.find('"', at + 1);
    at = close == line.npos ? line.size() : std::min(line.find(separator, close), line.size());
  }
  std::string_view field = trimmed(line.substr(0, at));
  line.remove_prefix(std::min(at + 1, line.size()));
  if (field.size() >= 2 && field.front() == '"' && field.back() == '"')
    field = trimmed(field.substr(1, field.size() - 2));
  return field;
}

bool to_number(std::string_view field, double& value) {
  if (field.starts_with('+')) field.remove_prefix(1);
  const char* const end = field.data() + field.size();
  const auto result = std::from_chars(field.data(), end, value);
  return result.ptr == end && result.ec == std::errc{};
}

/// The row of names.
struct Header {
  char separator = ',';
  std::vector<std::string> names;

  explicit Header(std::string_view line) {
    for (const char c : {';', '\t'})
      if (line.find(',') == line.npos && line.find(c) != line.npos) separator = c;
    while (!line.empty()) names.emplace_back(take_field(line, separator));
  }
  std::string list() const {
    constexpr std::size_t most = 20;
    std::string all;
    for (std::size_t i = 0; i < std::min(names.size(), most); ++i)
      all += (i == 0 ? "" : ", ") + io::quoted(names[i]);
    return names.size() > most ? all + ", .." : all;
  }
  /// Where the columns stand.
  std::vector<std::size_t> places_of(const std::vector<std::string>& columns) const {
    double number;
    if (std::all_of(names.begin(), names.end(),
                    [&](const std::string& name) { return to_number(name, number); }))
      fail("row of names", "there is none", "write the columns' names into the first line");
    std::vector<std::size_t> places;
    for (const std::string& column : columns) {
      const auto found = std::find(names.begin(), names.end(), column);
      if (found == names.end())
        fail("column " + io::quoted(column), "does not exist; the table has " + list(),
             column == "z" ? "samples of the plane are not fitted, give those of space"
                           : "name the columns as asked for, or choose with --columns");
      if (std::find(found + 1, names.end(), column) != names.end())
        fail("column " + io::quoted(column), "is there several times", "give them different names");
      places.push_back(static_cast<std::size_t>(found - names.begin()));
    }
    return places;
  }
};

void read_rows(Lines& lines, const Header& header, const std::vector<std::string>& columns,
               Table& table) {
  const auto places = header.places_of(columns);
  const std::size_t last = *std::max_element(places.begin(), places.end());
  std::vector<std::string_view> fields(last + 1);
  while (lines.next()) {
    std::string_view line = lines.line();
    for (std::string_view& field : fields) field = take_field(line, header.separator);
    for (std::size_t c = 0; c < places.size(); ++c) {
      double value;
      if (!to_number(fields[places[c]], value) || !std::isfinite(value))
        fail(fmt::format("row {} (line {})", table.rows, lines.number()),
             fmt::format("its '{}' is {}", columns[c],
                         fields[places[c]].empty() ? "missing" : io::quoted(fields[places[c]])) +
                 ", no finite number",
             "correct it or leave the row out");
      table.columns[c].push_back(value);
    }
    ++table.rows;
  }
}

Table parse(std::string_view bytes, const std::vector<std::string>& columns) {
  Lines lines(bytes);
  if (!lines.next()) fail("file", "is empty", "write a row of names and rows of numbers");
  Table table;
  table.columns.resize(columns.size());
  read_rows(lines, Header(lines.line()), columns, table);
  if (table.rows == 0) fail("rows", "there are none", "write numbers below the row of names");
  return table;
}

}  // namespace

Table read_table_bytes(const std::string& name, std::string_view bytes,
                       const std::vector<std::string>& columns) {
  Table table;
  read_named(name, [&] { table = parse(bytes, columns); });
  return table;
}

Table read_table(const std::string& path, const std::vector<std::string>& columns) {
  Table table;
  read_named(path, [&] {
    const FileBytes bytes = load(path);
    table = parse(bytes, columns);
  });
  return table;
}

void write_table(const std::string& path, const std::vector<std::string>& names,
                 std::span<const std::span<const double>> columns) {
  fmt::memory_buffer text;
  fmt::format_to(std::back_inserter(text), "{}\n", fmt::join(names, ","));
  const std::size_t rows = columns.empty() ? 0 : columns[0].size();
  for (std::size_t r = 0; r < rows; ++r)
    for (std::size_t c = 0; c < columns.size(); ++c) {
      const double x = columns[c][r];
      if (std::isnan(x))
        text.append(std::string_view("nan"));
      else
        fmt::format_to(std::back_inserter(text), "{:.17g}", x);
      text.push_back(c + 1 == columns.size() ? '\n' : ',');
    }
  write_atomically(path, {text.data(), text.size()});
}

}  // namespace crest::io
