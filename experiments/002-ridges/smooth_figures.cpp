// SPDX-License-Identifier: GPL-3.0-or-later
// Pictures of certified ridges: the surfaces of smooth_table.md with their umbilics, ridges by
// colour and type, turning and purple points.
#include <fmt/format.h>

#include <cctype>
#include <filesystem>

#include "algorithms/smooth_ridges/smooth_ridges.hpp"
#include "experiments/002-ridges/smooth_surfaces.hpp"
#include "experiments/program.hpp"
#include "io/ridges/smooth_ridge_picture.hpp"
#include "kernel/arithmetic/self_test.hpp"

namespace crest {
namespace {

/// Letters and digits, else one hyphen.
std::string file_name(const std::string& name) {
  std::string out;
  for (const char c : name)
    if (std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '.')
      out += c;
    else if (!out.empty() && out.back() != '-')
      out += '-';
  return out + ".png";
}

void run(const std::filesystem::path& folder) {
  std::filesystem::create_directories(folder);
  for (const auto& surface : experiments::generic_surfaces()) {
    const auto result = smooth_ridges::smooth_ridges(experiments::make_surface(surface), {});
    io::PictureOptions options;
    options.width = 560;
    io::write_smooth_picture(folder / file_name(surface.name), result, options);
    fmt::print("{}: {}\n", file_name(surface.name),
               result.certified ? "certified" : "not certified");
    std::fflush(stdout);
  }
}

}  // namespace
}  // namespace crest

int main(int argc, char** argv) {
  std::string folder = "smooth-figures";
  crest::experiments::Program program("Pictures of certified ridges");
  program.option("--folder", folder, "where to");
  return program.run(argc, argv, [&] {
    crest::kernel::require_sound_floating_point();
    crest::run(folder);
    return 0;
  });
}
