// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/coding/container.hpp"

#include <openssl/evp.h>

#include <algorithm>
#include <bit>
#include <boost/crc.hpp>
#include <stdexcept>
#include <string>

#include "kernel/geometry/input_error.hpp"

namespace crest::coding {
namespace {

constexpr std::array<std::uint8_t, 4> kMagic = {0x43, 0x4d, 0x43, 0x1a};
/// Attributes and clearance are of version 2.
constexpr std::uint8_t kVersion = 1, kNewest = 2;

void put_varint(Bytes& out, std::uint32_t x) {
  for (; x >= 128; x >>= 7) out.push_back(static_cast<std::uint8_t>(x | 128));
  out.push_back(static_cast<std::uint8_t>(x));
}

template <class Word>
void put_word(Bytes& out, Word x) {
  for (std::size_t i = 0; i < sizeof(Word); ++i)
    out.push_back(static_cast<std::uint8_t>(x >> (8 * i)));
}

std::uint32_t checksum(std::span<const std::uint8_t> bytes) {
  boost::crc_32_type crc;
  crc.process_bytes(bytes.data(), bytes.size());
  return crc.checksum();
}

/// Reads the header; every error names the byte where it stands.
class Reader {
 public:
  explicit Reader(std::span<const std::uint8_t> bytes) : bytes_(bytes) {}

  [[noreturn]] void fail(const std::string& problem,
                         const char* remedy = "get the file again") const {
    throw kernel::InputError("header, byte " + std::to_string(at_) + ": " + problem + "; " +
                             remedy);
  }
  std::span<const std::uint8_t> take(std::size_t count) {
    if (bytes_.size() - at_ < count) fail("the stream ends too early");
    at_ += count;
    return bytes_.subspan(at_ - count, count);
  }
  std::uint8_t byte() { return take(1)[0]; }
  std::uint32_t varint() {
    std::uint64_t x = 0;
    for (int i = 0; i < 5; ++i) {
      const std::uint8_t b = byte();
      x |= std::uint64_t{b & 127u} << (7 * i);
      if (b >= 128) continue;
      if ((b == 0 && i > 0) || x > 0xffffffffu) break;
      return static_cast<std::uint32_t>(x);
    }
    fail("a number is longer than it may be");
  }
  std::uint32_t word() {
    std::uint32_t x = 0;
    const auto bytes = take(4);
    for (std::size_t i = 4; i-- > 0;) x = x << 8 | bytes[i];
    return x;
  }
  std::size_t left() const { return bytes_.size() - at_; }

 private:
  std::span<const std::uint8_t> bytes_;
  std::size_t at_ = 0;
};

Index announced(Reader& reader, bool follows, Index otherwise) {
  if (!follows) return otherwise;
  const Index x = reader.varint();
  if (x == otherwise) reader.fail("a number that needs not be there");
  return x;
}

}  // namespace

bool Container::has(Section section) const {
  switch (section) {
    case Section::connectivity:
      return true;
    case Section::positions:
      return places != Places::none;
    case Section::attributes:
      return has_attributes;
    case Section::order:
      break;
  }
  return keeps_order;
}

Bytes compose(const Container& c) {
  Bytes out(kMagic.begin(), kMagic.end());
  const auto flag = [](bool set, int bit) {
    return static_cast<std::uint8_t>((set ? 1 : 0) << bit);
  };
  out.push_back(c.has_attributes || c.cleared ? kNewest : kVersion);
  out.push_back(static_cast<std::uint8_t>(
      flag(c.counts.components != 1, 0) | flag(c.counts.loops != 0, 1) |
      flag(c.counts.handles != 0, 2) | static_cast<std::uint8_t>(c.places) << 3 |
      flag(c.has_attributes, 5) | flag(c.keeps_order, 6)));
  out.push_back(
      static_cast<std::uint8_t>(static_cast<std::uint8_t>(c.method) | flag(c.cleared, 2)));
  put_varint(out, c.counts.vertices);
  if (c.counts.components != 1) put_varint(out, c.counts.components);
  if (c.counts.loops != 0) put_varint(out, c.counts.loops);
  if (c.counts.handles != 0) put_varint(out, c.counts.handles);
  for (std::size_t i = 0; i < c.sections.size(); ++i) {
    if (!c.has(static_cast<Section>(i))) continue;
    put_varint(out, static_cast<std::uint32_t>(c.sections[i].size()));
    put_word(out, checksum(c.sections[i]));
    out.insert(out.end(), c.sections[i].begin(), c.sections[i].end());
  }
  out.insert(out.end(), c.digest.begin(), c.digest.end());
  return out;
}

Container parse(std::span<const std::uint8_t> stream) {
  Reader reader(stream);
  if (!std::equal(kMagic.begin(), kMagic.end(), reader.take(4).begin()))
    reader.fail("this is no .cmc stream", "give a file that crest encode wrote");
  const std::uint8_t version = reader.byte();
  if (version != kVersion && version != kNewest)
    reader.fail("the stream is of version " + std::to_string(version) + ", this reader knows 1, 2",
                "use a newer crest");
  const std::uint8_t flags = reader.byte();
  Container c;
  c.has_attributes = (flags & 32) != 0;
  if ((flags & 128) != 0 || (flags >> 3 & 3) == 3) reader.fail("a flag has no meaning");
  c.places = static_cast<Places>(flags >> 3 & 3);
  c.keeps_order = (flags & 64) != 0;
  const std::uint8_t method = reader.byte();
  if (method > 7) reader.fail("the method has no meaning");
  c.method = static_cast<Method>(method & 3);
  c.cleared = method > 3;
  if ((c.has_attributes || c.cleared) != (version == kNewest))
    reader.fail("the version is not that of the flags");
  c.counts.vertices = reader.varint();
  c.counts.components = announced(reader, (flags & 1) != 0, 1);
  c.counts.loops = announced(reader, (flags & 2) != 0, 0);
  c.counts.handles = announced(reader, (flags & 4) != 0, 0);
  if (c.counts.components == 0 || c.counts.components > c.counts.vertices / 3)
    reader.fail("so many components have more vertices");
  for (std::size_t i = 0; i < c.sections.size(); ++i) {
    if (!c.has(static_cast<Section>(i))) continue;
    const std::uint32_t size = reader.varint();
    const std::uint32_t sum = reader.word();
    c.sections[i] = reader.take(size);
    if (checksum(c.sections[i]) != sum)
      reader.fail(std::string("the checksum of section ") + kSectionNames[i] + " differs");
  }
  const auto digest = reader.take(c.digest.size());
  std::copy(digest.begin(), digest.end(), c.digest.begin());
  if (reader.left() > 0) reader.fail("bytes follow the end of the stream");
  return c;
}

std::array<std::uint8_t, 8> digest_head(std::span<const std::uint8_t> bytes) {
  std::array<std::uint8_t, 32> whole;
  if (EVP_Digest(bytes.data(), bytes.size(), whole.data(), nullptr, EVP_sha256(), nullptr) != 1)
    throw std::runtime_error("OpenSSL has no SHA-256");
  std::array<std::uint8_t, 8> head;
  std::copy_n(whole.begin(), head.size(), head.begin());
  return head;
}

std::array<std::uint8_t, 8> mesh_digest(Index vertices, std::span<const Triangle> faces,
                                        std::span<const Point> points) {
  Bytes bytes;
  bytes.reserve(8 + 12 * faces.size() + 24 * points.size());
  put_word(bytes, vertices);
  put_word(bytes, static_cast<std::uint32_t>(faces.size()));
  for (const Triangle& f : faces) {
    const auto least = static_cast<std::size_t>(std::min_element(f.begin(), f.end()) - f.begin());
    for (std::size_t k = 0; k < 3; ++k) put_word(bytes, f[(least + k) % 3]);
  }
  for (const Point& p : points)
    for (const double x : p) put_word(bytes, std::bit_cast<std::uint64_t>(x));
  return digest_head(bytes);
}

}  // namespace crest::coding
