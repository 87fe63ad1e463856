// SPDX-License-Identifier: GPL-3.0-or-later
// Crest's rays and isosurfaces of volumes beside VTK's (flying edges, rays by a cell locator) and,
// if it was there when this was built, OpenVDB's (level set rays, volume to mesh), in one run on
// one thread: processor time, medians, the systems take turns. (<ctime>: programs that read clocks
// are optimised.)
#include <fmt/format.h>
#include <tbb/global_control.h>
#include <vtkFloatArray.h>
#include <vtkFlyingEdges3D.h>
#include <vtkGenericCell.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkStaticCellLocator.h>
#ifdef CREST_OPENVDB
#include <openvdb/openvdb.h>
#include <openvdb/tools/RayIntersector.h>
#include <openvdb/tools/VolumeToMesh.h>
#endif

#include <algorithm>
#include <ctime>
#include <map>

#include "algorithms/splines/isosurface.hpp"
#include "algorithms/splines/pinhole.hpp"
#include "experiments/001-splines/test_functions.hpp"
#include "experiments/processor_time.hpp"
#include "experiments/program.hpp"

namespace crest::experiments {
namespace {

constexpr double kLevel = 0.5;

/// One step of one system: processor seconds of each run, and what it made.
struct Row {
  std::vector<double> seconds;
  double items = 0, hits = 0;
};

/// Triangles, quadrangles, cubes or rays, and hits if any.
using Made = std::pair<std::size_t, std::size_t>;

class Comparison {
 public:
  Comparison(int nodes, int size)
      : nodes_(nodes),
        spline_(volume_of(marschner_lobb, nodes)),
        samples_(std::get<std::vector<float>>(spline_.grid().samples)) {
    rays_ = splines::automatic_view(spline_, size).rays();
    image_->SetDimensions(nodes, nodes, nodes);
    image_->SetOrigin(-1, -1, -1);
    const double h = 2.0 / (nodes - 1);
    image_->SetSpacing(h, h, h);
    vtkNew<vtkFloatArray> array;
    array->SetNumberOfTuples(static_cast<vtkIdType>(samples_.size()));
    std::copy(samples_.begin(), samples_.end(), array->GetPointer(0));
    image_->GetPointData()->SetScalars(array);
  }

  void run() {
    crest();
    vtk();
    openvdb();
  }
  void print() const {
    for (const auto& [name, row] : rows_) {
      std::vector<double> s = row.seconds;
      std::sort(s.begin(), s.end());
      const double median = s[s.size() / 2];
      fmt::print("| {}^3 | {} | {:.3f} s | {} | {:.3f} us | {} |\n", nodes_, name, median,
                 row.items, 1e6 * median / row.items,
                 row.hits == 0 ? "" : fmt::format("{:.2f} %", 100 * row.hits / row.items));
    }
  }

 private:
  template <class Work>
  void measure(const std::string& name, const Work& work) {
    const double start = processor_seconds();
    const auto [items, hits] = work();
    Row& row = rows_[name];
    row.seconds.push_back(processor_seconds() - start);
    row.items = static_cast<double>(items);
    row.hits = static_cast<double>(hits);
  }
  void crest() {
    std::optional<splines::RayCaster> caster;
    measure("1 Crest, hull of every cube", [&] {
      caster.emplace(spline_, kLevel);
      return Made{spline_.cube_count(), 0};
    });
    measure("2 Crest, rays, first hits proven", [&] {
      std::vector<splines::Hit> hits(rays_.size());
      const auto counts = caster->cast(rays_, hits);
      return Made{rays_.size(), counts.hits};
    });
    measure("3 Crest, mesh of proven topology, triangles", [&] {
      return Made{splines::extract_isosurface(spline_, kLevel, 30).triangles.size(), 0};
    });
  }
  void vtk() {
    vtkNew<vtkFlyingEdges3D> edges;
    measure("4 VTK, flying edges, triangles", [&] {
      edges->SetInputData(image_);
      edges->SetValue(0, kLevel);
      edges->Update();
      return Made{edges->GetOutput()->GetNumberOfPolys(), 0};
    });
    vtkNew<vtkStaticCellLocator> locator;
    measure("5 VTK, locator of its cells, triangles", [&] {
      locator->SetDataSet(edges->GetOutput());
      locator->BuildLocator();
      return Made{edges->GetOutput()->GetNumberOfPolys(), 0};
    });
    measure("6 VTK, rays by it, every 16th", [&] {
      std::size_t cast = 0, hits = 0;
      vtkNew<vtkGenericCell> cell;
      for (std::size_t i = 0; i < rays_.size(); i += 16, ++cast) {
        using kernel::operator*;
        using kernel::operator+;
        const Vec3 end = rays_[i].origin + 100.0 * rays_[i].direction;
        double t = 0, x[3], parametric[3];
        int part = 0;
        vtkIdType id = 0;
        hits += locator->IntersectWithLine(rays_[i].origin.data(), end.data(), 0, t, x, parametric,
                                           part, id, cell) != 0;
      }
      return Made{cast, hits};
    });
  }
#ifdef CREST_OPENVDB
  /// Nodes near the level, negative beyond it, as a level set whose voxel is 1.
  openvdb::FloatGrid::Ptr band() const {
    const auto grid = openvdb::FloatGrid::create(3);
    grid->setGridClass(openvdb::GRID_LEVEL_SET);
    grid->setTransform(openvdb::math::Transform::createLinearTransform(2.0 / (nodes_ - 1)));
    auto accessor = grid->getAccessor();
    const auto value = [&](int x, int y, int z) {
      const auto n = static_cast<std::size_t>(nodes_);
      return static_cast<float>(kLevel) -
             samples_[static_cast<std::size_t>(x) +
                      n * (static_cast<std::size_t>(y) + n * static_cast<std::size_t>(z))];
    };
    for (int z = 1; z + 1 < nodes_; ++z)
      for (int y = 1; y + 1 < nodes_; ++y)
        for (int x = 1; x + 1 < nodes_; ++x) {
          const float own = value(x, y, z);
          bool near = false;
          for (int k = 0; k < 27; ++k)
            near |= (value(x + k % 3 - 1, y + k / 3 % 3 - 1, z + k / 9 - 1) < 0) != (own < 0);
          if (near) accessor.setValue({x, y, z}, own);
        }
    return grid;
  }
  void openvdb() {
    openvdb::FloatGrid::Ptr grid;
    measure("7 OpenVDB, level set of a band, nodes", [&] {
      grid = band();
      return Made{samples_.size(), 0};
    });
    measure("8 OpenVDB, level set rays", [&] {
      const openvdb::tools::LevelSetRayIntersector<openvdb::FloatGrid> intersector(*grid);
      std::size_t hits = 0;
      for (const auto& ray : rays_) {
        const openvdb::Vec3R origin(ray.origin[0] + 1, ray.origin[1] + 1, ray.origin[2] + 1);
        openvdb::Vec3R direction(ray.direction[0], ray.direction[1], ray.direction[2]);
        direction.normalize();
        openvdb::Vec3R place;
        hits += intersector.intersectsWS(openvdb::math::Ray<double>(origin, direction), place);
      }
      return Made{rays_.size(), hits};
    });
    measure("9 OpenVDB, volume to mesh, quadrangles", [&] {
      std::vector<openvdb::Vec3s> points;
      std::vector<openvdb::Vec4I> quads;
      openvdb::tools::volumeToMesh(*grid, points, quads, 0.0);
      return Made{quads.size(), 0};
    });
  }
#else
  void openvdb() {}
#endif

  int nodes_;
  splines::QuadraticSpline spline_;
  const std::vector<float>& samples_;  ///< its own
  std::vector<splines::Ray> rays_;
  vtkNew<vtkImageData> image_;
  std::map<std::string, Row> rows_;
};

}  // namespace
}  // namespace crest::experiments

int main(int argc, char** argv) {
  using namespace crest::experiments;
  int size = 512, repeat = 3;
  std::vector<int> nodes = {41, 256};
  Program program("rays and isosurfaces of Marschner and Lobb's function beside peers");
  program.option("--size", size, "pixels along each side");
  program.option("--repeat", repeat, "runs, of which the median counts");
  program.list("--nodes", nodes, "samples along each axis (41 256)");
  return program.run(argc, argv, [&] {
    const tbb::global_control one(tbb::global_control::max_allowed_parallelism, 1);
#ifdef CREST_OPENVDB
    openvdb::initialize();
#else
    fmt::print("OpenVDB: was not found when this was built; skipped\n\n");
#endif
    fmt::print(
        "| samples | step | processor time | items | each | of the rays hit |\n"
        "|---|---|---|---|---|---|\n");
    for (const int n : nodes) {
      Comparison comparison(n, size);
      for (int i = 0; i < repeat; ++i) comparison.run();
      comparison.print();
    }
    return 0;
  });
}
