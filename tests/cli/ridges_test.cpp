// SPDX-License-Identifier: GPL-3.0-or-later
// crest sample, crest ridges and crest-verify, end to end.
#include <catch2/catch.hpp>

#include "tests/cli/run_crest.hpp"
#include "tests/cli/vtp_digest.hpp"

using namespace crest::tests;

namespace {

/// A rotated ellipsoid e.off in a folder of its own.
struct EllipsoidFolder : TemporaryFolder {
  explicit EllipsoidFolder(int vertices = 2500) {
    const auto made = run_crest("crest sample ellipsoid --parameters 1,1.5,2 --rotate --vertices " +
                                    std::to_string(vertices) + " -o e.off",
                                path());
    INFO(made.err);
    REQUIRE(made.exit_code == 0);
  }
};

ProgramResult require_done(const std::string& line, const fs::path& folder) {
  const auto result = run_crest(line, folder);
  INFO(line << "\n" << result.err << result.out);
  REQUIRE(result.exit_code == 0);
  return result;
}

}  // namespace

TEST_CASE("ridges of an ellipsoid: known answers, files, a certificate that verifies") {
  const EllipsoidFolder folder(10000);
  const auto run = require_done(
      "crest ridges e.off -o e.vtp --picture e.svg --report e.json --certificate e.crest",
      folder.path());
  CHECK(run.err.empty());  // no progress when piped
  CHECK(run.out.find("index sum 2") != std::string::npos);
  const auto report = read_json(folder / "e.json");
  CHECK(report["euler_characteristic"] == 2);
  CHECK(report["boundary_loops"] == 0);
  CHECK(report["umbilics"]["count"] == 4);
  CHECK(report["umbilics"]["index_sum"] == 2);
  for (const auto& umbilic : report["umbilics"]["items"]) {
    CHECK(umbilic["index"] == 0.5);
    CHECK(umbilic["kind"] == "1-ridge");
    CHECK(umbilic["point"].size() == 3);
  }
  for (const char* colour : {"blue", "red"}) {
    INFO(colour);
    CHECK(report["ridges"][colour]["loops"] == 1);
    CHECK(report["ridges"][colour]["segments"] == 2);
  }
  CHECK(report["open_ends"] == 0);
  CHECK(report["certificate"]["written"] == true);
  CHECK(report["certificate"]["certified"] == true);
  CHECK(report["certificate"]["claims"] == nlohmann::json::array({"ridges-mesh"}));
  CHECK(report["data_digest"].get<std::string>().size() == 64);
  for (const char* arithmetic : {"", " --arithmetic mpfr"}) {
    const auto verdict =
        run_crest(std::string("crest-verify e.crest --input e.off") + arithmetic, folder.path());
    INFO(verdict.out << verdict.err);
    CHECK(verdict.exit_code == 0);
    CHECK(verdict.out.find("ACCEPTED") != std::string::npos);
    CHECK(verdict.out.find("positions and faces, oriented as in the file") != std::string::npos);
    CHECK(verdict.out.find("against the faces") == std::string::npos);
    CHECK(verdict.out.find(report["data_digest"].get<std::string>()) != std::string::npos);
  }
  CHECK(read_text(folder / "e.vtp").find("<VTKFile") != std::string::npos);
  CHECK(digest_in_vtp(folder / "e.vtp") == report["data_digest"].get<std::string>());
  CHECK(read_text(folder / "e.svg").find("<svg") != std::string::npos);
}

TEST_CASE("the certificate is about its mesh: crest-verify rejects another and a damaged file") {
  const EllipsoidFolder folder;
  require_done("crest ridges e.off --certificate e.crest", folder.path());
  require_done("crest sample ellipsoid --parameters 1,1.4,2 --rotate --vertices 2500 -o other.off",
               folder.path());
  CHECK(run_crest("crest-verify e.crest --input other.off", folder.path()).exit_code == 1);
  std::string bytes = read_text(folder / "e.crest");
  bytes[bytes.size() - 100] = static_cast<char>(bytes[bytes.size() - 100] ^ 1);
  write_text(folder / "damaged.crest", bytes);
  CHECK(run_crest("crest-verify damaged.crest", folder.path()).exit_code == 1);
  CHECK(run_crest("crest-verify missing.crest", folder.path()).exit_code == 3);
}

TEST_CASE("the report has its keys, also without a certificate") {
  const EllipsoidFolder folder;
  require_done("crest ridges e.off --report e.json --threads 2", folder.path());
  const auto report = read_json(folder / "e.json");
  for (const char* key : {"crest",
                          "command",
                          "input",
                          "seconds",
                          "peak_rss_bytes",
                          "threads",
                          "predicates",
                          "certificate",
                          "warnings",
                          "vertices",
                          "faces",
                          "euler_characteristic",
                          "boundary_loops",
                          "umbilics",
                          "ridges",
                          "open_ends",
                          "conflict_triangles",
                          "ambiguous_edges",
                          "scale",
                          "fit",
                          "paper_umbilics",
                          "dropped",
                          "salience",
                          "data_digest"}) {
    INFO(key);
    CHECK(report.contains(key));
  }
  CHECK(report["command"] == "ridges");
  CHECK(report["input"] == "e.off");
  CHECK(report["threads"] == 2);
  CHECK(report["peak_rss_bytes"].get<double>() > 1e6);
  CHECK(report["seconds"]["total"].get<double>() > 0);
  for (const char* phase : {"read", "fit", "extract", "write"})
    CHECK(report["seconds"].contains(phase));
  REQUIRE_FALSE(report["predicates"].empty());
  for (const auto& [name, counts] : report["predicates"].items()) {
    INFO(name);
    for (const char* stage : {"calls", "interval", "exact", "symbolic"})
      CHECK(counts[stage].is_number_unsigned());
  }
  for (const char* colour : {"blue", "red"}) {
    const auto& part = report["ridges"][colour];
    CHECK(part["length"].get<double>() > 0);
    CHECK(part["elliptic_length"].get<double>() + part["hyperbolic_length"].get<double>() <=
          part["length"].get<double>() * (1 + 1e-12));
  }
  const auto& certificate = report["certificate"];
  CHECK(certificate["written"] == false);
  CHECK(certificate["certified"] == false);
  CHECK(certificate["undecided"] == 0);
  CHECK(certificate["claims"] == nlohmann::json::array());
  CHECK(report["fit"]["vertices_by_degree"]["4"] == report["vertices"]);
  CHECK(report["paper_umbilics"]["plus"].is_number_unsigned());
}

TEST_CASE("output bytes do not depend on the number of threads") {
  const EllipsoidFolder folder(6000);
  for (const char* threads : {"1", "2", "3"}) {
    const std::string n = threads;
    require_done("crest ridges e.off --quiet --threads " + n + " -o " + n + ".vtp --picture " + n +
                     ".svg --certificate " + n + ".crest && crest ridges e.off --quiet --threads " +
                     n + " -o " + n + ".obj && crest ridges e.off --quiet --threads " + n + " -o " +
                     n + ".ply",
                 folder.path());
  }
  for (const char* extension : {".vtp", ".obj", ".ply", ".svg", ".crest"}) {
    INFO(extension);
    const std::string one = read_text(folder / (std::string("1") + extension));
    CHECK(one.size() > 1000);
    CHECK((one == read_text(folder / (std::string("2") + extension))));
    CHECK((one == read_text(folder / (std::string("3") + extension))));
  }
}

TEST_CASE("filters drop ridges from the output and say how many, the certificate keeps all") {
  const EllipsoidFolder folder;
  require_done("crest ridges e.off --quiet --report all.json --certificate all.crest",
               folder.path());
  require_done(
      "crest ridges e.off --quiet --min-length 1e6 --report none.json --certificate none.crest",
      folder.path());
  const auto all = read_json(folder / "all.json"), none = read_json(folder / "none.json");
  const auto ridges = [](const nlohmann::json& report) {
    std::size_t count = 0;
    for (const char* colour : {"blue", "red"}) {
      const auto& part = report["ridges"][colour];
      count += part["loops"].get<std::size_t>() + part["segments"].get<std::size_t>();
    }
    return count;
  };
  CHECK(ridges(all) >= 6);
  CHECK(ridges(none) == 0);
  CHECK(none["dropped"]["by_length"] == ridges(all));
  CHECK(none["umbilics"] == all["umbilics"]);
  CHECK((read_text(folder / "all.crest") == read_text(folder / "none.crest")));
  CHECK(all["certificate"]["subset"] == false);
  CHECK(none["certificate"]["subset"] == true);
  CHECK(none["certificate"]["subset_by"] == nlohmann::json::array({"--min-length"}));
  CHECK(none["certificate"]["counts"] == all["certificate"]["counts"]);
  CHECK(none["certificate"]["counts"]["umbilics"] == 4);
}

TEST_CASE("salience: what is written is said to be a subset of what is certified") {
  const TemporaryFolder folder;
  require_done("crest sample blend --vertices 6000 --noise 0.02 --rotate -o b.off", folder.path());
  const auto whole = require_done(
      "crest ridges b.off --certificate all.crest --report all.json -o all.vtp", folder.path());
  CHECK(whole.out.find("a subset") == std::string::npos);
  CHECK(whole.out.find("whole graph: ") != std::string::npos);
  CHECK(whole.out.find("salient") != std::string::npos);
  const auto all = read_json(folder / "all.json");
  const std::size_t ridges = all["certificate"]["counts"]["blue"]["loops"].get<std::size_t>() +
                             all["certificate"]["counts"]["blue"]["segments"].get<std::size_t>() +
                             all["certificate"]["counts"]["red"]["loops"].get<std::size_t>() +
                             all["certificate"]["counts"]["red"]["segments"].get<std::size_t>();
  for (const std::string level : {"significant", "salient"}) {
    const auto run = require_done("crest ridges b.off --certificate " + level + ".crest --" +
                                      level + " --report " + level + ".json -o " + level + ".vtp",
                                  folder.path());
    CHECK(run.out.find("a subset of the certified graph: ") != std::string::npos);
    CHECK(run.out.find(" of " + std::to_string(ridges) + " ridges (--" + level + ")\n") !=
          std::string::npos);
    const auto report = read_json(folder / (level + ".json"));
    CHECK(report["certificate"]["subset"] == true);
    CHECK(report["certificate"]["counts"] == all["certificate"]["counts"]);
    CHECK(report["salience"]["ridges_" + level].get<std::size_t>() +
              report["dropped"]["by_level"].get<std::size_t>() ==
          ridges);
    CHECK((read_text(folder / (level + ".crest")) == read_text(folder / "all.crest")));
    CHECK(read_text(folder / (level + ".vtp")).size() < read_text(folder / "all.vtp").size());
  }
  const auto counted = require_done("crest ridges b.off --all", folder.path());
  CHECK(counted.out.find("salient") == std::string::npos);
}

TEST_CASE("salience: a cylinder has nothing significant, and the summary says so") {
  const TemporaryFolder folder;
  require_done("crest sample cylinder --vertices 1000 --rotate -o c.off", folder.path());
  const auto run =
      require_done("crest ridges c.off --report c.json --picture c.svg", folder.path());
  CHECK(run.out.find("nothing significant: k1, k2 constant along their lines within the error of "
                     "the fit\n") != std::string::npos);
  CHECK(read_json(folder / "c.json")["salience"]["degenerate"] == true);
  CHECK(read_json(folder / "c.json")["salience"]["support_points"] == 30);
}

TEST_CASE("salience: options that contradict each other are usage errors") {
  const EllipsoidFolder folder;
  for (const char* options :
       {"--salient --significant", "--all --salient", "--salient --significance 0",
        "--scale auto --significance 0", "--significance -1", "--min-weight x"})
    CHECK(run_crest(std::string("crest ridges e.off ") + options, folder.path()).exit_code == 2);
  const auto run =
      require_done("crest ridges e.off --significance 0 --report e.json", folder.path());
  CHECK(run.out.find("salient") == std::string::npos);
  CHECK_FALSE(read_json(folder / "e.json").contains("salience"));
}

TEST_CASE("options change what they name") {
  const EllipsoidFolder folder;
  require_done("crest ridges e.off --quiet --order 3 --report third.json", folder.path());
  require_done("crest ridges e.off --quiet --crest-only --report crest.json", folder.path());
  require_done("crest ridges e.off --quiet --scale 0.4 --report scale.json", folder.path());
  require_done("crest ridges e.off --quiet --scale auto --report auto.json", folder.path());
  require_done("crest ridges e.off --quiet --rings 4 --report rings.json", folder.path());
  CHECK(read_json(folder / "third.json")["order"] == 3);
  CHECK(read_json(folder / "scale.json")["scale"] == 0.4);
  const auto chosen = read_json(folder / "auto.json")["salience"];
  CHECK(chosen["support_choice"].size() >= 3);
  CHECK(chosen["support_choice"][0]["points"] == 30);
  CHECK(chosen["support_points"].get<int>() >= 30);
  const auto crest = read_json(folder / "crest.json");
  for (const char* colour : {"blue", "red"})
    CHECK(crest["ridges"][colour]["hyperbolic_length"] == 0);
  CHECK(read_json(folder / "rings.json")["data_digest"] !=
        read_json(folder / "third.json")["data_digest"]);
}

TEST_CASE("a quiet run is quiet, and noise depends on its seed") {
  const TemporaryFolder folder;
  const std::string sample = "crest sample ellipsoid --vertices 600 --quiet --noise 0.1 ";
  const auto result = require_done(sample + "-o a.off", folder.path());
  CHECK(result.out.empty());
  CHECK(result.err.empty());
  require_done(sample + "--seed 1 -o b.off && " + sample + "--seed 2 -o c.off", folder.path());
  CHECK((read_text(folder / "a.off") == read_text(folder / "b.off")));
  CHECK((read_text(folder / "a.off") != read_text(folder / "c.off")));
  const auto ridges = require_done("crest ridges a.off --quiet", folder.path());
  CHECK(ridges.out.empty());
  CHECK(ridges.err.empty());
}
