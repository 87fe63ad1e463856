// SPDX-License-Identifier: GPL-3.0-or-later
// Claim 4's two checkers on the surfaces of the tables: verdicts and processor time of the programs
// as a user runs them.
#include <fmt/format.h>
#include <sys/resource.h>
#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>

#include "algorithms/smooth_ridges/smooth_ridges.hpp"
#include "certify/ridges_smooth/encode.hpp"
#include "experiments/002-ridges/smooth_surfaces.hpp"
#include "experiments/program.hpp"
#include "kernel/arithmetic/self_test.hpp"

namespace crest {
namespace {

using experiments::SmoothSurface;

struct Options {
  std::string first = "build/cli/crest-verify", second = "build/certify/second/crest-recheck";
  std::vector<std::string> only;
};

/// Of programs that have ended.
double children_seconds() {
  rusage usage{};
  getrusage(RUSAGE_CHILDREN, &usage);
  const auto of = [](const timeval& t) {
    return static_cast<double>(t.tv_sec) + 1e-6 * static_cast<double>(t.tv_usec);
  };
  return of(usage.ru_utime) + of(usage.ru_stime);
}

struct Verdict {
  std::string text;
  double seconds;
};
Verdict judged(const std::string& program, const std::filesystem::path& file) {
  const double begin = children_seconds();
  const int status = std::system((program + " " + file.string() + " > /dev/null").c_str());
  const bool known = status == 0 || (WIFEXITED(status) && WEXITSTATUS(status) == 1);
  return {status == 0 ? "accepted" : known ? "REJECTED" : "NO ANSWER", children_seconds() - begin};
}

void row(const SmoothSurface& surface, const Options& o) {
  const auto result = smooth_ridges::smooth_ridges(experiments::make_surface(surface), {});
  if (!result.certified) {
    fmt::print("| {} | | | | not certified |\n", surface.name);
    return;
  }
  const certify::Bytes bytes = certify::encode(result.certificate);
  const auto file = std::filesystem::temp_directory_path() /
                    fmt::format("recheck-{}.crest", static_cast<long>(getpid()));
  std::ofstream(file, std::ios::binary)
      .write(reinterpret_cast<const char*>(bytes.data()),
             static_cast<std::streamsize>(bytes.size()));
  const Verdict first = judged(o.first, file), second = judged(o.second, file);
  std::filesystem::remove(file);
  fmt::print("| {} | {:.2f} | {:.2f} | {:.0f} | {}, {} |\n", surface.name, first.seconds,
             second.seconds, second.seconds / first.seconds, first.text, second.text);
}

void run_table(const Options& o) {
  fmt::print("| surface | crest-verify s | crest-recheck s | quotient | verdicts |\n");
  fmt::print("|---|---|---|---|---|\n");
  auto surfaces = experiments::generic_surfaces();
  for (SmoothSurface& s : experiments::reported_surfaces()) surfaces.push_back(std::move(s));
  for (const SmoothSurface& surface : surfaces) {
    const auto named = [&](const std::string& part) {
      return surface.name.find(part) != std::string::npos;
    };
    if (!o.only.empty() && std::none_of(o.only.begin(), o.only.end(), named)) continue;
    row(surface, o);
    std::fflush(stdout);
  }
  fmt::print("\nProcessor seconds of one run each, with the reading of the file.\n");
}

}  // namespace
}  // namespace crest

int main(int argc, char** argv) {
  crest::Options o;
  crest::experiments::Program program("The two checkers of claim 4 on the surfaces of the tables");
  program.option("--first", o.first, "the first checker");
  program.option("--second", o.second, "the second");
  program.option("--only", o.only, "surfaces whose name contains one of these");
  return program.run(argc, argv, [&] {
    crest::kernel::require_sound_floating_point();
    crest::run_table(o);
    return 0;
  });
}
