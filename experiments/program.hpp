// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The command line of an experiment. The parser stays in program.cpp: its header costs more to
// compile than most experiments.
#include <functional>
#include <initializer_list>
#include <memory>
#include <string>

namespace CLI {
class App;
}

namespace crest::experiments {

/// Inclusive.
struct Range {
  int least, most;
};

/// Options keep what they hold when they are not given; a name without dashes is required.
class Program {
 public:
  explicit Program(const char* purpose);
  ~Program();

  /// T: int, unsigned, std::size_t, double, std::string, std::filesystem::path, or a vector of int,
  /// double, std::string: then the option takes all values that follow it.
  template <class T>
  void option(const char* name, T& value, const char* help);
  /// T: int, unsigned.
  template <class T>
  void option(const char* name, T& value, const char* help, Range range);
  void option(const char* name, std::string& value, const char* help,
              std::initializer_list<const char*> choices);
  /// T: a vector; commas too separate its values.
  template <class T>
  void list(const char* name, T& values, const char* help);
  void flag(const char* name, bool& value, const char* help);

  /// Prints the command as the first line ("Command: experiments/003-reeb/growth"), then works.
  /// Returns what work returns; 3 if it throws; the parser's code for bad arguments and --help.
  int run(int argc, char** argv, const std::function<int()>& work);

 private:
  std::unique_ptr<CLI::App> app_;
};

}  // namespace crest::experiments
