// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/outputs.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <filesystem>

#include "cli/command.hpp"
#include "kernel/geometry/input_error.hpp"

namespace crest::cli {
namespace {

namespace fs = std::filesystem;
using kernel::InputError;

std::string temporary_beside(const fs::path& path, std::size_t number) {
  const std::string name =
      fmt::format(".crest-{}-{}{}", getpid(), number, path.extension().string());
  return (path.parent_path() / name).string();
}

void check_extension(const std::string& option, const fs::path& path,
                     const std::vector<std::string>& extensions) {
  if (extensions.empty()) return;
  std::string extension = path.extension().string();
  std::transform(extension.begin(), extension.end(), extension.begin(),
                 [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c + 32) : c; });
  std::string known;
  for (const std::string& e : extensions) {
    if (extension == e) return;
    known += (known.empty() ? "" : ", ") + e;
  }
  throw UsageError(
      fmt::format("{} {}: unknown extension; use one of {}", option, path.string(), known));
}

/// Makes and removes the temporary file: the only sure way to learn whether it can be made.
void probe(const std::string& path, const std::string& temporary) {
  const int file = ::open(temporary.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
  if (file < 0)
    throw InputError(fmt::format("{}: cannot be written: {}", path, std::strerror(errno)));
  ::close(file);
  ::unlink(temporary.c_str());
}

}  // namespace

Outputs::~Outputs() {
  for (const File& file : files_)
    if (file.written && file.temporary != file.path) ::unlink(file.temporary.c_str());
}

void Outputs::add(const std::string& option, const std::string& path,
                  const std::vector<std::string>& extensions) {
  if (path.empty()) return;
  check_extension(option, path, extensions);
  std::error_code ignored;
  // Through a symbolic link the file it names is replaced, not the link.
  const fs::path resolved = fs::weakly_canonical(path, ignored);
  const std::string place = resolved.empty() ? path : resolved.string();
  const auto status = fs::status(place, ignored);
  if (fs::is_directory(status)) throw InputError(path + ": cannot be written: is a directory");
  for (const File& other : files_)
    if (other.path == place)
      throw UsageError(fmt::format("{} and {} name the same file", other.option, option));
  if (fs::exists(status) && !fs::is_regular_file(status)) {  // a device or pipe: written directly
    files_.push_back({option, place, place, false});
    return;
  }
  const std::string temporary = temporary_beside(place, files_.size());
  probe(path, temporary);
  files_.push_back({option, place, temporary, false});
}

bool Outputs::wanted(const std::string& option) const {
  return std::any_of(files_.begin(), files_.end(),
                     [&](const File& file) { return file.option == option; });
}

void Outputs::write(const std::string& option,
                    const std::function<void(const std::string&)>& writer) {
  for (File& file : files_) {
    if (file.option != option) continue;
    file.written = true;
    try {
      writer(file.temporary);
    } catch (const std::bad_alloc&) {
      throw;
    } catch (const std::exception& error) {
      std::string what = error.what();
      if (const auto at = what.find(file.temporary); at != std::string::npos)
        what.replace(at, file.temporary.size(), file.path);
      else
        what = file.path + ": " + what;
      throw InputError(what);
    }
  }
}

void Outputs::commit() {
  for (File& file : files_) {
    if (!file.written || file.temporary == file.path) continue;
    if (std::rename(file.temporary.c_str(), file.path.c_str()) != 0)
      throw InputError(fmt::format("{}: cannot be written: {}", file.path, std::strerror(errno)));
    file.written = false;
  }
}

}  // namespace crest::cli
