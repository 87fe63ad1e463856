// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Output files appear whole or not at all, one by one or several together.
#include <functional>
#include <string>
#include <string_view>
#include <vector>

namespace crest::io {

/// Writes `bytes` to a file without a name in the folder of `path`, then gives it this name (where
/// the file system has no such files: to a temporary file beside `path`, which is renamed). A
/// target that is a symbolic link keeps being one; a device or pipe is written directly.
/// Guarantees: on failure, or when the process is killed, the old file, if any, is untouched and
///   nothing new is left behind (a temporary name exists for a moment while an old file is
///   replaced).
/// Throws: kernel::InputError, one line naming the file.
void write_atomically(const std::string& path, std::string_view bytes);

/// The same for a file of pieces, which `write` hands to its argument one after the other.
using Sink = std::function<void(std::string_view)>;
void write_atomically(const std::string& path, const std::function<void(const Sink&)>& write);

/// Throws kernel::InputError as write_atomically() would if no file can be made at `path`.
void require_writable(const std::string& path);

/// Several files that appear together: while this object lives, write_atomically() holds its files
/// back, complete and without a name, until commit(). One at a time, in one thread.
class PendingFiles {
 public:
  PendingFiles();
  ~PendingFiles();
  PendingFiles(const PendingFiles&) = delete;
  PendingFiles& operator=(const PendingFiles&) = delete;

  /// Lets all held files appear; SIGINT and SIGTERM are ignored meanwhile.
  /// Throws: kernel::InputError; files not yet in place then never appear.
  void commit();
  /// Whether files are held back now, here or by a caller.
  static bool any();

 private:
  friend void write_atomically(const std::string& path,
                               const std::function<void(const Sink&)>& write);
  class File;
  std::vector<File> files_;
  PendingFiles* outer_;
};

}  // namespace crest::io
