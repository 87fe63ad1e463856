// SPDX-License-Identifier: GPL-3.0-or-later
// crest curvature: outputs, normals from files, errors.
#include <catch2/catch.hpp>

#include "tests/cli/run_crest.hpp"

using namespace crest::tests;

namespace {

void check_refused(const std::string& line, const fs::path& folder, int exit_code,
                   const std::string& word) {
  const auto result = run_crest(line, folder);
  INFO(line << "\n" << result.err);
  CHECK(result.exit_code == exit_code);
  CHECK(result.out.empty());
  CHECK(is_one_line(result.err));
  CHECK(result.err.find(word) != std::string::npos);
}

}  // namespace

TEST_CASE("curvature of a sphere: every output, the report's keys") {
  const TemporaryFolder folder;
  REQUIRE(run_crest("crest sample sphere --vertices 600 -o s.off", folder.path()).exit_code == 0);
  for (const char* method : {"np", "ne", "cf", "qf", "qt", "jet", "normal-cycle"}) {
    const auto result =
        run_crest(std::string("crest curvature s.off --reference sphere --method ") + method +
                      " -o s.vtp --focal f.vtp --picture s.svg --report s.json",
                  folder.path());
    INFO(method << "\n" << result.err);
    REQUIRE(result.exit_code == 0);
    const auto report = read_json(folder / "s.json");
    CHECK(report["method"] == method);
    for (const char* name : {"k1", "k2", "K", "H"}) {
      CHECK(report[name]["min"].get<double>() <= report[name]["median"].get<double>());
      CHECK(report[name]["median"].get<double>() <= report[name]["max"].get<double>());
    }
    CHECK(report["H"]["median"].get<double>() == Approx(-1).epsilon(0.05));
    CHECK(report["dist_H"].get<double>() < 0.01);
    CHECK(report["undetermined"] == 0);
    for (const char* name : {"s.vtp", "f.vtp"})
      CHECK(read_text(folder / name).find("<VTKFile") != std::string::npos);
    CHECK(read_text(folder / "s.svg").find("<svg") != std::string::npos);
  }
  // The gradient of the sphere gives the exact tensor.
  CHECK(run_crest("crest curvature s.off --method np --reference sphere --report s.json",
                  folder.path())
            .exit_code == 0);
  CHECK(read_json(folder / "s.json")["dist_K"].get<double>() < 1e-20);
}

TEST_CASE("what curvature writes it reads back: the mesh and its normals, vtp and ply") {
  const TemporaryFolder folder;
  REQUIRE(
      run_crest("crest sample torus --vertices 400 --rotate -o t.off", folder.path()).exit_code ==
      0);
  const std::string np = "crest curvature t.off --method np --reference torus --rotate";
  for (const char* extension : {"vtp", "ply"}) {
    const std::string file = std::string("n.") + extension;
    REQUIRE(run_crest(np + " -o " + file + " --report a.json", folder.path()).exit_code == 0);
    const auto again =
        run_crest("crest curvature " + file + " --method np --report b.json", folder.path());
    INFO(file << "\n" << again.err);
    REQUIRE(again.exit_code == 0);
    CHECK(read_json(folder / "b.json")["normals"] == "file");
    for (const char* name : {"k1", "k2", "K", "H", "asymmetry"})
      CHECK(read_json(folder / "a.json")[name] == read_json(folder / "b.json")[name]);
  }
  CHECK(run_crest(np + " -o n.vtu", folder.path()).exit_code == 0);
  CHECK(read_text(folder / "n.vtu").find("corner_K") == std::string::npos);
  CHECK(run_crest(np + " --corners -o n.vtu", folder.path()).exit_code == 0);
  CHECK(read_text(folder / "n.vtu").find("corner_K") != std::string::npos);
  check_refused("crest curvature t.off --method jet --corners -o n.vtu", folder.path(), 2, "np");
  check_refused(np + " --corners -o n.ply", folder.path(), 2, ".vtu");
}

TEST_CASE("curvature says what is wrong in one line") {
  const TemporaryFolder folder;
  write_text(folder / "t.off",
             "OFF\n4 4 0\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n3 0 2 1\n3 0 1 3\n3 1 2 3\n3 0 3 2\n");
  write_text(folder / "bare.ply",
             "ply\nformat ascii 1.0\nelement vertex 3\nproperty double x\nproperty double y\n"
             "property double z\nelement face 1\nproperty list uchar int vertex_indices\n"
             "end_header\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n");
  write_text(folder / "zero.ply",
             "ply\nformat ascii 1.0\nelement vertex 3\nproperty double x\nproperty double y\n"
             "property double z\nproperty float nx\nproperty float ny\nproperty float nz\n"
             "element face 1\nproperty list uchar int vertex_indices\n"
             "end_header\n0 0 0 0 0 1\n1 0 0 0 0 0\n0 1 0 0 0 1\n3 0 1 2\n");
  write_text(folder / "huge.off", "OFF\n3 1 0\n0 0 0\n1e200 0 0\n0 1e200 0\n3 0 1 2\n");
  check_refused("crest curvature t.off --method xx", folder.path(), 2, "method");
  check_refused("crest curvature t.off --method np --normals estimated", folder.path(), 2, "ne");
  check_refused("crest curvature t.off --method ne --normals file", folder.path(), 2, "np");
  check_refused("crest curvature t.off --normals gradient --method cf", folder.path(), 2,
                "--reference");
  check_refused("crest curvature t.off --rotate", folder.path(), 2, "--reference");
  check_refused("crest curvature t.off --reference nothing", folder.path(), 2, "nothing");
  check_refused("crest curvature t.off -o t.obj", folder.path(), 2, "t.obj");
  check_refused("crest curvature t.off --degree 9", folder.path(), 2, "degree");
  check_refused("crest curvature t.off --method np", folder.path(), 3, "t.off");
  check_refused("crest curvature bare.ply --method np", folder.path(), 3, "none");
  check_refused("crest curvature zero.ply --method np", folder.path(), 3, "vertex 1");
  check_refused("crest curvature huge.off", folder.path(), 3, "scale the mesh by 1e-200");
  check_refused("crest curvature missing.off", folder.path(), 3, "missing.off");
}
