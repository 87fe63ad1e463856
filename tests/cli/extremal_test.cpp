// SPDX-License-Identifier: GPL-3.0-or-later
// crest extremal as a user runs it: volumes with known sheets, an image, points, what is refused.
#include <catch2/catch.hpp>

#include "tests/cli/run_crest.hpp"

using namespace crest::tests;

namespace {

struct ExtremalCase {
  const char* arguments;
  int exit_code;
  const char* words;
};

ProgramResult extremal(const std::string& arguments, const TemporaryFolder& folder) {
  const auto run = run_crest("crest extremal " + arguments, folder.path());
  INFO(arguments << "\n" << run.err);
  CHECK(run.exit_code == 0);
  return run;
}

void sample(const std::string& arguments, const TemporaryFolder& folder) {
  REQUIRE(run_crest("crest sample " + arguments + " --quiet", folder.path()).exit_code == 0);
}

nlohmann::json report_of(const std::string& arguments, const TemporaryFolder& folder) {
  extremal(arguments + " --report r.json --quiet", folder);
  return read_json(folder / "r.json");
}

/// Text of an NRRD of 6 x 6 x 6 samples, a ridge at z = 2.4.
std::string small_volume(const std::string& sample = "") {
  std::string text = "NRRD0004\ntype: double\ndimension: 3\nsizes: 6 6 6\nencoding: ascii\n\n";
  for (int z = 0; z < 6; ++z)
    for (int i = 0; i < 36; ++i)
      text += (sample.empty() ? std::to_string(10 - (z - 2.4) * (z - 2.4)) : sample) + "\n";
  return text;
}

/// 40 x 30 pixels, a bright line at the given row, 16 bits.
std::string line_image(int row) {
  std::string bytes = "P5\n40 30\n65535\n";
  for (int y = 0; y < 30; ++y)
    for (int x = 0; x < 40; ++x) {
      const int value = std::max(0, 60000 - 9000 * std::abs(y - row)) + 13 * x;
      bytes += static_cast<char>(value >> 8);
      bytes += static_cast<char>(value & 255);
    }
  return bytes;
}

}  // namespace

TEST_CASE(
    "crest extremal: a closed sheet with report, files, picture and an accepted certificate") {
  const TemporaryFolder folder;
  sample("sphere-shell --nodes 32 -o s.nrrd", folder);
  for (const std::string end : {"vtp", "ply", "obj"}) {
    const auto run = extremal("s.nrrd --ridge --min-value 0.4 -o a." + end +
                                  " --picture a.png --report a.json --certificate a.crest --cite",
                              folder);
    CHECK(run.out.find("{li2010extremal,") != std::string::npos);
    CHECK(fs::file_size(folder / ("a." + end)) > 0);
  }
  const auto report = read_json(folder / "a.json");
  for (const char* key : {"crest",
                          "command",
                          "input",
                          "seconds",
                          "peak_rss_bytes",
                          "threads",
                          "certificate",
                          "warnings",
                          "dimension",
                          "definition",
                          "sigma",
                          "h",
                          "vertices",
                          "polygons",
                          "nodes",
                          "active_nodes",
                          "flat_nodes",
                          "cells",
                          "critical_edges",
                          "extremal_edges",
                          "undecided_edges",
                          "odd_faces",
                          "junction_edges",
                          "ambiguous_faces",
                          "sheets_split",
                          "valence",
                          "bisections",
                          "octree",
                          "odd_valence_edges",
                          "odd_valence_unexplained",
                          "features",
                          "components",
                          "undecided"}) {
    INFO(key);
    CHECK(report.contains(key));
  }
  for (const char* key : {"empty", "regular", "cone", "open"}) CHECK(report["cells"].contains(key));
  CHECK(report["certificate"]["certified"] == true);
  CHECK(report["odd_valence_edges"] == 0);
  REQUIRE(report["components"].size() == 1);
  const auto& sheet = report["components"][0];
  CHECK(sheet["euler_characteristic"] == 2);
  CHECK(sheet["boundary_loops"] == 0);
  CHECK(sheet["orientable"] == true);
  CHECK(sheet["area"].get<double>() == Approx(4 * 3.14159 * 0.36).epsilon(0.03));
  const auto verify = run_crest("crest-verify a.crest", folder.path());
  INFO(verify.out << verify.err);
  CHECK(verify.exit_code == 0);
}

TEST_CASE("crest extremal: on a halved grid a coarse sphere is isotopic to the field's") {
  const TemporaryFolder folder;
  sample("sphere-shell --nodes 32 -o s.vti", folder);
  const auto report =
      report_of("s.vti --ridge --min-value 0.4 --refine 1 -o s.vtp --certificate s.crest", folder);
  REQUIRE(report["components"].size() == 1);
  CHECK(report["components"][0]["isotopic"] == true);
  CHECK(report["nodes"] == 63 * 63 * 63);
  const auto verify = run_crest("crest-verify s.crest", folder.path());
  INFO(verify.out << verify.err);
  CHECK(verify.exit_code == 0);
  CHECK(run_crest("crest extremal s.vti --ridge --refine 4 -o t.vtp", folder.path()).exit_code ==
        2);
}

TEST_CASE("crest extremal: a one-sided sheet, and the same bytes for any number of threads") {
  const TemporaryFolder folder;
  sample("moebius-sheet --nodes 40 -o m.vti", folder);
  for (const std::string threads : {"1", "2", "3"})
    extremal("m.vti --ridge --min-value 0.4 -o " + threads + ".vtp --certificate " + threads +
                 ".crest --report " + threads + ".json --threads " + threads,
             folder);
  for (const std::string end : {".vtp", ".crest"})
    for (const std::string threads : {"2", "3"})
      CHECK(read_text(folder / (threads + end)) == read_text(folder / ("1" + end)));
  const auto report = read_json(folder / "1.json");
  REQUIRE(report["components"].size() == 1);
  CHECK(report["components"][0]["euler_characteristic"] == 0);
  CHECK(report["components"][0]["boundary_loops"] == 1);
  CHECK(report["components"][0]["orientable"] == false);
  CHECK(report["odd_faces"].get<int>() > 0);
  CHECK(report["odd_valence_unexplained"] == 0);
}

TEST_CASE("crest extremal: results stand in the file's world") {
  const TemporaryFolder folder;
  // The sheet z = 2.4, axes turned: x along -Y, y along X; z steps of 3.
  std::string text = small_volume();
  text.insert(text.find("encoding"),
              "space directions: (0,-1,0) (1,0,0) (0,0,3)\nspace origin: (10,20,30)\n");
  write_text(folder / "v.nrrd", text);
  extremal("v.nrrd --ridge --sigma 0.5 -o v.obj --quiet", folder);
  std::size_t vertices = 0;
  for (const std::string& line : split_lines(read_text(folder / "v.obj"))) {
    if (line.rfind("v ", 0) != 0) continue;
    double x = 0, y = 0, z = 0;
    REQUIRE(std::sscanf(line.c_str(), "v %lf %lf %lf", &x, &y, &z) == 3);
    ++vertices;
    CHECK((x >= 10 && x <= 15 && y >= 15 && y <= 20));
    CHECK(z == Approx(37.2).margin(0.01));
  }
  CHECK(vertices > 0);
}

TEST_CASE("crest extremal: curves of an image, row 0 at the top") {
  const TemporaryFolder folder;
  write_text(folder / "i.pgm", line_image(8));
  const auto report = report_of("i.pgm --ridge --min-value 40000 -o i.obj --picture i.png", folder);
  CHECK(report["dimension"] == 2);
  REQUIRE(report["components"].size() == 1);
  CHECK(report["components"][0]["euler_characteristic"] == 1);
  CHECK(report["components"][0]["ends"] == 2);
  for (const std::string& line : split_lines(read_text(folder / "i.obj"))) {
    double x = 0, y = 0;
    if (std::sscanf(line.c_str(), "v %lf %lf", &x, &y) == 2) CHECK(y == Approx(29 - 8).margin(0.1));
  }
  CHECK(fs::file_size(folder / "i.png") > 0);
}

TEST_CASE("crest extremal: the surface of points with normals of any sign") {
  const TemporaryFolder folder;
  sample("moebius-points --vertices 6000 -o p.xyz", folder);
  const auto report = report_of("p.xyz --surface --radius 0.12 --depth 6 -o p.vtp", folder);
  REQUIRE(report["components"].size() == 1);
  CHECK(report["components"][0]["euler_characteristic"] == 0);
  CHECK(report["components"][0]["boundary_loops"] == 1);
  CHECK(report["components"][0]["orientable"] == false);
  CHECK(report["octree"]["leaves"].get<int>() > 0);
}

TEST_CASE("crest extremal: nothing to extract is no error") {
  const TemporaryFolder folder;
  write_text(folder / "c.nrrd", small_volume("7"));
  const auto run = extremal("c.nrrd --ridge -o c.vtp --certificate c.crest", folder);
  CHECK(run.err.find("no extremal surface") != std::string::npos);
  CHECK(run_crest("crest-verify c.crest", folder.path()).exit_code == 0);
  const auto picture = run_crest("crest extremal c.nrrd --ridge --picture c.png", folder.path());
  CHECK(picture.exit_code == 3);
  CHECK(!fs::exists(folder / "c.png"));
}

TEST_CASE("crest extremal: one line and the right exit code for what cannot be done") {
  const TemporaryFolder folder;
  write_text(folder / "v.nrrd", small_volume());
  write_text(folder / "nan.nrrd", small_volume().replace(small_volume().rfind("3."), 8, "nan"));
  write_text(folder / "short.nrrd", small_volume().substr(0, 300));
  write_text(folder / "p.xyz", "0 0 0 0 0 1\n1 0 0 0 0 1\n0 1 0 0 0 1\n");
  write_text(folder / "bare.xyz", "0 0 0\n1 0 0\n");
  for (const ExtremalCase& c :
       {ExtremalCase{"v.nrrd", 2, "give one of --ridge, --valley"},
        ExtremalCase{"v.nrrd --ridge --valley", 2, "give one of"},
        ExtremalCase{"v.nrrd --ridge --radius 1", 2, "are for points"},
        ExtremalCase{"p.xyz --surface --sigma 1", 2, "are for volumes"},
        ExtremalCase{"v.nrrd --ridge --sigma -1", 2, "is less than 0"},
        ExtremalCase{"v.nrrd --ridge --sigma nan", 2, "not a finite number"},
        ExtremalCase{"p.xyz --surface --radius -1", 2, "is less than 0"},
        ExtremalCase{"v.nrrd --ridge --definition tensor", 2, "tensor"},
        ExtremalCase{"v.nrrd --ridge -o v.off", 2, "v.off"},
        ExtremalCase{"none.nrrd --ridge", 3, "does not exist"},
        ExtremalCase{"nan.nrrd --ridge -o n.vtp", 3, "is not a number"},
        ExtremalCase{"short.nrrd --ridge -o n.vtp", 3, "samples"},
        ExtremalCase{"bare.xyz --surface", 3, "has no normal"},
        ExtremalCase{"v.nrrd --ridge --raw 6,6,6,half", 3, "--raw"},
        ExtremalCase{"p.xyz --ridge", 3, "'.xyz' are not read"}}) {
    const auto run = run_crest(std::string("crest extremal ") + c.arguments, folder.path());
    INFO(c.arguments << "\n" << run.err);
    CHECK(run.exit_code == c.exit_code);
    CHECK(is_one_line(run.err));
    CHECK(run.err.find(c.words) != std::string::npos);
  }
  CHECK(!fs::exists(folder / "n.vtp"));
}

TEST_CASE("crest sample: volumes and points take their own options alone") {
  const TemporaryFolder folder;
  for (const ExtremalCase& c :
       {ExtremalCase{"sphere-shell --vertices 100 -o s.nrrd", 2, "takes --nodes alone"},
        ExtremalCase{"ellipsoid --nodes 10 -o s.off", 2, "--nodes is for volumes"},
        ExtremalCase{"moebius-points --rotate -o s.xyz", 2, "takes --vertices, --noise and --seed"},
        ExtremalCase{"sphere-shell -o s.off", 3, "write .nrrd or .vti"},
        ExtremalCase{"moebius-points -o s.off", 3, "write .xyz or .pwn"}}) {
    const auto run = run_crest(std::string("crest sample ") + c.arguments, folder.path());
    INFO(c.arguments << "\n" << run.err);
    CHECK(run.exit_code == c.exit_code);
    CHECK(is_one_line(run.err));
    CHECK(run.err.find(c.words) != std::string::npos);
  }
}

TEST_CASE("crest extremal: blocks and restarts give the same bytes, damaged pieces are refused") {
  const TemporaryFolder folder;
  sample("sphere-shell --nodes 24 -o s.nrrd", folder);
  extremal("s.nrrd --ridge --min-value 0.4 --quiet --certificate whole.crest", folder);
  std::filesystem::create_directory(folder / "pieces");
  const std::string blocks =
      "s.nrrd --ridge --min-value 0.4 --quiet --blocks 4 --restart pieces --certificate ";
  extremal(blocks + "blocks.crest", folder);
  CHECK(read_text(folder / "blocks.crest") == read_text(folder / "whole.crest"));
  extremal(blocks + "again.crest", folder);
  CHECK(read_text(folder / "again.crest") == read_text(folder / "whole.crest"));

  const auto piece = std::filesystem::directory_iterator(folder / "pieces")->path();
  const std::string good = read_text(piece);
  std::vector<std::string> damaged = {"", good.substr(0, good.find('\n') + 20)};
  for (const std::size_t at : {good.find('\n') + 1, good.size() / 2, good.size() - 1}) {
    damaged.push_back(good);
    damaged.back()[at] = static_cast<char>(good[at] ^ 1);
  }
  for (const std::string& bytes : damaged) {
    write_text(piece, bytes);
    const auto run = run_crest("crest extremal " + blocks + "damaged.crest", folder.path());
    CHECK(run.exit_code == 3);
    CHECK(run.err.find("is damaged or cannot be read; delete it") != std::string::npos);
    CHECK_FALSE(std::filesystem::exists(folder / "damaged.crest"));
  }
}

TEST_CASE(
    "crest extremal: blocks finished before a failure are kept, those of other samples refused") {
  const TemporaryFolder folder;
  sample("sphere-shell --nodes 48 -o s.nrrd", folder);
  extremal("s.nrrd --ridge --min-value 0.4 --quiet --certificate whole.crest", folder);
  const std::string good = read_text(folder / "s.nrrd");
  const std::size_t header = good.find("\n\n") + 1;
  write_text(folder / "t.nhdr", good.substr(0, header) + "data file: t.raw\n");
  const std::string samples = good.substr(header + 1);
  const auto write_samples = [&](std::string bytes) { write_text(folder / "t.raw", bytes); };
  const auto run_blocks = [&] {
    return run_crest(
        "crest extremal t.nhdr --ridge --min-value 0.4 --quiet --blocks 8 --restart pieces "
        "--certificate blocks.crest",
        folder.path());
  };
  const auto kept = [&] {
    return std::distance(std::filesystem::directory_iterator(folder / "pieces"), {});
  };
  std::filesystem::create_directory(folder / "pieces");
  std::string bad = samples;
  bad.replace(bad.size() - 8, 8, 8, '\xff');  // no number
  write_text(folder / "u.nrrd", good.substr(0, header + 1) + bad);
  const auto failed = run_crest(
      "crest extremal u.nrrd --ridge --min-value 0.4 --quiet --blocks 8 --restart pieces -o u.vtp",
      folder.path());
  INFO(failed.err);
  CHECK(failed.exit_code == 3);
  CHECK(is_one_line(failed.err));
  CHECK(kept() == 7);  // all but the last
  CHECK_FALSE(std::filesystem::exists(folder / "u.vtp"));

  write_samples(samples);
  CHECK(run_blocks().exit_code == 0);
  CHECK(read_text(folder / "blocks.crest") == read_text(folder / "whole.crest"));
  CHECK(kept() == 8);
  std::string other = samples;
  other[other.size() - 2] = static_cast<char>(other[other.size() - 2] ^ 1);
  write_samples(other);  // the header's file is what it was
  const auto refused = run_blocks();
  CHECK(refused.exit_code == 3);
  CHECK(refused.err.find("is of another run") != std::string::npos);
}
