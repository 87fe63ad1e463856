// SPDX-License-Identifier: GPL-3.0-or-later
// Quadratic splines as files.
#include <catch2/catch.hpp>
#include <cstring>

#include "io/read/volume_reader.hpp"
#include "io/splines/quadratic_model_file.hpp"
#include "kernel/geometry/input_error.hpp"
#include "tests/splines/volumes.hpp"
#include "tests/support/program.hpp"

using namespace crest;
using namespace crest::tests;

TEST_CASE("a saved quadratic spline is read back bit by bit, a plain volume is none") {
  auto grid = random_volume<float>({5, 4, 6}, 1000, kSeed + 50);
  for (float& x : std::get<std::vector<float>>(grid.samples)) x *= 0.1F;
  grid.spacing = {0.1, 1.0 / 3, 2.7};
  grid.origin = {1e-7, -1e9 / 7, 3};
  grid.directions = {{{0.48, 0.6, 0.64}, {-0.8, 0.6, 0}, {0.384, 0.512, -0.768}}};
  const TemporaryFolder folder;
  const std::string path = (folder / "model.vti").string();
  const splines::QuadraticSpline fresh(grid, splines::Border::extend);
  io::write_quadratic_model(path, fresh);
  const auto header = io::read_quadratic_header(path);
  REQUIRE(header);
  auto read = io::read_volume(path).grid;
  header->restore(read);
  const splines::QuadraticSpline saved(read, header->border);
  CHECK(saved.grid().samples == grid.samples);
  CHECK(saved.grid().origin == grid.origin);
  CHECK(saved.grid().spacing == grid.spacing);
  CHECK(saved.grid().directions == grid.directions);
  CHECK(saved.border() == splines::Border::extend);
  for (int i = 0; i < 50; ++i) {
    const Vec3 p = grid.to_world({0.008 * i, 0.02 * i, 0.25 * i});
    const auto a = fresh.evaluate(p), b = saved.evaluate(p);
    CHECK(std::memcmp(&a, &b, sizeof a) == 0);
  }
  const std::string text = read_text(path);
  auto damaged = text;
  damaged.replace(damaged.find("Name=\"border\""), 13, "Name=\"margin\"");
  write_text(folder / "damaged.vti", damaged);
  CHECK_THROWS_AS(io::read_quadratic_header((folder / "damaged.vti").string()), kernel::InputError);
  auto huge = text;
  const std::size_t at = huge.find("WholeExtent=\"") + 13;
  huge.replace(at, huge.find('"', at) - at, "0 9000000 0 9 0 9");
  write_text(folder / "huge.vti", huge);
  CHECK_THROWS_WITH(io::read_quadratic_header((folder / "huge.vti").string()),
                    Catch::Contains("more than the file holds"));
  write_text(folder / "plain.txt", "frame");
  CHECK_FALSE(io::read_quadratic_header((folder / "plain.txt").string()));
}
