// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/piece_work.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

#include "algorithms/extremal/record_bytes.hpp"
#include "certify/container/sha256.hpp"
#include "cli/version.hpp"
#include "io/formats/files.hpp"
#include "io/write/atomic_file.hpp"
#include "kernel/geometry/input_error.hpp"

namespace crest::cli {
namespace {

using extremal::AtPlace;
using extremal::Records;
using extremal::Volume;
using kernel::GridBox;

/// Exactly, in the narrower real type that holds the file's.
Volume volume_in(const io::VolumeBoxes& boxes, const GridBox& box) {
  Volume r{box.size(), boxes.frame().spacing, {}, {}};
  const auto samples = boxes.read(box);
  std::visit(
      [&](const auto& x) {
        using Native = typename std::decay_t<decltype(x)>::value_type;
        if constexpr (sizeof(Native) <= 2 || std::is_same_v<Native, float>)
          r.samples = std::vector<float>(x.begin(), x.end());
        else
          r.samples = std::vector<double>(x.begin(), x.end());
      },
      samples);
  return r;
}

/// Names the file in the errors of what knows no file names.
template <class Work>
auto naming(const std::string& file, const Work& work) {
  try {
    return work();
  } catch (const kernel::InputError& error) {
    throw error.with_file(file);
  }
}

kernel::GridPiece piece_of(const PieceJob& job, std::size_t piece) {
  return naming(job.input,
                [&] { return extremal::piece_of(job.frame, job.options, job.owned[piece]); });
}

certify::Digest digest_of(const Volume& part) {
  return std::visit(
      [](const auto& samples) {
        return certify::sha256({{reinterpret_cast<const std::uint8_t*>(samples.data()),
                                 samples.size() * sizeof(samples[0])}});
      },
      part.samples);
}

/// What a finished piece depends on, in a line. The samples themselves: they may stand in a file
/// beside the one that is named, and times are kept by copies.
std::string key_of(const PieceJob& job, const kernel::GridPiece& piece, const Volume& part) {
  const extremal::Options& o = job.options;
  std::string r =
      fmt::format("crest {} records 2 {} {} {}", CREST_VERSION, fmt::join(piece.size, ","),
                  fmt::join(job.frame.spacing, ","), certify::hex(digest_of(part)));
  r += fmt::format(" {} {} {} {} {} {} {} {} {} {}", int(o.definition), int(o.side), o.sigma,
                   o.tensor_sigma.value_or(o.sigma), o.min_value.has_value(),
                   o.min_value.value_or(0), o.min_strength, o.refine, job.meshes.extremal,
                   job.meshes.critical);
  return r +
         fmt::format(" {} {}\n", fmt::join(piece.owned.low, ","), fmt::join(piece.owned.high, ","));
}

std::string file_of(const PieceJob& job, std::size_t piece) {
  const GridBox& box = job.owned[piece];
  return (std::filesystem::path(job.restart) /
          fmt::format("piece-{}-{}.records", fmt::join(box.low, ","), fmt::join(box.high, ",")))
      .string();
}

std::optional<Records> finished_piece(const std::string& path, const std::string& key) {
  if (!std::filesystem::exists(path)) return {};
  try {
    const io::FileBytes file = io::load(path);
    const std::string_view bytes = file;
    if (bytes.starts_with(key)) {
      const auto* from = reinterpret_cast<const std::uint8_t*>(bytes.data());
      const std::span<const std::uint8_t> rest(from + key.size(), bytes.size() - key.size());
      if (rest.size() < sizeof(certify::Digest)) throw std::runtime_error("cut off");
      const auto records = rest.subspan(sizeof(certify::Digest));
      if (!std::ranges::equal(certify::sha256({records}), rest.first(sizeof(certify::Digest))))
        throw std::runtime_error("another digest");
      return extremal::records_from(records);
    }
  } catch (const std::runtime_error&) {  // or an empty file, which cannot be loaded
    throw kernel::InputError(path + ": piece: is damaged or cannot be read; delete it");
  }
  throw kernel::InputError(path + ": piece: is of another run; choose another folder");
}

void keep_piece(const std::string& path, const std::string& key, const Records& records) {
  const auto bytes = extremal::to_bytes(records);
  std::string file = key;
  const auto append = [&](std::span<const std::uint8_t> more) {
    file.append(reinterpret_cast<const char*>(more.data()), more.size());
  };
  append(certify::sha256({bytes}));
  append(bytes);
  io::PendingFiles at_once;  // the run's own files appear at its end, if it comes to that
  io::write_atomically(path, file);
  at_once.commit();
}

PieceEngine this_process() {
  PieceEngine r;
  r.records = [](const PieceJob& job, const io::VolumeBoxes& boxes) {
    std::vector<Records> all;
    for (std::size_t p = 0; p < job.owned.size(); ++p) all.push_back(piece_records(job, boxes, p));
    return extremal::join(std::move(all));
  };
  r.values = [](const PieceJob& job, const io::VolumeBoxes& boxes,
                const std::vector<std::size_t>& of, std::span<const kernel::Vec3> places) {
    std::vector<AtPlace> values(places.size());
    for (std::size_t p = 0; p < job.owned.size(); ++p) {
      std::vector<kernel::Vec3> own;
      for (std::size_t i = 0; i < of.size(); ++i)
        if (of[i] == p) own.push_back(places[i]);
      const auto got = piece_values(job, boxes, p, own);
      std::size_t next = 0;
      for (std::size_t i = 0; i < of.size(); ++i)
        if (of[i] == p) values[i] = got[next++];
    }
    return values;
  };
  return r;
}

/// Slabs of some layers, in the order of the samples.
std::vector<GridBox> slabs(const kernel::GridSize& size) {
  const std::uint64_t layer = std::uint64_t{size[0]} * size[1];
  const auto thick = static_cast<kernel::Index>(std::max<std::uint64_t>(1, (1U << 24) / layer));
  return kernel::cut_grid(size, {1, 1, (size[2] + thick - 1) / thick});
}

}  // namespace

extremal::VolumeFrame frame_of(const kernel::SampledGrid& grid) {
  extremal::VolumeFrame r;
  for (std::size_t k = 0; k < 3; ++k) {
    // What is too large for a number is refused by name later.
    r.size[k] = static_cast<kernel::Index>(std::min<std::size_t>(grid.size[k], kernel::kNone));
  }
  r.spacing = grid.spacing;
  return r;
}

Records piece_records(const PieceJob& job, const io::VolumeBoxes& boxes, std::size_t piece) {
  const auto p = piece_of(job, piece);
  const Volume part = volume_in(boxes, p.all);
  const auto work = [&] {
    return naming(job.input,
                  [&] { return extremal::records_of(part, p, job.options, job.meshes); });
  };
  if (job.restart.empty()) return work();
  const std::string path = file_of(job, piece), key = key_of(job, p, part);
  if (auto found = finished_piece(path, key)) return std::move(*found);
  Records r = work();
  keep_piece(path, key, r);
  return r;
}

std::vector<AtPlace> piece_values(const PieceJob& job, const io::VolumeBoxes& boxes,
                                  std::size_t piece, std::span<const kernel::Vec3> places) {
  if (places.empty()) return {};
  const auto p = piece_of(job, piece);
  return extremal::values_of(volume_in(boxes, p.all), p, job.options, places);
}

PieceEngine& piece_engine() {
  static PieceEngine engine = this_process();
  return engine;
}

extremal::Result extract_pieces(const PieceJob& job, const io::VolumeBoxes& boxes,
                                certify::ExtremalCertificate* certificate) {
  const PieceEngine& engine = piece_engine();
  Records joined = engine.records(job, boxes);
  const extremal::Owners owners(job.frame, job.options, job.owned);
  const auto values = [&](std::span<const kernel::Vec3> places) {
    std::vector<std::size_t> of;
    of.reserve(places.size());
    for (const kernel::Vec3& x : places) of.push_back(owners.of(x));
    return engine.values(job, boxes, of, places);
  };
  extremal::Result r =
      extremal::assemble(job.frame, job.options, std::move(joined), values, certificate);
  if (certificate != nullptr)
    extremal::store_samples(
        slabs(job.frame.size), [&](const GridBox& box) { return volume_in(boxes, box); },
        certificate->data);
  return r;
}

}  // namespace crest::cli
