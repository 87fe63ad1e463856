// SPDX-License-Identifier: GPL-3.0-or-later
// Ridge surfaces of the shared volumes: regular share, odd faces, what is not decided; pictures.
#include <fmt/format.h>
#include <tbb/global_control.h>

#include <algorithm>
#include <chrono>
#include <filesystem>

#include "certify/extremal/encode.hpp"
#include "certify/verify.hpp"
#include "experiments/000-extremal/inputs.hpp"
#include "experiments/program.hpp"
#include "io/extremal/extremal_picture.hpp"
#include "io/read/volume_reader.hpp"

namespace crest::experiments {
namespace {

struct DataSet {
  const char* file;
  double sigma, tensor_sigma, min_value;
};

/// Thresholds are about the brightness of the structures shown.
constexpr DataSet kData[] = {{"EMD-3001.map", 1, 2, 0.1},
                             {"neghip.nrrd", 1, 1, 60},
                             {"hydrogen_64.vti", 1, 1, 0.01},
                             {"HeadMRVolume.mhd", 1, 1, 40},
                             {"bolt.nrrd", 1, 1, 100},
                             {"stent_ct.nrrd", 1, 1, 800},
                             {"isabel_windspeed_30.nrrd", 1, 1, 30},
                             {"iguana_ct.nii.gz", 1, 1, 60},
                             {"mri_head_256.nrrd", 1, 1, 60}};

double seconds_since(std::chrono::steady_clock::time_point start) {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

std::string place_of(const std::filesystem::path& folder, const std::string& file) {
  for (const auto& path : {folder / file, folder / "unpacked" / file})
    if (std::filesystem::exists(path)) return path.string();
  return {};
}

void row(const DataSet& data, bool hessian, const std::string& path, const std::string& pictures,
         bool certify) {
  auto file = io::read_volume(path);
  auto options = ridge_options(hessian, data.min_value);
  options.sigma = data.sigma;
  options.tensor_sigma = data.tensor_sigma;
  const extremal::Volume volume = volume_of(file.grid);
  certify::ExtremalCertificate certificate;
  const auto start = std::chrono::steady_clock::now();
  auto r = extremal::extract(volume, options, certify ? &certificate : nullptr);
  const double time = seconds_since(start);
  std::size_t bytes = 0;
  double checking = 0;
  std::string verdict = "-";
  if (certify) {
    const auto encoded = certify::encode(certificate);
    bytes = encoded.size();
    const auto before = std::chrono::steady_clock::now();
    const certify::Verdict checked = certify::verify(encoded);
    verdict = checked.accepted ? "accepted" : "REJECTED: " + checked.reason;
    checking = seconds_since(before);
  }
  const auto& c = r.counts;
  std::int64_t euler = 0;
  std::size_t loops = 0, one_sided = 0, isotopic = 0;
  for (const auto& k : r.components) {
    euler += k.euler_characteristic;
    loops += k.boundary_loops;
    one_sided += k.orientable ? 0 : 1;
    isotopic += k.isotopic.value_or(false) ? 1 : 0;
  }
  const std::size_t cells = std::max<std::size_t>(1, c.empty + c.regular + c.cone + c.open);
  fmt::print(
      "| {} | {} | {} | {} | {} | {} | {} | {} | {} | {} | {} | {} | {} | {} | {} | {} | {} | "
      "{:.1f} | "
      "{:.3f} | "
      "{:.2f} | {:.1f} | {} | {:.2f} |\n",
      data.file, hessian ? "hessian" : "structure", data.sigma, data.tensor_sigma, data.min_value,
      r.polygons(), r.components.size(), one_sided, isotopic, euler, loops, c.odd_faces,
      c.valence[0], c.valence[2], c.odd_valence_unexplained, c.undecided_edges, c.undecided_types,
      100.0 * static_cast<double>(c.empty + c.regular) / static_cast<double>(cells),
      static_cast<double>(c.cone_tests) / static_cast<double>(std::max<std::size_t>(1, c.edges)),
      time, static_cast<double>(bytes) / 1e6, verdict, checking);
  std::fflush(stdout);
  if (pictures.empty() || hessian || r.polygons() == 0) return;
  for (auto& p : r.points) p = file.grid.to_world(p);
  for (auto& n : r.normals) n = file.grid.direction_to_world(n);
  const std::string name = std::string(data.file).substr(0, std::string(data.file).find('.'));
  io::write_extremal_picture((std::filesystem::path(pictures) / (name + ".png")).string(), r);
}

}  // namespace
}  // namespace crest::experiments

int main(int argc, char** argv) {
  using namespace crest;
  std::string folder = "../shared/data/volumes", pictures, only;
  int threads = 2;
  bool certify = false, hessian = false;
  experiments::Program program("Ridge surfaces of the shared volumes.");
  program.option("--data", folder,
                 "the volumes; those packed by xz unpacked beside them or in DATA/unpacked");
  program.option("--pictures", pictures, "a folder for pictures");
  program.option("--only", only, "one file");
  program.option("--threads", threads, "threads", {1, 64});
  program.flag("--certify", certify, "certificate and checker, too");
  program.flag("--hessian", hessian, "by the Hessian, too");
  return program.run(argc, argv, [&] {
    const tbb::global_control limit(tbb::global_control::max_allowed_parallelism,
                                    static_cast<std::size_t>(threads));
    fmt::print(
        "{} threads. Proven: cells empty or regular, of those tested; seconds of the "
        "extraction{}\n\n"
        "| data | definition | sigma | tensor-sigma | min-value | polygons | components | "
        "one-sided | isotopic | "
        "chi | loops | odd "
        "faces | valence 1 | valence 3 | unexplained | undecided edges | undecided types | proven, "
        "% | tests an edge | "
        "seconds | certificate, MB | checker | its seconds |\n"
        "|---|---|---|---|---|---|---|---|---|---|---|---|---|---|---|---|---|---|---|---|---|---|"
        "---|\n",
        threads, certify ? " with the certificate" : "");
    for (const auto& data : experiments::kData) {
      if (!only.empty() && only != data.file) continue;
      const std::string path = experiments::place_of(folder, data.file);
      if (path.empty()) {
        fmt::print("| {} | is not there |\n", data.file);
        continue;
      }
      experiments::row(data, false, path, pictures, certify);
      if (hessian) experiments::row(data, true, path, pictures, certify);
    }
    return 0;
  });
}
