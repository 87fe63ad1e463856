// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// A system at work on a thread of its own, while the thread that called listens for signals.
#include <functional>
#include <memory>
#include <string>

#include "bindings/python/arguments.hpp"

namespace crest::python {

struct Job;

/// What a system's work tells and asks. Any thread may.
class Progress {
 public:
  explicit Progress(Job& job) : job_(job) {}
  /// What is done now, in words. Throws: kernel::Stopped.
  void show(const std::string& what) const;
  bool stopped() const;
  /// Shows `what` and returns the work's result.
  template <class Work>
  auto step(const std::string& what, Work&& work) const {
    show(what);
    return work();
  }

 private:
  Job& job_;
};

using System = Output (*)(const Arguments&, const Progress&);

/// Called by the thread that called run(), a dozen times a second or more often, with what was
/// shown since. What it throws stops the work at its next stop point (kernel/geometry/stop.hpp);
/// run() does not wait for that.
using Listener = std::function<void(const std::vector<std::string>& shown)>;

/// Requires: listen may be called. Guarantees: the same output whatever the threads (0: as many as
/// the machine has). Throws: what the system or `listen` throws, std::runtime_error where floating
/// point is not sound.
Output run(System system, Arguments arguments, int threads, const Listener& listen);

/// Until no work that was stopped goes on, but no longer than so; whether none does. As little as
/// can be should run while the process takes down its libraries.
bool wait_for_stopped(double seconds);

}  // namespace crest::python
