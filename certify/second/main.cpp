// SPDX-License-Identifier: GPL-3.0-or-later
// crest-recheck FILE: exit code 0 the claim is proven, 1 it is not, 2 usage, 3 the file cannot be
// read.
#include <fstream>
#include <iostream>
#include <iterator>
#include <new>

#include "certify/second/check.hpp"

int main(int argc, char** argv) {
  using namespace crest::recheck;
  const std::string argument = argc == 2 ? argv[1] : "";
  if (argument == "--help") {
    std::cout << "usage: crest-recheck FILE\nA second checker of claim 4 "
                 "(certify/ridges_smooth/SPEC.md, version "
                 "2), independent of crest-verify.\n";
    return 0;
  }
  if (argument.empty() || argument[0] == '-') {
    std::cerr << "usage: crest-recheck FILE\n";
    return 2;
  }
  std::ifstream in(argument, std::ios::binary);
  const std::string text((std::istreambuf_iterator<char>(in)), std::istreambuf_iterator<char>());
  if (!in.is_open() || in.bad()) {
    std::cerr << argument << ": cannot be read\n";
    return 3;
  }
  try {
    const std::string claim = recheck(Bytes(text.begin(), text.end()));
    std::cout << "ACCEPTED\n" << claim;
  } catch (const Rejected& why) {
    std::cout << "REJECTED: " << why.what() << "\n";
    return 1;
  } catch (const std::bad_alloc&) {
    std::cout << "REJECTED: it asks for more memory than there is\n";
    return 1;
  }
  return std::cout.flush() ? 0 : 3;
}
