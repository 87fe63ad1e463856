// SPDX-License-Identifier: GPL-3.0-or-later
// --page of every command that has it, as a user runs it.
#include <catch2/catch.hpp>

#include "tests/cli/run_crest.hpp"

using namespace crest::tests;

namespace {

nlohmann::json scene_of(const std::string& page) {
  const std::string start = "id=\"scene\">";
  const std::size_t at = page.find(start) + start.size();
  return nlohmann::json::parse(page.substr(at, page.find("</script", at) - at));
}

std::size_t items_of(const nlohmann::json& scene) {
  std::size_t items = 0;
  for (const auto& layer : scene["layers"]) items += layer["count"].get<std::size_t>();
  return items;
}

}  // namespace

TEST_CASE("crest --page: every command with a picture, the same bytes with one thread and two") {
  const TemporaryFolder folder;
  REQUIRE(run_crest("crest sample ellipsoid --parameters 1,1.5,2 --vertices 700 -o e.off && "
                    "crest sample moebius-sheet --nodes 20 -o m.nrrd && "
                    "crest sample block-twist --vertices 500 -o t.vtu && "
                    "crest sample lattice --seed 5 --parameters 16,1 -o l.vtu",
                    folder.path())
              .exit_code == 0);
  for (const std::string line :
       {"ridges e.off", "ridges e.off --all --certificate p.crest", "features e.off --angle 8",
        "features e.off", "reeb e.off --expression 'x*x - y*z'", "curvature e.off --focal f.vtp",
        "strips e.off", "lineart e.off", "modes t.vtu --mode 0.6 --neutral --degenerate",
        "extremal m.nrrd --ridge --min-value 0.4", "spline m.nrrd --isovalue 0.4", "skeleton l.vtu",
        "compress l.vtu",
        "ridges --param 'u; v; u^2 + 0.5*v^2 + 0.2*u^3 + 0.3*u*v^2 + 0.1*v^3' --domain "
        "-0.5,0.6,-0.5,0.6"}) {
    INFO(line);
    std::string pages[2];
    for (const int threads : {1, 2}) {
      const auto run = run_crest(
          "crest " + line + " --page p.html --threads " + std::to_string(threads), folder.path());
      INFO(run.err);
      REQUIRE(run.exit_code == 0);
      pages[threads - 1] = read_text(folder / "p.html");
    }
    CHECK(pages[0] == pages[1]);
    const auto scene = scene_of(pages[0]);
    CHECK(scene["command"] == "crest " + line + " --page p.html");
    CHECK(scene["title"].get<std::string>().find(" of ") != std::string::npos);
    CHECK(scene["summary"].get<std::string>().size() > 10);
    CHECK(scene["surfaces"].size() + items_of(scene) > 0);
    const bool certified = line.find("--certificate") != std::string::npos;
    CHECK(scene["certificate"].is_null() != certified);
    if (certified) CHECK(scene["certificate"][2] == fs::file_size(folder / "p.crest"));
  }
}

TEST_CASE("crest --page: complete or not at all, and only as .html") {
  const TemporaryFolder folder;
  write_text(folder / "bad.off", "OFF\n4 1 0\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n3 0 1 9\n");
  CHECK(run_crest("crest ridges bad.off --page p.html", folder.path()).exit_code == 3);
  CHECK_FALSE(fs::exists(folder / "p.html"));
  write_text(folder / "t.off",
             "OFF\n4 4 0\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n3 0 2 1\n3 0 1 3\n3 1 2 3\n3 0 3 2\n");
  CHECK(run_crest("crest strips t.off --page p.txt", folder.path()).exit_code == 2);
  CHECK(run_crest("crest strips t.off --page none/p.html", folder.path()).exit_code == 3);
  const auto twice = run_crest("crest strips t.off --page p.html -o p.html", folder.path());
  CHECK(twice.exit_code == 2);
  // The checker that a page is to carry is not there: no page, and no certificate either.
  const auto run =
      run_crest("CREST_VERIFY_JS=none.js crest features t.off --page p.html --certificate p.crest",
                folder.path());
  CHECK(run.exit_code == 3);
  CHECK(is_one_line(run.err));
  CHECK_FALSE(fs::exists(folder / "p.html"));
  CHECK_FALSE(fs::exists(folder / "p.crest"));
  // A name that a page must not take for markup.
  const std::string name = "<img src=x onerror=alert(1)>.off";
  fs::copy_file(folder / "t.off", folder / name);
  REQUIRE(run_crest("crest strips '" + name + "' --page p.html", folder.path()).exit_code == 0);
  const std::string page = read_text(folder / "p.html");
  CHECK(page.find("<img") == std::string::npos);
  CHECK(scene_of(page)["title"] == "Triangle strips of " + name);
}
