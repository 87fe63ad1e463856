// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Claim 3 from bytes that nobody has checked.
#include <span>

#include "certify/container/buffer.hpp"
#include "certify/reeb/records.hpp"

namespace crest::certify {

/// A ReebCertificate for checking: the positions, on which nothing depends, stay in the bytes.
struct ReebContents {
  std::size_t vertices = 0;
  std::span<const std::uint8_t> positions;
  Buffer<std::array<std::uint32_t, 3>> faces;
  Buffer<double> values, edge_values;
  std::int32_t euler_characteristic = 0;
  std::uint32_t boundary_loops = 0, components = 0;
  std::uint32_t line_critical = 0, face_critical = 0, tiles = 0;
  std::uint32_t minima = 0, saddles = 0, maxima = 0;
  Buffer<std::uint32_t> order, critical_nodes;
  Buffer<ArcRecord> arcs;
  Buffer<CutRecord> cuts;
  std::uint32_t tied_arcs = 0, contracted_nodes = 0;
};

/// Both sections. Throws Malformed. The number of midpoint values is what the data
/// section's length leaves: whether it is the number of edges is a check of step 1.
ReebContents open_reeb(std::span<const std::uint8_t> data, std::span<const std::uint8_t> claims);
/// The same as the producer's struct.
ReebCertificate decode_reeb(std::span<const std::uint8_t> data,
                            std::span<const std::uint8_t> claims);

}  // namespace crest::certify
