// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The files a run writes: all of them appear complete at the end, or none does.
#include <functional>
#include <string>
#include <vector>

#include "io/write/atomic_file.hpp"

namespace crest::cli {

/// Usage: add() every file before the long work (a place that cannot be written is found out then),
/// write() each, commit() at the end. Without commit() nothing is left behind.
class Outputs {
 public:
  /// Announces the file `path` of `option`; an empty path is no file.
  /// Throws: UsageError for an extension not in `extensions` (empty list: any) or a path given
  ///   twice; kernel::InputError when no file can be made there.
  void add(const std::string& option, const std::string& path,
           const std::vector<std::string>& extensions = {});

  /// True if add() was called with a non-empty path for this option.
  bool wanted(const std::string& option) const;

  /// Calls `writer` with the file's name, if it is wanted; it writes with io::write_atomically().
  void write(const std::string& option, const std::function<void(const std::string&)>& writer);

  /// Lets the written files appear. Throws kernel::InputError.
  void commit() { pending_.commit(); }

 private:
  struct File {
    std::string option, path, place;
  };
  std::vector<File> files_;
  io::PendingFiles pending_;
};

}  // namespace crest::cli
