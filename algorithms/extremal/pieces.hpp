// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The extraction piece by piece: for volumes that do not fit the memory, and for many machines.
//
//   records of every piece (samples with a halo at hand) -> join -> mesh -> values at its places,
//   of every piece again -> result
//
// One piece is the whole grid: extract() of extremal.hpp takes the same way. So the result does not
// depend on how the grid is cut.
#include <functional>
#include <span>

#include "algorithms/extremal/assembly.hpp"
#include "algorithms/extremal/certificate.hpp"
#include "algorithms/extremal/extraction.hpp"

namespace crest::extremal {

/// What is known of a volume before a sample is read.
struct VolumeFrame {
  std::array<Index, 3> size{};
  Vec3 spacing{1, 1, 1}, origin{0, 0, 0};

  Grid grid() const { return {size, spacing, origin}; }
};

/// The samples of a box of the volume, as a volume of its own.
using ReadBox = std::function<Volume(const kernel::GridBox&)>;
Volume part_of(const Volume& volume, const kernel::GridBox& box);

/// Owned nodes with their halo. Throws kernel::InputError as extract does, where it can be seen
/// without samples.
kernel::GridPiece piece_of(const VolumeFrame& frame, const Options& options,
                           const kernel::GridBox& owned);

/// What the piece's nodes own. Throws as extract does: samples are named by their place in the
/// whole.
Records records_of(const Volume& part, const kernel::GridPiece& piece, const Options& options,
                   const Meshes& meshes);
/// Values at places that the piece owns.
std::vector<AtPlace> values_of(const Volume& part, const kernel::GridPiece& piece,
                               const Options& options, std::span<const Vec3> places);

/// Which of the pieces own a place each, in order; boxes by place in `owned`.
class Owners {
 public:
  Owners(const VolumeFrame& frame, const Options& options, std::vector<kernel::GridBox> owned);
  std::size_t of(const Vec3& place) const;

 private:
  kernel::GridSize size_{};
  int levels_;
  std::vector<kernel::GridBox> owned_;
};

/// The joined pieces' result; `values` as in Assembly. With `certificate` all but its samples and
/// their type are filled.
Result assemble(const VolumeFrame& frame, const Options& options, Records joined,
                const ValuesAt& values, certify::ExtremalCertificate* certificate);

/// One piece after the other; `read` is asked for a box three times at most.
Result extract_in_pieces(const VolumeFrame& frame, const Options& options,
                         const std::vector<kernel::GridBox>& owned, const ReadBox& read,
                         certify::ExtremalCertificate* certificate);

}  // namespace crest::extremal
