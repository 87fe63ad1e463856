// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/line_art/drawing_writer.hpp"

#include "io/formats/files.hpp"
#include "io/write/atomic_file.hpp"
#include "kernel/geometry/input_error.hpp"

namespace crest::io {

void write_drawing(const std::string& path, const line_art::Drawing& drawing) {
  const std::string extension = lower_extension(path);
  if (extension == ".svg") return write_atomically(path, svg_of(drawing));
  if (extension == ".pdf") return write_atomically(path, pdf_of(drawing));
  if (extension == ".eps") return write_atomically(path, eps_of(drawing));
  if (extension == ".vtp") return write_atomically(path, vtp_of(drawing));
  throw kernel::InputError(path +
                           ": file: has an unknown extension; write .svg, .pdf, .eps or .vtp");
}

}  // namespace crest::io
