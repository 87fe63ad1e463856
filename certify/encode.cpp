// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <bit>
#include <cstring>
#include <stdexcept>

#include "certify/container/container.hpp"
#include "certify/container/sha256.hpp"
#include "certify/ridges_mesh/canonical.hpp"

namespace crest::certify {
namespace {

class ByteWriter {
 public:
  explicit ByteWriter(Bytes start = {}) : bytes_(std::move(start)) {}
  template <class Integer>
  void integer(Integer value) {
    auto bits = static_cast<std::uint64_t>(value);
    for (std::size_t i = 0; i < sizeof(Integer); ++i, bits >>= 8)
      bytes_.push_back(static_cast<std::uint8_t>(bits));
  }
  void rows(const std::vector<std::array<std::uint32_t, 3>>& rows) {
    std::uint8_t* to = grow(rows.size() * kFaceSize);
    for (const auto& row : rows)
      for (const auto word : row) to = store(to, word);
  }
  /// A zero is written as +0.
  template <std::size_t n>
  void rows(const std::vector<std::array<double, n>>& rows) {
    std::uint8_t* to = grow(rows.size() * n * sizeof(double));
    for (const auto& row : rows)
      for (const double x : row)
        to = store(to, x == 0 ? std::uint64_t{0} : std::bit_cast<std::uint64_t>(x));
  }
  void numbers(const std::vector<double>& list) {
    std::uint8_t* to = grow(list.size() * sizeof(double));
    for (const double x : list)
      to = store(to, x == 0 ? std::uint64_t{0} : std::bit_cast<std::uint64_t>(x));
  }
  void numbers(const std::vector<std::uint32_t>& list) {
    std::uint8_t* to = grow(list.size() * sizeof(std::uint32_t));
    for (const auto word : list) to = store(to, word);
  }
  void count(std::size_t n) {
    if (n > 0xffffffffU) throw std::invalid_argument("certificate: a list is too long");
    integer(static_cast<std::uint32_t>(n));
  }
  void bytes(std::span<const std::uint8_t> piece) {
    bytes_.insert(bytes_.end(), piece.begin(), piece.end());
  }
  void reserve(std::size_t n) { bytes_.reserve(n); }
  std::size_t size() const { return bytes_.size(); }
  Bytes& result() { return bytes_; }

 private:
  std::uint8_t* grow(std::size_t n) {
    bytes_.resize(bytes_.size() + n);
    return bytes_.data() + bytes_.size() - n;
  }
  template <class Word>
  static std::uint8_t* store(std::uint8_t* to, Word word) {
    for (std::size_t i = 0; i < sizeof(Word); ++i)
      to[i] = static_cast<std::uint8_t>(word >> (8 * i));
    return to + sizeof(Word);
  }
  Bytes bytes_;
};

void write_data(ByteWriter& out, const MeshData& data) {
  if (data.monge.size() != data.positions.size())
    throw std::invalid_argument("certificate: as many Monge forms as vertices are needed");
  out.count(data.positions.size());
  out.count(data.faces.size());
  out.rows(data.faces);
  out.rows(data.positions);
  out.rows(data.monge);
}

void write_ridge(ByteWriter& out, const RidgeRecord& ridge) {
  out.integer(ridge.flags);
  out.count(ridge.nodes.size());
  for (std::size_t end = 0; end < 2; ++end) {
    out.integer(ridge.end_kind[end]);
    out.integer(ridge.end_patch[end]);
  }
  for (const auto& node : ridge.nodes) {
    out.integer(node.edge);
    out.integer(node.type);
  }
}

void write_claims(ByteWriter& out, const RidgesMeshCertificate& c) {
  out.integer(c.euler_characteristic);
  out.integer(c.boundary_loops);
  out.integer(c.twice_index_sum);
  out.integer(c.conflict_triangles);
  out.integer(c.ambiguous_edges);
  for (const auto zeros : c.zero_extremalities) out.integer(zeros);
  out.count(c.face_indices.size());
  for (const auto& record : c.face_indices) {
    out.integer(record.face);
    out.integer(record.twice_index);
  }
  out.count(c.patches.size());
  for (const auto& patch : c.patches) {
    out.integer(patch.centre);
    out.integer(patch.twice_index);
    out.integer(patch.kind);
    out.integer(patch.coherent);
    out.count(patch.faces.size());
    for (const auto face : patch.faces) out.integer(face);
  }
  for (const auto count : c.counts) out.integer(count);
  for (const auto& ridge : c.ridges) write_ridge(out, ridge);
}

void write_features_data(ByteWriter& out, const FeaturesMeshCertificate& c) {
  out.count(c.positions.size());
  out.count(c.faces.size());
  out.rows(c.faces);
  out.rows(c.positions);
  out.bytes(c.marked_before);
}

void write_features_claims(ByteWriter& out, const FeaturesMeshCertificate& c) {
  out.integer(c.euler_characteristic);
  out.integer(c.boundary_loops);
  for (const auto* list : {&c.removed, &c.marked_after, &c.dropped}) {
    out.count(list->size());
    for (const auto v : *list) out.integer(v);
  }
  for (const BettiRecord& b : c.betti) {
    out.integer(b.euler);
    out.integer(b.components);
    out.integer(b.loops);
    out.integer(b.closed);
  }
}

/// Open for writing: reseal and rebind report lengths that do not fit as a wrong argument.
Container open_for_sealing(const Bytes& bytes) {
  try {
    return open_container(bytes);
  } catch (const Malformed& problem) {
    throw std::invalid_argument(problem.what());
  }
}

void store_seal(Bytes& bytes, const Digest& seal) {
  std::copy(seal.begin(), seal.end(), bytes.end() - static_cast<std::ptrdiff_t>(kSealSize));
}

/// Header and data section; the claim section's length is still open.
template <class WriteData>
EncodedData begin(std::uint32_t claim, std::size_t data_size, WriteData&& write_data_section) {
  ByteWriter out;
  out.reserve(kHeaderSize + data_size + data_size / 8);
  out.bytes(kMagic);
  out.integer(kVersion);
  out.integer(claim);
  out.bytes(Digest{});
  out.integer(std::uint64_t{data_size});
  out.integer(std::uint64_t{0});
  write_data_section(out);
  EncodedData data{std::move(out.result()), {}};
  data.digest = sha256({std::span(data.bytes).subspan(kHeaderSize)});
  std::copy(data.digest.begin(), data.digest.end(), data.bytes.begin() + kDigestOffset);
  return data;
}

/// Claim section and seal.
template <class WriteClaims>
Bytes finish(EncodedData data, WriteClaims&& write_claim_section) {
  ByteWriter out(std::move(data.bytes));
  const std::size_t claims_start = out.size();
  write_claim_section(out);
  auto claims_size = static_cast<std::uint64_t>(out.size() - claims_start);
  out.bytes(Digest{});
  Bytes bytes = std::move(out.result());
  for (std::size_t i = 0; i < 8; ++i, claims_size >>= 8)
    bytes[kLengthsOffset + 8 + i] = static_cast<std::uint8_t>(claims_size);
  reseal(bytes);
  return bytes;
}

void write_reeb_data(ByteWriter& out, const ReebCertificate& c) {
  out.count(c.positions.size());
  out.count(c.faces.size());
  out.integer(static_cast<std::uint8_t>(c.edge_values.empty() ? 1 : 2));
  out.rows(c.faces);
  out.rows(c.positions);
  out.numbers(c.values);
  out.numbers(c.edge_values);
}

void write_reeb_claims(ByteWriter& out, const ReebCertificate& c) {
  out.integer(c.euler_characteristic);
  for (const auto number : {c.boundary_loops, c.components, c.line_critical, c.face_critical,
                            c.tiles, c.minima, c.saddles, c.maxima})
    out.integer(number);
  out.numbers(c.order);
  out.count(c.critical_nodes.size());
  out.numbers(c.critical_nodes);
  out.count(c.arcs.size());
  for (const ArcRecord& arc : c.arcs) {
    out.integer(arc.lower);
    out.integer(arc.upper);
  }
  out.count(c.cuts.size());
  for (const CutRecord& cut : c.cuts) {
    out.integer(cut.arc);
    out.integer(cut.node);
  }
}

/// Header, the two sections, digest and seal.
template <class WriteData, class WriteClaims>
Bytes compose(std::uint32_t claim, std::size_t data_size, WriteData&& write_data_section,
              WriteClaims&& write_claim_section) {
  return finish(begin(claim, data_size, write_data_section), write_claim_section);
}

}  // namespace

EncodedData encode_data(const MeshData& data) {
  const std::size_t size = 8 + data.faces.size() * kFaceSize + data.positions.size() * kVertexSize;
  return begin(kRidgesMesh, size, [&](ByteWriter& out) { write_data(out, data); });
}

Bytes encode_as_is(const RidgesMeshCertificate& certificate) {
  return finish(encode_data(certificate.data),
                [&](ByteWriter& out) { write_claims(out, certificate); });
}

Bytes encode(const FeaturesMeshCertificate& certificate) {
  if (certificate.marked_before.size() != certificate.positions.size())
    throw std::invalid_argument("certificate: as many marks as vertices are needed");
  const std::size_t data_size = 8 + certificate.faces.size() * kFaceSize +
                                certificate.positions.size() * (3 * sizeof(double) + 1);
  return compose(
      kFeaturesMesh, data_size, [&](ByteWriter& out) { write_features_data(out, certificate); },
      [&](ByteWriter& out) { write_features_claims(out, certificate); });
}

Bytes encode(const ReebCertificate& certificate) {
  const std::size_t vertices = certificate.positions.size();
  if (certificate.values.size() != vertices)
    throw std::invalid_argument("certificate: as many values as vertices are needed");
  if (certificate.order.size() !=
      vertices + std::size_t{certificate.line_critical} + certificate.face_critical)
    throw std::invalid_argument("certificate: the order must hold every node");
  const std::size_t data_size = 9 + certificate.faces.size() * kFaceSize +
                                vertices * 4 * sizeof(double) +
                                certificate.edge_values.size() * sizeof(double);
  return compose(
      kReeb, data_size, [&](ByteWriter& out) { write_reeb_data(out, certificate); },
      [&](ByteWriter& out) { write_reeb_claims(out, certificate); });
}

Bytes encode(RidgesMeshCertificate certificate) {
  make_canonical(certificate);
  return encode_as_is(certificate);
}

Bytes encode(RidgesMeshCertificate certificate, EncodedData data) {
  make_canonical(certificate);
  return finish(std::move(data), [&](ByteWriter& out) { write_claims(out, certificate); });
}

Digest data_digest(const Bytes& certificate) {
  return open_for_sealing(certificate).data_digest();
}

void reseal(Bytes& certificate) {
  store_seal(certificate, open_for_sealing(certificate).seal());
}

void rebind(Bytes& certificate) {
  const Digest digest = open_for_sealing(certificate).data_digest();
  std::copy(digest.begin(), digest.end(), certificate.begin() + kDigestOffset);
  reseal(certificate);
}

}  // namespace crest::certify
