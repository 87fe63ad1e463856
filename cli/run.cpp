// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/run.hpp"

#include <fmt/format.h>
#include <tbb/global_control.h>
#include <tbb/info.h>
#include <unistd.h>

#include <cstdio>
#include <filesystem>
#include <stdexcept>
#include <string_view>

#include "cli/references.hpp"
#include "cli/version.hpp"
#include "io/formats/files.hpp"
#include "io/page/page.hpp"
#include "io/page/scene.hpp"
#include "io/picture/camera.hpp"

namespace crest::cli {
namespace {

void require_sound(void (*self_test)()) {
  try {
    self_test();
  } catch (const std::runtime_error& error) {
    throw std::runtime_error(std::string("this machine's floating point is not sound: ") +
                             error.what());
  }
}

}  // namespace

Run::Run(const Task& task, int threads)
    : options_(task.options),
      command_(task.command),
      report_(task.command, options_.input, threads),
      shows_(!options_.quiet && isatty(STDERR_FILENO) != 0) {
  outputs_.add("-o", options_.output, task.formats);
  for (const OutputFile& file : task.files) outputs_.add(file.option, file.path, file.extensions);
  outputs_.add("--picture", options_.picture, {".svg", ".png"});
  outputs_.add("--page", options_.page, {".html"});
  outputs_.add("--certificate", options_.certificate);
  outputs_.add("--report", options_.report);
}

void Run::show(const std::string& what) const {
  if (!shows_) return;
  std::fprintf(stderr, "\r\033[K%s%s", what.c_str(), what.empty() ? "" : " ...");
  std::fflush(stderr);
}

void Run::write_certificate(const std::string& claim, std::span<const std::uint8_t> bytes,
                            std::size_t undecided) {
  write_certificate(
      claim,
      [&](const io::Sink& sink) {
        sink({reinterpret_cast<const char*>(bytes.data()), bytes.size()});
      },
      undecided);
}

void Run::write_certificate(const std::string& claim,
                            const std::function<void(const io::Sink&)>& make,
                            std::size_t undecided) {
  write("--certificate", [&](const std::string& path) {
    const bool shown = wanted("--page");
    io::write_atomically(path, [&](const io::Sink& sink) {
      make([&](std::string_view piece) {
        sink(piece);
        certificate_bytes_ += piece.size();
        if (shown) page_certificate_ += piece;
      });
    });
    report_.set_certificate(claim, undecided);
  });
}

void Run::show_page(const std::function<io::Scene()>& scene) {
  if (!wanted("--page")) return;
  step("page", "composing the page", [&] { scene_ = std::make_shared<io::Scene>(scene()); });
}

void Run::write_page(const Outcome& outcome) {
  if (!scene_) return;
  std::error_code ignored;
  const bool file = std::filesystem::exists(options_.input, ignored);
  scene_->title +=
      " of " + (file ? std::filesystem::path(options_.input).filename().string() : options_.input);
  write("--page", [&](const std::string& path) {
    io::write_page(path, *scene_,
                   {options_.command_line, CREST_VERSION, outcome.summary, report_.warnings(),
                    page_certificate_});
  });
}

void Run::finish(const Outcome& outcome) {
  write_page(outcome);
  write("--report", [&](const std::string& path) { io::write_atomically(path, report_.text()); });
  outputs_.commit();
  show({});
  if (!options_.quiet) {
    for (const std::string& warning : report_.warnings())
      fmt::print(stderr, "crest {}: warning: {}\n", command_, io::one_line(warning));
    fmt::print("{}", outcome.summary);
    if (certificate_bytes_ > 0)
      fmt::print("certificate: {} bytes (crest-verify {})\n", certificate_bytes_,
                 options_.certificate);
    else if (wanted("--certificate"))
      fmt::print("certificate: {} was not written, the result is not certified\n",
                 options_.certificate);
    fmt::print("time: {:.3g} s\n", report_.elapsed());
  }
  if (options_.cite) fmt::print("{}", bibtex(outcome.references));
}

int run_command(const Task& task, const std::function<Outcome(Run&)>& work, void (*self_test)()) {
  io::check_viewpoint(task.options.viewpoint);
  const int threads =
      task.options.threads > 0 ? task.options.threads : tbb::info::default_concurrency();
  Run run(task, threads);
  require_sound(self_test);
  const tbb::global_control limit(tbb::global_control::max_allowed_parallelism,
                                  static_cast<std::size_t>(threads));
  const Outcome outcome = work(run);
  run.finish(outcome);
  return outcome.exit_code;
}

}  // namespace crest::cli
