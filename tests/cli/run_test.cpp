// SPDX-License-Identifier: GPL-3.0-or-later
// What cli/run.hpp promises every command.
#include "cli/run.hpp"

#include <fcntl.h>

#include <catch2/catch.hpp>
#include <cmath>
#include <csignal>

#include "cli/interrupt.hpp"
#include "io/write/atomic_file.hpp"
#include "io/write/mesh_writer.hpp"
#include "tests/cli/run_crest.hpp"

using namespace crest::tests;
using namespace crest::cli;

namespace {

CommonOptions quiet_options(const TemporaryFolder& folder) {
  CommonOptions options;
  options.output = folder / "out.txt";
  options.report = folder / "report.json";
  options.quiet = true;
  return options;
}

int run_with(const CommonOptions& options, const std::function<void(Run&)>& work) {
  return run_command({"test", options, {".txt"}}, [&](Run& run) {
    run.write("-o", [](const std::string& path) { crest::io::write_atomically(path, "new"); });
    work(run);
    return Outcome{"", {}, kExhausted};
  });
}

/// Runs `work` in a process of its own; returns how that ended (waitpid).
int status_of(const std::function<void()>& work) {
  const pid_t child = fork();
  if (child == 0) {
    for (const int signal : {SIGINT, SIGTERM}) std::signal(signal, SIG_DFL);  // not Catch's
    work();
    _exit(0);
  }
  int status = 0;
  waitpid(child, &status, 0);
  return status;
}

}  // namespace

TEST_CASE("a run's files appear together at its end, its exit code is the work's") {
  const TemporaryFolder folder;
  const CommonOptions options = quiet_options(folder);
  CHECK(run_with(options, [&](Run& run) {
          CHECK(folder.entries() == 0);
          run.warn("a warning");
          run.report()["number"] = 1.5;
          run.report()["undefined"] = Json();
        }) == kExhausted);
  CHECK(folder.entries() == 2);
  CHECK(read_text(folder / "out.txt") == "new");
  const auto report = read_json(folder / "report.json");
  CHECK(report["command"] == "test");
  CHECK(report["number"] == 1.5);
  CHECK(report["undefined"].is_null());
  CHECK(report["warnings"] == nlohmann::json::array({"a warning"}));
}

TEST_CASE("a report never holds a number that is not finite: nothing is written") {
  const TemporaryFolder folder;
  write_text(folder / "out.txt", "old");
  for (const double x : {std::nan(""), HUGE_VAL, -HUGE_VAL}) {
    const auto work = [&](Run& run) {
      run.report()["part"] = {{"good", 1.0}, {"bad", std::vector<double>{0.0, x}}};
    };
    // Exit code 70 by main(), as for everything that is not the user's fault.
    CHECK_THROWS_WITH(run_with(quiet_options(folder), work), "the report's part.bad is not finite");
    CHECK(folder.entries() == 1);
    CHECK(read_text(folder / "out.txt") == "old");
  }
}

TEST_CASE("a file that would hold a number that is not finite: nothing is written") {
  const TemporaryFolder folder;
  write_text(folder / "out.txt", "old");
  const auto work = [&](Run&) {
    crest::io::write_mesh(folder / "good.off", {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}});
    crest::io::write_mesh(folder / "bad.off", {{0, 0, 0}, {1, 0, 0}, {0, HUGE_VAL, 0}},
                          {{0, 1, 2}});
  };
  // As above: what is not InputError ends as exit code 70.
  CHECK_THROWS_WITH(run_with(quiet_options(folder), work), "the output's number is not finite");
  CHECK(folder.entries() == 1);
  CHECK(read_text(folder / "out.txt") == "old");
}

TEST_CASE("a self-test that fails stops a run before it works") {
  const TemporaryFolder folder;
  const CommonOptions options = quiet_options(folder);
  const auto work = [](Run&) -> Outcome { throw std::logic_error("worked"); };
  CHECK_THROWS_WITH(run_command({"test", options, {}}, work,
                                [] { throw std::runtime_error("products are fused"); }),
                    Catch::Contains("floating point") && Catch::Contains("products are fused"));
  CHECK(folder.entries() == 0);
}

TEST_CASE("a killed run leaves nothing and the old files whole") {
  const TemporaryFolder folder;
  // Where the file system has no files without names kill -9 may leave a temporary one.
  const int unnamed = ::open(folder.path().c_str(), O_TMPFILE | O_WRONLY, 0600);
  if (unnamed >= 0) ::close(unnamed);
  REQUIRE(unnamed >= 0);
  write_text(folder / "out.txt", "old");
  for (const int signal : {SIGKILL, SIGINT, SIGTERM}) {
    const int status =
        status_of([&] { run_with(quiet_options(folder), [&](Run&) { std::raise(signal); }); });
    CHECK(WIFSIGNALED(status));
    CHECK(folder.entries() == 1);
    CHECK(read_text(folder / "out.txt") == "old");
  }
}

TEST_CASE("files held back appear over what was made meanwhile, a folder that went is an error") {
  const TemporaryFolder folder;
  const auto place = folder / "sub";
  fs::create_directory(place);
  {
    crest::io::PendingFiles files;
    crest::io::write_atomically(folder / "a.txt", "a");
    crest::io::write_atomically(place / "b.txt", "b");
    CHECK(folder.entries() == 1);
    write_text(place / "b.txt", "made meanwhile");
    files.commit();
  }
  CHECK(read_text(folder / "a.txt") == "a");
  CHECK(read_text(place / "b.txt") == "b");
  CHECK(std::distance(fs::directory_iterator(place), fs::directory_iterator()) == 1);
  crest::io::PendingFiles files;
  crest::io::write_atomically(folder / "c.txt", "c");
  crest::io::write_atomically(place / "d.txt", "d");
  fs::remove_all(place);
  CHECK_THROWS_AS(files.commit(), crest::kernel::InputError);
}

TEST_CASE("the first SIGINT is noted while somebody listens, the second one ends the program") {
  CHECK(status_of([] {
          const Interrupt interrupt;
          if (interrupt.requested()) _exit(1);
          std::raise(SIGINT);
          _exit(interrupt.requested() ? 2 : 3);
        }) == 2 << 8);
  const int twice = status_of([] {
    const Interrupt interrupt;
    std::raise(SIGINT);
    std::raise(SIGINT);
  });
  CHECK((WIFSIGNALED(twice) && WTERMSIG(twice) == SIGINT));
  const int later = status_of([] {
    { const Interrupt interrupt; }
    std::raise(SIGINT);
  });
  CHECK((WIFSIGNALED(later) && WTERMSIG(later) == SIGINT));
  // As under nohup, or in the background of a script.
  CHECK(status_of([] {
          std::signal(SIGINT, SIG_IGN);
          const Interrupt interrupt;
          std::raise(SIGINT);
          _exit(interrupt.requested() ? 2 : 3);
        }) == 3 << 8);
}
