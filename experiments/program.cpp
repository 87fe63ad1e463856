// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/program.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <filesystem>
#include <iostream>

namespace crest::experiments {
namespace {

/// From the folder of all experiments on.
std::string name_of_program() {
  const std::string path = std::filesystem::read_symlink("/proc/self/exe").string();
  const std::size_t at = path.rfind("/experiments/");
  return at == std::string::npos ? path : path.substr(at + 1);
}

}  // namespace

Program::Program(const char* purpose) : app_(std::make_unique<CLI::App>(purpose)) {}
Program::~Program() = default;

template <class T>
void Program::option(const char* name, T& value, const char* help) {
  CLI::Option* option = app_->add_option(name, value, help);
  if (name[0] != '-') option->required();
}
template void Program::option(const char*, int&, const char*);
template void Program::option(const char*, unsigned&, const char*);
template void Program::option(const char*, std::size_t&, const char*);
template void Program::option(const char*, double&, const char*);
template void Program::option(const char*, std::string&, const char*);
template void Program::option(const char*, std::filesystem::path&, const char*);
template void Program::option(const char*, std::vector<double>&, const char*);
template void Program::option(const char*, std::vector<std::string>&, const char*);

template <class T>
void Program::option(const char* name, T& value, const char* help, Range range) {
  app_->add_option(name, value, help)->check(CLI::Range(range.least, range.most));
}
template void Program::option(const char*, int&, const char*, Range);
template void Program::option(const char*, unsigned&, const char*, Range);

void Program::option(const char* name, std::string& value, const char* help,
                     std::initializer_list<const char*> choices) {
  app_->add_option(name, value, help)
      ->check(CLI::IsMember(std::vector<std::string>(choices.begin(), choices.end())));
}

template <class T>
void Program::list(const char* name, T& values, const char* help) {
  app_->add_option(name, values, help)->delimiter(',');
}
template void Program::list(const char*, std::vector<int>&, const char*);
template void Program::list(const char*, std::vector<double>&, const char*);
template void Program::list(const char*, std::vector<std::string>&, const char*);

void Program::flag(const char* name, bool& value, const char* help) {
  app_->add_flag(name, value, help);
}

int Program::run(int argc, char** argv, const std::function<int()>& work) {
  CLI11_PARSE(*app_, argc, argv);
  fmt::print("Command: {}", name_of_program());
  for (int i = 1; i < argc; ++i) fmt::print(" {}", argv[i]);
  fmt::print("\n\n");
  try {
    return work();
  } catch (const std::exception& error) {
    std::cerr << error.what() << '\n';
    return 3;
  }
}

}  // namespace crest::experiments
