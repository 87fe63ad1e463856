// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The bytes of many streams as one number, which every compiler, optimisation and machine must
// give.
#include <cstdio>
#include <string>

#include "algorithms/coding/container.hpp"
#include "tests/coding/damaged_streams.hpp"

namespace crest::tests {

/// Of all methods, places, attributes, orders and clearance on generated meshes: spheres, stacked
/// and flipped, tori with holes, several components. `count`: how many streams there were. What is
/// decoded is part of it. Sixteen hexadecimal digits.
inline std::string digest_of_streams(int& count) {
  Random random(kSeed);
  std::vector<coding::Bytes> streams = some_streams(random);
  std::vector<PlainMesh> meshes = {torus_grid(40, 30), stacked_sphere(300, random),
                                   punch_holes(joined_tori(3, 7, 9), 3, random)};
  flip_edges(meshes.emplace_back(torus_grid(50, 60)), 9000, random);
  flip_edges(meshes.emplace_back(stacked_sphere(2000, random)), 20000, random);
  for (const PlainMesh& mesh : meshes)
    for (int i = 0; i < 15; ++i) {
      coding::EncodeOptions options;
      if (i % 5 < 4) options.method = static_cast<coding::Method>(i % 5);
      options.places = static_cast<coding::Places>(i / 5);
      options.tolerance = 0.03;
      streams.push_back(coding::encode(mesh.vertices(), mesh.faces, mesh.points, options).stream);
    }
  count = static_cast<int>(streams.size());
  coding::Bytes all;
  for (const coding::Bytes& stream : streams) {
    all.insert(all.end(), stream.begin(), stream.end());
    const coding::Decoded decoded = coding::decode(stream);
    const auto head = coding::mesh_digest(decoded.info.vertices, decoded.faces, decoded.points);
    all.insert(all.end(), head.begin(), head.end());
  }
  std::string words;
  for (const std::uint8_t byte : coding::digest_head(all)) {
    char digits[3];
    std::snprintf(digits, sizeof digits, "%02x", byte);
    words += digits;
  }
  return words;
}

}  // namespace crest::tests
