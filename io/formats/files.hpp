// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Files' names and bytes, and what is said when something is wrong with them.
#include <functional>
#include <memory>
#include <string>
#include <string_view>

namespace crest::io {

/// File names and words quoted from files may hold anything; this is one line of UTF-8 that no
/// terminal obeys: `instead` of control characters and of bytes that are no characters.
std::string one_line(std::string text, char instead = '?');

/// Throws kernel::InputError "ELEMENT: PROBLEM; REMEDY", one line; read_named puts the file's name
/// in front.
[[noreturn]] void fail(const std::string& element, const std::string& problem,
                       const std::string& remedy);

/// The extension in lower case, with its dot.
std::string lower_extension(const std::string& path);

/// Bytes in memory of their own, in pages so large that a long file needs few of them: to get pages
/// costs more than to read into them.
class FileBytes {
 public:
  explicit FileBytes(std::size_t size);
  char* data() { return bytes_.get(); }
  operator std::string_view() const { return {bytes_.get(), size_}; }

 private:
  struct Free {
    void operator()(char* bytes) const;
  };
  std::unique_ptr<char, Free> bytes_;
  std::size_t size_;
};

/// The bytes of a regular file.
FileBytes load(const std::string& path);

/// Runs `read`; whatever it throws becomes an InputError of one line with the file's name in front.
void read_named(const std::string& name, const std::function<void()>& read);

}  // namespace crest::io
