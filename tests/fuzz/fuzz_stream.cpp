// SPDX-License-Identifier: GPL-3.0-or-later
// libFuzzer target of streams: any bytes decode to a mesh or are refused, and what decodes does so
// in the checker's decoder, too, to the same mesh. Most inputs are edits of small streams, with
// checksums made right again.
#include <bit>
#include <cstdlib>

#include "algorithms/coding/coding.hpp"
#include "certify/coding/stream.hpp"
#include "kernel/geometry/input_error.hpp"
#include "tests/coding/damaged_streams.hpp"

namespace {

using namespace crest;

/// Edits of four bytes each: where (2), how, a value.
void edit(coding::Bytes& stream, std::span<const std::uint8_t> edits) {
  for (; edits.size() >= 4 && stream.size() > 1; edits = edits.subspan(4)) {
    const std::size_t place = (edits[0] + 256U * edits[1]) % stream.size();
    const auto at = stream.begin() + static_cast<std::ptrdiff_t>(place);
    const std::uint8_t value = edits[3];
    switch (edits[2] % 4) {
      case 0:
        *at = value;
        break;
      case 1:
        *at ^= static_cast<std::uint8_t>(1u << value % 8);
        break;
      case 2:
        stream.insert(at, value);
        break;
      default:
        value % 4 == 0 ? stream.resize(place) : void(stream.erase(at));
    }
  }
}

void require_same(const coding::Decoded& mesh, const coding::Bytes& stream) {
  const certify::DecodedMesh other =
      certify::decode_stream(stream, mesh.info.vertices, mesh.faces.size());
  if (other.faces != mesh.faces || other.positions.size() != mesh.points.size()) std::abort();
  for (std::size_t v = 0; v < mesh.points.size(); ++v)
    for (std::size_t k = 0; k < 3; ++k)
      if (other.positions[v][k] != std::bit_cast<std::uint64_t>(mesh.points[v][k])) std::abort();
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const std::vector<coding::Bytes> streams = [] {
    tests::Random random(1);
    return tests::some_streams(random);
  }();
  if (size < 2) return 0;
  const std::span<const std::uint8_t> input(data + 2, size - 2);
  coding::Bytes stream(input.begin(), input.end());
  if (data[0] % 8 != 0) edit(stream = streams[data[1] % streams.size()], input);
  if (data[0] % 16 > 2 && stream.size() > 16) tests::renew_checksums(stream);
  try {
    require_same(coding::decode(stream, {.faces = 1u << 20}), stream);
  } catch (const kernel::InputError&) {
    // refused
  }
  return 0;
}
