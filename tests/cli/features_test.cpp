// SPDX-License-Identifier: GPL-3.0-or-later
// crest features as a user runs it.
#include <catch2/catch.hpp>

#include "tests/cli/run_crest.hpp"

using namespace crest::tests;

TEST_CASE("crest features: outputs, report and an accepted certificate, the same bytes each time") {
  const TemporaryFolder folder;
  REQUIRE(run_crest("crest sample ellipsoid --vertices 1500 -o e.off", folder.path()).exit_code ==
          0);
  const std::string line =
      "crest features e.off --threshold 0.8 --close 1 --prune 3 --min-patch 4 --close-branches 4 ";
  const auto run = run_crest(line +
                                 "-o e.vtp --picture e.svg --report e.json --certificate e.crest "
                                 "--cite",
                             folder.path());
  INFO(run.err);
  REQUIRE(run.exit_code == 0);
  CHECK(run.out.find("{roessl2005surfaces,") != std::string::npos);
  const auto report = read_json(folder / "e.json");
  for (const char* key :
       {"marked", "nodes", "arcs", "branches", "loops", "patches", "betti_before", "betti_after"}) {
    INFO(key);
    CHECK(report.contains(key));
  }
  CHECK(report["betti_before"] == report["betti_after"]);
  CHECK(report["certificate"]["certified"] == true);
  CHECK(report["marked"].get<int>() > 280);
  const auto verdict = run_crest("crest-verify e.crest --input e.off", folder.path());
  INFO(verdict.out);
  CHECK(verdict.exit_code == 0);
  CHECK(verdict.out.find(report["data_digest"].get<std::string>()) != std::string::npos);
  // The output is itself a mesh with lines on it.
  CHECK(run_crest("crest features e.vtp --quiet", folder.path()).exit_code == 0);
  REQUIRE(run_crest(line + "--threads 1 --quiet -o f.vtp --picture f.svg --certificate f.crest",
                    folder.path())
              .exit_code == 0);
  for (const char* extension : {".vtp", ".svg", ".crest"}) {
    CHECK(read_text(folder / (std::string("e") + extension)) ==
          read_text(folder / (std::string("f") + extension)));
  }
}

TEST_CASE("crest features refuses wrong options with exit code 2 and bad meshes with 3") {
  const TemporaryFolder folder;
  write_text(folder / "t.off",
             "OFF\n4 4 0\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n3 0 2 1\n3 0 1 3\n3 1 2 3\n3 0 3 2\n");
  write_text(folder / "bad.off", "OFF\n4 1 0\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n3 0 1 9\n");
  for (const char* options :
       {"--threshold 1.5", "--threshold nan", "--threshold 0.5 --value 1", "--value x",
        "--value nan", "--dilate 1.5", "--dilate -1", "--erode nan", "--neighbourhood geodesic",
        "--prune -1", "--prune 1.5", "--min-patch x", "-o t.ply", "--picture t.pdf"}) {
    const auto run = run_crest(std::string("crest features t.off ") + options, folder.path());
    INFO(options << "\n" << run.err);
    CHECK(run.exit_code == 2);
    CHECK(is_one_line(run.err));
  }
  for (const char* file : {"bad.off", "none.off"}) {
    const auto run =
        run_crest(std::string("crest features ") + file + " -o out.vtp", folder.path());
    CHECK(run.exit_code == 3);
    CHECK(is_one_line(run.err));
    CHECK_FALSE(fs::exists(folder / "out.vtp"));
  }
  CHECK(run_crest("crest features t.off --dilate 1.5 --neighbourhood path", folder.path())
            .exit_code == 0);
}
