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

#include <algorithm>
#include <cstdio>
#include <deque>
#include <list>
#include <new>
#include <utility>

#include "cli/command.hpp"
#include "kernel/arithmetic/self_test.hpp"
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

/// A message goes in parts, behind its size: MPI counts bytes by int.
constexpr std::size_t kPart = std::size_t{1} << 20;

/// Calls use(begin, count) for the parts of a message.
template <class Use>
void for_parts(Bytes& message, const Use& use) {
  for (std::size_t at = 0; at < message.size(); at += kPart)
    use(message.data() + at, static_cast<int>(std::min(kPart, message.size() - at)));
}

Bytes receive(const diy::mpi::communicator& world, int rank, Tag tag) {
  std::size_t size = 0;
  world.recv(rank, tag, size);
  Bytes r(size);
  for_parts(r, [&](char* begin, int count) {
    MPI_Recv(begin, count, MPI_BYTE, rank, tag, world, MPI_STATUS_IGNORE);
  });
  return r;
}

/// Messages that are sent while other work goes on.
class Mail {
 public:
  explicit Mail(const diy::mpi::communicator& world) : world_(world) {}
  ~Mail() {
    for (Letter& letter : under_way_)
      for (diy::mpi::request& request : letter.requests) request.wait();
  }
  void send(int rank, Tag tag, Bytes bytes) {
    Letter& letter = under_way_.emplace_back();
    letter.bytes = std::move(bytes);
    letter.size = letter.bytes.size();
    letter.requests.push_back(world_.isend(rank, tag, letter.size));
    for_parts(letter.bytes, [&](char* begin, int count) {
      MPI_Isend(begin, count, MPI_BYTE, rank, tag, world_, &letter.requests.emplace_back().r);
    });
    under_way_.remove_if([](Letter& one) {
      std::erase_if(one.requests, [](auto& request) { return static_cast<bool>(request.test()); });
      return one.requests.empty();
    });
  }

 private:
  struct Letter {
    Bytes bytes;
    std::size_t size = 0;
    std::vector<diy::mpi::request> requests;
  };
  const diy::mpi::communicator& world_;
  std::list<Letter> under_way_;
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

/// Rank 0's side of an order.
class Asking {
 public:
  using Take = std::function<void(std::size_t, Bytes)>;
  Asking(const Order& order, const Take& take)
      : order_(order), take_(take), shares_(world_, order.pieces), mail_(world_) {
    for (int rank = 0; rank < world_.size(); ++rank) waiting_.push_back(shares_.of(rank));
  }

  void run() {
    send_out();
    for (const std::size_t piece : waiting_[0]) {
      if (failure_.none())
        finish(piece, answer([&](Bytes& to) { order_.here(piece, order_.own(piece), to); }));
      look();
    }
    for (std::size_t rank = 1; rank < waiting_.size(); ++rank)
      for (const std::size_t piece : waiting_[rank]) {
        if (early_[rank].empty()) take_in(rank);
        Bytes bytes = std::move(early_[rank].front());
        early_[rank].pop_front();
        finish(piece, std::move(bytes));
      }
  }
  /// What went wrong on any rank.
  void throw_if_any() const { failure_.throw_if_any(); }

 private:
  void send_out() {
    Task task = order_.task;
    auto pieces = static_cast<int>(order_.pieces);
    Bytes common = order_.common;
    announce(world_, task, pieces, common);
    exchanged += common.size() * static_cast<std::size_t>(world_.size() - 1);
    for (std::size_t piece = 0; piece < order_.pieces; ++piece) {
      if (shares_.rank_of(piece) == 0) continue;
      Bytes own = answer([&](Bytes& to) {
        if (!failure_.none()) throw std::runtime_error("stopped");
        to = order_.own(piece);
      });
      exchanged += own.size();
      note(own);
      mail_.send(shares_.rank_of(piece), kOwn, std::move(own));
    }
  }

  /// Takes what the others have answered so far: where one has failed, the rest is not worked on.
  void look() {
    for (std::size_t rank = 1; rank < waiting_.size(); ++rank)
      while (early_[rank].size() < waiting_[rank].size() &&
             world_.iprobe(static_cast<int>(rank), kAnswer))
        take_in(rank);
  }

  void take_in(std::size_t rank) {
    Bytes bytes = receive(world_, static_cast<int>(rank), kAnswer);
    exchanged += bytes.size();
    note(bytes);
    if (!failure_.none()) bytes = {};
    early_[rank].push_back(std::move(bytes));
  }

  void finish(std::size_t piece, Bytes bytes) {
    if (failure_.none()) note(bytes);
    if (!failure_.none()) return;
    bytes.pop_back();
    note(answer([&](Bytes&) { take_(piece, std::move(bytes)); }));
  }

  /// The first failure stops the others.
  void note(const Bytes& answer) {
    if (!failure_.none() || failure_.note(answer)) return;
    for (int rank = 1; rank < world_.size(); ++rank) world_.send(rank, kStop, rank);
  }

  const diy::mpi::communicator world_;
  const Order& order_;
  const Take& take_;
  const Shares shares_;
  Failure failure_;
  Mail mail_;
  std::vector<std::vector<std::size_t>> waiting_;   ///< a rank's pieces
  std::map<std::size_t, std::deque<Bytes>> early_;  ///< a rank's answers that are not taken yet
};

}  // namespace

void ask(const Order& order, const std::function<void(std::size_t, Bytes)>& take) {
  Asking asking(order, take);
  try {
    asking.run();
  } catch (const std::bad_alloc&) {
    // No room for a message: the others would wait for ever to be rid of it.
    std::fputs("crest-mpi: out of memory\n", stderr);
    MPI_Abort(MPI_COMM_WORLD, cli::kExhausted);
  }
  asking.throw_if_any();
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
      Bytes own = receive(world, 0, kOwn);
      const bool stop = world.iprobe(0, kStop) || !failure.note(own) || !failure.none();
      Bytes result = answer([&](Bytes& to) {
        if (stop) throw std::runtime_error("stopped");
        own.pop_back();
        if (!std::exchange(started, true)) {
          kernel::require_sound_floating_point();  // rank 0's command has tried its own
          skill.start(common);
        }
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
