// SPDX-License-Identifier: GPL-3.0-or-later
#include "distributed/rank_engine.hpp"

// DIY's headers forget the first two.
// clang-format off
#include <stdexcept>
#include <string>
#include <vtk_diy2.h>
#include VTK_DIY2(diy/assigner.hpp)
#include VTK_DIY2(diy/mpi.hpp)
#include VTK_DIY2(diy/serialization.hpp)
// clang-format on

#include <list>
#include <memory>
#include <new>

#include "algorithms/extremal/record_bytes.hpp"
#include "kernel/geometry/input_error.hpp"

namespace crest::distributed {
namespace {

using cli::PieceJob;
using extremal::AtPlace;
using extremal::Records;
using kernel::Vec3;

enum Order : int { kDone, kRecords, kValues };
enum Tag : int { kAnswer = 1, kPlaces = 2, kStop = 3 };
/// What an answer begins with.
enum class Kind : std::uint8_t { good, bad_input, no_memory, internal };

std::size_t exchanged = 0;

void save(diy::BinaryBuffer& to, const PieceJob& job) {
  diy::save(to, job.input);
  diy::save(to, job.source.field);
  diy::save(to, job.source.raw);
  diy::save(to, job.frame);
  diy::save(to, job.options);
  diy::save(to, job.meshes);
  diy::save(to, job.owned);
  diy::save(to, job.restart);
}
void load(diy::BinaryBuffer& from, PieceJob& job) {
  diy::load(from, job.input);
  diy::load(from, job.source.field);
  diy::load(from, job.source.raw);
  diy::load(from, job.frame);
  diy::load(from, job.options);
  diy::load(from, job.meshes);
  diy::load(from, job.owned);
  diy::load(from, job.restart);
}

using Bytes = std::vector<char>;

template <class T>
void append(Bytes& to, const T* from, std::size_t count) {
  const auto* bytes = reinterpret_cast<const char*>(from);
  to.insert(to.end(), bytes, bytes + count * sizeof(T));
}

/// What `work` returns, or what went wrong: no rank may leave the others waiting.
template <class Work>
Bytes answer(const Work& work) {
  Bytes r(1);
  const auto failed = [&](Kind kind, const char* what) {
    r.assign(1, static_cast<char>(kind));
    append(r, what, std::char_traits<char>::length(what));
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
  return r;
}

/// Throws what the answer says to have gone wrong.
void require_good(const Bytes& bytes) {
  const std::string what(bytes.begin() + 1, bytes.end());
  switch (static_cast<Kind>(bytes[0])) {
    case Kind::good:
      return;
    case Kind::bad_input:
      throw kernel::InputError(what);
    case Kind::no_memory:
      throw std::bad_alloc();
    case Kind::internal:
      throw std::runtime_error(what);
  }
}

/// Which rank works on a piece, and which pieces a rank has.
class Shares {
 public:
  Shares(const diy::mpi::communicator& world, std::size_t pieces)
      : assigner_(world.size(), static_cast<int>(pieces)) {}
  int rank_of(std::size_t piece) const { return assigner_.rank(static_cast<int>(piece)); }
  std::vector<int> of(int rank) const {
    std::vector<int> r;
    assigner_.local_gids(rank, r);
    return r;
  }

 private:
  diy::ContiguousAssigner assigner_;
};

void order(const diy::mpi::communicator& world, Order what) {
  int word = what;
  diy::mpi::broadcast(world, word, 0);
}

Bytes records_of(const PieceJob& job, const io::VolumeBoxes& boxes, int piece) {
  return answer([&](Bytes& to) {
    const auto bytes =
        extremal::to_bytes(piece_records(job, boxes, static_cast<std::size_t>(piece)));
    append(to, bytes.data(), bytes.size());
  });
}

Records records_in(const Bytes& bytes) {
  const auto* from = reinterpret_cast<const std::uint8_t*>(bytes.data());
  return extremal::records_from({from + 1, bytes.size() - 1});
}

/// On rank 0: of all pieces. The first piece's error that is met stops all ranks.
Records all_records(const PieceJob& job, const io::VolumeBoxes& boxes) {
  const diy::mpi::communicator world;
  const Shares shares(world, job.owned.size());
  order(world, kRecords);
  diy::MemoryBuffer buffer;
  save(buffer, job);
  diy::mpi::broadcast(world, buffer.buffer, 0);
  exchanged += buffer.buffer.size() * static_cast<std::size_t>(world.size() - 1);
  std::vector<Records> all(job.owned.size());
  Bytes bad;
  const auto take = [&](std::size_t piece, const Bytes& bytes) {
    if (static_cast<Kind>(bytes[0]) == Kind::good) {
      all[piece] = records_in(bytes);
    } else if (bad.empty()) {
      bad = bytes;
      for (int rank = 1; rank < world.size(); ++rank) world.send(rank, kStop, rank);
    }
  };
  for (const int piece : shares.of(0))
    if (bad.empty()) take(static_cast<std::size_t>(piece), records_of(job, boxes, piece));
  for (std::size_t piece = 0; piece < all.size(); ++piece) {
    const int rank = shares.rank_of(piece);
    if (rank == 0) continue;
    Bytes bytes;
    world.recv(rank, kAnswer, bytes);
    exchanged += bytes.size();
    take(piece, bytes);
  }
  if (!bad.empty()) require_good(bad);
  return extremal::join(std::move(all));
}

std::vector<AtPlace> all_values(const PieceJob& job, const io::VolumeBoxes& boxes,
                                const std::vector<std::size_t>& of, std::span<const Vec3> places) {
  const diy::mpi::communicator world;
  const Shares shares(world, job.owned.size());
  std::vector<std::vector<Vec3>> own(job.owned.size());
  for (std::size_t i = 0; i < of.size(); ++i) own[of[i]].push_back(places[i]);
  order(world, kValues);
  for (std::size_t piece = 0; piece < own.size(); ++piece) {
    if (shares.rank_of(piece) == 0) continue;
    Bytes bytes;
    append(bytes, own[piece].data(), own[piece].size());
    world.send(shares.rank_of(piece), kPlaces, bytes);
    exchanged += bytes.size();
  }
  std::vector<std::vector<AtPlace>> got(own.size());
  for (const int piece : shares.of(0)) {
    const auto p = static_cast<std::size_t>(piece);
    got[p] = piece_values(job, boxes, p, own[p]);
  }
  Bytes bad;
  for (std::size_t piece = 0; piece < own.size(); ++piece) {
    if (shares.rank_of(piece) == 0) continue;
    Bytes bytes;
    world.recv(shares.rank_of(piece), kAnswer, bytes);
    exchanged += bytes.size();
    if (static_cast<Kind>(bytes[0]) != Kind::good) {
      if (bad.empty()) bad = bytes;
      continue;
    }
    got[piece].resize(own[piece].size());
    std::copy(bytes.begin() + 1, bytes.end(), reinterpret_cast<char*>(got[piece].data()));
  }
  if (!bad.empty()) require_good(bad);
  std::vector<AtPlace> r;
  std::vector<std::size_t> next(own.size());
  for (const std::size_t piece : of) r.push_back(got[piece][next[piece]++]);
  return r;
}

/// Answers are sent while the next piece is worked on.
class Mail {
 public:
  explicit Mail(const diy::mpi::communicator& world) : world_(world) {}
  ~Mail() {
    for (auto& [bytes, request] : under_way_) request.wait();
  }
  void send(Bytes bytes) {
    under_way_.emplace_back(std::move(bytes), diy::mpi::request());
    under_way_.back().second = world_.isend(0, kAnswer, under_way_.back().first);
    under_way_.remove_if([](auto& one) { return static_cast<bool>(one.second.test()); });
  }

 private:
  const diy::mpi::communicator& world_;
  std::list<std::pair<Bytes, diy::mpi::request>> under_way_;
};

}  // namespace

void use_all_ranks() {
  cli::PieceEngine& engine = cli::piece_engine();
  engine.least_pieces = static_cast<std::size_t>(diy::mpi::communicator().size());
  engine.records = all_records;
  engine.values = all_values;
}

void dismiss() {
  order(diy::mpi::communicator(), kDone);
}

std::size_t bytes_exchanged() {
  return exchanged;
}

void serve() {
  const diy::mpi::communicator world;
  PieceJob job;
  std::unique_ptr<io::VolumeBoxes> boxes;
  for (;;) {
    int word = kDone;
    diy::mpi::broadcast(world, word, 0);
    if (word == kDone) return;
    Mail mail(world);
    if (word == kRecords) {
      diy::MemoryBuffer buffer;
      diy::mpi::broadcast(world, buffer.buffer, 0);
      load(buffer, job);
      boxes.reset();
    }
    bool failed = false;
    for (const int piece : Shares(world, job.owned.size()).of(world.rank())) {
      std::vector<Vec3> places;
      if (word == kValues) {
        Bytes bytes;
        world.recv(0, kPlaces, bytes);
        places.resize(bytes.size() / sizeof(Vec3));
        std::copy(bytes.begin(), bytes.end(), reinterpret_cast<char*>(places.data()));
      }
      failed = failed || world.iprobe(0, kStop);
      mail.send(answer([&](Bytes& to) {
        if (failed) throw std::runtime_error("stopped");
        failed = true;  // unless what follows returns
        if (!boxes) boxes = std::make_unique<io::VolumeBoxes>(job.input, job.source);
        const auto p = static_cast<std::size_t>(piece);
        if (word == kRecords) {
          const auto bytes = extremal::to_bytes(piece_records(job, *boxes, p));
          append(to, bytes.data(), bytes.size());
        } else {
          const auto values = piece_values(job, *boxes, p, places);
          append(to, values.data(), values.size());
        }
        failed = false;
      }));
    }
  }
}

}  // namespace crest::distributed
