// SPDX-License-Identifier: GPL-3.0-or-later
#include "bindings/python/run.hpp"

#include <tbb/task_arena.h>

#include <cfenv>
#include <chrono>
#include <condition_variable>
#include <mutex>
#include <thread>

#include "kernel/arithmetic/self_test.hpp"
#include "kernel/geometry/stop.hpp"

namespace crest::python {

struct Job {
  std::mutex mutex;
  std::condition_variable changed;
  std::vector<std::string> shown;
  bool done = false;
  kernel::StopFlag stop = false;
  Output output;
  std::exception_ptr error;
};

namespace {

/// How many threads are at work. Never taken down: a thread may end after main() does.
struct Workers {
  std::mutex mutex;
  std::condition_variable fewer;
  int count = 0;
};
Workers& workers() {
  static Workers& all = *new Workers;
  return all;
}

void count_worker(int change) {
  const std::lock_guard lock(workers().mutex);
  workers().count += change;
  workers().fewer.notify_all();
}

/// A thread at work, counted as long as it is. Throws: std::system_error where there is none.
template <class Work>
std::thread worker(Work work) {
  count_worker(1);
  try {
    return std::thread([work = std::move(work)] {
      work();
      count_worker(-1);
    });
  } catch (...) {
    count_worker(-1);
    throw;
  }
}

Output work(System system, const Arguments& arguments, int threads, Job& job) {
  // Other libraries of the process may have set flush-to-zero or a rounding mode.
  std::fesetenv(FE_DFL_ENV);
  kernel::require_sound_floating_point();
  tbb::task_arena arena(threads > 0 ? threads : tbb::task_arena::automatic);
  return arena.execute([&] {
    const kernel::Stoppable stoppable(&job.stop);
    return system(arguments, Progress(job));
  });
}

}  // namespace

void Progress::show(const std::string& what) const {
  if (stopped()) throw kernel::Stopped();
  const std::lock_guard lock(job_.mutex);
  job_.shown.push_back(what);
  job_.changed.notify_all();
}

bool Progress::stopped() const {
  return job_.stop;
}

Output run(System system, Arguments arguments, int threads, const Listener& listen) {
  const auto job = std::make_shared<Job>();
  std::thread thread = worker([job, system, threads, arguments = std::move(arguments)] {
    try {
      job->output = work(system, arguments, threads, *job);
    } catch (...) {
      job->error = std::current_exception();
    }
    {
      const std::lock_guard lock(job->mutex);
      job->done = true;
      job->changed.notify_all();
    }
  });
  try {
    for (bool done = false; !done;) {
      std::vector<std::string> shown;
      {
        std::unique_lock lock(job->mutex);
        job->changed.wait_for(lock, std::chrono::milliseconds(50),
                              [&] { return job->done || !job->shown.empty(); });
        shown.swap(job->shown);
        done = job->done;
      }
      listen(shown);
    }
  } catch (...) {
    job->stop = true;
    thread.detach();
    throw;
  }
  thread.join();
  if (job->error) std::rethrow_exception(job->error);
  return std::move(job->output);
}

bool wait_for_stopped(double seconds) {
  std::unique_lock lock(workers().mutex);
  return workers().fewer.wait_for(lock, std::chrono::duration<double>(seconds),
                                  [] { return workers().count == 0; });
}

}  // namespace crest::python
