// SPDX-License-Identifier: GPL-3.0-or-later
// What all commands write, byte for byte, and what they do on a machine that cannot certify.
#include <algorithm>
#include <catch2/catch.hpp>
#include <iterator>

#include "tests/cli/run_crest.hpp"

using namespace crest::tests;

TEST_CASE("all outputs on ten inputs have the digests kept beside this test") {
  const TemporaryFolder folder;
  const fs::path tests = fs::path(CREST_SOURCE_DIR) / "tests/cli";
  const auto run = run_crest("sh '" + (tests / "outputs.sh").string() + "'", folder.path());
  INFO(run.err);
  REQUIRE(run.exit_code == 0);
  const auto lines = split_lines(run.out), kept = split_lines(read_text(tests / "outputs.sha256"));
  CHECK(kept.size() > 80);
  std::vector<std::string> changed;
  std::set_symmetric_difference(lines.begin(), lines.end(), kept.begin(), kept.end(),
                                std::back_inserter(changed));
  CHECK(changed.empty());
  // ParaView 5.11 with an up-to-date libexpat reads no points from appended data.
  std::size_t data_sets = 0;
  for (const auto& entry : fs::directory_iterator(folder.path())) {
    INFO(entry.path().filename().string());
    const std::string bytes = read_text(entry.path());
    CHECK(bytes.find("AppendedData") == std::string::npos);
    if (entry.path().extension() != ".vtp" && entry.path().extension() != ".vtu") continue;
    ++data_sets;
    CHECK(bytes.find("format=\"binary\"") != std::string::npos);
    CHECK(bytes.find("vtkZLibDataCompressor") != std::string::npos);
  }
  CHECK(data_sets > 12);
}

TEST_CASE("a machine with unsound floating point: exit code 70 from every command that certifies") {
  const TemporaryFolder folder;
  // Loaded before the program, it leaves the rounding mode changed.
  const std::string unsound =
      "ASAN_OPTIONS=verify_asan_link_order=0 LD_PRELOAD='" CREST_ROUND_UPWARD "' ";
  REQUIRE(run_crest("crest sample ellipsoid --vertices 600 -o ellipsoid.off && crest ridges "
                    "ellipsoid.off --quiet --certificate sound.crest",
                    folder.path())
              .exit_code == 0);
  const auto entries = folder.entries();
  std::size_t certifying = 0;
  for (const std::string& name : command_names(run_crest("crest --help", folder.path()).out)) {
    const std::string help = run_crest("crest " + name + " --help", folder.path()).out;
    if (help.find("--certificate") == std::string::npos) continue;
    ++certifying;
    for (const std::string& example : examples_of(help)) {
      const auto run = run_crest(unsound + example, folder.path());
      INFO(example << "\n" << run.err);
      CHECK(run.exit_code == 70);
      CHECK(run.out.empty());
      CHECK(is_one_line(run.err));
      CHECK(run.err.find("internal error: this machine's floating point") != std::string::npos);
    }
  }
  CHECK(certifying >= 3);
  CHECK(folder.entries() == entries);
  const auto verdict = run_crest(unsound + "crest-verify sound.crest", folder.path());
  CHECK(verdict.exit_code == 70);
  CHECK(verdict.out.empty());
}
