// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// A loop over independent checks on all cores. With CREST_SERIAL on one: a page has no threads.
#ifndef CREST_SERIAL
#include <mpfr.h>

#include <algorithm>
#include <atomic>
#include <exception>
#include <mutex>
#include <thread>
#include <vector>
#endif
#include <cstddef>

namespace crest::certify {

/// Calls body(worker, i) for i < count; every thread makes its own worker with make().
/// Guarantees: the exception thrown is the one of the least i that throws, whatever the number of
///   threads: indices are handed out in order, and those below a failure are finished.
template <class Make, class Body>
void parallel_for(std::size_t count, Make&& make, Body&& body) {
#ifdef CREST_SERIAL
  auto worker = make();
  for (std::size_t i = 0; i < count; ++i) body(worker, i);
#else
  // Single ones if there are few: umbilics differ much in cost.
  const std::size_t chunk = std::clamp<std::size_t>(count / 64, 1, 8);
  std::atomic<std::size_t> next{0}, failed{count};
  std::exception_ptr problem;
  std::mutex mutex;
  const auto run = [&] {
    std::size_t i = 0;
    try {
      auto worker = make();
      for (;;) {
        const std::size_t first = next.fetch_add(chunk);
        if (first >= failed.load()) return;
        for (i = first; i < std::min(first + chunk, count); ++i) body(worker, i);
      }
    } catch (...) {
      const std::lock_guard lock(mutex);
      if (i > failed.load() || (problem && i == failed.load())) return;
      failed = i;
      problem = std::current_exception();
    }
  };
  const std::size_t most = std::max(1U, std::thread::hardware_concurrency());
  std::vector<std::jthread> others;
  for (std::size_t k = 1; k < std::min(most, (count + chunk - 1) / chunk); ++k)
    others.emplace_back([&] {
      run();
      mpfr_free_cache2(MPFR_FREE_LOCAL_CACHE);  // of this thread: pi, log 2
    });
  run();
  others.clear();
  if (problem) std::rethrow_exception(problem);
#endif
}

}  // namespace crest::certify
