// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/read/tensor_volume.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "io/formats/files.hpp"
#include "io/formats/text_scan.hpp"
#include "io/formats/volume.hpp"
#include "io/read/tensor_fields.hpp"

namespace crest::io {
namespace {

using kernel::Index;
using kernel::Vec3;

/// What the volume's reader leaves out: a header's field, empty if it is not there.
std::string_view header_value(std::string_view bytes, std::string_view key) {
  const std::string_view header =
      bytes.substr(0, std::min(bytes.find("\n\n"), bytes.find("\r\n\r\n")));
  for (std::size_t at = 0; at < header.size();) {
    const std::size_t end = std::min(header.find('\n', at), header.size());
    std::string_view line = header.substr(at, end - at);
    at = end + 1;
    if (!line.starts_with(key) || line.substr(key.size(), 1) != ":") continue;
    line.remove_prefix(key.size() + 1);
    return line.substr(0, line.find('\r'));
  }
  return {};
}

/// From sample to sample along the three axes in space.
std::array<Vec3, 3> steps_of(std::string_view bytes, const Volume& volume) {
  std::array<Vec3, 3> steps{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
  if (!header_value(bytes, "space directions").empty()) {
    std::copy(volume.steps.begin() + 1, volume.steps.end(), steps.begin());
    return steps;
  }
  TextScan scan(header_value(bytes, "spacings"));
  for (std::size_t i = 0; i < 4 && scan.in_line(); ++i) {
    double x = 0;
    if (!scan.take(x)) break;
    if (i > 0 && std::isfinite(x)) steps[i - 1][i - 1] = x;
  }
  return steps;
}

class Grid {
 public:
  Grid(std::string_view bytes, const TensorRequest& request)
      : volume_(read_nrrd(bytes, {})), request_(request), steps_(steps_of(bytes, volume_)) {
    const auto& size = volume_.size;
    if (size.size() != 4 || (size[0] != 6 && size[0] != 7 && size[0] != 9))
      fail("sizes", "are not those of a volume of tensors",
           "the first of four axes must have 6, 7 (mask first) or 9 numbers");
    for (std::size_t k = 0; k < 3; ++k) n_[k] = size[k + 1];
    if (*std::min_element(n_.begin(), n_.end()) < 2)
      fail("sizes", "have an axis of one sample", "give two samples along each axis at least");
    constexpr std::size_t most = 100'000'000;  // cubes: tetrahedra have 32-bit numbers
    if (n_[0] > most / n_[1] || n_[0] * n_[1] > most / n_[2])
      fail("sizes", "are too large for tetrahedra", "crop the volume");
    if (!request.field.empty() && request.field != "tensor")
      fail(fmt::format("array '{}'", request.field), "does not exist",
           "an NRRD file has one, 'tensor'");
  }

  TensorFile read() {
    TensorFile file;
    file.field = "tensor";
    read_tensors(file);
    std::vector<Vec3> points;
    for (std::size_t z = 0; z < n_[2]; ++z)
      for (std::size_t y = 0; y < n_[1]; ++y)
        for (std::size_t x = 0; x < n_[0]; ++x) {
          Vec3 p = volume_.origin;
          const std::array<std::size_t, 3> at = {x, y, z};
          for (std::size_t k = 0; k < 3; ++k)
            for (std::size_t c = 0; c < 3; ++c) p[c] += static_cast<double>(at[k]) * steps_[k][c];
          points.push_back(p);
        }
    file.mesh = kernel::TetMesh(std::move(points), tets(file));
    return file;
  }

 private:
  void read_tensors(TensorFile& file) {
    const std::size_t numbers = volume_.size[0], mask = numbers == 7 ? 1 : 0;
    const auto place = tensor_places(request_.order.empty() ? "xx xy xz yy yz zz" : request_.order);
    const std::size_t count = n_[0] * n_[1] * n_[2];
    std::size_t outside = 0;
    std::vector<double> sample(numbers);
    for (std::size_t v = 0; v < count; ++v) {
      std::visit(
          [&](const auto& x) {
            for (std::size_t k = 0; k < numbers; ++k)
              sample[k] = static_cast<double>(x[numbers * v + k]);
          },
          volume_.samples);
      const bool inside = mask == 0 || sample[0] > 0;
      outside += inside ? 0 : 1;
      if (!inside) {
        file.tensors.push_back({});
        continue;
      }
      for (const double x : sample)
        if (!std::isfinite(x))
          fail(fmt::format("sample {}, {}, {}", v % n_[0], v / n_[0] % n_[1], v / n_[0] / n_[1]),
               "is not finite", "repair the field");
      file.tensors.push_back(
          tensor_of({sample.data() + mask, numbers - mask}, place, file.max_asymmetry));
    }
    if (outside > 0)
      file.warnings.push_back(
          fmt::format("{} of {} samples are outside the mask: their tensor is 0", outside, count));
  }

  std::vector<kernel::TetMesh::Tet> tets(TensorFile& file) const {
    constexpr int orders[6][3] = {{0, 1, 2}, {1, 2, 0}, {2, 0, 1}, {0, 2, 1}, {1, 0, 2}, {2, 1, 0}};
    const std::array<std::size_t, 3> stride = {1, n_[0], n_[0] * n_[1]};
    std::vector<kernel::TetMesh::Tet> result;
    std::int64_t cube = 0;
    for (std::size_t z = 0; z + 1 < n_[2]; ++z)
      for (std::size_t y = 0; y + 1 < n_[1]; ++y)
        for (std::size_t x = 0; x + 1 < n_[0]; ++x, ++cube)
          for (std::size_t o = 0; o < 6; ++o) {
            std::size_t v = x + y * stride[1] + z * stride[2];
            kernel::TetMesh::Tet t{static_cast<Index>(v), 0, 0, 0};
            for (std::size_t k = 0; k < 3; ++k) {
              v += stride[static_cast<std::size_t>(orders[o][k])];
              t[k + 1] = static_cast<Index>(v);
            }
            if (o >= 3) std::swap(t[2], t[3]);  // of positive volume
            result.push_back(t);
            file.cell_of.push_back(cube);
          }
    return result;
  }

  Volume volume_;
  const TensorRequest& request_;
  std::array<Vec3, 3> steps_;
  std::array<std::size_t, 3> n_{};
};

}  // namespace

TensorFile read_tensor_volume(std::string_view bytes, const TensorRequest& request) {
  return Grid(bytes, request).read();
}

}  // namespace crest::io
