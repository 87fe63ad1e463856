// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// A loop on the producer's threads, as many as --threads allows.
#include <tbb/blocked_range.h>
#include <tbb/enumerable_thread_specific.h>
#include <tbb/parallel_for.h>

#include <atomic>
#include <exception>
#include <mutex>

#include "certify/container/reject.hpp"

namespace crest::certify::witness {

/// Calls body(worker, i) for i < count; every thread makes its own worker with make().
/// Guarantees: the Reject thrown is the one of the least i that throws, whatever the number of
///   threads.
template <class Make, class Body>
void for_all(std::size_t count, const Make& make, const Body& body) {
  tbb::enumerable_thread_specific<decltype(make())> workers(make);
  std::atomic<std::size_t> failed{count};
  std::exception_ptr problem;
  std::mutex mutex;
  tbb::parallel_for(tbb::blocked_range<std::size_t>(0, count), [&](const auto& range) {
    auto& worker = workers.local();
    std::size_t i = range.begin();
    try {
      for (; i < range.end() && i < failed; ++i) body(worker, i);
    } catch (const Reject&) {
      const std::lock_guard lock(mutex);
      if (i > failed) return;
      failed = i;
      problem = std::current_exception();
    }
  });
  if (problem) std::rethrow_exception(problem);
}

}  // namespace crest::certify::witness
