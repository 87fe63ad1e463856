// SPDX-License-Identifier: GPL-3.0-or-later
// DIY's headers forget the first two.
// clang-format off
#include <stdexcept>
#include <string>
#include <vtk_diy2.h>
#include VTK_DIY2(diy/serialization.hpp)
// clang-format on

#include <memory>

#include "algorithms/extremal/record_bytes.hpp"
#include "cli/piece_work.hpp"
#include "distributed/systems.hpp"

namespace crest::distributed {
namespace {

using cli::PieceJob;
using extremal::AtPlace;
using extremal::Records;
using kernel::Vec3;

template <class Job, class Use>
void for_members(Job& job, const Use& use) {
  use(job.input);
  use(job.source.field);
  use(job.source.raw);
  use(job.frame);
  use(job.options);
  use(job.meshes);
  use(job.owned);
  use(job.restart);
}

template <class T>
void append(Bytes& to, const T* from, std::size_t count) {
  const auto* bytes = reinterpret_cast<const char*>(from);
  to.insert(to.end(), bytes, bytes + count * sizeof(T));
}

template <class T>
std::vector<T> items_in(const Bytes& bytes) {
  std::vector<T> r(bytes.size() / sizeof(T));
  std::copy(bytes.begin(), bytes.end(), reinterpret_cast<char*>(r.data()));
  return r;
}

void records_to(const PieceJob& job, const io::VolumeBoxes& boxes, std::size_t piece, Bytes& to) {
  const auto bytes = extremal::to_bytes(piece_records(job, boxes, piece));
  append(to, bytes.data(), bytes.size());
}

void values_to(const PieceJob& job, const io::VolumeBoxes& boxes, std::size_t piece,
               const Bytes& places, Bytes& to) {
  const auto values = piece_values(job, boxes, piece, items_in<Vec3>(places));
  append(to, values.data(), values.size());
}

Records all_records(const PieceJob& job, const io::VolumeBoxes& boxes) {
  diy::MemoryBuffer common;
  for_members(job, [&](const auto& member) { diy::save(common, member); });
  std::vector<Records> all(job.owned.size());
  ask({Task::volume_records, std::move(common.buffer), job.owned.size(),
       [](std::size_t) { return Bytes(); },
       [&](std::size_t piece, const Bytes&, Bytes& to) { records_to(job, boxes, piece, to); }},
      [&](std::size_t piece, const Bytes& bytes) {
        const auto* from = reinterpret_cast<const std::uint8_t*>(bytes.data());
        all[piece] = extremal::records_from({from, bytes.size()});
      });
  return extremal::join(std::move(all));
}

std::vector<AtPlace> all_values(const PieceJob& job, const io::VolumeBoxes& boxes,
                                const std::vector<std::size_t>& of, std::span<const Vec3> places) {
  std::vector<std::vector<Vec3>> own(job.owned.size());
  for (std::size_t i = 0; i < of.size(); ++i) own[of[i]].push_back(places[i]);
  std::vector<std::vector<AtPlace>> got(own.size());
  ask({Task::volume_values,
       {},
       own.size(),
       [&](std::size_t piece) {
         Bytes bytes;
         append(bytes, own[piece].data(), own[piece].size());
         return bytes;
       },
       [&](std::size_t piece, const Bytes& bytes, Bytes& to) {
         values_to(job, boxes, piece, bytes, to);
       }},
      [&](std::size_t piece, const Bytes& bytes) { got[piece] = items_in<AtPlace>(bytes); });
  std::vector<AtPlace> r;
  std::vector<std::size_t> next(own.size());
  for (const std::size_t piece : of) r.push_back(got[piece][next[piece]++]);
  return r;
}

}  // namespace

std::map<Task, Skill> volume_skills() {
  // The values asked for are those of the volume that the records were of.
  struct State {
    PieceJob job;
    std::unique_ptr<io::VolumeBoxes> boxes;
  };
  const auto state = std::make_shared<State>();
  const auto start = [state](const Bytes& common) {
    diy::MemoryBuffer buffer;
    buffer.buffer = common;
    for_members(state->job, [&](auto& member) { diy::load(buffer, member); });
    state->boxes = std::make_unique<io::VolumeBoxes>(state->job.input, state->job.source);
  };
  const auto records = [state](std::size_t piece, const Bytes&, Bytes& to) {
    records_to(state->job, *state->boxes, piece, to);
  };
  const auto values = [state](std::size_t piece, const Bytes& places, Bytes& to) {
    values_to(state->job, *state->boxes, piece, places, to);
  };
  return {{Task::volume_records, {start, records}},
          {Task::volume_values, {[](const Bytes&) {}, values}}};
}

void use_ranks_for_volumes() {
  cli::PieceEngine& engine = cli::piece_engine();
  engine.least_pieces = rank_count();
  engine.records = all_records;
  engine.values = all_values;
}

}  // namespace crest::distributed
