// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Jobs and answers of meshes as messages. What one consists of says for_members(message, use), for
// both ways: a function of this namespace for each.

// DIY's headers forget the first two.
// clang-format off
#include <stdexcept>
#include <string>
#include <vtk_diy2.h>
#include VTK_DIY2(diy/serialization.hpp)
// clang-format on

#include "distributed/ranks.hpp"

namespace crest::distributed {

template <class Message>
Bytes bytes_of(Message message) {
  diy::MemoryBuffer buffer;
  for_members(message, [&](const auto& member) { diy::save(buffer, member); });
  return std::move(buffer.buffer);
}

template <class Message>
Message message_in(Bytes bytes) {
  Message r;
  diy::MemoryBuffer buffer;
  buffer.buffer = std::move(bytes);
  for_members(r, [&](auto& member) { diy::load(buffer, member); });
  return r;
}

template <class Job>
void work(std::size_t, Bytes own, Bytes& answer) {
  answer = bytes_of(work_on(message_in<Job>(std::move(own))));
}

template <class Job>
Skill skill() {
  return {[](const Bytes&) {}, work<Job>};
}

template <class Job, class Answer>
auto by_ranks(Task task) {
  return [task](std::size_t jobs, const std::function<Job(std::size_t)>& job) {
    std::vector<Answer> r(jobs);
    ask({task, {}, jobs, [&](std::size_t i) { return bytes_of(job(i)); }, work<Job>},
        [&](std::size_t i, Bytes bytes) { r[i] = message_in<Answer>(std::move(bytes)); });
    return r;
  };
}

}  // namespace crest::distributed
