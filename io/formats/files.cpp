// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/formats/files.hpp"

#include <sys/mman.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <new>

#include "kernel/geometry/input_error.hpp"

namespace crest::io {
namespace {

constexpr std::uintmax_t kLargestFile = std::uintmax_t{1} << 36;

/// How many bytes of UTF-8 the character has that starts at a place; 0: there is none, or it is a
/// control character or one that XML does not have.
std::size_t length_of_character(const std::string& text, std::size_t at) {
  const auto byte = [&](std::size_t i) {
    return i < text.size() ? static_cast<unsigned char>(text[i]) : 0U;
  };
  const unsigned first = byte(at);
  if (first < 0x80) return first < 0x20 || first == 0x7f ? 0 : 1;
  const std::size_t length = first >= 0xf0 && first < 0xf5   ? 4
                             : first >= 0xe0 && first < 0xf0 ? 3
                             : first >= 0xc2 && first < 0xe0 ? 2
                                                             : 0;
  std::uint32_t character = first & (0xffU >> (length + 1));
  for (std::size_t i = 1; i < length; ++i) {
    if ((byte(at + i) & 0xc0U) != 0x80) return 0;
    character = character << 6 | (byte(at + i) & 0x3fU);
  }
  constexpr std::array<std::uint32_t, 5> least = {0, 0, 0xa0, 0x800, 0x10000};
  const bool surrogate = character >= 0xd800 && character < 0xe000;
  const bool none = surrogate || character == 0xfffe || character == 0xffff || character > 0x10ffff;
  return none || character < least[length] ? 0 : length;
}

}  // namespace

std::string one_line(std::string text, char instead) {
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t length = length_of_character(text, at);
    if (length == 0) text[at] = instead;
    at += std::max<std::size_t>(length, 1);
  }
  return text;
}

void fail(const std::string& element, const std::string& problem, const std::string& remedy) {
  // Before the exception's C string ends at a zero quoted from the file.
  throw kernel::InputError(one_line(element + ": " + problem + "; " + remedy));
}

std::string lower_extension(const std::string& path) {
  std::string extension = std::filesystem::path(path).extension().string();
  for (char& c : extension)
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  return extension;
}

FileBytes::FileBytes(std::size_t size) : size_(size) {
  constexpr std::size_t large_page = std::size_t{1} << 21;
  void* memory = nullptr;
  if (posix_memalign(&memory, size < large_page ? sizeof(void*) : large_page, size) != 0)
    throw std::bad_alloc();
  bytes_.reset(static_cast<char*>(memory));
  if (size >= large_page) madvise(memory, size, MADV_HUGEPAGE);  // where it is not known: no harm
}

void FileBytes::Free::operator()(char* bytes) const {
  std::free(bytes);
}

FileBytes load(const std::string& path) {
  std::error_code error;
  if (!std::filesystem::exists(path, error)) fail("file", "does not exist", "check the path");
  if (!std::filesystem::is_regular_file(path, error))
    fail("file", "is not a regular file", "give the path of a mesh file");
  const auto size = std::filesystem::file_size(path, error);
  if (error || size > kLargestFile) fail("file", "is too large", "split the mesh");
  if (size == 0) fail("file", "is empty", "export the mesh again");
  FileBytes bytes(static_cast<std::size_t>(size));
  std::ifstream stream(path, std::ios::binary);
  if (!stream.read(bytes.data(), static_cast<std::streamsize>(size)))
    fail("file", "cannot be read", "check its permissions");
  return bytes;
}

void read_named(const std::string& name, const std::function<void()>& read) {
  try {
    try {
      read();
    } catch (const kernel::InputError&) {
      throw;
    } catch (const std::bad_alloc&) {
      fail("file", "needs more memory than there is", "split the mesh");
    } catch (const std::exception&) {
      const std::string extension = lower_extension(name);
      fail("file",
           "cannot be read as " + extension.substr(std::min<std::size_t>(1, extension.size())),
           "export the mesh again");
    }
  } catch (const kernel::InputError& error) {
    throw kernel::InputError(one_line(error.with_file(name).what()));
  }
}

}  // namespace crest::io
