// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/certify/mutants.hpp"

#include <algorithm>
#include <functional>

#include "certify/container/container.hpp"
#include "certify/ridges_mesh/decode.hpp"
#include "tests/support/edits.hpp"

namespace crest::tests {
namespace {

using namespace certify;
using Certificate = RidgesMeshCertificate;

template <class Row>
Row* pick(std::vector<Row>& rows, Random& random) {
  return rows.empty() ? nullptr : &rows[random() % rows.size()];
}

/// Makes the four counts agree with the records, so that counting alone finds nothing.
void recount(Certificate& c) {
  c.counts = {};
  for (const auto& ridge : c.ridges)
    ++c.counts[2 * (ridge.flags & 1U) + ((ridge.flags & 2U) != 0 ? 0 : 1)];
}

void edit_patch(PatchRecord& patch, Random& random) {
  switch (random() % 6) {
    case 0:
      return edit_number(patch.centre, random);
    case 1:
      return edit_number(patch.twice_index, random);
    case 2:
      patch.kind = static_cast<std::uint8_t>((patch.kind + 1 + random() % 3) % 4);
      return;
    case 3:
      patch.coherent ^= 1U;
      return;
    case 4:
      patch.faces.push_back(static_cast<std::uint32_t>(random() % 400));
      return std::sort(patch.faces.begin(), patch.faces.end());
    default:
      edit_list(patch.faces, random);
  }
}

void edit_ridge(RidgeRecord& ridge, Random& random) {
  const std::size_t end = random() % 2;
  switch (random() % 8) {
    case 0:
      std::swap(ridge.end_kind[0], ridge.end_kind[1]);
      std::swap(ridge.end_patch[0], ridge.end_patch[1]);
      return;
    case 1:
      ridge.end_kind[end] = static_cast<std::uint8_t>(random() % 3);
      return;
    case 2:
      return edit_number(ridge.end_patch[end], random);
    case 3:
      ridge.flags ^= static_cast<std::uint8_t>(1U << random() % 2);
      return;
    case 4:
      std::reverse(ridge.nodes.begin(), ridge.nodes.end());
      return;
    case 5:
      if (auto* node = pick(ridge.nodes, random)) edit_number(node->edge, random);
      return;
    case 6:
      if (auto* node = pick(ridge.nodes, random))
        node->type ^= static_cast<std::uint8_t>(1U << random() % 4);
      return;
    default:
      edit_list(ridge.nodes, random);
  }
}

/// Cuts a ridge in two, or joins two, with counts to match.
void cut_or_join(Certificate& c, Random& random) {
  RidgeRecord* ridge = pick(c.ridges, random);
  if (ridge == nullptr) return;
  if (random() % 2 && ridge->nodes.size() > 1) {
    RidgeRecord rest = *ridge;
    const auto at = static_cast<std::ptrdiff_t>(1 + random() % (ridge->nodes.size() - 1));
    rest.nodes.erase(rest.nodes.begin(), rest.nodes.begin() + at);
    ridge->nodes.resize(static_cast<std::size_t>(at));
    c.ridges.push_back(rest);
  } else {
    const RidgeRecord other = *pick(c.ridges, random);
    ridge->nodes.insert(ridge->nodes.end(), other.nodes.begin(), other.nodes.end());
  }
}

std::uint64_t read64(const Bytes& bytes, std::size_t at) {
  std::uint64_t x = 0;
  for (std::size_t i = 0; i < 8; ++i) x |= std::uint64_t{bytes[at + i]} << (8 * i);
  return x;
}
void write64(Bytes& bytes, std::size_t at, std::uint64_t x) {
  for (std::size_t i = 0; i < 8; ++i) bytes[at + i] = static_cast<std::uint8_t>(x >> (8 * i));
}

}  // namespace

Certificate decode(const Bytes& bytes) {
  const Container container = open_container(bytes);
  Certificate c;
  c.data = decode_data(container.data);
  decode_claims(container.claims, c);
  return c;
}

Bytes mutate_bytes(Bytes bytes, Random& random) {
  const std::uint64_t data = read64(bytes, kLengthsOffset);
  // Half of the edits in the claim section, which is the smaller part.
  const std::uint64_t room = bytes.size() - std::min(bytes.size(), kHeaderSize);
  const auto claims = static_cast<std::size_t>(kHeaderSize + std::min(data, room));
  const bool anywhere = claims >= bytes.size() || random() % 2;
  const std::size_t at =
      anywhere ? random() % bytes.size() : claims + random() % (bytes.size() - claims);
  const auto place = bytes.begin() + static_cast<std::ptrdiff_t>(at);
  const std::size_t before = bytes.size();
  switch (random() % 8) {
    case 0:
      bytes.resize(at);
      break;
    case 1:
      bytes.insert(bytes.end(), 1 + random() % 40, static_cast<std::uint8_t>(random()));
      break;
    case 2:
      bytes.erase(place, place + std::min<std::ptrdiff_t>(bytes.end() - place,
                                                          1 + static_cast<int>(random() % 16)));
      break;
    case 3:
      bytes.insert(place, 1 + random() % 16, static_cast<std::uint8_t>(random()));
      break;
    case 4:
      bytes[at] = static_cast<std::uint8_t>(random());
      break;
    default:
      bytes[at] ^= static_cast<std::uint8_t>(1U << random() % 8);
  }
  if (bytes.size() != before && bytes.size() > kHeaderSize + kSealSize && random() % 4) {
    const std::uint64_t left = bytes.size() - kHeaderSize - kSealSize;
    if (data <= left) write64(bytes, kLengthsOffset + 8, left - data);
  }
  return bytes;
}

std::string difference_in_words(const Bytes& original, const Bytes& mutant) {
  const auto end = static_cast<std::ptrdiff_t>(std::min(original.size(), mutant.size()));
  const auto at = std::mismatch(original.begin(), original.begin() + end, mutant.begin()).first -
                  original.begin();
  std::string text = std::to_string(original.size()) + " bytes became " +
                     std::to_string(mutant.size()) + ", the first other one is byte " +
                     std::to_string(at);
  if (at == end) return text;
  const auto i = static_cast<std::size_t>(at);
  return text + ": " + std::to_string(original[i]) + " became " + std::to_string(mutant[i]);
}

std::string mutate_claim(Certificate& c, Random& random) {
  using Edit = std::pair<const char*, std::function<void()>>;
  const Edit edits[] = {
      {"euler", [&] { edit_number(c.euler_characteristic, random); }},
      {"loops", [&] { edit_number(c.boundary_loops, random); }},
      {"sum", [&] { edit_number(c.twice_index_sum, random); }},
      {"conflicts", [&] { edit_number(c.conflict_triangles, random); }},
      {"ambiguous", [&] { edit_number(c.ambiguous_edges, random); }},
      {"frames",
       [&] {
         std::uint32_t* const numbers[] = {&c.against_faces, &c.equal_curvatures,
                                           &c.parallel_frames};
         std::uint32_t &x = *numbers[random() % 3], &y = *numbers[random() % 3];
         random() % 2 ? std::swap(x, y) : edit_number(x, random);
       }},
      {"zeros", [&] { edit_number(c.zero_extremalities[random() % 2], random); }},
      {"count", [&] { c.counts[random() % 4] += random() % 2 ? 1U : 0xffffffffU; }},
      {"index list", [&] { edit_list(c.face_indices, random); }},
      {"index",
       [&] {
         if (auto* record = pick(c.face_indices, random)) edit_number(record->twice_index, random);
       }},
      {"index face",
       [&] {
         if (auto* record = pick(c.face_indices, random)) edit_number(record->face, random);
       }},
      {"patch list", [&] { edit_list(c.patches, random); }},
      {"patch",
       [&] {
         if (auto* patch = pick(c.patches, random)) edit_patch(*patch, random);
       }},
      {"ridge list",
       [&] {
         edit_list(c.ridges, random);
         if (random() % 2) recount(c);
       }},
      {"cut or join",
       [&] {
         cut_or_join(c, random);
         recount(c);
       }},
      {"ridge",
       [&] {
         if (auto* ridge = pick(c.ridges, random)) edit_ridge(*ridge, random);
         if (random() % 2) recount(c);
       }},
  };
  // Ridges carry most of the claim: they get half of the edits.
  const std::size_t n = std::size(edits), i = random() % (2 * n);
  const Edit& edit = edits[i < n ? i : n - 1 - i % 3];
  edit.second();
  return edit.first;
}

}  // namespace crest::tests
