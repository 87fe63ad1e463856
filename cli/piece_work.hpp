// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Volumes extracted piece by piece: by this process, one after the other, or by those of crest-mpi.
#include <functional>
#include <span>
#include <string>

#include "algorithms/extremal/pieces.hpp"
#include "io/read/volume_boxes.hpp"

namespace crest::cli {

/// All that whoever works on a piece has to know.
struct PieceJob {
  std::string input;
  io::VolumeSource source;
  extremal::VolumeFrame frame;
  extremal::Options options;
  extremal::Meshes meshes;
  std::vector<kernel::GridBox> owned;
  std::string restart;  ///< folder of finished pieces; empty: none is kept
};

extremal::VolumeFrame frame_of(const kernel::SampledGrid& grid);

/// The records of a piece, from the folder of finished pieces where they are there; else they are
/// put there. Throws kernel::InputError: bad samples, a folder with pieces of another run.
extremal::Records piece_records(const PieceJob& job, const io::VolumeBoxes& boxes,
                                std::size_t piece);
std::vector<extremal::AtPlace> piece_values(const PieceJob& job, const io::VolumeBoxes& boxes,
                                            std::size_t piece,
                                            std::span<const kernel::Vec3> places);

/// Who works on the pieces.
struct PieceEngine {
  std::size_t least_pieces = 1;  ///< how many pieces there must be, if nobody says
  /// Of all pieces, joined.
  std::function<extremal::Records(const PieceJob&, const io::VolumeBoxes&)> records;
  /// At places in pieces: `of` says which.
  std::function<std::vector<extremal::AtPlace>(const PieceJob&, const io::VolumeBoxes&,
                                               const std::vector<std::size_t>& of,
                                               std::span<const kernel::Vec3>)>
      values;
};
/// This process, unless the program sets another.
PieceEngine& piece_engine();

/// The result by the engine; with `certificate` all of it is filled.
extremal::Result extract_pieces(const PieceJob& job, const io::VolumeBoxes& boxes,
                                certify::ExtremalCertificate* certificate);

}  // namespace crest::cli
