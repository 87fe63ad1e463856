// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Ctrl-C as a wish to end well: long work asks for it and stops with what it has.

namespace crest::cli {

/// While it lives, the first SIGINT is only noted; the next one ends the program at once, as all do
/// without it. A SIGINT that the program was started to ignore stays ignored. One at a time.
class Interrupt {
 public:
  Interrupt();
  ~Interrupt();
  Interrupt(const Interrupt&) = delete;
  Interrupt& operator=(const Interrupt&) = delete;

  /// Whether the SIGINT came. Any thread may ask.
  bool requested() const;
};

}  // namespace crest::cli
