// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// How a command runs: what is the same for all of them, once. A command is its options, its work,
// the keys it adds to the report and its lines on the terminal.
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "cli/command.hpp"
#include "cli/common_options.hpp"
#include "cli/outputs.hpp"
#include "cli/report.hpp"
#include "io/read/mesh_reader.hpp"
#include "io/write/atomic_file.hpp"
#include "kernel/arithmetic/self_test.hpp"
#include "kernel/geometry/input_error.hpp"

namespace crest::io {
struct Scene;
}

namespace crest::cli {

/// A file the command can write besides those of the common options.
struct OutputFile {
  std::string option, path;
  std::vector<std::string> extensions;
};

struct Task {
  std::string command;
  const CommonOptions& options;
  std::vector<std::string> formats;    ///< extensions of -o
  std::vector<OutputFile> files = {};  ///< its own
};

/// What the work leaves to say.
struct Outcome {
  std::string summary;                       ///< a few lines for the terminal
  std::vector<std::string> references = {};  ///< keys of references.bib, for --cite
  int exit_code = kDone;
};

/// What a command's work has at hand.
class Run {
 public:
  Run(const Task& task, int threads);
  ~Run() { show({}); }
  Run(const Run&) = delete;
  Run& operator=(const Run&) = delete;

  Report& report() { return report_; }
  /// From where pictures are to show the shape.
  const io::Viewpoint& viewpoint() const { return options_.viewpoint; }
  void warn(const std::string& what) { report_.warn(what); }

  /// One line on a terminal that says what is being done (empty: none); nothing where stderr is not
  /// a terminal.
  void show(const std::string& what) const;

  /// Shows `what`, times `work` as a phase of the report and returns its result.
  template <class Work>
  auto step(const std::string& phase, const std::string& what, Work&& work) {
    show(what);
    return report_.timed(phase, std::forward<Work>(work));
  }
  /// The step that reads INPUT: a file with warnings and what was cleaned, which is reported.
  template <class Reader>
  auto read(Reader&& reader) {
    auto file = step("read", "reading " + options_.input, [&] { return reader(options_.input); });
    for (const std::string& warning : file.warnings) warn(warning);
    report_["cleanup"] = to_json(file.cleanup);
    return file;
  }
  /// INPUT as a mesh, cleaned as the common options say.
  io::MeshFile read_mesh(io::MeshRequest request = {}) {
    request.clean = options_.clean;
    request.step = options_.step;
    return read([&](const std::string& path) { return io::read_mesh(path, request); });
  }
  /// Names INPUT in the errors of what knows no file names.
  template <class Work>
  auto with_input(Work&& work) const {
    try {
      return work();
    } catch (const kernel::InputError& error) {
      throw error.with_file(options_.input);
    }
  }

  bool wanted(const std::string& option) const { return outputs_.wanted(option); }
  /// Hands `writer` the place to write the file of `option` to, if it is wanted (Outputs::write).
  void write(const std::string& option, const std::function<void(const std::string&)>& writer) {
    outputs_.write(option, writer);
  }
  /// The scene of --page, made now if that is wanted and written at the end, with what was written
  /// to --certificate.
  void show_page(const std::function<io::Scene()>& scene);
  /// Writes --certificate, if it is wanted, and reports its claim as certified but for `undecided`
  /// cells, of which it states nothing.
  void write_certificate(const std::string& claim, std::span<const std::uint8_t> bytes,
                         std::size_t undecided = 0);
  /// The same of bytes that `make` hands on in pieces.
  void write_certificate(const std::string& claim, const std::function<void(const io::Sink&)>& make,
                         std::size_t undecided = 0);

 private:
  friend int run_command(const Task&, const std::function<Outcome(Run&)>&, void (*)());
  void finish(const Outcome& outcome);
  void write_page(const Outcome& outcome);

  const CommonOptions& options_;
  std::string command_;
  Outputs outputs_;
  Report report_;
  std::size_t certificate_bytes_ = 0;  ///< 0: none was written
  std::string page_certificate_;       ///< its bytes, if there is a page
  std::shared_ptr<io::Scene> scene_;
  bool shows_;
};

/// Announces the outputs, makes sure that the floating point is sound, works with the threads asked
/// for, writes the report, lets all outputs appear, and speaks: warnings, summary, references.
/// Returns the outcome's exit code.
/// Throws: what the parts throw; std::runtime_error if `self_test` does (exit code 70).
int run_command(const Task& task, const std::function<Outcome(Run&)>& work,
                void (*self_test)() = kernel::require_sound_floating_point);

}  // namespace crest::cli
