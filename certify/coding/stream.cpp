// SPDX-License-Identifier: GPL-3.0-or-later
// Container and order (docs/cmc-format.md, sections 1 and 9).
#include "certify/coding/stream.hpp"

#include <algorithm>
#include <cstring>

#include "certify/coding/decisions.hpp"
#include "certify/container/byte_writer.hpp"
#include "certify/container/sha256.hpp"

namespace crest::certify {
namespace {

using u32 = std::uint32_t;
using Span = std::span<const std::uint8_t>;

class Bytes8 {
 public:
  explicit Bytes8(Span bytes) : left_(bytes) {}

  Span take(std::size_t n) {
    require(n <= left_.size(), "stream: ends early");
    const Span piece = left_.first(n);
    left_ = left_.subspan(n);
    return piece;
  }
  u32 byte() { return take(1)[0]; }
  u32 varint() {
    std::uint64_t x = 0;
    for (int shift = 0;; shift += 7) {
      require(shift < 35, "stream: a count is too long");
      const u32 b = byte();
      x |= std::uint64_t{b & 0x7f} << shift;
      if (b >> 7 != 0) continue;
      require((b != 0 || shift == 0) && x >> 32 == 0, "stream: a count not in its one form");
      return static_cast<u32>(x);
    }
  }
  Span section() {
    const u32 n = varint();
    u32 stated = 0;
    const Span sum = take(4);
    for (std::size_t i = 4; i-- > 0;) stated = stated << 8 | sum[i];
    const Span bytes = take(n);
    require(crc_of(bytes) == stated, "stream: a section's checksum is another");
    return bytes;
  }
  bool empty() const { return left_.empty(); }

 private:
  static u32 crc_of(Span bytes) {
    u32 crc = 0xffffffffu;
    for (const std::uint8_t b : bytes) {
      crc ^= b;
      for (int k = 0; k < 8; ++k) crc = crc >> 1 ^ (0xedb88320u & (0u - (crc & 1u)));
    }
    return ~crc;
  }
  Span left_;
};

std::vector<u32> read_permutation(Decisions& in, std::size_t size) {
  std::array<Counter, 2> down;
  std::array<std::array<Counter, 64>, 2> gap;
  std::vector<bool> taken(size, false);
  std::vector<u32> numbers;
  std::int64_t before = -1;
  bool was_down = false;
  while (numbers.size() < size) {
    was_down = in.alone(down[was_down]);
    const std::uint64_t g = in.large(gap[was_down]);
    require(g < size, "stream: an order's number is out of range");
    before += was_down ? -1 - static_cast<std::int64_t>(g) : 1 + static_cast<std::int64_t>(g);
    require(before >= 0 && before < static_cast<std::int64_t>(size),
            "stream: an order's number is out of range");
    const auto number = static_cast<std::size_t>(before);
    require(!taken[number], "stream: an order's number stands twice");
    taken[number] = true;
    numbers.push_back(static_cast<u32>(number));
  }
  return numbers;
}

void reorder(DecodedMesh& mesh, Span section) {
  Decisions in(section);
  const std::vector<u32> vertex = read_permutation(in, mesh.vertices),
                         face = read_permutation(in, mesh.faces.size());
  in.finish();
  FaceList faces(mesh.faces.size());
  for (std::size_t f = 0; f < faces.size(); ++f)
    for (std::size_t k = 0; k < 3; ++k) faces[face[f]][k] = vertex[mesh.faces[f][k]];
  mesh.faces = std::move(faces);
  if (mesh.positions.empty()) return;
  auto positions = mesh.positions;
  for (std::size_t v = 0; v < positions.size(); ++v) positions[vertex[v]] = mesh.positions[v];
  mesh.positions = std::move(positions);
}

FaceList decode_faces(Span section, const StreamCounts& counts, int method, std::size_t faces) {
  return method == 0 ? decode_valences(section, counts, faces)
                     : decode_strips(section, counts, method, faces);
}

FaceList decode_cleared(Span section, const StreamCounts& counts, int method, std::size_t faces) {
  Bytes8 in(section);
  std::size_t size = 0;
  const Span length = in.take(4);
  for (std::size_t i = 4; i-- > 0;) size = size << 8 | length[i];
  const Span base = in.take(size);
  Decisions decisions(section.subspan(4 + size));
  std::array<Counter, 64> counters;
  const std::uint64_t lost = decisions.large(counters), rounds = 1 + decisions.below(64);
  require(lost < counts.vertices, "stream: no vertices are left without those of valence 3");
  StreamCounts fewer = counts;
  fewer.vertices -= static_cast<u32>(lost);
  FaceList list = decode_faces(base, fewer, method, faces);
  u32 vertex = fewer.vertices;
  for (std::uint64_t round = 0; round < rounds; ++round) {
    std::array<Counter, 4> put_back;
    for (std::size_t f = 0, end = list.size(); f < end; ++f) {
      const auto [a, b, c] = list[f];
      const auto fresh =
          std::count_if(list[f].begin(), list[f].end(), [&](u32 v) { return v >= fewer.vertices; });
      if (!decisions.alone(put_back[static_cast<std::size_t>(fresh)])) continue;
      require(vertex < counts.vertices && list.size() + 2 <= faces,
              "stream: more vertices or faces are put back than the mesh has");
      list[f] = {a, b, vertex};
      list.push_back({b, c, vertex});
      list.push_back({c, a, vertex++});
    }
  }
  require(vertex == counts.vertices, "stream: vertices of valence 3 are missing");
  decisions.finish();
  return list;
}

void check_digest(const DecodedMesh& mesh, Span stated) {
  ByteWriter out;
  out.integer(mesh.vertices);
  out.integer(static_cast<u32>(mesh.faces.size()));
  for (auto face : mesh.faces) {
    std::rotate(face.begin(), std::min_element(face.begin(), face.end()), face.end());
    for (const u32 v : face) out.integer(v);
  }
  for (const auto& point : mesh.positions)
    for (const std::uint64_t pattern : point) out.integer(pattern);
  const auto digest = sha256({out.result()});
  require(std::equal(stated.begin(), stated.end(), digest.begin()),
          "stream: the mesh's digest is another");
}

}  // namespace

DecodedMesh decode_stream(Span stream, std::size_t vertices, std::size_t faces) {
  constexpr std::array<std::uint8_t, 4> magic = {0x43, 0x4d, 0x43, 0x1a};
  Bytes8 in(stream);
  const Span start = in.take(magic.size());
  require(std::equal(magic.begin(), magic.end(), start.begin()), "stream: is not .cmc");
  const u32 version = in.byte(), flags = in.byte();
  const bool attributes = (flags & 32) != 0;
  DecodedMesh mesh;
  mesh.has_attributes = attributes;
  mesh.positions_mode = static_cast<int>(flags >> 3 & 3);
  mesh.ordered = (flags & 64) != 0;
  require((flags & 0x80) == 0 && mesh.positions_mode < 3, "stream: flags of no meaning");
  const u32 method = in.byte();
  const bool cleared = method >= 4;
  require(method < 8, "stream: no such method");
  require(version == (attributes || cleared ? 2 : 1), "stream: of version {}, unlike its flags",
          version);
  mesh.method = static_cast<int>(method % 4);
  mesh.vertices = in.varint();
  const auto optional = [&](u32 flag, u32 otherwise) {
    if ((flags & flag) == 0) return otherwise;
    const u32 x = in.varint();
    require(x != otherwise, "stream: a count that needs no telling");
    return x;
  };
  mesh.components = optional(1, 1);
  mesh.loops = optional(2, 0);
  mesh.handles = optional(4, 0);
  require(mesh.vertices == vertices && mesh.components >= 1 &&
              std::uint64_t{3} * mesh.components <= vertices && mesh.loops <= 3 * faces &&
              mesh.handles <= 3 * faces,
          "stream: its counts are not the mesh's");
  const StreamCounts counts = {mesh.vertices, mesh.components, mesh.loops, mesh.handles};
  const Span connectivity = in.section();
  mesh.connectivity_bytes = connectivity.size();
  mesh.faces = cleared ? decode_cleared(connectivity, counts, mesh.method, faces)
                       : decode_faces(connectivity, counts, mesh.method, faces);
  require(mesh.faces.size() == faces, "stream: {} faces, the mesh has {}", mesh.faces.size(),
          faces);
  if (mesh.positions_mode > 0)
    mesh.positions = decode_positions(in.section(), mesh.faces, vertices, mesh.positions_mode);
  if (attributes) require(!in.section().empty(), "stream: its attributes' section is empty");
  if (mesh.ordered) reorder(mesh, in.section());
  check_digest(mesh, in.take(8));
  require(in.empty(), "stream: bytes left over");
  return mesh;
}

}  // namespace crest::certify
