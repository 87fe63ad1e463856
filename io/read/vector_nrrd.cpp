// SPDX-License-Identifier: GPL-3.0-or-later
// Vectors on a grid from NRRD: the first axis holds the components.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "io/formats/volume.hpp"
#include "io/read/plane_grid.hpp"

namespace crest::io {
namespace {

/// From point to point along the axes after the first, which is none of space.
std::vector<kernel::Vec3> steps_of(const Volume& volume) {
  auto steps = volume.steps;
  const bool space = std::any_of(steps[0].begin(), steps[0].end(), [](double x) { return x != 0; });
  if (space)
    fail("kinds", "do not say that the first axis holds vectors",
         "add 'kinds: 2-vector space space' to the header");
  steps.erase(steps.begin());
  return steps;
}

}  // namespace

PlaneGrid read_vector_nrrd(const std::string& path, const VectorRequest& request,
                           PlanarFieldFile& file) {
  VolumeRequest wanted;
  wanted.companion = [&](const std::string& name) {
    return load((std::filesystem::path(path).parent_path() / name).string());
  };
  const FileBytes bytes = load(path);
  const Volume volume = read_nrrd(bytes, wanted);
  const auto& size = volume.size;
  if (size.size() < 3 || size.size() > 4 || (size[0] != 2 && size[0] != 3))
    fail("sizes", "are not those of vectors on a grid",
         "give 2 or 3 components, columns, rows (and layers), in this order");
  const std::size_t layers = size.size() == 4 ? size[3] : 1;
  if (layers > 1 && !request.slice)
    fail("grid", fmt::format("has {} layers", layers), "choose one with --slice K, from 0");
  const auto layer = static_cast<std::size_t>(request.slice.value_or(0));
  if (layer >= layers)
    fail("slice", fmt::format("{} does not exist", layer), "layers count from 0");
  if (!request.field.empty() && request.field != "vectors")
    fail(fmt::format("array '{}'", request.field), "does not exist",
         "an NRRD file has one, 'vectors'");
  file.field = "vectors";
  const auto steps = steps_of(volume);
  if (steps[0][2] != 0 || steps[1][2] != 0)
    fail("space directions", "of columns and rows leave the plane of x and y", "turn the grid");
  PlaneGrid grid{size[1], size[2], {}, {}};
  const auto number = [&](std::size_t i) {
    return std::visit([i](const auto& x) { return static_cast<double>(x[i]); }, volume.samples);
  };
  for (std::size_t j = 0; j < grid.ny; ++j)
    for (std::size_t i = 0; i < grid.nx; ++i) {
      const double a = static_cast<double>(i), b = static_cast<double>(j);
      const kernel::Vec2 p = {volume.origin[0] + a * steps[0][0] + b * steps[1][0],
                              volume.origin[1] + a * steps[0][1] + b * steps[1][1]};
      if (!std::isfinite(p[0]) || !std::isfinite(p[1]))
        fail("space directions", "lead beyond all numbers", "correct the NRRD header");
      grid.points.push_back(p);
      const std::size_t at = size[0] * ((layer * grid.ny + j) * grid.nx + i);
      grid.vectors.push_back({number(at), number(at + 1)});
    }
  return grid;
}

}  // namespace crest::io
