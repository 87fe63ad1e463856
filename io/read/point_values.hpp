// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The numbers a file gives its points: one path for all formats and commands.
#include <optional>
#include <string>
#include <vector>

#include "io/formats/soup.hpp"
#include "kernel/geometry/index.hpp"

namespace crest::io {

/// A scalar field of a soup: of its points, or of its cells, taken as the mean over the faces
/// around a point.
class PointValues {
 public:
  /// The scalar field of that name, points first; an empty name: the only one of the points, or if
  /// they have none of the cells. Throws: kernel::InputError with the scalar fields there are, or
  /// with `remedy` if there are none.
  PointValues(const Soup& soup, const std::string& name, const std::string& remedy);

  const std::string& name() const { return field_->name; }
  /// What was done to get them, or nothing.
  std::optional<std::string> note() const;
  /// Without loss for a field of points. Throws: kernel::InputError naming the point if it has no
  /// value, one that is not finite, or an integer beyond 2^53, which would be rounded so that ties
  /// appear.
  double at(kernel::Index point) const;

 private:
  void average();

  const Soup& soup_;
  const Field* field_ = nullptr;
  bool of_cells_ = false;
  std::vector<double> means_;         ///< of fields of cells
  std::vector<std::uint32_t> faces_;  ///< around each point
};

/// The normals of these points, as long as the file has them: those that it says are normals, else
/// a field "Normals". Throws: kernel::InputError if there are none, or naming a point whose normal
/// is zero or not finite.
std::vector<kernel::Vec3> point_normals(const Soup& soup, const std::vector<kernel::Index>& points);

}  // namespace crest::io
