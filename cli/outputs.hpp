// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The files a run writes: all of them appear complete at the end, or none does.
#include <functional>
#include <string>
#include <vector>

namespace crest::cli {

/// Usage: add() every file before the long work (a place that cannot be written is found out then),
/// write() each, commit() at the end. Without commit() nothing is left behind.
class Outputs {
 public:
  Outputs() = default;
  ~Outputs();
  Outputs(const Outputs&) = delete;
  Outputs& operator=(const Outputs&) = delete;

  /// Announces the file `path` of `option`; an empty path is no file.
  /// Throws: UsageError for an extension not in `extensions` (empty list: any) or a path given
  ///   twice; kernel::InputError when no file can be made there.
  void add(const std::string& option, const std::string& path,
           const std::vector<std::string>& extensions = {});

  /// True if add() was called with a non-empty path for this option.
  bool wanted(const std::string& option) const;

  /// Calls `writer` with the name of a temporary file beside the final one (same extension).
  /// Errors of the writer come out as kernel::InputError naming the final file.
  void write(const std::string& option, const std::function<void(const std::string&)>& writer);

  /// Renames the written files into place. Throws kernel::InputError.
  void commit();

 private:
  struct File {
    std::string option, path, temporary;
    bool written;
  };
  std::vector<File> files_;
};

}  // namespace crest::cli
