// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Meshes from files that may be packed (.xz).
#include <sys/wait.h>

#include <cstdio>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>

#include "io/read/mesh_reader.hpp"

namespace crest::experiments {

/// As io::read_mesh; NAME.ply.xz is unpacked by the program xz. Nothing if there is no such
/// program. Throws: kernel::InputError; std::runtime_error if xz fails.
inline std::optional<io::MeshFile> read_mesh(const std::string& path) {
  if (!path.ends_with(".xz")) return io::read_mesh(path);
  std::string quoted = "'";
  for (const char c : path) quoted += c == '\'' ? "'\\''" : std::string(1, c);
  const std::string command = "command -v xz >/dev/null || exit 9; xz -dc -- " + quoted + "'";
  std::FILE* pipe = popen(command.c_str(), "r");
  if (!pipe) throw std::runtime_error(path + ": no shell to unpack it");
  std::string bytes;
  char buffer[1 << 16];
  for (std::size_t n = 0; (n = std::fread(buffer, 1, sizeof buffer, pipe)) > 0;)
    bytes.append(buffer, n);
  const int status = pclose(pipe);
  if (WIFEXITED(status) && WEXITSTATUS(status) == 9) return std::nullopt;
  if (status != 0) throw std::runtime_error(path + ": xz cannot unpack it");
  return io::read_mesh_bytes(path.substr(0, path.size() - 3), std::move(bytes));
}

}  // namespace crest::experiments
