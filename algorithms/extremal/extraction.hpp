// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// All that is decided of a piece of the grid, and of places in it.
#include "algorithms/extremal/components.hpp"
#include "algorithms/extremal/records.hpp"

namespace crest::extremal {

class Extraction {
 public:
  /// The whole grid as one piece.
  Extraction(Fields fields, const Options& options);
  /// Requires: the fields are those of the piece's nodes (all of them).
  Extraction(Fields fields, const Options& options, const std::optional<kernel::GridPiece>& piece);
  Extraction(const Extraction&) = delete;  // Its parts refer to each other.
  Extraction& operator=(const Extraction&) = delete;

  const Options& options() const { return options_; }
  const Fields& fields() const { return fields_; }
  const kernel::GridPiece& piece() const { return piece_; }
  const Nodes& nodes() const { return nodes_; }
  const Cells& cells() const { return cells_; }
  const Edges& edges() const { return edges_; }
  const Faces& faces() const { return faces_; }

  /// What the piece's own nodes own.
  Records records(const Meshes& meshes) const;
  /// All that is left is to be thrown away.
  Fields take_fields() { return std::move(fields_); }
  /// The mesh with all that is reported, of the whole grid.
  Result result(bool critical) const;

 private:
  Options options_;
  Fields fields_;
  kernel::GridPiece piece_;  ///< of the refined grid
  Nodes nodes_;
  Cells cells_;
  Edges edges_;
  Faces faces_;
};

/// Values at places of the whole grid (in its units), of those that the piece owns.
std::vector<AtPlace> values_at(const Fields& fields, const kernel::GridPiece& piece,
                               std::span<const Vec3> places);
/// The node that owns a place.
Node owner_of(const kernel::GridSize& size, const Vec3& place);

/// A piece of the samples' grid on the grid that is halved so many times.
kernel::GridPiece refined(const kernel::GridPiece& piece, int levels);

}  // namespace crest::extremal
