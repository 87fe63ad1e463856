// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/outputs.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

#include "cli/command.hpp"

namespace crest::cli {
namespace {

namespace fs = std::filesystem;

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

}  // namespace

void Outputs::add(const std::string& option, const std::string& path,
                  const std::vector<std::string>& extensions) {
  if (path.empty()) return;
  check_extension(option, path, extensions);
  std::error_code ignored;
  const fs::path resolved = fs::weakly_canonical(path, ignored);
  const std::string place = resolved.empty() ? path : resolved.string();
  for (const File& other : files_)
    if (other.place == place)
      throw UsageError(fmt::format("{} and {} name the same file", other.option, option));
  io::require_writable(path);
  files_.push_back({option, path, place});
}

bool Outputs::wanted(const std::string& option) const {
  return std::any_of(files_.begin(), files_.end(),
                     [&](const File& file) { return file.option == option; });
}

void Outputs::write(const std::string& option,
                    const std::function<void(const std::string&)>& writer) {
  for (const File& file : files_)
    if (file.option == option) writer(file.path);
}

}  // namespace crest::cli
