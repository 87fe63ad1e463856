// SPDX-License-Identifier: GPL-3.0-or-later
// The fuzzers' corpus with bytes changed, cut out, doubled and cut off: a soup or an InputError of
// one line. The fuzzers themselves (tests/fuzz) go further.
#include <catch2/catch.hpp>
#include <filesystem>

#include "tests/io/soups.hpp"
#include "tests/support/random.hpp"
#include "tests/support/temporary_folder.hpp"

namespace {

using namespace crest::tests;

std::string damaged(std::string bytes, Random& random) {
  const auto below = [&](std::size_t n) { return static_cast<std::size_t>(random() % (n + 1)); };
  for (std::size_t edits = 1 + below(3); edits > 0 && !bytes.empty(); --edits) {
    const std::size_t at = below(bytes.size() - 1), length = 1 + below(8);
    switch (random() % 6) {
      case 0:
        bytes[at] = static_cast<char>(random());
        break;
      case 1:
        bytes.erase(at, length);
        break;
      case 2:
        bytes.insert(at, bytes.substr(below(bytes.size() - 1), length));
        break;
      case 3:
        bytes.resize(at);
        break;
      case 4:
        bytes[at] = "0123456789-. \n\r\"#$"[random() % 18];
        break;
      default:
        bytes.insert(at, "99999999999");
    }
  }
  return bytes;
}

}  // namespace

TEST_CASE("damaged files give soups or input errors", "[io]") {
  const auto corpus = std::filesystem::path(CREST_SOURCE_DIR) / "tests" / "fuzz" / "corpus";
  std::vector<std::filesystem::path> files;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(corpus))
    if (entry.is_regular_file()) files.push_back(entry.path());
  std::sort(files.begin(), files.end());
  Random random(kSeed);
  std::size_t soups = 0, errors = 0;
  for (const auto& path : files) {
    const std::string format = path.parent_path().filename().string();
    const bool xml = format == "vtp" || format == "vtu";  // VTK is slow
    const std::string whole = read_text(path.string());
    for (std::uint64_t i = scaled(xml ? 20 : 300); i > 0; --i) {
      const std::string bytes = damaged(whole, random);
      INFO(path << ", case " << i << ", " << random_origin());
      std::string line;
      try {
        crest::io::read_named("mesh." + format, [&] {
          const auto soup = soup_of("mesh." + format, bytes, {.wanted = true, .normals = true});
          for (const auto& field : soup.point_fields)
            CHECK((field.missing.empty() || field.missing.size() == soup.points.size()));
        });
        ++soups;
        continue;
      } catch (const crest::kernel::InputError& error) {
        line = error.what();
      }
      ++errors;
      if (line.find('\n') != line.npos || line.find("; ") == line.npos) FAIL_CHECK(line);
    }
  }
  CHECK(soups > files.size());
  CHECK(errors > files.size());
}
