// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Ends work whose caller wants no more of it: long loops pass stop points, which throw. Work that
// is not asked to stop computes the same with them as without.
#include <atomic>
#include <exception>

namespace crest::kernel {

/// Thrown by a stop point. Says nothing of the input: whoever asked for the end catches it.
class Stopped : public std::exception {
 public:
  const char* what() const noexcept override { return "stopped"; }
};

/// True: the work is to end. Any thread may set it.
using StopFlag = std::atomic<bool>;

namespace detail {
/// Of the work that this thread does; null if nobody can end it.
inline constinit thread_local const StopFlag* stop_flag = nullptr;
}  // namespace detail

/// The flag this thread's stop points look at, for work that other threads take over.
inline const StopFlag* stop_flag() {
  return detail::stop_flag;
}

/// While it lives, this thread's stop points look at `flag`, which outlives it.
class Stoppable {
 public:
  explicit Stoppable(const StopFlag* flag) : before_(detail::stop_flag) {
    detail::stop_flag = flag;
  }
  ~Stoppable() { detail::stop_flag = before_; }
  Stoppable(const Stoppable&) = delete;
  Stoppable& operator=(const Stoppable&) = delete;

 private:
  const StopFlag* before_;
};

/// Where nothing is lost but the work so far. Throws: Stopped. Cost: a load and a branch; for
/// steps of a microsecond or more.
inline void stop_point() {
  if (const StopFlag* const flag = detail::stop_flag; flag && flag->load(std::memory_order_relaxed))
    throw Stopped();
}

}  // namespace crest::kernel
