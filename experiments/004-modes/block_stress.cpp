// SPDX-License-Identifier: GPL-3.0-or-later
// The four blocks of paper 004, section 7 and appendix B: stress of a block under compression, push
// and pull, three compressions, a twisting compression, as VTU with a 6-component point array.
#include <fmt/format.h>

#include <chrono>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "experiments/004-modes/blocks.hpp"
#include "experiments/program.hpp"

namespace crest::experiments {
namespace {

/// Raw appended data: header, then arrays with their length in bytes.
class VtuWriter {
 public:
  template <class T>
  std::string add(const std::string& name, const char* type, int components,
                  const std::vector<T>& x) {
    const std::uint64_t bytes = x.size() * sizeof(T), offset = data_.size();
    data_.append(reinterpret_cast<const char*>(&bytes), 8);
    data_.append(reinterpret_cast<const char*>(x.data()), bytes);
    return fmt::format(
        "<DataArray type=\"{}\" Name=\"{}\" NumberOfComponents=\"{}\" format=\"appended\" "
        "offset=\"{}\"/>\n",
        type, name, components, offset);
  }
  const std::string& data() const { return data_; }

 private:
  std::string data_;
};

void write(const std::filesystem::path& path, const ElasticBlock& block,
           const std::vector<std::array<double, 6>>& stress) {
  const auto tets = block.tets();
  const auto& n = block.size();
  std::vector<std::array<double, 3>> points;
  for (int k = 0; k <= n[2]; ++k)
    for (int j = 0; j <= n[1]; ++j)
      for (int i = 0; i <= n[0]; ++i)
        points.push_back({static_cast<double>(i), static_cast<double>(j), static_cast<double>(k)});
  std::vector<std::int64_t> corners, offsets;
  for (const auto& t : tets) {
    corners.insert(corners.end(), t.begin(), t.end());
    offsets.push_back(static_cast<std::int64_t>(corners.size()));
  }
  const std::vector<std::uint8_t> types(tets.size(), 10);
  VtuWriter writer;
  std::ofstream out(path, std::ios::binary);
  out << "<?xml version=\"1.0\"?>\n<VTKFile type=\"UnstructuredGrid\" version=\"1.0\" "
         "byte_order=\"LittleEndian\" header_type=\"UInt64\">\n<UnstructuredGrid>\n"
      << fmt::format("<Piece NumberOfPoints=\"{}\" NumberOfCells=\"{}\">\n", points.size(),
                     tets.size())
      << "<PointData Tensors=\"stress\">\n"
      << writer.add("stress", "Float64", 6, stress) << "</PointData>\n<Points>\n"
      << writer.add("points", "Float64", 3, points) << "</Points>\n<Cells>\n"
      << writer.add("connectivity", "Int64", 1, corners)
      << writer.add("offsets", "Int64", 1, offsets) << writer.add("types", "UInt8", 1, types)
      << "</Cells>\n</Piece>\n</UnstructuredGrid>\n<AppendedData encoding=\"raw\">\n_"
      << writer.data() << "\n</AppendedData>\n</VTKFile>\n";
}

void run(const std::filesystem::path& folder, const std::string& only, bool mirror) {
  fmt::print(
      "| block | hexahedra | tets | iterations | seconds | file |\n|---|---|---|---|---|---|\n");
  for (const Scenario& s : scenarios()) {
    if (!only.empty() && only != s.name) continue;
    const auto start = std::chrono::steady_clock::now();
    const auto [block, stress, steps] = loaded(s, mirror);
    const std::chrono::duration<double> time = std::chrono::steady_clock::now() - start;
    const auto path = folder / (s.name + ".vtu");
    write(path, block, stress);
    const int hexahedra = s.cubes[0] * s.cubes[1] * s.cubes[2];
    fmt::print("| {} | {} | {} | {} | {:.1f} | {} |\n", s.name, hexahedra, 6 * hexahedra, steps,
               time.count(), path.filename().string());
  }
}

}  // namespace
}  // namespace crest::experiments

int main(int argc, char** argv) {
  std::filesystem::path folder = ".";
  std::string only;
  bool mirror = false;
  crest::experiments::Program program("Stress of the four blocks as VTU.");
  program.option("--output", folder, "folder of the files");
  program.option("--only", only, "one block: single, push_pull, three, twist");
  program.flag("--mirror", mirror, "make the symmetries of the loads exact (not of twist)");
  return program.run(argc, argv, [&] {
    crest::experiments::run(folder, only, mirror);
    return 0;
  });
}
