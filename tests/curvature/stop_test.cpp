// SPDX-License-Identifier: GPL-3.0-or-later
// Stop points: which work ends, and which goes on.
#include "kernel/geometry/stop.hpp"

#include <tbb/blocked_range.h>

#include <catch2/catch.hpp>

#include "algorithms/curvature/curvature.hpp"
#include "kernel/geometry/parallel.hpp"
#include "tests/curvature/shapes.hpp"

namespace {

using namespace crest;
using kernel::StopFlag;
using kernel::Stoppable;
using kernel::Stopped;
constexpr int kMany = 100000;

TEST_CASE("a stop point throws where the work's own flag is set") {
  CHECK_NOTHROW(kernel::stop_point());
  StopFlag flag = false, other = true;
  {
    const Stoppable outer(&flag);
    CHECK_NOTHROW(kernel::stop_point());
    {
      const Stoppable inner(&other);
      CHECK_THROWS_AS(kernel::stop_point(), Stopped);
      const Stoppable nobody(nullptr);
      CHECK_NOTHROW(kernel::stop_point());
    }
    CHECK_NOTHROW(kernel::stop_point());
    flag = true;
    CHECK_THROWS_AS(kernel::stop_point(), Stopped);
  }
  CHECK_NOTHROW(kernel::stop_point());
}

TEST_CASE("loops carry the flag to all their threads, and leave none there") {
  StopFlag flag = false;
  std::atomic<int> foreign = 0, done = 0;
  const auto body = [&](int) {
    ++done;
    if (kernel::stop_flag() != &flag) ++foreign;
  };
  {
    const Stoppable stoppable(&flag);
    kernel::parallel_for(0, kMany, body);
    kernel::parallel_for(tbb::blocked_range<int>(0, kMany), [&](const auto& range) {
      for (int i = range.begin(); i < range.end(); ++i) body(i);
    });
    kernel::parallel_invoke([&] { body(0); }, [&] { body(1); });
    const int sum = kernel::parallel_reduce(
        tbb::blocked_range<int>(0, kMany), 0,
        [&](const auto& range, int part) {
          body(0);
          return part + static_cast<int>(range.size());
        },
        [](int a, int b) { return a + b; });
    CHECK(sum == kMany);
  }
  CHECK(done > 2 * kMany);
  CHECK(foreign == 0);
  std::atomic<int> left = 0;
  tbb::parallel_for(0, kMany, [&](int) { left += kernel::stop_flag() != nullptr; });
  CHECK(left == 0);
}

TEST_CASE("a loop ends soon after its flag is set") {
  StopFlag flag = false;
  const Stoppable stoppable(&flag);
  std::atomic<int> done = 0;
  const auto body = [&](int) {
    if (++done == 100) flag = true;
  };
  CHECK_THROWS_AS(kernel::parallel_for(0, kMany, body), Stopped);
  CHECK(done >= 100);
  CHECK(done < kMany / 2);  // those that had begun
  CHECK_THROWS_AS(kernel::parallel_invoke([&] { body(0); }, [&] { body(1); }), Stopped);
}

TEST_CASE("a system that is stopped throws, and computes the same where it is not") {
  const kernel::TriangleMesh mesh = tests::torus(60, 1).mesh;
  curvature::Options options;
  options.method = curvature::Method::qf;
  const auto plain = curvature::estimate(mesh, options).vertices;
  StopFlag flag = false;
  const Stoppable stoppable(&flag);
  const auto same = curvature::estimate(mesh, options).vertices;
  REQUIRE(same.size() == plain.size());
  for (std::size_t v = 0; v < same.size(); ++v) CHECK(same[v].k1 == plain[v].k1);
  flag = true;
  CHECK_THROWS_AS(curvature::estimate(mesh, options), Stopped);
}

}  // namespace
