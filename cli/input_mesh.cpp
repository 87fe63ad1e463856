// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/input_mesh.hpp"

#include <fcntl.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <charconv>
#include <filesystem>
#include <fstream>
#include <iterator>

namespace crest::cli {
namespace {

namespace fs = std::filesystem;

/// Gone with all that is in it at the end.
class TemporaryFolder {
 public:
  TemporaryFolder() : path_((fs::temp_directory_path() / "crest-verify-XXXXXX").string()) {
    if (!mkdtemp(path_.data())) throw std::runtime_error("cannot make a folder " + path_);
  }
  ~TemporaryFolder() {
    std::error_code ignored;
    fs::remove_all(path_, ignored);
  }
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;
  std::string operator/(const char* name) const { return path_ + "/" + name; }

 private:
  std::string path_;
};

/// The exit code, or -1 if there is no such program.
int run(std::vector<std::string> words) {
  std::vector<char*> pointers;
  for (std::string& word : words) pointers.push_back(word.data());
  pointers.push_back(nullptr);
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_addopen(&actions, STDOUT_FILENO, "/dev/null", O_WRONLY, 0);
  pid_t child = 0;
  const int failed = posix_spawnp(&child, pointers[0], &actions, nullptr, pointers.data(), environ);
  posix_spawn_file_actions_destroy(&actions);
  int status = 0;
  if (failed != 0 || waitpid(child, &status, 0) != child || !WIFEXITED(status)) return -1;
  return WEXITSTATUS(status) == 127 ? -1 : WEXITSTATUS(status);
}

/// Numbers of a text that `crest` wrote, one after the other.
class Numbers {
 public:
  explicit Numbers(const std::string& path) {
    std::ifstream in(path, std::ios::binary);
    text_.assign(std::istreambuf_iterator<char>(in), {});
    at_ = text_.data();
    if (text_.starts_with("OFF\n")) at_ += 4;
  }
  template <class Number>
  Number next() {
    const char* const end = text_.data() + text_.size();
    while (at_ != end && (*at_ == ' ' || *at_ == '\n')) ++at_;
    Number x{};
    const auto [after, error] = std::from_chars(at_, end, x);
    if (error != std::errc()) throw InputUnreadable("crest clean has written no mesh");
    at_ = after;
    return x;
  }

 private:
  std::string text_;
  const char* at_;
};

}  // namespace

namespace {

/// From the folder of this program, else from those of PATH.
std::string crest_program() {
  std::error_code none;
  const fs::path beside = fs::read_symlink("/proc/self/exe", none).parent_path() / "crest";
  return fs::exists(beside, none) ? beside.string() : "crest";
}

void require_there(int code) {
  if (code == -1)
    throw InputUnreadable("--input needs the program crest, which is not there; install it");
}

}  // namespace

certify::InputMesh input_mesh(const std::string& file, const std::vector<std::string>& arguments) {
  const TemporaryFolder folder;
  const std::string mesh_file = folder / "mesh.off";
  std::vector<std::string> words = {crest_program(), "clean"};
  words.insert(words.end(), arguments.begin(), arguments.end());
  words.insert(words.end(), {"-o", mesh_file, "--", file});
  const int code = run(words);
  require_there(code);
  if (code != 0) throw InputUnreadable("");
  Numbers numbers(mesh_file);
  certify::InputMesh mesh{file, {}, {}};
  mesh.positions.resize(numbers.next<std::size_t>());
  mesh.faces.resize(numbers.next<std::size_t>());
  numbers.next<std::size_t>();
  for (auto& position : mesh.positions)
    for (double& x : position) x = numbers.next<double>() + 0.0;  // certificates hold no -0
  for (auto& face : mesh.faces) {
    numbers.next<std::size_t>();
    for (std::uint32_t& v : face) v = numbers.next<std::uint32_t>();
  }
  return mesh;
}

namespace {

/// Of the data section of the certificate that a command makes of a file.
certify::Digest digest_by(std::vector<std::string> words, const std::string& file,
                          const std::vector<std::string>& arguments) {
  const TemporaryFolder folder;
  const std::string certificate = folder / "field.crest";
  words.insert(words.begin(), crest_program());
  words.insert(words.end(), arguments.begin(), arguments.end());
  words.insert(words.end(), {"--quiet", "--certificate", certificate, "--", file});
  require_there(run(words));
  // Special places or undecided lines are no failure here: there is a certificate, of the same
  // field.
  if (!fs::exists(certificate)) throw InputUnreadable("");
  return certify::data_digest(certify::read_file(certificate));
}

}  // namespace

certify::Digest input_tensors(const std::string& file, const std::vector<std::string>& arguments) {
  return digest_by({"modes", "--degenerate"}, file, arguments);
}

certify::Digest input_vectors(const std::string& file, const std::vector<std::string>& arguments) {
  return digest_by({"skeleton"}, file, arguments);
}

}  // namespace crest::cli
