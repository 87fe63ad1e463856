// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/write/inline_array.hpp"

#include <libdeflate.h>
#include <openssl/evp.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <memory>
#include <new>
#include <string>
#include <vector>

namespace crest::io {
namespace {

constexpr std::size_t kRun = 16;  ///< blocks for which one decides

class Compressor {
 public:
  explicit Compressor(int level) : compressor_(libdeflate_alloc_compressor(level)) {
    if (!compressor_) throw std::bad_alloc();
  }
  /// No longer than it has to be: all blocks of an array are kept.
  std::string operator()(std::string_view bytes) {
    room_.resize(libdeflate_zlib_compress_bound(compressor_.get(), bytes.size()));
    return {room_.data(), libdeflate_zlib_compress(compressor_.get(), bytes.data(), bytes.size(),
                                                   room_.data(), room_.size())};
  }

 private:
  struct Free {
    void operator()(libdeflate_compressor* c) const { libdeflate_free_compressor(c); }
  };
  std::unique_ptr<libdeflate_compressor, Free> compressor_;
  std::vector<char> room_;
};

std::vector<std::string> compressed(std::size_t size, const BytesAt& bytes, std::size_t block) {
  const std::size_t count = (size + block - 1) / block;
  std::vector<std::string> streams(count);
  tbb::parallel_for(std::size_t{0}, (count + kRun - 1) / kRun, [&](std::size_t run) {
    std::vector<char> room;
    const auto block_at = [&](std::size_t b) {
      return bytes(b * block, std::min(block, size - b * block), room);
    };
    const std::size_t first = run * kRun, end = std::min(count, first + kRun);
    const std::string_view sample = block_at(first);
    Compressor compressor(1);
    streams[first] = compressor(sample);
    if (8 * streams[first].size() > 7 * sample.size()) compressor = Compressor(0);
    for (std::size_t b = first + 1; b < end; ++b) streams[b] = compressor(block_at(b));
  });
  return streams;
}

/// One text of base64, whatever pieces its bytes come in.
class Base64 {
 public:
  explicit Base64(const Sink& sink) : sink_(sink) {}
  void add(std::string_view bytes) {
    while (!bytes.empty()) {
      const std::size_t size = std::min(bytes.size(), kPiece - used_);
      std::memcpy(bytes_.data() + used_, bytes.data(), size);
      bytes.remove_prefix(size);
      if ((used_ += size) == kPiece) flush();
    }
  }
  /// Requires: a multiple of three bytes since the last call, unless it is the end.
  void flush() {
    const int length = EVP_EncodeBlock(text_.data(), bytes_.data(), static_cast<int>(used_));
    sink_({reinterpret_cast<const char*>(text_.data()), static_cast<std::size_t>(length)});
    used_ = 0;
  }

 private:
  static constexpr std::size_t kPiece = 3 << 14;
  const Sink& sink_;
  std::vector<unsigned char> bytes_ = std::vector<unsigned char>(kPiece),
                             text_ = std::vector<unsigned char>(kPiece / 3 * 4 + 1);
  std::size_t used_ = 0;
};

}  // namespace

void write_inline_array(std::string_view bytes, std::size_t block, const Sink& sink) {
  write_inline_array(
      bytes.size(),
      [&](std::size_t at, std::size_t size, std::vector<char>&) { return bytes.substr(at, size); },
      block, sink);
}

void write_inline_array(std::size_t size, const BytesAt& bytes, std::size_t block,
                        const Sink& sink) {
  const std::vector<std::string> streams = compressed(size, bytes, block);
  std::vector<std::uint32_t> header = {static_cast<std::uint32_t>(streams.size()),
                                       static_cast<std::uint32_t>(block),
                                       static_cast<std::uint32_t>(size % block)};
  for (const std::string& stream : streams)
    header.push_back(static_cast<std::uint32_t>(stream.size()));
  Base64 text(sink);
  text.add({reinterpret_cast<const char*>(header.data()), header.size() * sizeof header[0]});
  text.flush();
  for (const std::string& stream : streams) text.add(stream);
  text.flush();
}

}  // namespace crest::io
