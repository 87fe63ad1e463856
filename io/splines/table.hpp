// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Tables of numbers: CSV with a row of names first.
// Own code: VTK's reader needs 4 s for a million rows, and its columns are texts.
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace crest::io {

struct Table {
  std::vector<std::vector<double>> columns;  ///< as they were asked for
  std::size_t rows = 0;
};

/// Reads these columns, all numbers finite. Names and fields may be in quotation marks, commas,
/// semicolons or tabs separate them: what the row of names has; blank lines do not count.
/// Throws: kernel::InputError "FILE: ELEMENT: PROBLEM; REMEDY", one line: a column is missing, a
/// field is no finite number (rows are counted from 0, lines from 1), there is no row.
Table read_table(const std::string& path, const std::vector<std::string>& columns);

/// The same for a file that is in memory: `name` stands in messages.
Table read_table_bytes(const std::string& name, std::string_view bytes,
                       const std::vector<std::string>& columns);

/// Writes columns of one length, 17 digits a number; what is not a number as `nan`. Guarantees: no
/// half-written file.
void write_table(const std::string& path, const std::vector<std::string>& names,
                 std::span<const std::span<const double>> columns);

}  // namespace crest::io
