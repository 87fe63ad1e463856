// SPDX-License-Identifier: GPL-3.0-or-later
// Cubic splines as files.
#include "io/splines/cubic_model_file.hpp"

#include <catch2/catch.hpp>
#include <cstring>
#include <fstream>
#include <sstream>

#include "algorithms/splines/cubic_fit.hpp"
#include "kernel/geometry/input_error.hpp"
#include "tests/splines/scattered_functions.hpp"
#include "tests/support/temporary_folder.hpp"

using namespace crest;
using namespace crest::tests;
using splines::CubicModel;
using splines::Smoothness;

namespace {

std::string bytes_of(const std::string& path) {
  std::ifstream stream(path, std::ios::binary);
  std::stringstream text;
  text << stream.rdbuf();
  return text.str();
}

CubicModel model_of(Smoothness smoothness) {
  const Samples s = sampled(500, kSeed, f_test);
  // A box whose spacing no double holds.
  return splines::fit_cubic(s.points, s.values,
                            {smoothness, {{3, 2, 7}}, {{Vec3{-0.1, 0, 1.0 / 3}, Vec3{1, 1.3, 1}}}})
      .model;
}

}  // namespace

TEST_CASE("a saved cubic spline is read back bit by bit") {
  const TemporaryFolder folder;
  const std::string path = folder / "model.vti";
  for (const Smoothness mode : {Smoothness::c1, Smoothness::local, Smoothness::sequential}) {
    const CubicModel model = model_of(mode);
    io::write_cubic_model(path, model);
    CHECK(io::is_cubic_model(path));
    const CubicModel back = io::read_cubic_model(path);
    CHECK(back.smoothness == mode);
    CHECK(back.unit == model.unit);
    CHECK(back.domain.low == model.domain.low);
    CHECK(back.domain.high == model.domain.high);
    CHECK(back.domain.cubes == model.domain.cubes);
    CHECK(back.vertices == model.vertices);
    CHECK(back.slopes == model.slopes);
    CHECK(back.centres == model.centres);
    const std::string first = bytes_of(path);
    io::write_cubic_model(path, back);
    CHECK(bytes_of(path) == first);
  }
}

TEST_CASE("damaged files of cubic splines are refused in one line") {
  const TemporaryFolder folder;
  const std::string path = folder / "model.vti";
  io::write_cubic_model(path, model_of(Smoothness::c1));
  const std::string good = bytes_of(path);
  const auto refused = [](const std::string& bytes, const std::string& words) {
    try {
      io::read_cubic_model_bytes("model.vti", bytes);
      FAIL("not refused");
    } catch (const kernel::InputError& error) {
      const std::string what = error.what();
      CAPTURE(what);
      CHECK(what.starts_with("model.vti: "));
      CHECK(what.find(words) != what.npos);
      CHECK(what.find('\n') == what.npos);
    }
  };
  const auto changed = [&](const std::string& from, const std::string& to) {
    std::string bytes = good;
    const std::size_t at = bytes.find(from);
    REQUIRE(at != bytes.npos);
    return bytes.replace(at, from.size(), to);
  };
  CHECK_NOTHROW(io::read_cubic_model_bytes("model.vti", good));
  refused("", "cannot be read");
  refused(good.substr(0, good.size() / 2), "");
  for (const char* name : {"slopes", "centre", "box", "unit", "type", "smoothness"})
    refused(changed("Name=\"" + std::string(name) + "\"", "Name=\"other\""),
            name == std::string("type") ? "'type'" : name);
}
