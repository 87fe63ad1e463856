// SPDX-License-Identifier: GPL-3.0-or-later
// libFuzzer target of one format: any bytes give a mesh or an InputError of one line.
#include <cstdint>
#include <cstdlib>
#include <string>

#include "io/read/mesh_reader.hpp"
#include "kernel/geometry/input_error.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string bytes(reinterpret_cast<const char*>(data), size);
  try {
    if (crest::io::read_mesh_bytes("mesh." CREST_FUZZ_FORMAT, bytes).mesh.face_count() == 0)
      abort();
  } catch (const crest::kernel::InputError& error) {
    const std::string line = error.what();
    if (line.find('\n') != std::string::npos || line.find("; ") == std::string::npos) abort();
  }
  return 0;
}
