#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# Starts a new system: a skeleton that compiles, is tested, and has its command, its experiment and
# a page for its claim. CONTRIBUTING.md says how to go on from there.
#   scripts/new-system.sh NAME     NAME: lower case letters, digits, underscores
set -eu
root=$(cd "$(dirname "$0")/.." && pwd)
cd "$root"

usage() {
  echo "usage: scripts/new-system.sh NAME (lower case letters, digits, underscores)" >&2
  exit 2
}
[ $# -eq 1 ] || usage
name=$1
case $name in
  "" | [!a-z]* | *[!a-z0-9_]* | kernel | certify | io | cli | support | install | fuzz | architecture)
    usage ;;
esac
for place in "algorithms/$name" "tests/$name" "experiments/$name" "cli/${name}_command.cpp"; do
  if [ -e "$place" ]; then
    echo "new-system.sh: $place exists" >&2
    exit 1
  fi
done

# instantiate FILE: the template from stdin, NAME replaced.
instantiate() {
  mkdir -p "$(dirname "$1")"
  sed "s/@NAME@/$name/g" >"$1"
  echo "  $1"
}
echo "Made:"

instantiate "algorithms/$name/$name.hpp" <<'END'
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The public calls of this system (theory and limits: README.md beside this file).
#include "kernel/geometry/triangle_mesh.hpp"

namespace crest::@NAME@ {

/// Counts of the mesh's cells. boundary_edges: edges with one face.
struct Census {
  kernel::Index vertices = 0, edges = 0, faces = 0, boundary_edges = 0;
  int euler_characteristic = 0;
};

/// Counts the cells of the mesh. Cost: O(E).
Census take_census(const kernel::TriangleMesh& mesh);

}  // namespace crest::@NAME@
END

instantiate "algorithms/$name/$name.cpp" <<'END'
// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/@NAME@/@NAME@.hpp"

namespace crest::@NAME@ {

Census take_census(const kernel::TriangleMesh& mesh) {
  Census census;
  census.vertices = mesh.vertex_count();
  census.edges = mesh.edge_count();
  census.faces = mesh.face_count();
  census.euler_characteristic = mesh.euler_characteristic();
  for (const kernel::Edge& edge : mesh.edges()) {
    if (edge.f0 == kernel::kNone || edge.f1 == kernel::kNone) ++census.boundary_edges;
  }
  return census;
}

}  // namespace crest::@NAME@
END

instantiate "algorithms/$name/README.md" <<'END'
# @NAME@

Paper: which one, its key in references.bib, the sections this folder implements.

## Theory
What is computed, in the paper's words and letters; letter -> meaning -> equation.

## Claim
What the certificate states, under which hypotheses, and by which theorem (certify/SPEC.md has the
format; the checker's file is certify/verify_@NAME@.cpp and shares nothing with this folder).

## Limits
What is decided exactly, what is estimated, what is refused.
END

instantiate "cli/${name}_command.cpp" <<'END'
// SPDX-License-Identifier: GPL-3.0-or-later
// crest @NAME@: in the table through this file's name (cli/CMakeLists.txt).
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <memory>

#include "algorithms/@NAME@/@NAME@.hpp"
#include "cli/run.hpp"
#include "io/read/mesh_reader.hpp"

namespace crest::cli {
namespace {

struct Options {
  CommonOptions common;
};

Outcome work(Run& run) {
  const io::MeshFile file = run.read(io::read_mesh);
  const auto census =
      run.step("count", "counting", [&] { return @NAME@::take_census(file.mesh); });
  Report& report = run.report();
  report["vertices"] = census.vertices;
  report["faces"] = census.faces;
  report["boundary_edges"] = census.boundary_edges;
  report["euler_characteristic"] = census.euler_characteristic;
  return {fmt::format("{} vertices, {} faces, Euler characteristic {}\n", census.vertices,
                      census.faces, census.euler_characteristic)};
}

std::function<int()> add(CLI::App& app) {
  auto options = std::make_shared<Options>();
  app.add_option("INPUT", options->common.input, "triangle mesh")->required();
  app.add_option("--report", options->common.report, "counts and times (.json)")->type_name("FILE");
  add_run_options(app, options->common);
  return [options] { return run_command({"@NAME@", options->common, {}}, work); };
}

}  // namespace

extern const Command @NAME@_command;
const Command @NAME@_command = {
    "@NAME@",
    "the cells of a triangle mesh, counted",
    add,
    {"crest @NAME@ ellipsoid.off",  //
     "crest @NAME@ ellipsoid.off --quiet --report census.json"}};

}  // namespace crest::cli
END

instantiate "tests/$name/${name}_test.cpp" <<'END'
// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/@NAME@/@NAME@.hpp"

#include <catch2/catch.hpp>

using crest::kernel::TriangleMesh;

TEST_CASE("a tetrahedron has 4 vertices, 6 edges, 4 faces and no boundary") {
  const TriangleMesh mesh({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}},
                          {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {0, 3, 2}});
  const auto census = crest::@NAME@::take_census(mesh);
  CHECK(census.vertices == 4);
  CHECK(census.edges == 6);
  CHECK(census.faces == 4);
  CHECK(census.boundary_edges == 0);
  CHECK(census.euler_characteristic == 2);
}

TEST_CASE("a single triangle has three boundary edges") {
  const TriangleMesh mesh({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}});
  CHECK(crest::@NAME@::take_census(mesh).boundary_edges == 3);
}
END

instantiate "experiments/$name/${name}_table.cpp" <<'END'
// SPDX-License-Identifier: GPL-3.0-or-later
// The paper's table beside ours: one line a mesh given on the command line.
#include <fmt/format.h>

#include <exception>

#include "algorithms/@NAME@/@NAME@.hpp"
#include "io/read/mesh_reader.hpp"

int main(int argc, char** argv) try {
  fmt::print("{:<40} {:>9} {:>9} {:>5}\n", "mesh", "vertices", "faces", "chi");
  for (int i = 1; i < argc; ++i) {
    const auto file = crest::io::read_mesh(argv[i]);
    const auto census = crest::@NAME@::take_census(file.mesh);
    fmt::print("{:<40} {:>9} {:>9} {:>5}\n", argv[i], census.vertices, census.faces,
               census.euler_characteristic);
  }
  return 0;
} catch (const std::exception& error) {
  fmt::print(stderr, "{}\n", error.what());
  return 3;
}
END

echo "Next: CONTRIBUTING.md, \"A new system\", from step 2 on."
