// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/write/atomic_file.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <signal.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <utility>

#include "kernel/geometry/input_error.hpp"

namespace crest::io {
namespace {

namespace fs = std::filesystem;

[[noreturn]] void fail(const std::string& path, int error) {
  throw kernel::InputError(path + ": file: cannot be written (" + std::strerror(error) +
                           "); choose a folder that can be written and has room");
}

bool write_all(int descriptor, std::string_view bytes) {
  while (!bytes.empty()) {
    const ssize_t n = ::write(descriptor, bytes.data(), bytes.size());
    if (n < 0 && errno == EINTR) continue;
    if (n < 0) return false;
    bytes.remove_prefix(static_cast<std::size_t>(n));
  }
  return true;
}

/// mkstemp creates files only their owner reads; an output is an ordinary file.
mode_t ordinary_mode() {
  const mode_t mask = ::umask(0);
  ::umask(mask);
  return 0666 & ~mask;
}

using Writing = std::function<void(const Sink&)>;

/// Of the pieces written to a descriptor, the error of the first that failed; 0: none did.
int write_pieces(int descriptor, const Writing& write) {
  int error = 0;
  write([&](std::string_view piece) {
    if (error == 0 && !write_all(descriptor, piece)) error = errno;
  });
  return error;
}

void write_directly(const std::string& path, const Writing& write) {
  const int descriptor = ::open(path.c_str(), O_WRONLY | O_CLOEXEC);
  if (descriptor < 0) fail(path, errno);
  int error = 0;
  try {
    error = write_pieces(descriptor, write);
  } catch (...) {
    ::close(descriptor);
    throw;
  }
  if (::close(descriptor) != 0 && error == 0) error = errno;
  if (error != 0) fail(path, error);
}

/// The file that a symbolic link names, else the path itself.
std::string target_of(const std::string& path) {
  std::error_code error;
  if (!fs::is_symlink(path, error)) return path;
  const fs::path resolved = fs::weakly_canonical(path, error);
  return error ? path : resolved.string();
}

/// A device or pipe: there is nothing to rename. Throws for a folder.
bool is_special(const std::string& path, const std::string& target) {
  std::error_code ignored;
  const fs::file_status status = fs::status(target, ignored);
  if (fs::is_directory(status)) fail(path, EISDIR);
  return fs::exists(status) && !fs::is_regular_file(status);
}

std::string folder_of(const std::string& target) {
  const fs::path folder = fs::path(target).parent_path();
  return folder.empty() ? "." : folder.string();
}

/// The kernel's name of an open file.
std::string open_name(int descriptor) {
  return fmt::format("/proc/self/fd/{}", descriptor);
}

/// A new file without a name in the folder of `target`; -1 where the file system, or a missing
/// /proc, cannot give it one later.
int open_unnamed(const std::string& path, const std::string& target) {
  const int descriptor = ::open(folder_of(target).c_str(), O_TMPFILE | O_WRONLY | O_CLOEXEC, 0666);
  if (descriptor >= 0) {
    if (::access(open_name(descriptor).c_str(), F_OK) == 0) return descriptor;
    ::close(descriptor);
    return -1;
  }
  // EISDIR: a kernel that does not know O_TMPFILE.
  if (errno != EOPNOTSUPP && errno != EISDIR && errno != EINVAL) fail(path, errno);
  return -1;
}

class IgnoreInterrupts {
 public:
  IgnoreInterrupts() {
    struct sigaction ignore {};
    ignore.sa_handler = SIG_IGN;
    for (const int i : {0, 1}) ::sigaction(kSignals[i], &ignore, &before_[i]);
  }
  ~IgnoreInterrupts() {
    for (const int i : {0, 1}) ::sigaction(kSignals[i], &before_[i], nullptr);
  }
  IgnoreInterrupts(const IgnoreInterrupts&) = delete;
  IgnoreInterrupts& operator=(const IgnoreInterrupts&) = delete;

 private:
  static constexpr int kSignals[] = {SIGINT, SIGTERM};
  struct sigaction before_[2];
};

PendingFiles* current = nullptr;

}  // namespace

/// One held file: an open descriptor without a name, or (descriptor_ < 0) the bytes.
class PendingFiles::File {
 public:
  File(const std::string& path, const std::string& target)
      : path_(path), target_(target), descriptor_(open_unnamed(path, target)) {}
  /// By the other one, so that a writing that throws closes the file.
  File(const std::string& path, const std::string& target, const Writing& write)
      : File(path, target) {
    if (descriptor_ < 0)
      write([&](std::string_view piece) { bytes_ += piece; });
    else if (const int error = write_pieces(descriptor_, write))
      fail(path_, error);
  }
  ~File() {
    if (descriptor_ >= 0) ::close(descriptor_);
    if (!temporary_.empty()) ::unlink(temporary_.c_str());
  }
  File(File&& other) noexcept
      : path_(std::move(other.path_)),
        target_(std::move(other.target_)),
        temporary_(std::exchange(other.temporary_, {})),
        bytes_(std::move(other.bytes_)),
        descriptor_(std::exchange(other.descriptor_, -1)) {}
  File& operator=(File&&) = delete;

  /// All that can fail for want of room. An old file is replaced by renaming: no link does that.
  void prepare() {
    if (descriptor_ < 0) return store_beside();
    std::error_code ignored;
    if (fs::exists(target_, ignored)) link_beside();
  }
  void appear() {
    if (temporary_.empty()) {
      if (link_to(target_)) return;
      if (errno != EEXIST) fail(path_, errno);
      link_beside();  // it was made meanwhile
    }
    if (std::rename(temporary_.c_str(), target_.c_str()) != 0) fail(path_, errno);
    temporary_.clear();
  }

 private:
  bool link_to(const std::string& name) const {
    return ::linkat(AT_FDCWD, open_name(descriptor_).c_str(), AT_FDCWD, name.c_str(),
                    AT_SYMLINK_FOLLOW) == 0;
  }
  void link_beside() {
    for (int number = 0; temporary_.empty(); ++number) {
      const std::string name = fmt::format("{}.{}-{}", target_, ::getpid(), number);
      if (link_to(name))
        temporary_ = name;
      else if (errno != EEXIST)
        fail(path_, errno);
    }
  }
  void store_beside() {
    std::string name = target_ + ".XXXXXX";
    const int descriptor = ::mkstemp(name.data());
    if (descriptor < 0) fail(path_, errno);
    temporary_ = name;
    int error = 0;
    if (!write_all(descriptor, bytes_) || ::fchmod(descriptor, ordinary_mode()) != 0) error = errno;
    if (::close(descriptor) != 0 && error == 0) error = errno;
    if (error != 0) fail(path_, error);
  }

  std::string path_, target_, temporary_, bytes_;
  int descriptor_;
};

bool PendingFiles::any() {
  return current != nullptr;
}

PendingFiles::PendingFiles() : outer_(std::exchange(current, this)) {}

PendingFiles::~PendingFiles() {
  current = outer_;
}

void PendingFiles::commit() {
  const IgnoreInterrupts guard;
  std::vector<File> files = std::exchange(files_, {});
  for (File& file : files) file.prepare();
  for (File& file : files) file.appear();
}

void write_atomically(const std::string& path, std::string_view bytes) {
  write_atomically(path, [&](const Sink& sink) { sink(bytes); });
}

void write_atomically(const std::string& path, const std::function<void(const Sink&)>& write) {
  const std::string target = target_of(path);
  if (is_special(path, target)) return write_directly(path, write);
  if (current) {
    current->files_.emplace_back(path, target, write);
    return;
  }
  PendingFiles alone;
  alone.files_.emplace_back(path, target, write);
  alone.commit();
}

void require_writable(const std::string& path) {
  const std::string target = target_of(path);
  if (is_special(path, target)) return;
  if (const int descriptor = open_unnamed(path, target); descriptor >= 0) {
    ::close(descriptor);
    return;
  }
  if (::access(folder_of(target).c_str(), W_OK | X_OK) != 0) fail(path, errno);
}

}  // namespace crest::io
