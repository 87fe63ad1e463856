// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <memory>
#include <stdexcept>

#include "certify/container/container.hpp"

namespace crest::certify {
namespace {

struct Close {
  void operator()(std::FILE* file) const { std::fclose(file); }
};
using File = std::unique_ptr<std::FILE, Close>;

[[noreturn]] void fail(const std::string& path, const char* action) {
  throw std::runtime_error(fmt::format("{}: cannot {}: {}", path, action, std::strerror(errno)));
}

template <class List>
List read_all(const std::string& path) {
  const File file(std::fopen(path.c_str(), "rb"));
  if (!file) fail(path, "open");
  List bytes;
  // The size is only a hint (pipes have none); the loop reads to the end whatever it says.
  std::size_t chunk = std::size_t{1} << 16;
  if (std::fseek(file.get(), 0, SEEK_END) == 0) {
    if (const long size = std::ftell(file.get()); size > 0 && size < (1L << 40))
      chunk = static_cast<std::size_t>(size) + 1;
    std::rewind(file.get());
  }
  std::size_t used = 0;
  while (true) {
    bytes.resize(used + chunk);
    const std::size_t got = std::fread(bytes.data() + used, 1, chunk, file.get());
    used += got;
    if (got < chunk) break;
  }
  if (std::ferror(file.get())) fail(path, "read");
  bytes.resize(used);
  return bytes;
}

}  // namespace

void write_file(const std::string& path, const Bytes& bytes) {
  std::error_code ignored;
  const auto status = std::filesystem::status(path, ignored);
  // A device or pipe is written directly: renaming would put a file in its place.
  const bool special = std::filesystem::exists(status) && !std::filesystem::is_regular_file(status);
  const std::string temporary = special ? path : fmt::format("{}.part-{}", path, ::getpid());
  File file(std::fopen(temporary.c_str(), "wb"));
  if (!file) fail(path, "write");
  bool good = std::fwrite(bytes.data(), 1, bytes.size(), file.get()) == bytes.size();
  good = std::fclose(file.release()) == 0 && good;
  if (good && (special || std::rename(temporary.c_str(), path.c_str()) == 0)) return;
  const int error = errno;
  if (!special) std::remove(temporary.c_str());
  errno = error;
  fail(path, "write");
}

Bytes read_file(const std::string& path) {
  return read_all<Bytes>(path);
}

Buffer<std::uint8_t> read_buffer(const std::string& path) {
  return read_all<Buffer<std::uint8_t>>(path);
}

}  // namespace crest::certify
