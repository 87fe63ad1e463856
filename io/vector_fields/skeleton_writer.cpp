// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/vector_fields/skeleton_writer.hpp"

#include "io/formats/files.hpp"
#include "io/write/formats.hpp"
#include "io/write/poly_data.hpp"
#include "kernel/geometry/input_error.hpp"

namespace crest::io {
namespace {

using namespace vector_fields;

enum Type { kCritical, kSwitch, kSeparatrix, kOrbit };

void add_row(Columns& row, Type type, int kind, int index, int end, int target, int bits) {
  row.add("type", static_cast<int>(type));
  row.add("kind", kind);
  row.add("index", index);
  row.add("end", end);
  row.add("target", target);
  row.add("bits", bits);
}

PolyData::Id add(PolyData& data, const Vec2& p) {
  return data.add_point({p[0], p[1], 0});
}

void add_line(PolyData& data, const std::vector<Vec2>& line, bool closed, Columns*& row) {
  std::vector<PolyData::Id> ids;
  for (const Vec2& p : line) ids.push_back(add(data, p));
  if (closed) ids.push_back(ids.front());
  row = &data.add_line(ids);
}

void check_extension(const std::string& path) {
  if (lower_extension(path) != ".vtp")
    throw kernel::InputError(path + ": file: has an unknown extension; write .vtp");
}

}  // namespace

void write_paths(const std::string& path, const Skeleton& skeleton, const Importance& importance) {
  check_extension(path);
  PolyData data;
  for (Index z = 0; z < importance.zeros.size(); ++z) {
    const ZeroWeight& w = importance.zeros[z];
    const bool paired = w.end == PathEnd::partner;
    if (w.path.empty() || (paired && w.partner < z)) continue;
    std::vector<PolyData::Id> ids = {add(data, skeleton.critical_points[z].point)};
    for (const PathPoint& p : w.path)
      ids.push_back(data.add_point({p.point[0], p.point[1], p.time}));
    if (paired) ids.push_back(add(data, skeleton.critical_points[w.partner].point));
    Columns& row = data.add_line(ids);
    row.add("zero", static_cast<int>(z));
    row.add("partner", paired ? static_cast<int>(w.partner) : -1);
    row.add("first", w.first);
    row.add("weight", w.weight);
  }
  write_vtp(path, *data.data());
}

vtkSmartPointer<vtkPolyData> skeleton_poly_data(const SkeletonScene& scene) {
  const Skeleton& s = *scene.skeleton;
  PolyData data;
  for (const CriticalPoint& c : s.critical_points)
    add_row(data.add_vertex(add(data, c.point)), kCritical, static_cast<int>(c.kind),
            c.index.value_or(0), -1, -1, 0);
  for (const SwitchPoint& p : s.switch_points)
    add_row(data.add_vertex(add(data, p.point)), kSwitch, p.inside ? 1 : 0, 0, -1, -1, 0);
  Columns* row = nullptr;
  for (const Separatrix& l : s.separatrices) {
    add_line(data, l.line, false, row);
    add_row(*row, kSeparatrix, l.forward ? 1 : 0, 0, static_cast<int>(l.end),
            l.end == EndKind::undecided ? -1 : static_cast<int>(l.target), l.bits);
  }
  for (const ClosedOrbit& o : s.orbits) {
    add_line(data, o.line, true, row);
    add_row(*row, kOrbit, o.attracting ? 1 : 0, 0, -1, -1, 53);
  }
  if (!scene.data_digest.empty()) data.fields().add("data_digest", scene.data_digest);
  return data.data();
}

void write_skeleton(const std::string& path, const SkeletonScene& scene) {
  if (lower_extension(path) != ".vtp")
    throw kernel::InputError(path + ": file: has an unknown extension; write .vtp");
  write_vtp(path, *skeleton_poly_data(scene));
}

}  // namespace crest::io
