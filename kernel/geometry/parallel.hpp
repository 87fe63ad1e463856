// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// TBB's loops with a stop point before each part, whichever thread does it.
#include <tbb/parallel_for.h>
#include <tbb/parallel_invoke.h>
#include <tbb/parallel_reduce.h>

#include "kernel/geometry/stop.hpp"

namespace crest::kernel {

/// body(part) for parts that cover the range. Throws: Stopped, and what the body throws.
template <class Range, class Body>
void parallel_for(const Range& range, const Body& body) {
  tbb::parallel_for(range, [&body, flag = stop_flag()](const Range& part) {
    const Stoppable stoppable(flag);
    stop_point();
    body(part);
  });
}

/// body(i) for first <= i < last. Throws: Stopped, and what the body throws.
template <class Index, class Body>
void parallel_for(Index first, Index last, const Body& body) {
  tbb::parallel_for(first, last, [&body, flag = stop_flag()](Index i) {
    const Stoppable stoppable(flag);
    stop_point();
    body(i);
  });
}

/// join over parts that cover the range of body(part, value). Throws: Stopped, and what the
/// functions throw.
template <class Range, class Value, class Body, class Join>
Value parallel_reduce(const Range& range, const Value& identity, const Body& body,
                      const Join& join) {
  return tbb::parallel_reduce(
      range, identity,
      [&body, flag = stop_flag()](const Range& part, const Value& value) {
        const Stoppable stoppable(flag);
        stop_point();
        return body(part, value);
      },
      join);
}

/// Both works. Throws: Stopped, and what they throw.
template <class One, class Other>
void parallel_invoke(const One& one, const Other& other) {
  const auto stoppable = [flag = stop_flag()](const auto& work) {
    return [&work, flag] {
      const Stoppable here(flag);
      stop_point();
      work();
    };
  };
  tbb::parallel_invoke(stoppable(one), stoppable(other));
}

}  // namespace crest::kernel
