// SPDX-License-Identifier: GPL-3.0-or-later
// libFuzzer target of one format: any bytes give a soup with all its fields, and of it a mesh, or
// an InputError of one line.
#include <cstdint>
#include <cstdlib>
#include <string>

#include "io/formats/files.hpp"
#include "io/formats/readers.hpp"
#include "io/read/mesh_reader.hpp"
#include "kernel/geometry/input_error.hpp"

namespace {

template <class Read>
void run(const Read& read) {
  try {
    read();
  } catch (const crest::kernel::InputError& error) {
    const std::string line = error.what();
    if (line.find('\n') != std::string::npos || line.find("; ") == std::string::npos) abort();
  }
}

void require_sizes(const std::vector<crest::io::Field>& fields, std::size_t owners) {
  for (const crest::io::Field& field : fields)
    if (!field.missing.empty() && field.missing.size() != owners) abort();
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string bytes(reinterpret_cast<const char*>(data), size);
  run([&] {
    // VTK throws std::bad_alloc, which read_named turns into a message.
    crest::io::read_named("mesh." CREST_FUZZ_FORMAT, [&] {
      const crest::io::Soup soup =
          crest::io::soup_reader("." CREST_FUZZ_FORMAT)(bytes, {.wanted = true, .normals = true});
      require_sizes(soup.point_fields, soup.points.size());
      require_sizes(soup.cell_fields, soup.cells.size());
    });
  });
  run([&] {
    if (crest::io::read_mesh_bytes("mesh." CREST_FUZZ_FORMAT, bytes).mesh.face_count() == 0)
      abort();
  });
  return 0;
}
