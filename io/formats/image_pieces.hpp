// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Volumes whose pieces are files of their own (.pvti), read box by box.
#include "io/formats/parallel_index.hpp"
#include "io/formats/volume.hpp"
#include "kernel/geometry/piece.hpp"

namespace crest::io {

class ImagePieces {
 public:
  /// `request.companion` loads pieces. Throws kernel::InputError. Origin, spacing and directions
  /// are those of the first piece: the others must have the same.
  ImagePieces(std::string_view index, VolumeRequest request);

  /// Without samples, which have the type of its variant.
  const Volume& frame() const { return frame_; }
  /// In the order of a grid of the box; of nodes that several pieces hold those of the last one.
  /// Loads the pieces that the box meets, one after the other. Throws where no piece has a node.
  Samples read(const kernel::GridBox& box) const;

 private:
  void of_piece(std::size_t k, const std::function<void(vtkImageData&)>& use) const;

  ParallelIndex index_;
  VolumeRequest request_;
  Volume frame_;
  std::array<double, 15> placement_{};  ///< origin, spacing, directions
};

}  // namespace crest::io
