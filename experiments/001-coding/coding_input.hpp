// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The meshes of the experiments on coding: nothing mended, .xz unpacked.
#include <algorithm>
#include <filesystem>
#include <string>
#include <vector>

#include "experiments/packed_mesh.hpp"
#include "io/read/surface_reader.hpp"
#include "kernel/geometry/input_error.hpp"

namespace crest::experiments {

struct CodingInput {
  std::vector<kernel::Vec3> points;
  std::vector<kernel::Triangle> faces;
  kernel::Index vertices() const { return static_cast<kernel::Index>(points.size()); }
};

inline CodingInput read_coding_input(const std::string& path) {
  if (std::filesystem::path(path).extension() == ".xz") {
    const auto file = read_mesh(path);
    if (!file) throw kernel::InputError(path + ": file: is packed and there is no xz; install it");
    return {file->mesh.points(), file->mesh.faces()};
  }
  io::SurfaceFile file = io::read_surface(path);
  return {std::move(file.points), std::move(file.faces)};
}

/// Files of the folders, by name.
inline std::vector<std::filesystem::path> files_of(const std::vector<std::string>& folders) {
  std::vector<std::filesystem::path> files;
  for (const std::string& folder : folders)
    if (std::filesystem::is_directory(folder))
      for (const auto& entry : std::filesystem::directory_iterator(folder))
        if (entry.is_regular_file()) files.push_back(entry.path());
  std::sort(files.begin(), files.end(),
            [](const auto& a, const auto& b) { return a.filename() < b.filename(); });
  return files;
}

}  // namespace crest::experiments
