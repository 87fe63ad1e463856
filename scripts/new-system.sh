#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# Starts a new system: a skeleton that compiles, is tested, and has its command, its experiment, its
# claim's room with a checker, and mutation tests. CONTRIBUTING.md says how to go on from there.
#   scripts/new-system.sh NAME [--input KIND]
# NAME: lower case letters, digits, underscores. KIND: what the system computes from; asked for on a
# terminal. mesh: a triangle mesh; field: a triangle mesh with a number a vertex; tetrahedra;
# grid: hexahedra; points: points alone.
set -eu
root=$(cd "$(dirname "$0")/.." && pwd)
cd "$root"

kinds="mesh tetrahedra grid field points"
usage() {
  echo "usage: scripts/new-system.sh NAME --input mesh|tetrahedra|grid|field|points" \
    "(NAME: lower case letters, digits, underscores)" >&2
  exit 2
}
name=
input=
while [ $# -gt 0 ]; do
  case $1 in
    --input) [ $# -ge 2 ] || usage; input=$2; shift ;;
    -*) usage ;;
    *) [ -z "$name" ] || usage; name=$1 ;;
  esac
  shift
done
case $name in
  "" | [!a-z]* | *[!a-z0-9_]* | *__* | *_) usage ;;
  kernel | certify | io | cli | support | install | fuzz | architecture) usage ;;
  container | exact | surface) usage ;;
esac
if [ -z "$input" ] && [ -t 0 ]; then
  printf 'What does it compute from (%s)? ' "$kinds"
  read -r input
fi
case " $kinds " in
  *" ${input:-none} "*) ;;
  *) usage ;;
esac
for place in "algorithms/$name" "certify/$name" "tests/$name" "experiments/$name" \
    "cli/${name}_command.cpp"; do
  if [ -e "$place" ]; then
    echo "new-system.sh: $place exists" >&2
    exit 1
  fi
done

# The reader of a file of cells; without it there is nothing to read these inputs with.
case $input in
  tetrahedra | grid | points)
    if ! [ -e io/formats/soup.hpp ]; then
      echo "new-system.sh: no reader for $input here (io/formats/soup.hpp)" >&2
      exit 1
    fi ;;
esac
# Corners of a cell; type of cells in VTK's words; what the text calls the input and the cells.
case $input in
  mesh) corners=3 cell=triangle words="triangle mesh" cells=faces ;;
  field) corners=3 cell=triangle words="triangle mesh with a number a vertex" cells=faces ;;
  tetrahedra) corners=4 cell=tetrahedron words="tetrahedra" cells=tetrahedra ;;
  grid) corners=8 cell=hexahedron words="hexahedra" cells=hexahedra ;;
  points) corners=1 cell=vertex words="points" cells=points ;;
esac
dashed=$(echo "$name" | tr _ -)
camel=$(echo "$name" | awk -F_ '{ for (i = 1; i <= NF; ++i)
  printf "%s%s", toupper(substr($i, 1, 1)), substr($i, 2) }')
number=$(sed -n 's/^inline constexpr std::uint32_t k[A-Za-z0-9]* = \([0-9]*\), k[A-Za-z0-9]*Version.*/\1/p' \
  certify/*/records.hpp | sort -n | tail -n 1)
number=$((number + 1))

# instantiate FILE: the template from stdin. A line that ends in "@ KIND..." is kept, without the
# mark, for these kinds only.
instantiate() {
  mkdir -p "$(dirname "$1")"
  awk -v kind="$input" '
    match($0, / *@( [a-z]+)+$/) {
      if (index(substr($0, RSTART) " ", " " kind " ") == 0) next
      $0 = substr($0, 1, RSTART - 1)
    }
    { print }' |
    sed -e "s/@NAME@/$name/g" -e "s/@DASHED@/$dashed/g" -e "s/@CAMEL@/$camel/g" \
      -e "s/@NUMBER@/$number/g" -e "s/@CORNERS@/$corners/g" -e "s/@WORDS@/$words/g" \
      -e "s/@CELLS@/$cells/g" -e "s/@CELL@/$cell/g" >"$1"
  echo "  $1"
}
echo "Made:"

instantiate "algorithms/$name/$name.hpp" <<'END'
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The public calls of this system (theory and limits: README.md beside this file).
#include <array>
#include <cstdint>
#include <vector>

#include "kernel/arithmetic/vec3.hpp"

namespace crest::@NAME@ {

/// What the system computes from: @WORDS@.
struct Input {
  std::vector<kernel::Vec3> points;
  std::vector<std::array<std::uint32_t, @CORNERS@>> cells;  ///< by their corners
  std::vector<double> values;  ///< one a point@ field
};

struct Census {
  std::uint32_t distinct = 0;  ///< places with a point
  std::uint32_t used = 0;      ///< points that are corners of cells
};

/// Counts the input's points. Requires: finite points, corners below their number.
/// Cost: O(V log V + C).
Census take_census(const Input& input);

}  // namespace crest::@NAME@
END

instantiate "algorithms/$name/$name.cpp" <<'END'
// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/@NAME@/@NAME@.hpp"

#include <set>

namespace crest::@NAME@ {

Census take_census(const Input& input) {
  const std::set<kernel::Vec3> places(input.points.begin(), input.points.end());
  std::set<std::uint32_t> corners;
  for (const auto& cell : input.cells) corners.insert(cell.begin(), cell.end());
  return {static_cast<std::uint32_t>(places.size()), static_cast<std::uint32_t>(corners.size())};
}

}  // namespace crest::@NAME@
END

instantiate "algorithms/$name/certificate.hpp" <<'END'
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// A census as claim @DASHED@ (certify/@NAME@/SPEC.md).
#include "algorithms/@NAME@/@NAME@.hpp"
#include "certify/@NAME@/encode.hpp"

namespace crest::@NAME@ {

certify::@CAMEL@Certificate make_certificate(const Input& input, const Census& census);

}  // namespace crest::@NAME@
END

instantiate "algorithms/$name/certificate.cpp" <<'END'
// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/@NAME@/certificate.hpp"

namespace crest::@NAME@ {

certify::@CAMEL@Certificate make_certificate(const Input& input, const Census& census) {
  certify::@CAMEL@Certificate c;
  c.points = input.points;
  c.cells = input.cells;
  for (const double x : input.values) c.values.push_back({x});@ field
  c.distinct = census.distinct;
  c.used = census.used;
  return c;
}

}  // namespace crest::@NAME@
END

instantiate "algorithms/$name/README.md" <<'END'
# @NAME@

Paper: which one, its key in references.bib, the sections this folder implements.

## Theory
What is computed, in the paper's words and letters.

| letter | meaning | where |
|---|---|---|
| Input, Census | the @WORDS@; what is counted | `@NAME@.hpp` |

## Pipeline
| step | file |
|---|---|
| the call | `@NAME@.hpp` |
| the certificate | `certificate.hpp` |

## Claim
What the certificate states, under which hypotheses, and by which theorem: claim @NUMBER@, certify/@NAME@/SPEC.md;
the checker is certify/@NAME@/claim.cpp.

## Limits
What is decided exactly, what is estimated, what is refused.
END

instantiate "certify/$name/SPEC.md" <<'END'
# Claim @NUMBER@: @DASHED@

Version 1. State here what later versions change.

## Data section
| bytes | content |
|---|---|
| u32 V, u32 C | points, cells |
| V x 3 f64 | positions |
| C x @CORNERS@ u32 | cells: corners below V |
| V x f64 | a number a point |@ field

## Definitions
The *places* are the different triples among the positions. A point is *used* if it is a corner of a cell.

## Claim section
| bytes | content |
|---|---|
| u32 | places |
| u32 | used points |

## What the checker proves, in order
1. The file is well formed, the seal and the data digest match, corners are below V.
2. The number of places.
3. The number of used points.
END

instantiate "certify/$name/records.hpp" <<'END'
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The certificate of claim @NUMBER@, @DASHED@, as plain structs (SPEC.md).
#include <array>
#include <cstdint>
#include <vector>

namespace crest::certify {

inline constexpr std::uint32_t k@CAMEL@ = @NUMBER@, k@CAMEL@Version = 1;

struct @CAMEL@Certificate {
  std::vector<std::array<double, 3>> points;                ///< V
  std::vector<std::array<std::uint32_t, @CORNERS@>> cells;  ///< C
  std::vector<std::array<double, 1>> values;                ///< V@ field
  std::uint32_t distinct = 0, used = 0;
};

}  // namespace crest::certify
END

instantiate "certify/$name/encode.hpp" <<'END'
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Claim @NUMBER@ as bytes: all that a producer needs.
#include "certify/@NAME@/records.hpp"
#include "certify/certificate.hpp"

namespace crest::certify {

/// The file's bytes, sealed. Throws std::invalid_argument for lists whose lengths do not fit.
/// Cost: linear.
Bytes encode(const @CAMEL@Certificate& certificate);

}  // namespace crest::certify
END

instantiate "certify/$name/encode.cpp" <<'END'
// SPDX-License-Identifier: GPL-3.0-or-later
#include "certify/@NAME@/encode.hpp"

#include "certify/container/compose.hpp"

namespace crest::certify {

Bytes encode(const @CAMEL@Certificate& c) {
  if (c.values.size() != c.points.size())@ field
    throw std::invalid_argument("certificate: as many numbers as points are needed");@ field
  std::size_t data_size = 8 + sizeof(double) * 3 * c.points.size();
  data_size += sizeof(std::uint32_t) * @CORNERS@ * c.cells.size();
  data_size += sizeof(double) * c.values.size();@ field
  const auto write_data = [&](ByteWriter& out) {
    out.count(c.points.size());
    out.count(c.cells.size());
    out.rows(c.points);
    for (const auto& cell : c.cells) out.numbers(std::span<const std::uint32_t>(cell));
    out.rows(c.values);@ field
  };
  const auto write_claims = [&](ByteWriter& out) {
    out.integer(c.distinct);
    out.integer(c.used);
  };
  return compose({k@CAMEL@, k@CAMEL@Version}, data_size, write_data, write_claims);
}

}  // namespace crest::certify
END

instantiate "certify/$name/decode.hpp" <<'END'
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Claim @NUMBER@ from bytes that nobody has checked.
#include <span>

#include "certify/@NAME@/records.hpp"

namespace crest::certify {

/// Both sections. Throws Malformed.
@CAMEL@Certificate decode_@NAME@(std::span<const std::uint8_t> data,
                                 std::span<const std::uint8_t> claims);

}  // namespace crest::certify
END

instantiate "certify/$name/decode.cpp" <<'END'
// SPDX-License-Identifier: GPL-3.0-or-later
#include "certify/@NAME@/decode.hpp"

#include "certify/container/plain_numbers.hpp"

namespace crest::certify {

@CAMEL@Certificate decode_@NAME@(std::span<const std::uint8_t> data,
                                 std::span<const std::uint8_t> claims) {
  @CAMEL@Certificate c;
  ByteReader reader(data);
  const std::size_t points = reader.integer<std::uint32_t>();
  const std::size_t cells = reader.integer<std::uint32_t>();
  reader.rows(c.points, points);
  require_plain_rows(c.points, "positions");
  reader.rows(c.cells, cells);
  reader.rows(c.values, points);@ field
  require_plain_rows(c.values, "numbers");@ field
  if (reader.left() != 0) throw Malformed("data section: bytes left over");
  reader = ByteReader(claims);
  c.distinct = reader.integer<std::uint32_t>();
  c.used = reader.integer<std::uint32_t>();
  if (reader.left() != 0) throw Malformed("claim section: bytes left over");
  return c;
}

}  // namespace crest::certify
END

instantiate "certify/$name/claim.cpp" <<'END'
// SPDX-License-Identifier: GPL-3.0-or-later
// Claim @NUMBER@, @DASHED@: the steps of SPEC.md in order.
#include <algorithm>

#include "certify/@NAME@/decode.hpp"
#include "certify/container/checker.hpp"
#include "certify/container/prove.hpp"
#include "certify/container/reject.hpp"
#include "certify/surface/input_tie.hpp"@ mesh

namespace crest::certify {
namespace {

std::size_t count_used(const @CAMEL@Certificate& c) {
  std::vector<std::uint8_t> used(c.points.size(), 0);
  for (const auto& cell : c.cells)
    for (const std::uint32_t v : cell) {
      require(v < used.size(), "cells: no point {}", v);
      used[v] = 1;
    }
  return static_cast<std::size_t>(std::count(used.begin(), used.end(), 1));
}

void verify_@NAME@(std::span<const std::uint8_t> data, std::span<const std::uint8_t> claims,
                   const VerifyOptions& options, Verdict& verdict) {
  const @CAMEL@Certificate c = decode_@NAME@(data, claims);
  const std::size_t used = count_used(c);
  prove(verdict, "data: {} points, {} cells; digests match", c.points.size(), c.cells.size());
  if (options.input) {@ mesh
    check_input(*options.input, c.points, c.cells);@ mesh
    prove(verdict, "input: {} holds the same positions and faces", options.input->name);@ mesh
  }@ mesh
  if (options.input)@ field tetrahedra grid points
    throw TieUnavailable("@DASHED@: no reader for its input is trusted");@ field tetrahedra grid points
  auto places = c.points;
  std::sort(places.begin(), places.end());
  require_equal(c.distinct, std::unique(places.begin(), places.end()) - places.begin(), "places");
  prove(verdict, "places: {}", c.distinct);
  require_equal(c.used, used, "used points");
  prove(verdict, "used points: {}", c.used);
}

}  // namespace

extern const ClaimChecker @NAME@_claim;
const ClaimChecker @NAME@_claim = {k@CAMEL@, k@CAMEL@Version, "@DASHED@", verify_@NAME@};

}  // namespace crest::certify
END

instantiate "cli/${name}_command.cpp" <<'END'
// SPDX-License-Identifier: GPL-3.0-or-later
// crest @NAME@: in the table through this file's name (cli/CMakeLists.txt).
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <memory>

#include "algorithms/@NAME@/certificate.hpp"
#include "cli/run.hpp"
#include "io/formats/files.hpp"@ tetrahedra grid points
#include "io/formats/readers.hpp"@ tetrahedra grid points

namespace crest::cli {
namespace {

struct @CAMEL@Options {
  CommonOptions common;
  std::string field;@ field
};

@NAME@::Input read_input(Run& run, const @CAMEL@Options&) {@ mesh
@NAME@::Input read_input(Run& run, const @CAMEL@Options& o) {@ field tetrahedra grid points
  io::MeshRequest request;@ field
  request.field = o.field;@ field
  const io::MeshFile file = run.read_mesh(request);@ field
  const io::MeshFile file = run.read_mesh();@ mesh
  @NAME@::Input input;@ mesh field
  input.points = file.mesh.points();@ mesh field
  input.cells = file.mesh.faces();@ mesh field
  input.values = file.values;@ field
  return input;@ mesh field
  return run.step("read", "reading " + o.common.input, [&] {@ tetrahedra grid points
    @NAME@::Input input;@ tetrahedra grid points
    io::read_named(o.common.input, [&] {@ tetrahedra grid points
      const io::Soup soup = io::read_vtu(io::load(o.common.input), {});@ tetrahedra grid points
      input.points = soup.points;@ tetrahedra grid points
      for (std::size_t c = 0; c < soup.cells.size(); ++c) {@ tetrahedra grid points
        const auto nodes = soup.cells.nodes(c);@ tetrahedra grid points
        if (soup.cells.type(c) != io::CellType::@CELL@ || nodes.size() != @CORNERS@)@ tetrahedra grid points
          io::fail("cell " + std::to_string(soup.cell_tag(c)), "is no @CELL@", "leave it out");@ tetrahedra grid points
        auto& cell = input.cells.emplace_back();@ tetrahedra grid points
        for (std::size_t k = 0; k < nodes.size(); ++k) {@ tetrahedra grid points
          if (nodes[k] < 0 || static_cast<std::size_t>(nodes[k]) >= soup.points.size())@ tetrahedra grid points
            io::fail("cell " + std::to_string(soup.cell_tag(c)), "has a node that does not exist",@ tetrahedra grid points
                     "export the file again");@ tetrahedra grid points
          cell[k] = static_cast<std::uint32_t>(nodes[k]);@ tetrahedra grid points
        }@ tetrahedra grid points
      }@ tetrahedra grid points
    });@ tetrahedra grid points
    return input;@ tetrahedra grid points
  });@ tetrahedra grid points
}

Outcome work(Run& run, const @CAMEL@Options& o) {
  const @NAME@::Input input = read_input(run, o);
  const auto census = run.step("count", "counting", [&] { return @NAME@::take_census(input); });
  Report& report = run.report();
  report["points"] = input.points.size();
  report["cells"] = input.cells.size();
  report["places"] = census.distinct;
  report["used_points"] = census.used;
  run.write_certificate("@DASHED@", certify::encode(@NAME@::make_certificate(input, census)));
  return {fmt::format("{} points at {} places, {} of them corners of {} @CELLS@\n",
                      input.points.size(), census.distinct, census.used, input.cells.size())};
}

std::function<int()> add_@NAME@(CLI::App& app) {
  auto options = std::make_shared<@CAMEL@Options>();
  CommonOptions& common = options->common;
  app.add_option("INPUT", common.input, "triangle mesh")->required();@ mesh
  app.add_option("INPUT", common.input, "triangle mesh with fields (.vtp)")->required();@ field
  app.add_option("INPUT", common.input, "@WORDS@ (.vtu)")->required();@ tetrahedra grid points
  app.add_option("--field", options->field, "the numbers' name")->required()->type_name("NAME");@ field
  app.add_option("--report", common.report, "counts and times (.json)")->type_name("FILE");
  app.add_option("--certificate", common.certificate, "the counts' proof")->type_name("FILE");
  add_run_options(app, common);
  add_clean_options(app, common.clean, true);@ mesh field
  return [options] {
    return run_command({"@NAME@", options->common, {}},
                       [&](Run& run) { return work(run, *options); });
  };
}

}  // namespace

extern const Command @NAME@_command;
const Command @NAME@_command = {
    "@NAME@",
    "the points of @WORDS@, counted",
    add_@NAME@,
    {"crest @NAME@ ellipsoid.off",@ mesh
     "crest @NAME@ ellipsoid.off --quiet --certificate census.crest"}};@ mesh
    {"crest @NAME@ ellipsoid-curvature.vtp --field k1",@ field
     "crest @NAME@ ellipsoid-curvature.vtp --field k1 --certificate census.crest"}};@ field
    {"crest @NAME@ cells.vtu",@ tetrahedra grid points
     "crest @NAME@ cells.vtu --quiet --certificate census.crest"}};@ tetrahedra grid points

}  // namespace crest::cli
END

instantiate "tests/$name/${name}_test.cpp" <<'END'
// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/@NAME@/@NAME@.hpp"

#include <catch2/catch.hpp>

#include "tests/@NAME@/samples.hpp"

using namespace crest::tests;

TEST_CASE("points are counted by place, and those that are corners of cells") {
  const auto census = crest::@NAME@::take_census(one_cell());
  CHECK(census.distinct == @CORNERS@);
  CHECK(census.used == @CORNERS@);
  auto twice = one_cell();
  twice.points.push_back(twice.points.front());
  CHECK(crest::@NAME@::take_census(twice).distinct == @CORNERS@);
  CHECK(crest::@NAME@::take_census(twice).used == @CORNERS@);
  CHECK(crest::@NAME@::take_census({}).distinct == 0);
}
END

instantiate "tests/$name/samples.hpp" <<'END'
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Inputs with known answers.
#include "algorithms/@NAME@/@NAME@.hpp"

namespace crest::tests {

/// One cell with corners at different places.
inline @NAME@::Input one_cell() {
  @NAME@::Input input;
  input.cells.emplace_back();
  for (std::uint32_t k = 0; k < @CORNERS@; ++k) {
    input.points.push_back({0.5 * (k & 1), 0.25 * (k >> 1 & 1), 2.0 * (k >> 2)});
    input.cells[0][k] = k;
    input.values.push_back(k);@ field
  }
  return input;
}

}  // namespace crest::tests
END

instantiate "tests/$name/mutation_test.cpp" <<'END'
// SPDX-License-Identifier: GPL-3.0-or-later
// The claim is accepted, and no changed one is that is not true of its own data.
#include <catch2/catch.hpp>

#include "algorithms/@NAME@/certificate.hpp"
#include "certify/@NAME@/decode.hpp"
#include "certify/container/container.hpp"
#include "certify/verify.hpp"
#include "tests/@NAME@/samples.hpp"
#include "tests/support/failures.hpp"

using namespace crest::certify;
using namespace crest::tests;

namespace {

Bytes certificate() {
  const auto input = one_cell();
  return encode(crest::@NAME@::make_certificate(input, crest::@NAME@::take_census(input)));
}

/// Counted anew, by the producer. The data must be of the right form.
bool is_true(const Bytes& bytes) {
  const Container container = open_container(bytes);
  const auto c = decode_@NAME@(container.data, container.claims);
  crest::@NAME@::Input input;
  input.points = c.points;
  input.cells = c.cells;
  const auto census = crest::@NAME@::take_census(input);
  return census.distinct == c.distinct && census.used == c.used;
}

}  // namespace

TEST_CASE("the certificate is accepted") {
  const Verdict verdict = verify(certificate());
  INFO(verdict.reason);
  CHECK(verdict.accepted);
  CHECK(verdict.lines.size() == 3);
}

TEST_CASE("every changed number of the claim is rejected") {
  const auto input = one_cell();
  const auto truth = crest::@NAME@::make_certificate(input, crest::@NAME@::take_census(input));
  for (const int change : {-1, 1}) {
    auto places = truth, used = truth;
    places.distinct += static_cast<std::uint32_t>(change);
    used.used += static_cast<std::uint32_t>(change);
    CHECK_FALSE(verify(encode(places)).accepted);
    CHECK_FALSE(verify(encode(used)).accepted);
  }
}

TEST_CASE("edited bytes, bound again, are rejected unless true") {
  const Bytes original = certificate();
  Random random(kSeed);
  std::uint64_t mutants = 0;
  for (std::uint64_t i = 0; i < scaled(2000); ++i) {
    Bytes mutant = original;
    const auto at = random() % mutant.size();
    if (random() % 4 == 0)
      mutant.resize(at);
    else
      mutant[at] ^= static_cast<std::uint8_t>(1U << random() % 8);
    const OnFailure shown([&] { return "byte, size " + in_braces(at, mutant.size()); });
    CHECK_FALSE(verify(mutant).accepted);
    try {
      rebind(mutant);
    } catch (const std::invalid_argument&) {
      continue;
    }
    ++mutants;
    if (verify(mutant).accepted) CHECK(is_true(mutant));
  }
  CHECK(mutants > scaled(2000) / 2);
}
END

instantiate "experiments/$name/${name}_table.cpp" <<'END'
// SPDX-License-Identifier: GPL-3.0-or-later
// The paper's table beside ours: one line a size.
#include <fmt/format.h>

#include "algorithms/@NAME@/@NAME@.hpp"

int main() {
  fmt::print("{:>9} {:>9} {:>9}\n", "points", "places", "used");
  for (std::uint32_t n = 10; n <= 1000; n *= 10) {
    crest::@NAME@::Input input;
    for (std::uint32_t i = 0; i < n; ++i) input.points.push_back({1.0 * i, 0, 0});
    const auto census = crest::@NAME@::take_census(input);
    fmt::print("{:>9} {:>9} {:>9}\n", n, census.distinct, census.used);
  }
}
END

# The claim's row and number in certify/SPEC.md.
spec=$(mktemp)
awk -v row="| $number $dashed | [$name/SPEC.md]($name/SPEC.md) | none yet | \`crest-verify-$dashed\` |" \
  -v entry=", $number = $dashed |" '
  /^\| [0-9]+ [a-z]/ { in_table = 1 }
  in_table && !/^\|/ { print row; in_table = 0 }
  /^\| u32 \| claim: 1 = / { sub(/ \|$/, entry) }
  { print }' certify/SPEC.md >"$spec"
cat "$spec" >certify/SPEC.md
rm -f "$spec"
echo "  a row in certify/SPEC.md"
# What a user must trust has grown by the claim's room.
if [ -d docs ]; then
  scripts/trusted_base.sh --update
fi
# Names of other lengths than the templates' break lines elsewhere.
if [ -d .git ] || [ -e .git ]; then
  if command -v clang-format >/dev/null; then scripts/format.sh; fi
fi
echo "Next: CONTRIBUTING.md, \"A new system\", from step 2 on."
