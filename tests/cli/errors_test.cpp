// SPDX-License-Identifier: GPL-3.0-or-later
// Exit codes, one-line messages, and no half-written output.
#include <catch2/catch.hpp>

#include "tests/cli/run_crest.hpp"

using namespace crest::tests;

namespace {

constexpr const char* kTetrahedron =
    "OFF\n4 4 0\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n"
    "3 0 2 1\n3 0 1 3\n3 1 2 3\n3 0 3 2\n";

void check_refused(const std::string& line, const fs::path& folder, int exit_code) {
  const auto before = read_text(folder / "kept");
  const auto entries = std::distance(fs::directory_iterator(folder), fs::directory_iterator());
  const auto result = run_crest(line, folder);
  INFO(line << "\n" << result.err);
  CHECK(result.exit_code == exit_code);
  CHECK(result.out.empty());
  CHECK(is_one_line(result.err));
  CHECK(result.err.rfind("crest", 0) == 0);
  CHECK(read_text(folder / "kept") == before);
  CHECK(std::distance(fs::directory_iterator(folder), fs::directory_iterator()) == entries);
}

}  // namespace

TEST_CASE("wrong command lines: exit code 2 and one line") {
  const TemporaryFolder folder;
  write_text(folder / "kept", "old");
  write_text(folder / "t.off", kTetrahedron);
  for (const char* line : {
           "crest",
           "crest rigdes t.off",
           "crest ridges",
           "crest ridges t.off more.off",
           "crest ridges t.off --no-such-option",
           "crest ridges t.off --order 5",
           "crest ridges t.off --rings 0",
           "crest ridges t.off --rings two",
           "crest ridges t.off --rings 2 --scale auto",
           "crest ridges t.off --scale -1",
           "crest ridges t.off --scale 1x",
           "crest ridges t.off --scale nan",
           "crest ridges t.off --min-length -1",
           "crest ridges t.off --threads 0",
           "crest ridges t.off -o t.xyz",
           "crest ridges t.off -o out",
           "crest ridges t.off --picture t.pdf",
           "crest ridges t.off --picture t.png --view 1,2",
           "crest features t.off --picture t.png --up x,y,z",
           "crest ridges t.off --certificate same --report same",
           "crest sample ellipsoid",
           "crest sample nothing -o n.off",
           "crest sample ellipsoid --parameters 1,2,-3 -o n.off",
           "crest sample ellipsoid --vertices 3 -o n.off",
           "crest sample ellipsoid -o n.stl",
       })
    check_refused(line, folder.path(), 2);
}

TEST_CASE("bad input: exit code 3, one line naming the file, no output file touched") {
  const TemporaryFolder folder;
  write_text(folder / "kept", "old");
  write_text(folder / "kept.vtp", "old");
  const std::string points = "0 0 0\n1 0 0\n0 1 0\n0 0 1\n";
  const std::pair<const char*, std::string> inputs[] = {
      {"empty.off", ""},
      {"text.off", "this is not a mesh\n"},
      {"truncated.off", "OFF\n4 4 0\n0 0 0\n1 0 0\n"},
      {"nan.off", "OFF\n4 4 0\n0 0 0\n1 0 nan\n0 1 0\n0 0 1\n3 0 2 1\n3 0 1 3\n3 1 2 3\n3 0 3 2\n"},
      {"index.off", "OFF\n4 1 0\n" + points + "3 0 1 9\n"},
      {"degenerate.off", "OFF\n4 1 0\n" + points + "3 0 1 1\n"},
      {"flat.off", "OFF\n3 1 0\n0 0 0\n1 1 1\n2 2 2\n3 0 1 2\n"},
      {"fan.off", "OFF\n5 3 0\n" + points + "0 0 -1\n3 0 1 2\n3 0 1 3\n3 0 1 4\n"},
      {"format.xyz", "0 0 0\n"},
  };
  for (const auto& [name, text] : inputs) write_text(folder / name, text);
  for (const auto& [name, text] : inputs) {
    check_refused(std::string("crest ridges ") + name +
                      " -o kept.vtp --report r.json --certificate r.crest --picture r.svg",
                  folder.path(), 3);
    const auto result = run_crest(std::string("crest ridges ") + name, folder.path());
    CHECK(result.err.find(name) != std::string::npos);
  }
  check_refused("crest ridges missing.off", folder.path(), 3);
  check_refused("crest ridges .", folder.path(), 3);
  CHECK(read_text(folder / "kept.vtp") == "old");
}

TEST_CASE("a place that cannot be written is found out first, in one line") {
  const TemporaryFolder folder;
  write_text(folder / "kept", "old");
  write_text(folder / "t.off", kTetrahedron);
  fs::create_directory(folder / "folder.vtp");
  check_refused("crest ridges t.off -o no/such/folder/t.vtp", folder.path(), 3);
  check_refused("crest ridges t.off --report kept/t.json", folder.path(), 3);
  check_refused("crest ridges t.off -o folder.vtp", folder.path(), 3);
  check_refused("crest ridges t.off --picture t.png --view 0,0,0", folder.path(), 3);
  check_refused("crest curvature t.off --picture t.png --view 0,0,1 --up 0,0,-2", folder.path(), 3);
  check_refused("crest reeb t.off --expression z --picture t.png --up nan,0,0", folder.path(), 3);
  check_refused("crest sample ellipsoid --vertices 600 -o no/such/folder/t.off", folder.path(), 3);
  // Found out before the input is read.
  const auto result = run_crest("crest ridges missing.off -o no/t.vtp", folder.path());
  CHECK(result.err.find("no/t.vtp") != std::string::npos);
}

TEST_CASE("a full device: exit code 3, nothing left behind") {
  REQUIRE(fs::is_character_file("/dev/full"));
  const TemporaryFolder folder;
  write_text(folder / "kept", "old");
  write_text(folder / "t.off", kTetrahedron);
  check_refused("crest ridges t.off --quiet -o t.vtp --report /dev/full", folder.path(), 3);
}

TEST_CASE("crest-verify --reseal and --rebind to a full device or a missing folder: exit code 3") {
  if (!fs::exists("/dev/full")) return;
  const TemporaryFolder folder;
  write_text(folder / "kept", "old");
  write_text(folder / "t.off", kTetrahedron);
  REQUIRE(run_crest("crest ridges t.off --quiet --certificate t.crest", folder.path()).exit_code ==
          0);
  for (const char* option : {"--reseal", "--rebind"}) {
    for (const char* target : {"/dev/full", "no/such.crest", "."}) {
      check_refused(std::string("crest-verify ") + option + " t.crest " + target, folder.path(), 3);
      CHECK(fs::is_character_file("/dev/full"));
    }
    // A disk that fills up on the way: no file may grow beyond one block.
    check_refused(
        std::string("ulimit -f 1; trap '' XFSZ; crest-verify ") + option + " t.crest u.crest",
        folder.path(), 3);
  }
}

TEST_CASE("a report can go to a device, an output replaces a link's target") {
  const TemporaryFolder folder;
  write_text(folder / "t.off", kTetrahedron);
  const auto result = run_crest("crest ridges t.off --quiet --report /dev/stdout", folder.path());
  CHECK(result.exit_code == 0);
  CHECK(nlohmann::json::parse(result.out)["faces"] == 4);
  write_text(folder / "real.vtp", "old");
  fs::create_symlink("real.vtp", folder / "link.vtp");
  CHECK(run_crest("crest ridges t.off --quiet -o link.vtp", folder.path()).exit_code == 0);
  CHECK(fs::is_symlink(folder / "link.vtp"));
  CHECK(read_text(folder / "real.vtp").find("<VTKFile") != std::string::npos);
}

TEST_CASE("names of attributes reach no terminal as control characters") {
  const TemporaryFolder folder;
  write_text(folder / "t.ply",
             "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\n"
             "property float z\nproperty float a\x1b[31mRED\nelement face 1\n"
             "property list uchar int vertex_indices\nend_header\n"
             "0 0 0 1\n1 0 0 2\n0 1 0 3\n3 0 1 2\n");
  const auto encoded = run_crest("crest encode t.ply -o t.cmc", folder.path());
  CHECK(encoded.exit_code == 0);
  CHECK(encoded.out.find("a?[31mRED") != std::string::npos);
  const auto decoded = run_crest("crest decode t.cmc -o t.obj", folder.path());
  CHECK(decoded.exit_code == 0);
  CHECK(decoded.err.find("a?[31mRED") != std::string::npos);
  for (const std::string& text : {encoded.out, encoded.err, decoded.out, decoded.err})
    CHECK(text.find('\x1b') == std::string::npos);
  const auto refused = run_crest("crest decode t.cmc --max-numbers 2 -o u.vtp", folder.path());
  CHECK(refused.exit_code == 3);
  CHECK(is_one_line(refused.err));
  CHECK(refused.err.find("--max-numbers") != std::string::npos);
}
