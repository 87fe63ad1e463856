// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The meshes of the shared data for the tests of coding and strips.
#include <string>
#include <vector>

#include "io/read/surface_reader.hpp"
#include "tests/coding/meshes.hpp"
#include "tests/support/shared_data.hpp"

namespace crest::tests {

/// The oriented manifolds of the shared data, polygons cut into triangles.
inline const std::vector<std::string> kSharedMeshes = {"anchor.off",
                                                       "armadillo.off",
                                                       "b9_mesh.off",
                                                       "bones.off",
                                                       "bunny_3k.off",
                                                       "cheese.off",
                                                       "cube_no_bottom.obj",
                                                       "dino.off",
                                                       "disk.obj",
                                                       "double-torus-example.off",
                                                       "elephant.off",
                                                       "fandisk.off",
                                                       "featuretype.STL",
                                                       "fertility.off",
                                                       "head.off",
                                                       "homer.obj",
                                                       "horse.ply",
                                                       "joint.off",
                                                       "kitten.obj",
                                                       "knot1.off",
                                                       "lilium.obj",
                                                       "lion-head.off",
                                                       "man.off",
                                                       "max-planck_decimated.obj",
                                                       "penguin.obj",
                                                       "pinion.off",
                                                       "plane_holes.obj",
                                                       "rocker-arm.obj",
                                                       "rotor.off",
                                                       "spot.obj",
                                                       "springer.obj",
                                                       "stanford-bunny.obj",
                                                       "stratocaster.ply",
                                                       "torus.obj"};

inline PlainMesh read_plain(const std::string& path) {
  io::SurfaceFile file = io::read_surface(path);
  return {std::move(file.points), std::move(file.faces)};
}

}  // namespace crest::tests
