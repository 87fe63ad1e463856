// SPDX-License-Identifier: GPL-3.0-or-later
// crest-mpi: `mpirun -np N crest-mpi COMMAND ...` is `crest COMMAND ...`, with the same bytes.
#include <signal.h>
#include <tbb/global_control.h>
#include <unistd.h>

#include <algorithm>
#include <charconv>
#include <cstdio>
#include <optional>
#include <string_view>

// DIY's headers forget the first two.
// clang-format off
#include <stdexcept>
#include <string>
#include <vtk_diy2.h>
#include VTK_DIY2(diy/mpi.hpp)
// clang-format on

#include "cli/command.hpp"
#include "cli/program.hpp"
#include "distributed/systems.hpp"

namespace {

/// Whoever starts the ranks ends those that are left when one has died.
void stop(int) {
  constexpr std::string_view words =
      "crest-mpi: stopped before the end, nothing was written (did a rank die? extremal's "
      "--restart FOLDER goes on from what is done)\n";
  // Whether it can be said or not.
  [[maybe_unused]] const auto written = write(STDERR_FILENO, words.data(), words.size());
  _exit(crest::cli::kInternal);
}

int refuse(const char* what) {
  std::fprintf(stderr, "crest-mpi: %s\n", what);
  return crest::cli::kUsage;
}

/// Smooth surfaces are searched by one process.
bool is_smooth(int argc, char** argv) {
  return std::any_of(argv, argv + argc, [](std::string_view word) {
    return word.starts_with("--surface") || word.starts_with("--param");
  });
}

/// Of the command line, whose other words concern rank 0 alone, which also says if they are wrong.
std::size_t threads_in(int argc, char** argv) {
  constexpr std::string_view name = "--threads";
  std::size_t threads = 0;
  for (int i = 1; i < argc; ++i) {
    std::string_view word = argv[i];
    if (!word.starts_with(name)) continue;
    word.remove_prefix(name.size());
    if (word.starts_with('='))
      word.remove_prefix(1);
    else if (word.empty() && i + 1 < argc)
      word = argv[i + 1];
    std::from_chars(word.data(), word.data() + word.size(), threads);
  }
  return threads;
}

void serve(std::size_t threads) {
  std::optional<tbb::global_control> limit;
  if (threads > 0) limit.emplace(tbb::global_control::max_allowed_parallelism, threads);
  auto skills = crest::distributed::volume_skills();
  skills.merge(crest::distributed::mesh_skills());
  crest::distributed::serve(skills);
}

int run(int argc, char** argv) {
  const std::string_view command = argc < 2 ? "" : argv[1];
  if (command != "curvature" && command != "extremal" && command != "modes" && command != "ridges")
    return refuse(
        "curvature, extremal, modes and ridges are what several processes do (mpirun -np N "
        "crest-mpi ridges ...)");
  if (command == "ridges" && is_smooth(argc, argv))
    return refuse("several processes find ridges of meshes, not of --surface or --param");
  crest::distributed::use_ranks_for_volumes();
  crest::distributed::use_ranks_for_meshes();
  return crest::cli::run_program(argc, argv);
}

}  // namespace

int main(int argc, char** argv) {
  diy::mpi::environment environment(argc, argv);
  const diy::mpi::communicator world;
  int code = 0;
  if (world.rank() == 0) {
    signal(SIGTERM, stop);
    code = run(argc, argv);
    crest::distributed::dismiss();
    const bool quiet = std::any_of(
        argv, argv + argc, [](const char* word) { return std::string_view(word) == "--quiet"; });
    if (code == crest::cli::kDone && !quiet)
      std::printf("processes: %d, which sent one another %zu bytes\n", world.size(),
                  crest::distributed::bytes_exchanged());
  } else {
    serve(threads_in(argc, argv));
  }
  diy::mpi::broadcast(world, code, 0);
  return code;
}
