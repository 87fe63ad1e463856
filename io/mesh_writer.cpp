// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/mesh_writer.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <iterator>

#include "io/atomic_file.hpp"
#include "kernel/geometry/input_error.hpp"

namespace crest::io {
namespace {

std::string lower_extension(const std::string& path) {
  std::string extension = std::filesystem::path(path).extension().string();
  std::transform(extension.begin(), extension.end(), extension.begin(),
                 [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c + 32) : c; });
  return extension;
}

}  // namespace

void write_mesh(const std::string& path, const std::vector<kernel::Vec3>& points,
                const std::vector<kernel::Triangle>& faces) {
  const std::string extension = lower_extension(path);
  const bool off = extension == ".off";
  if (!off && extension != ".obj") {
    throw kernel::InputError(path + ": unknown extension; write .off or .obj");
  }
  fmt::memory_buffer text;
  auto out = std::back_inserter(text);
  if (off) fmt::format_to(out, "OFF\n{} {} 0\n", points.size(), faces.size());
  for (const kernel::Vec3& p : points) {
    fmt::format_to(out, "{}{} {} {}\n", off ? "" : "v ", p[0], p[1], p[2]);
  }
  for (const kernel::Triangle& f : faces) {
    if (off) {
      fmt::format_to(out, "3 {} {} {}\n", f[0], f[1], f[2]);
    } else {
      fmt::format_to(out, "f {} {} {}\n", f[0] + 1, f[1] + 1, f[2] + 1);
    }
  }
  write_atomically(path, std::string_view(text.data(), text.size()));
}

}  // namespace crest::io
