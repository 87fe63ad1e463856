// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Volumes that are read box by box.
#include <optional>
#include <string>

#include "io/formats/image_pieces.hpp"
#include "io/read/volume_reader.hpp"
#include "kernel/geometry/piece.hpp"

namespace crest::io {

/// Of files of plain samples (--raw; .nrrd of encoding raw) only what a box needs is read, of .pvti
/// the pieces that the box meets; other files are read whole, and kept.
class VolumeBoxes {
 public:
  /// Throws as read_volume() does, but for the values of plain samples and of pieces.
  VolumeBoxes(const std::string& path, const VolumeSource& source);

  /// Without samples.
  const kernel::SampledGrid& frame() const { return frame_.grid; }
  const std::vector<std::string>& warnings() const { return frame_.warnings; }
  /// Throws as read_volume() does of the values in the box: they are named by their place in the
  /// whole.
  kernel::SampledGrid::Samples read(const kernel::GridBox& box) const;

 private:
  void open_pieces(const VolumeSource& source);

  std::string path_;
  VolumeFile frame_;
  std::optional<kernel::SampledGrid> whole_;
  std::optional<ImagePieces> pieces_;
  std::size_t offset_ = 0;
  bool big_endian_ = false;
};

}  // namespace crest::io
