// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/read/volume_boxes.hpp"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>

#include "io/formats/plain_samples.hpp"
#include "io/read/volume_frame.hpp"

namespace crest::io {
namespace {

using kernel::GridBox;
using Samples = kernel::SampledGrid::Samples;

/// Open for reading at places.
class PlacedFile {
 public:
  explicit PlacedFile(const std::string& path) : file_(open(path.c_str(), O_RDONLY | O_CLOEXEC)) {
    if (file_ < 0) fail("file", "cannot be read", "check the path and its permissions");
  }
  ~PlacedFile() { close(file_); }
  PlacedFile(const PlacedFile&) = delete;
  PlacedFile& operator=(const PlacedFile&) = delete;

  std::size_t size() const {
    struct stat about {};
    if (fstat(file_, &about) != 0 || !S_ISREG(about.st_mode))
      fail("file", "is not a regular file", "give the path of a volume");
    return static_cast<std::size_t>(about.st_size);
  }
  void read(char* to, std::size_t count, std::size_t at) const {
    while (count > 0) {
      const ssize_t got = pread(file_, to, count, static_cast<off_t>(at));
      if (got <= 0) fail("samples", "cannot be read", "check the file and the disk");
      to += got;
      at += static_cast<std::size_t>(got);
      count -= static_cast<std::size_t>(got);
    }
  }

 private:
  int file_;
};

/// What comes before the samples is short.
constexpr std::size_t kLongestHeader = 1 << 16;

std::optional<PlainSamples> plain_samples(const std::string& path, const VolumeSource& source) {
  if (!source.raw.empty()) return plain_raw(source.raw);
  if (lower_extension(path) != ".nrrd") return {};
  const PlacedFile file(path);
  std::string head(std::min(file.size(), kLongestHeader), ' ');
  file.read(head.data(), head.size(), 0);
  return plain_nrrd(head);
}

/// The box's rows, in the grid's order.
template <class Use>
void for_each_row(const std::array<std::size_t, 3>& size, const GridBox& box, const Use& use) {
  std::size_t to = 0;
  for (std::size_t z = box.low[2]; z < box.high[2]; ++z)
    for (std::size_t y = box.low[1]; y < box.high[1]; ++y, to += box.size()[0])
      use(to, (z * size[1] + y) * size[0] + box.low[0]);
}

Samples empty_samples(NumberType type) {
  return with_type(type, [](auto zero) -> Samples { return std::vector<decltype(zero)>(); });
}

}  // namespace

VolumeBoxes::VolumeBoxes(const std::string& path, const VolumeSource& source) : path_(path) {
  std::optional<PlainSamples> plain;
  read_named(path, [&] {
    plain = plain_samples(path, source);
    if (!plain) return;
    check_length(*plain, PlacedFile(path).size());
    offset_ = plain->offset;
    big_endian_ = plain->big_endian;
    frame_ = frame_of(plain->volume);
    frame_.grid.samples = empty_samples(plain->type);
  });
  if (plain) return;
  read_named(path, [&] {
    if (source.raw.empty() && lower_extension(path) == ".pvti") open_pieces(source);
  });
  if (pieces_) return;
  frame_ = read_volume(path, source);
  whole_ = std::move(frame_.grid);
  frame_.grid = {whole_->size, whole_->spacing, whole_->origin, whole_->directions};
  frame_.grid.samples = std::visit(
      [](const auto& x) -> Samples { return std::decay_t<decltype(x)>(); }, whole_->samples);
}

void VolumeBoxes::open_pieces(const VolumeSource& source) {
  ImagePieces pieces(load(path_), {.field = source.field, .companion = companions_of(path_)});
  const std::vector<std::size_t>& size = pieces.frame().size;
  if (std::count(size.begin(), size.end(), 1) > 0) return;  // boxes have three axes
  frame_ = frame_of(pieces.frame());
  frame_.grid.samples = pieces.frame().samples;
  pieces_ = std::move(pieces);
}

Samples VolumeBoxes::read(const GridBox& box) const {
  Samples r = frame_.grid.samples;
  read_named(path_, [&] {
    if (pieces_) {
      r = pieces_->read(box);
      check_samples(r, frame_.grid.dimension(), box);
      return;
    }
    std::visit(
        [&](auto& samples) {
          using Native = typename std::decay_t<decltype(samples)>::value_type;
          const std::size_t width = box.size()[0];
          samples.resize(box.nodes());
          if (whole_) {
            const auto& from = std::get<std::vector<Native>>(whole_->samples);
            for_each_row(whole_->size, box, [&](std::size_t to, std::size_t at) {
              std::copy_n(from.data() + at, width, samples.data() + to);
            });
            return;
          }
          const PlacedFile file(path_);
          for_each_row(frame_.grid.size, box, [&](std::size_t to, std::size_t at) {
            file.read(reinterpret_cast<char*>(samples.data() + to), width * sizeof(Native),
                      offset_ + at * sizeof(Native));
          });
          if (sizeof(Native) > 1 && big_endian_)
            for (Native& x : samples)
              x = load_number<Native>(reinterpret_cast<const char*>(&x), true);
        },
        r);
    if (!whole_) check_samples(r, frame_.grid.dimension(), box);
  });
  return r;
}

}  // namespace crest::io
