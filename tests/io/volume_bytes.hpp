// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Files of one volume, 4 x 5 x 6 samples x + 10 y + 100 z - 50, made by hand in each format.
#include <zlib.h>

#include <string>

#include "tests/io/bytes.hpp"

namespace crest::tests {

inline double volume_value(std::size_t x, std::size_t y, std::size_t z) {
  return static_cast<double>(x + 10 * y + 100 * z) - 50;
}

template <class T>
std::string volume_samples(bool big_endian = false) {
  std::string bytes;
  for (std::size_t z = 0; z < 6; ++z)
    for (std::size_t y = 0; y < 5; ++y)
      for (std::size_t x = 0; x < 4; ++x)
        put(bytes, static_cast<T>(volume_value(x, y, z)), big_endian);
  return bytes;
}

inline std::string volume_words() {
  std::string text;
  for (std::size_t z = 0; z < 6; ++z)
    for (std::size_t y = 0; y < 5; ++y)
      for (std::size_t x = 0; x < 4; ++x)
        text += std::to_string(static_cast<int>(volume_value(x, y, z))) + (x == 3 ? "\n" : " ");
  return text;
}

/// `changes`: lines that replace those of 4 x 5 x 6 samples "signed fixed".
inline std::string inrimage(const std::string& changes, const std::string& samples) {
  std::string header =
      "#INRIMAGE-4#{\nXDIM=4\nYDIM=5\nZDIM=6\nVDIM=1\nTYPE=signed fixed\nPIXSIZE=16 bits\n"
      "CPU=decm\nVX=2\nVY=3\nVZ=4\n" +
      changes;
  header.resize(252, '\n');
  return header + "##}\n" + samples;
}

/// A Gaussian cube file of 4 x 5 x 6 samples, the last axis the fastest; `before`: samples.
inline std::string cube(const std::string& atoms, const std::string& behind_header,
                        const std::string& before) {
  std::string text =
      "title\nloop\n" + atoms + " 1 2 3\n4 2 0 0\n5 0 3 0\n6 0 0 4\n" + behind_header + before;
  for (std::size_t x = 0; x < 4; ++x)
    for (std::size_t y = 0; y < 5; ++y) {
      for (std::size_t z = 0; z < 6; ++z)
        text += std::to_string(static_cast<int>(volume_value(x, y, z))) + ".0E0 ";
      text += "\n";
    }
  return text;
}

/// `header`: 31: gzip's, 15: zlib's.
inline std::string deflated(const std::string& bytes, int header) {
  z_stream z{};
  deflateInit2(&z, 6, Z_DEFLATED, header, 8, Z_DEFAULT_STRATEGY);
  std::string result(bytes.size() + 1000, '\0');
  z.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(bytes.data()));
  z.avail_in = static_cast<uInt>(bytes.size());
  z.next_out = reinterpret_cast<Bytef*>(result.data());
  z.avail_out = static_cast<uInt>(result.size());
  deflate(&z, Z_FINISH);
  result.resize(z.total_out);
  deflateEnd(&z);
  return result;
}

inline std::string nrrd(const std::string& type, const std::string& more,
                        const std::string& samples, const std::string& sizes = "4 5 6") {
  return "NRRD0004\n# a comment\ntype: " + type + "\ndimension: 3\nsizes: " + sizes + "\n" + more +
         "\n\n" + samples;
}

inline std::string meta_image(const std::string& type, const std::string& more,
                              const std::string& samples) {
  return "ObjectType = Image\nNDims = 3\nDimSize = 4 5 6\n" + more + "ElementType = " + type +
         "\nElementDataFile = LOCAL\n" + samples;
}

/// A NIfTI-1 header; the numbers that tests change have names.
struct Nifti {
  bool big_endian = false;
  std::int16_t dimension[8] = {3, 4, 5, 6, 1, 1, 1, 1};
  std::int16_t type = 4, qform = 0, sform = 0;
  float spacing[8] = {1, 2, 3, 4, 0, 0, 0, 0};
  float offset = 352, slope = 0, intercept = 0;
  float quaternion[6] = {};
  float rows[12] = {};
  std::string magic = std::string("n+1\0", 4);

  std::string bytes(const std::string& samples) const {
    std::string b;
    put(b, std::int32_t{348}, big_endian);
    b.resize(40, '\0');
    for (const auto x : dimension) put(b, x, big_endian);
    b.resize(70, '\0');
    put(b, type, big_endian);
    b.resize(76, '\0');
    for (const auto x : spacing) put(b, x, big_endian);
    for (const auto x : {offset, slope, intercept}) put(b, x, big_endian);
    b.resize(252, '\0');
    put(b, qform, big_endian);
    put(b, sform, big_endian);
    for (const auto x : quaternion) put(b, x, big_endian);
    for (const auto x : rows) put(b, x, big_endian);
    b.resize(344, '\0');
    b += magic;
    b.resize(352, '\0');
    return b + samples;
  }
};

/// An MRC header.
struct Mrc {
  bool big_endian = false;
  std::int32_t size[3] = {4, 5, 6}, mode = 1, start[3] = {0, 0, 0}, intervals[3] = {4, 5, 6};
  float cell[3] = {8, 15, 24}, angles[3] = {90, 90, 90};
  std::int32_t axes[3] = {1, 2, 3}, extended = 0;
  float origin[3] = {0, 0, 0};

  std::string bytes(const std::string& samples) const {
    std::string b;
    for (const auto x : size) put(b, x, big_endian);
    put(b, mode, big_endian);
    for (const auto x : start) put(b, x, big_endian);
    for (const auto x : intervals) put(b, x, big_endian);
    for (const auto x : cell) put(b, x, big_endian);
    for (const auto x : angles) put(b, x, big_endian);
    for (const auto x : axes) put(b, x, big_endian);
    b.resize(92, '\0');
    put(b, extended, big_endian);
    b.resize(196, '\0');
    for (const auto x : origin) put(b, x, big_endian);
    b += "MAP ";
    b.resize(1024, '\0');
    return b + samples;
  }
};

inline std::string structured_points(const std::string& kind, const std::string& array,
                                     const std::string& samples) {
  return "# vtk DataFile Version 3.0\nt\n" + kind +
         "\nDATASET STRUCTURED_POINTS\nDIMENSIONS 4 5 6\nORIGIN 1 2 3\nSPACING 2 3 4\nPOINT_DATA "
         "120\n" +
         array + samples;
}

inline std::string vti(const std::string& type, const std::string& words,
                       const std::string& more = "") {
  return "<VTKFile type=\"ImageData\" version=\"0.1\" byte_order=\"LittleEndian\">\n"
         "<ImageData WholeExtent=\"0 3 0 4 0 5\" Origin=\"1 2 3\" Spacing=\"2 3 4\">\n"
         "<Piece Extent=\"0 3 0 4 0 5\"><PointData>" +
         more + "<DataArray type=\"" + type + "\" Name=\"a\" format=\"ascii\">\n" + words +
         "</DataArray></PointData></Piece></ImageData></VTKFile>\n";
}

}  // namespace crest::tests
