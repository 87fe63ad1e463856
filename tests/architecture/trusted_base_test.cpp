// SPDX-License-Identifier: GPL-3.0-or-later
// What the documents say a user must trust: scripts/trusted_base.sh computes it from the sources.
#include <catch2/catch.hpp>
#include <regex>
#include <set>

#include "tests/architecture/source_tree.hpp"

namespace {

using namespace crest::tests;

ProgramResult trusted_base(const std::string& root, const std::string& arguments) {
  const TemporaryFolder folder;
  return run_shell("'" + root + "/scripts/trusted_base.sh' " + arguments, folder.path(),
                   "/usr/bin");
}

bool mentions(const std::string& text, const std::string& what) {
  return text.find(what) != std::string::npos;
}

}  // namespace

TEST_CASE("the documents state the trusted base that the sources have") {
  const ProgramResult check = trusted_base(CREST_SOURCE_DIR, "--check");
  INFO(check.err);
  CHECK(check.exit_code == 0);
  // Each that speaks of the trusted base holds a table.
  for (const char* document :
       {"README.md", "certify/SPEC.md", "docs/certification.md", "docs/certified-ridges.md"}) {
    INFO(document << "\n" << check.out);
    CHECK(mentions(check.out, std::string(document) + " agrees"));
  }
}

TEST_CASE("the trusted base follows includes, sources of headers and sources without one") {
  const TemporaryFolder tree;
  const auto file = [&](const std::string& path, const std::string& text) {
    fs::create_directories((tree / path).parent_path());
    write_text(tree / path, text);
  };
  fs::create_directories(tree / "scripts");
  fs::copy_file(fs::path(CREST_SOURCE_DIR) / "scripts/trusted_base.sh",
                tree / "scripts/trusted_base.sh");
  file("cli/crest_verify.cpp",
       "// comment\n#include <CLI/CLI.hpp>\n#include \"kernel/a/x.hpp\"\n\n");
  file("kernel/a/x.hpp", "#include <vector>\nint x();\n");
  file("kernel/a/x.cpp", "#include \"kernel/a/x.hpp\"\nint x() {\n  return 1;  // one\n}\n");
  file("kernel/a/y.hpp", "int y();\n");
  file("certify/claim_table.cpp.in", "int table;\n");
  file("certify/one/claim.cpp", "#include \"certify/one/parts.hpp\"\n");
  file("certify/one/parts.hpp", "int part();\n");
  file("certify/one/part.cpp", "int part() { return 0; }\n");
  file("certify/one/encode.hpp", "int encode();\n");
  file("certify/one/encode.cpp", "#include \"kernel/a/y.hpp\"\n");
  file("certify/two/claim.cpp", "#include \"kernel/a/y.hpp\"\n");
  const ProgramResult one = trusted_base(tree.path().string(), "one");
  REQUIRE(one.exit_code == 0);
  CHECK(one.out ==
        "crest-verify-one\n"
        "     1  certify/claim_table.cpp.in\n"
        "     1  certify/one/claim.cpp\n"
        "     1  certify/one/part.cpp\n"
        "     1  certify/one/parts.hpp\n"
        "     2  cli/crest_verify.cpp\n"
        "     4  kernel/a/x.cpp\n"
        "     2  kernel/a/x.hpp\n"
        "        <CLI/CLI.hpp>\n"
        "    12  lines of code in 7 files\n\n");
  CHECK(mentions(trusted_base(tree.path().string(), "--table").out,
                 "| `crest-verify-one` | 7 | 4 | 6 | 2 | 12 |\n"
                 "| `crest-verify-two` | 6 | 2 | 7 | 2 | 11 |\n"
                 "| `crest-verify` | 9 | 5 | 7 | 2 | 14 |\n"));

  // A document with another number is found, and mended.
  file("docs/page.md",
       "before\n<!-- trusted base one -->\nold\n<!-- end of trusted base -->\nafter\n");
  file("README.md", "");
  file("certify/SPEC.md", "");
  file("certify/one/SPEC.md", "");
  CHECK(trusted_base(tree.path().string(), "--check").exit_code == 1);
  CHECK(trusted_base(tree.path().string(), "--update").exit_code == 0);
  CHECK(trusted_base(tree.path().string(), "--check").exit_code == 0);
  const std::string page = read_text(tree / "docs/page.md");
  CHECK(page.rfind("before\n<!-- trusted base one -->\n| program |", 0) == 0);
  CHECK(mentions(page, "| `crest-verify-one` | 7 | 4 | 6 | 2 | 12 |"));
  CHECK(mentions(page, "\n<!-- end of trusted base -->\nafter\n"));
}

#ifdef CREST_VERIFY_PROGRAM
namespace {

/// The sources of a member of libcrest_<library>.a, from the source's folder on: itself, or those
/// that the build compiles together as "unity_<n>_cxx.cxx".
std::vector<std::string> sources_of(const std::string& library, const std::string& member) {
  const std::string folder =
      has_prefix(library, "certify_") ? "certify/" + library.substr(8) + "/" : library + "/";
  if (!has_prefix(member, "unity_")) return {folder + member};
  const std::string together = read_text(fs::path(CREST_BINARY_DIR) / "certify/CMakeFiles" /
                                         ("crest_" + library + ".dir") / "Unity" / member);
  const std::regex include("#include \"" + std::string(CREST_SOURCE_DIR) + "/([^\"]+)\"");
  std::vector<std::string> sources;
  for (std::sregex_iterator at(together.begin(), together.end(), include), end; at != end; ++at)
    sources.push_back((*at)[1]);
  INFO(together);
  REQUIRE_FALSE(sources.empty());
  for (const std::string& source : sources) REQUIRE(has_prefix(source, folder));
  return sources;
}

}  // namespace

TEST_CASE("a checker is linked from files of its trusted base alone") {
  // Members of archives as the linker's map names them.
  const std::regex member("libcrest_([a-z_0-9]+)\\.a\\(([a-z_0-9]+\\.c(pp|xx))\\.o\\)");
  for (const auto& entry : fs::directory_iterator(fs::path(CREST_SOURCE_DIR) / "certify")) {
    if (!fs::exists(entry.path() / "claim.cpp")) continue;
    const std::string claim = entry.path().filename().string();
    std::string program = CREST_VERIFY_PROGRAM + ("-" + claim);
    std::replace(program.begin() + static_cast<std::ptrdiff_t>(program.rfind('/')), program.end(),
                 '_', '-');
    INFO(program);
    const ProgramResult base = trusted_base(CREST_SOURCE_DIR, claim);
    REQUIRE(base.exit_code == 0);
    const std::string map = read_text(program + ".map");
    std::set<std::string> linked;
    for (std::sregex_iterator at(map.begin(), map.end(), member), end; at != end; ++at)
      for (std::string& source : sources_of((*at)[1], (*at)[2])) linked.insert(std::move(source));
    CHECK(linked.size() > 5);
    for (const std::string& source : linked) {
      INFO(source << " is linked and not listed\n" << base.out);
      if (has_prefix(source, "kernel/"))
        CHECK(
            std::regex_search(base.out, std::regex("  kernel/[a-z_]+/" + source.substr(7) + "\n")));
      else
        CHECK(mentions(base.out, "  " + source + "\n"));
    }
  }
}
#endif
