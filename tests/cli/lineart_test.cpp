// SPDX-License-Identifier: GPL-3.0-or-later
// crest lineart as a user runs it: every file, an accepted certificate, and what is refused.
#include <catch2/catch.hpp>

#include "tests/cli/run_crest.hpp"

using namespace crest::tests;

namespace {

/// Three triangles at one edge.
constexpr const char* kFan =
    "OFF\n5 3 0\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n0 -1 0.5\n3 0 1 2\n3 0 1 3\n3 0 1 4\n";

void refused(const TemporaryFolder& folder, const std::string& command, int code,
             const std::string& words) {
  const auto run = run_crest(command, folder.path());
  INFO(command << ": " << run.err);
  CHECK(run.exit_code == code);
  CHECK(run.err.find(words) != std::string::npos);
  CHECK(std::count(run.err.begin(), run.err.end(), '\n') == 1);
  CHECK_FALSE(fs::exists(folder / "no.svg"));
}

}  // namespace

TEST_CASE("crest lineart: drawings in every format, a report and an accepted certificate") {
  const TemporaryFolder folder;
  REQUIRE(run_crest("crest sample torus --vertices 600 -o t.off", folder.path()).exit_code == 0);
  const auto run = run_crest(
      "crest lineart t.off --view 30,40 --width 50 -o t.svg --report t.json --certificate t.crest "
      "--save-sidecar s.json --save-buffers b --cite",
      folder.path());
  INFO(run.err);
  REQUIRE(run.exit_code == 0);
  CHECK(run.out.find("{roessl2005surfaces,") != std::string::npos);
  const auto report = read_json(folder / "t.json");
  CHECK(report["field"]["index_sum"] == 0);
  CHECK(report["strokes"]["over_contours"] == 0);
  CHECK(report["contours"]["pieces"] ==
        report["contours"]["visible"].get<int>() + report["contours"]["hidden"].get<int>());
  CHECK(report["certificate"]["certified"] == true);
  const auto verify =
      run_crest("crest-verify t.crest && crest-verify-lineart t.crest", folder.path());
  INFO(verify.err);
  CHECK(verify.exit_code == 0);
  for (const char* file :
       {"b-luminance.png", "b-lic.png", "b-normal.png", "b-curvature.png", "b-buffers.vti"})
    CHECK(fs::exists(folder / file));
  const auto more = run_crest(
      "crest lineart t.off --view 30,40 --width 50 --sidecar s.json --luminance b-luminance.png -o "
      "u.svg && crest lineart t.off --style contours --view 30,40 --perspective 40 -o t.pdf && "
      "crest "
      "lineart t.off --tone bands --cross-hatch --view 30,40 --width 50 -o t.eps && crest lineart "
      "t.off --style streamlines --field cross --tone length --view 30,40 --width 50 -o t.vtp",
      folder.path());
  INFO(more.err);
  CHECK(more.exit_code == 0);
  CHECK(read_text(folder / "t.pdf").substr(0, 5) == "%PDF-");
  CHECK(read_text(folder / "t.eps").find("%%CreationDate: 1970") != std::string::npos);
}

TEST_CASE("crest lineart: contours of what is no surface, certified") {
  const TemporaryFolder folder;
  write_text(folder / "fan.off", kFan);
  const auto run = run_crest(
      "crest lineart fan.off --style contours --camera 0,0,1,0,0,0 -o f.svg --certificate f.crest",
      folder.path());
  INFO(run.err);
  CHECK(run.exit_code == 0);
  CHECK(run_crest("crest-verify f.crest", folder.path()).exit_code == 0);
}

TEST_CASE("crest lineart: what is refused, in one line") {
  const TemporaryFolder folder;
  write_text(folder / "fan.off", kFan);
  REQUIRE(
      run_crest("crest sample torus --vertices 300 -o t.off && crest lineart t.off --view 10,20 "
                "--width 30 -o t.svg --save-sidecar s.json",
                folder.path())
          .exit_code == 0);
  refused(folder, "crest lineart fan.off -o no.svg", 3, "--style contours");
  refused(folder, "crest lineart t.off --camera 1,2,3,1,2,3 -o no.svg", 3, "eye and target");
  refused(folder, "crest lineart t.off --camera 0,0,0,1,0,0 --perspective 40 -o no.svg", 3,
          "is not in front of the eye");
  refused(folder, "crest lineart t.off --camera 0,0,1,nan,0,0 -o no.svg", 2, "finite");
  refused(folder, "crest lineart t.off --view 10,30 --sidecar s.json -o no.svg", 3, "another view");
  refused(folder, "crest lineart t.off --view 10,20 --up 0,0,0 -o no.svg", 3, "up");
  refused(folder, "crest lineart t.off --style contours --sidecar s.json -o no.svg", 2, "contours");
  write_text(folder / "bad.json", "{\"view\":");
  refused(folder, "crest lineart t.off --sidecar bad.json -o no.svg", 3, "bad.json");
  refused(folder, "crest lineart t.off --luminance t.off -o no.svg", 3, "is no PNG");
}
