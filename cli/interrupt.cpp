// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/interrupt.hpp"

#include <atomic>
#include <csignal>

namespace crest::cli {
namespace {

std::atomic<bool> came = false;
static_assert(std::atomic<bool>::is_always_lock_free);  // a handler may set it
struct sigaction before;

}  // namespace

Interrupt::Interrupt() {
  came = false;
  sigaction(SIGINT, nullptr, &before);
  if (before.sa_handler == SIG_IGN) return;
  struct sigaction note = {};
  note.sa_handler = [](int) { came = true; };
  note.sa_flags = static_cast<int>(SA_RESETHAND) | SA_RESTART;
  sigaction(SIGINT, &note, nullptr);
}

Interrupt::~Interrupt() {
  sigaction(SIGINT, &before, nullptr);
}

bool Interrupt::requested() const {
  return came;
}

}  // namespace crest::cli
