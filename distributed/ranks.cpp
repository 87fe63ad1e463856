// SPDX-License-Identifier: GPL-3.0-or-later
#include "distributed/ranks.hpp"

// DIY's headers forget the first two.
// clang-format off
#include <stdexcept>
#include <string>
#include <vtk_diy2.h>
#include VTK_DIY2(diy/assigner.hpp)
#include VTK_DIY2(diy/mpi.hpp)
// clang-format on

#include <list>
#include <new>
#include <utility>

#include "kernel/geometry/input_error.hpp"

namespace crest::distributed {
namespace {

enum Tag : int { kAnswer = 1, kOwn = 2, kStop = 3 };
/// What a message ends with.
enum class Kind : char { good, bad_input, no_memory, internal };

std::size_t exchanged = 0;

/// What `work` returns, or what went wrong: no rank may leave the others waiting.
template <class Work>
Bytes answer(const Work& work) {
  Bytes r;
  Kind kind = Kind::good;
  const auto failed = [&](Kind how, const std::string& what) {
    kind = how;
    r.assign(what.begin(), what.end());
  };
  try {
    work(r);
  } catch (const kernel::InputError& error) {
    failed(Kind::bad_input, error.what());
  } catch (const std::bad_alloc&) {
    failed(Kind::no_memory, "");
  } catch (const std::exception& error) {
    failed(Kind::internal, error.what());
  }
  r.push_back(static_cast<char>(kind));
  return r;
}

/// The first thing that went wrong.
class Failure {
 public:
  /// Whether the answer says that all is well.
  bool note(const Bytes& answer) {
    const auto kind = static_cast<Kind>(answer.back());
    if (kind != Kind::good && none()) {
      kind_ = kind;
      what_.assign(answer.begin(), answer.end() - 1);
    }
    return kind == Kind::good;
  }
  bool none() const { return kind_ == Kind::good; }
  void throw_if_any() const {
    if (none()) return;
    if (kind_ == Kind::bad_input) throw kernel::InputError(what_);
    if (kind_ == Kind::no_memory) throw std::bad_alloc();
    throw std::runtime_error(what_);
  }

 private:
  Kind kind_ = Kind::good;
  std::string what_;
};

/// Which rank works on a piece, and which pieces a rank has.
class Shares {
 public:
  Shares(const diy::mpi::communicator& world, std::size_t pieces)
      : assigner_(world.size(), static_cast<int>(pieces)) {}
  int rank_of(std::size_t piece) const { return assigner_.rank(static_cast<int>(piece)); }
  std::vector<std::size_t> of(int rank) const {
    std::vector<int> pieces;
    assigner_.local_gids(rank, pieces);
    return {pieces.begin(), pieces.end()};
  }

 private:
  diy::ContiguousAssigner assigner_;
};

/// Messages that are sent while other work goes on.
class Mail {
 public:
  explicit Mail(const diy::mpi::communicator& world) : world_(world) {}
  ~Mail() {
    for (auto& [bytes, request] : under_way_) request.wait();
  }
  void send(int rank, Tag tag, Bytes bytes) {
    under_way_.emplace_back(std::move(bytes), diy::mpi::request());
    under_way_.back().second = world_.isend(rank, tag, under_way_.back().first);
    under_way_.remove_if([](auto& one) { return static_cast<bool>(one.second.test()); });
  }

 private:
  const diy::mpi::communicator& world_;
  std::list<std::pair<Bytes, diy::mpi::request>> under_way_;
};

/// From rank 0 to all: the task, the number of pieces, what they have in common.
void announce(const diy::mpi::communicator& world, Task& task, int& pieces, Bytes& common) {
  int word = static_cast<int>(task);
  diy::mpi::broadcast(world, word, 0);
  task = static_cast<Task>(word);
  if (task == Task::none) return;
  diy::mpi::broadcast(world, pieces, 0);
  diy::mpi::broadcast(world, common, 0);
}

/// Rank 0's orders to the others.
void send_out(const diy::mpi::communicator& world, const Order& order, const Shares& shares,
              Mail& mail, Failure& failure) {
  Task task = order.task;
  auto pieces = static_cast<int>(order.pieces);
  Bytes common = order.common;
  announce(world, task, pieces, common);
  exchanged += common.size() * static_cast<std::size_t>(world.size() - 1);
  for (std::size_t piece = 0; piece < order.pieces; ++piece) {
    if (shares.rank_of(piece) == 0) continue;
    Bytes own = answer([&](Bytes& to) { to = order.own(piece); });
    exchanged += own.size();
    failure.note(own);
    mail.send(shares.rank_of(piece), kOwn, std::move(own));
  }
}

}  // namespace

void ask(const Order& order, const std::function<void(std::size_t, Bytes)>& take) {
  const diy::mpi::communicator world;
  const Shares shares(world, order.pieces);
  Failure failure;
  Mail mail(world);
  send_out(world, order, shares, mail, failure);
  const auto got = [&](std::size_t piece, Bytes bytes) {
    if (!failure.none()) return;
    if (failure.note(bytes)) {
      bytes.pop_back();
      if (failure.note(answer([&](Bytes&) { take(piece, std::move(bytes)); }))) return;
    }
    for (int rank = 1; rank < world.size(); ++rank) world.send(rank, kStop, rank);
  };
  for (const std::size_t piece : shares.of(0))
    if (failure.none())
      got(piece, answer([&](Bytes& to) { order.here(piece, order.own(piece), to); }));
  for (std::size_t piece = 0; piece < order.pieces; ++piece) {
    if (shares.rank_of(piece) == 0) continue;
    Bytes bytes;
    world.recv(shares.rank_of(piece), kAnswer, bytes);
    exchanged += bytes.size();
    got(piece, std::move(bytes));
  }
  failure.throw_if_any();
}

void serve(const std::map<Task, Skill>& skills) {
  const diy::mpi::communicator world;
  for (;;) {
    Task task = Task::none;
    int pieces = 0;
    Bytes common;
    announce(world, task, pieces, common);
    if (task == Task::none) return;
    const Skill& skill = skills.at(task);
    Mail mail(world);
    bool started = false;
    Failure failure;
    for (const std::size_t piece :
         Shares(world, static_cast<std::size_t>(pieces)).of(world.rank())) {
      Bytes own;
      world.recv(0, kOwn, own);
      const bool stop = world.iprobe(0, kStop) || !failure.note(own) || !failure.none();
      Bytes result = answer([&](Bytes& to) {
        if (stop) throw std::runtime_error("stopped");
        own.pop_back();
        if (!std::exchange(started, true)) skill.start(common);
        skill.work(piece, std::move(own), to);
      });
      failure.note(result);
      mail.send(0, kAnswer, std::move(result));
    }
  }
}

void dismiss() {
  Task task = Task::none;
  int pieces = 0;
  Bytes common;
  announce(diy::mpi::communicator(), task, pieces, common);
}

std::size_t rank_count() {
  return static_cast<std::size_t>(diy::mpi::communicator().size());
}

std::size_t bytes_exchanged() {
  return exchanged;
}

}  // namespace crest::distributed
