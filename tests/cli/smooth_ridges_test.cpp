// SPDX-License-Identifier: GPL-3.0-or-later
// crest ridges --surface and --param, end to end.
#include <catch2/catch.hpp>
#include <sstream>
#include <tuple>

#include "tests/cli/run_crest.hpp"
#include "tests/cli/vtp_digest.hpp"

using namespace crest::tests;

namespace {

constexpr const char* kEllipsoid =
    "crest ridges --surface 'x^2 + y^2/2.25 + z^2/4 - 1' --box '-3,3' ";
constexpr const char* kPatch =
    "crest ridges --param 'u; v; u^2 + 0.5*v^2 + 0.2*u^3 + 0.3*u*v^2 + 0.1*v^3' "
    "--domain '-0.5,0.6,-0.5,0.6' ";
constexpr const char* kSphere = "crest ridges --surface 'x^2 + y^2 + z^2 - 1' --box '-2,2' ";

ProgramResult run_for(const std::string& line, const fs::path& folder, int exit_code) {
  const auto result = run_crest(line, folder);
  INFO(line << "\n" << result.err << result.out);
  REQUIRE(result.exit_code == exit_code);
  return result;
}

std::size_t entries(const fs::path& folder) {
  return static_cast<std::size_t>(
      std::distance(fs::directory_iterator(folder), fs::directory_iterator()));
}

void check_refused(const std::string& line, const fs::path& folder, int exit_code,
                   const std::string& word) {
  const auto before = entries(folder);
  const auto result = run_crest(line, folder);
  INFO(line << "\n" << result.err);
  CHECK(result.exit_code == exit_code);
  CHECK(result.out.empty());
  CHECK(is_one_line(result.err));
  CHECK(result.err.rfind("crest", 0) == 0);
  CHECK(result.err.find(word) != std::string::npos);
  CHECK(entries(folder) == before);
}

}  // namespace

TEST_CASE("the ellipsoid given by its equation: certified counts, files, a certificate") {
  const TemporaryFolder folder;
  const auto run = run_for(std::string(kEllipsoid) +
                               "-o e.vtp --mesh m.off --picture e.svg --report e.json "
                               "--certificate e.crest",
                           folder.path(), 0);
  CHECK(run.err.empty());
  CHECK(run.out.find("certified: ") != std::string::npos);
  CHECK(run.out.find("NOT CERTIFIED") == std::string::npos);
  const auto report = read_json(folder / "e.json");
  CHECK(report["command"] == "ridges");
  CHECK(report["input"] == "x^2 + y^2/2.25 + z^2/4 - 1");
  CHECK(report["surface"]["kind"] == "implicit");
  CHECK(report["surface"]["box"] == nlohmann::json::array({-3, 3, -3, 3, -3, 3}));
  CHECK(report["euler_characteristic"] == 2);
  CHECK(report["components"] == 1);
  CHECK(report["umbilics"]["count"] == 4);
  CHECK(report["umbilics"]["index_sum"] == 2);
  for (const auto& umbilic : report["umbilics"]["items"]) {
    CHECK(umbilic["index"] == 0.5);
    CHECK(umbilic["kind"] == "1-ridge");
    CHECK(umbilic["point"][1].get<double>() == Approx(0).margin(1e-9));
  }
  for (const char* colour : {"blue", "red"}) {
    INFO(colour);
    const auto& part = report["ridges"][colour];
    CHECK(part["loops"] == 1);
    CHECK(part["segments"] == 2);
    const double typed =
        part["elliptic_length"].get<double>() + part["hyperbolic_length"].get<double>();
    CHECK(typed == Approx(part["length"].get<double>()));
  }
  CHECK(report["open_ends"] == 0);
  CHECK(report["turning_points"]["count"] == report["turning_points"]["items"].size());
  CHECK(report["purple_points"]["count"] == report["purple_points"]["items"].size());
  CHECK(report["uncertified_cells"].empty());
  CHECK(report["obstacles"].empty());
  const auto& certificate = report["certificate"];
  CHECK(certificate["written"] == true);
  CHECK(certificate["certified"] == true);
  CHECK(certificate["undecided"] == 0);
  CHECK(certificate["subset"] == false);
  CHECK(certificate["counts"]["red"]["segments"] == 2);
  CHECK(certificate["counts"]["umbilics"] == 4);
  CHECK(certificate["claims"] == nlohmann::json::array({"ridges-smooth"}));
  CHECK(certificate["bytes"] == fs::file_size(folder / "e.crest"));
  CHECK(certificate["bytes_per_triangle"].get<double>() ==
        Approx(certificate["bytes"].get<double>() / report["triangles"].get<double>()));
  for (const char* phase : {"completeness", "start", "faces", "umbilics", "bisection", "graph",
                            "certificate", "write", "total"}) {
    INFO(phase);
    CHECK(report["seconds"].contains(phase));
  }
  CHECK(report["face_tests"].get<int>() >= report["triangles"].get<int>());
  std::istringstream counts(split_lines(read_text(folder / "m.off")).at(1));
  int vertices = 0, faces = 0;
  counts >> vertices >> faces;
  CHECK(report["triangles"] == faces);
  CHECK(digest_in_vtp(folder / "e.vtp") == report["data_digest"].get<std::string>());
  CHECK(read_text(folder / "e.svg").find("umbilic +1/2, 1-ridge") != std::string::npos);
  const auto verdict = run_for("crest-verify e.crest", folder.path(), 0);
  CHECK(verdict.out.find("ACCEPTED") != std::string::npos);
}

TEST_CASE("a patch given by its parametrisation is certified, its ridges end at its boundary") {
  const TemporaryFolder folder;
  run_for(std::string(kPatch) + "-o p.vtp --report p.json", folder.path(), 0);
  const auto report = read_json(folder / "p.json");
  CHECK(report["surface"]["kind"] == "parametric");
  CHECK(report["surface"]["expressions"].size() == 3);
  CHECK(report["surface"]["domain"] == nlohmann::json::array({"-0.5", "0.6", "-0.5", "0.6"}));
  CHECK(report["euler_characteristic"] == 1);
  CHECK(report["boundary_loops"] == 1);
  CHECK(report["umbilics"]["count"] == 1);
  CHECK(report["ridges"]["blue"]["segments"] == 2);
  CHECK(report["ridges"]["red"]["segments"] == 1);
  CHECK(report["open_ends"] == 0);
  CHECK(report["certificate"]["certified"] == true);
  CHECK(report["certificate"]["written"] == false);
  CHECK(report["certificate"]["claims"].empty());
}

TEST_CASE("a sphere is refused: exit code 4, cells with reasons, no certificate") {
  const TemporaryFolder folder;
  const auto run =
      run_for(std::string(kSphere) +
                  "--start-faces 50 --max-depth 1 -o s.vtp --mesh m.vtp --picture s.png "
                  "--report s.json --certificate s.crest",
              folder.path(), 4);
  CHECK(run.out.find("NOT CERTIFIED: ") != std::string::npos);
  CHECK(run.out.find("s.crest was not written") != std::string::npos);
  CHECK(run.out.find("  at (") != std::string::npos);
  CHECK_FALSE(fs::exists(folder / "s.crest"));
  for (const char* name : {"s.vtp", "m.vtp", "s.png"}) CHECK(fs::exists(folder / name));
  const auto report = read_json(folder / "s.json");
  CHECK(report["certificate"]["written"] == false);
  CHECK(report["certificate"]["certified"] == false);
  CHECK(report["certificate"]["undecided"].get<int>() > 0);
  CHECK(report["certificate"]["claims"].empty());
  CHECK_FALSE(report["certificate"].contains("bytes"));
  REQUIRE_FALSE(report["uncertified_cells"].empty());
  const auto& cell = report["uncertified_cells"][0];
  CHECK(cell["center"].size() == 3);
  CHECK(cell["size"].get<double>() > 0);
  CHECK_FALSE(cell["reason"].get<std::string>().empty());
  CHECK(report["depth"] == 1);
  CHECK(report["stopped"] == false);
}

TEST_CASE("a limit of time and Ctrl-C stop a long run: exit code 4, files, no certificate") {
  const TemporaryFolder folder;
  // The first round takes seconds on any machine.
  const std::string line =
      "crest ridges --param '(2+(0.7+0.1*cos(u))*cos(v))*cos(u);(2+(0.7+0.1*cos(u))*cos(v))*sin(u);"
      "(0.7+0.1*cos(u))*sin(v)+0.15*cos(3*u)' --domain '0,2*pi,0,2*pi' --periodic uv "
      "--start-faces 200000 -o t.vtp --mesh t.off "
      "--report t.json --certificate t.crest ";
  for (const std::string& stopped :
       {line + "--seconds 0.5", "timeout --preserve-status -s INT 1 " + line}) {
    const auto run = run_for(stopped, folder.path(), 4);
    CHECK(run.out.find("NOT CERTIFIED: stopped: ") != std::string::npos);
    CHECK(run.out.find("t.crest was not written") != std::string::npos);
    CHECK_FALSE(fs::exists(folder / "t.crest"));
    const auto report = read_json(folder / "t.json");
    CHECK(report["stopped"] == true);
    CHECK(report["certificate"]["certified"] == false);
    CHECK(report["certificate"]["undecided"].get<int>() > 0);
    CHECK_FALSE(report["uncertified_cells"].empty());
    for (const char* name : {"t.vtp", "t.off", "t.json"}) fs::remove(folder / name);
  }
  check_refused("crest ridges --surface x --box 0,1 --seconds 0", folder.path(), 2, "--seconds");
  check_refused("crest ridges --surface x --box 0,1 --seconds -1", folder.path(), 2, "--seconds");
}

TEST_CASE("a limit of time that is not reached changes nothing") {
  const TemporaryFolder folder;
  run_for(std::string(kPatch) + "--quiet -o a.vtp --certificate a.crest", folder.path(), 0);
  run_for(std::string(kPatch) + "--quiet --seconds 1000 -o b.vtp --certificate b.crest",
          folder.path(), 0);
  CHECK((read_text(folder / "a.crest") == read_text(folder / "b.crest")));
  CHECK((read_text(folder / "a.vtp") == read_text(folder / "b.vtp")));
}

TEST_CASE("a budget that is spent is exit code 4") {
  const TemporaryFolder folder;
  run_for(std::string(kSphere) + "--start-faces 50 --budget 60 --quiet", folder.path(), 4);
}

TEST_CASE("surfaces that reach the box or are singular are refused, exit code 1") {
  const TemporaryFolder folder;
  for (const char* line : {
           "crest ridges --surface 'x^2 + y^2 - 1' --box '-2,2' --report r.json",
           "crest ridges --surface 'x^2 + y^2 - z^2' --box '-1,1.1' --report r.json",
           "crest ridges --surface 'x^2 + y^2 + z^2 + 1' --box '-1,1.1' --report r.json",
       }) {
    const auto run = run_for(line, folder.path(), 1);
    CHECK(run.out.find("NOT CERTIFIED: ") != std::string::npos);
    const auto report = read_json(folder / "r.json");
    CHECK(report["certificate"]["certified"] == false);
    CHECK_FALSE(report["obstacles"].empty());
  }
}

TEST_CASE("wrong expressions, boxes and domains: exit code 3, one line, the column") {
  const TemporaryFolder folder;
  const std::pair<const char*, const char*> lines[] = {
      {"crest ridges --surface 'x^2 + ' --box '-1,1'", "column 7"},
      {"crest ridges --surface 'x^2 + w' --box '-1,1'", "column 7"},
      {"crest ridges --surface '' --box '-1,1'", "column 1"},
      {"crest ridges --surface 'x^2' --box '1,-1'", "box"},
      {"crest ridges --surface 'x^2' --box '1,1'", "box"},
      {"crest ridges --surface 'x^2' --box 'a,1'", "'a'"},
      {"crest ridges --surface 'x^2' --box '0,inf'", "box"},
      {"crest ridges --surface 'x^2' --box '0,1,2'", "3 numbers"},
      {"crest ridges --surface 'x^2' --box ''", "--box"},
      {"crest ridges --param 'u;v' --domain '0,1,0,1'", "2 expressions"},
      {"crest ridges --param 'u;v;u*' --domain '0,1,0,1'", "column 3"},
      {"crest ridges --param 'u;v;x' --domain '0,1,0,1'", "column 1"},
      {"crest ridges --param 'u;v;u*v' --domain '0,1,0'", "3 expressions"},
      {"crest ridges --param 'u;v;u*v' --domain '0,u,0,1'", "u1"},
      {"crest ridges --param 'u;v;u*v' --domain '1,0,0,1'", "domain"},
      {"crest ridges --param 'u;v;u*v' --domain '0,1,0,1' --periodic u", "periodic"},
      {"crest ridges --surface 'x^2' --box '-1,1' -o no/such.vtp", "no/such.vtp"},
  };
  for (const auto& [line, word] : lines) check_refused(line, folder.path(), 3, word);
}

TEST_CASE("a surface that exists nowhere is refused, with the column of what is not defined") {
  const TemporaryFolder folder;
  const std::string z = "0.5*(1.2*u^2+v^2)+0.1*u^3-0.07*u*v^2+0.05*v^3+0.03*u^4+0.04*v^4";
  // The text of z begins a column of its own.
  const auto at = [&](std::size_t offset) {
    return "column " + std::to_string(z.size() + offset) + ": ";
  };
  const std::tuple<const char*, std::size_t, const char*> parts[] = {
      {"+log(u-1)", 2, "log(u-1)"},   {"+log(-1-u^2)", 2, "log(-1-u^2)"},
      {"+sqrt(-1)", 2, "sqrt(-1)"},   {"+0*sin(1/0)", 8, "1/0"},
      {"+0*log(0-1)", 4, "log(0-1)"}, {"+exp(1/0)", 6, "1/0"}};
  for (const auto& [part, offset, named] : parts) {
    const std::string line = "crest ridges --param 'u;v;" + z + part +
                             "' --domain 0.11,0.3,0.1,0.3 -o l.vtp --certificate l.crest";
    check_refused(line, folder.path(), 3, at(offset) + named + " is defined nowhere in the domain");
  }
  // Undefined in a part of the domain: not ill-posed, but nothing is certified.
  const auto half = run_for("crest ridges --param 'u;v;" + z +
                                "+log(u-0.2)' --domain 0.11,0.3,0.1,0.3 -o l.vtp --report l.json "
                                "--certificate l.crest",
                            folder.path(), 1);
  CHECK(half.out.find("NOT CERTIFIED: " + at(2) + "log(u-0.2) is not defined at (u, v) = (") !=
        std::string::npos);
  CHECK_FALSE(fs::exists(folder / "l.crest"));
  CHECK(read_json(folder / "l.json")["certificate"]["certified"] == false);
  check_refused("crest ridges --param 'u;v;u*v' --domain '0,1+0*log(-1),0,1'", folder.path(), 3,
                "column 5: log(-1) is not defined (in u1 = 1+0*log(-1))");
  check_refused(std::string("crest ridges --surface 'x^2+y^2/2.25+z^2/4-1+0*log(-x^2-1)' ") +
                    "--box '-3,3' --certificate l.crest",
                folder.path(), 3, "column 24: log(-x^2-1) is defined nowhere in the box");
}

TEST_CASE("one surface, and options of its kind: else exit code 2") {
  const TemporaryFolder folder;
  write_text(folder / "t.off",
             "OFF\n4 4 0\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n"
             "3 0 2 1\n3 0 1 3\n3 1 2 3\n3 0 3 2\n");
  const std::string surface = "crest ridges --surface 'x^2+y^2+z^2-1' --box '-2,2' ";
  const std::string param = "crest ridges --param 'u;v;u*v' --domain '0,1,0,1' ";
  const std::pair<std::string, const char*> lines[] = {
      {"crest ridges", "INPUT"},
      {surface + "t.off", "INPUT"},
      {surface + "--param 'u;v;u*v' --domain '0,1,0,1'", "--param"},
      {"crest ridges --surface 'x^2+y^2+z^2-1'", "--box"},
      {"crest ridges --box '-1,1'", "--surface"},
      {"crest ridges --param 'u;v;u*v'", "--domain"},
      {"crest ridges --domain '0,1,0,1' t.off", "--param"},
      {surface + "--rings 2", "--rings"},
      {surface + "--scale auto", "--scale"},
      {surface + "--crest-only", "--crest-only"},
      {param + "--min-length 1", "--min-length"},
      {surface + "--periodic u", "--periodic"},
      {param + "--periodic w", "--periodic"},
      {"crest ridges t.off --max-depth 3", "--max-depth"},
      {"crest ridges t.off --mesh m.off", "--mesh"},
      {surface + "--max-depth -1", "--max-depth"},
      {surface + "--budget 0", "--budget"},
      {surface + "--start-faces 3", "--start-faces"},
      {surface + "-o e.xyz", "e.xyz"},
      {surface + "--mesh e.stl", "e.stl"},
      {surface + "-o e.vtp --mesh e.vtp", "same file"},
  };
  for (const auto& [line, word] : lines) check_refused(line, folder.path(), 2, word);
}

TEST_CASE("certified output bytes do not depend on the number of threads") {
  const TemporaryFolder folder;
  for (const char* threads : {"1", "2", "3"}) {
    const std::string n = threads;
    const auto run =
        run_for(std::string(kPatch) + "--quiet --threads " + n + " -o " + n + ".vtp --mesh " + n +
                    "-mesh.vtp --picture " + n + ".svg --certificate " + n + ".crest",
                folder.path(), 0);
    CHECK(run.out.empty());
    CHECK(run.err.empty());
  }
  for (const char* extension : {".vtp", "-mesh.vtp", ".svg", ".crest"}) {
    INFO(extension);
    const std::string one = read_text(folder / (std::string("1") + extension));
    CHECK(one.size() > 1000);
    CHECK((one == read_text(folder / (std::string("2") + extension))));
    CHECK((one == read_text(folder / (std::string("3") + extension))));
  }
}

TEST_CASE("citing a smooth surface's run prints what its claim rests on") {
  const TemporaryFolder folder;
  const auto run = run_for(std::string(kSphere) + "--quiet --cite --start-faces 50 --max-depth 0",
                           folder.path(), 4);
  for (const char* key : {"cazals2004ridges", "plantinga2004isotopic", "krawczyk1969newton",
                          "rivara1984algorithms", "makino2003taylor"}) {
    INFO(key);
    CHECK(run.out.find(std::string("{") + key + ",") != std::string::npos);
  }
  CHECK(run.out.find("{cgal,") == std::string::npos);
}
