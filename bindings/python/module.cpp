// SPDX-License-Identifier: GPL-3.0-or-later
// The extension module crest._crest: run(), save(), wait_for_stopped(). The package's Python
// around it has the functions that users see.
#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include "bindings/python/run.hpp"
#include "bindings/python/systems.hpp"
#include "kernel/geometry/input_error.hpp"

namespace py = pybind11;

namespace crest::python {
namespace {

// Python to C++.

template <class T>
bool take(const py::array& array, Array& out) {
  if (!array.dtype().is(py::dtype::of<T>()) && !array.dtype().equal(py::dtype::of<T>()))
    return false;
  const auto dense = py::array_t<T, py::array::c_style>::ensure(array);
  if (!dense) throw py::error_already_set();
  out.data = std::vector<T>(dense.data(), dense.data() + dense.size());
  return true;
}

template <class... T>
Array array_from(const py::array& array, const std::variant<std::vector<T>...>*) {
  Array out{{array.shape(), array.shape() + array.ndim()}, {}};
  if (!(take<T>(array, out) || ...))
    throw py::type_error("an array of type " + py::str(array.dtype()).cast<std::string>());
  return out;
}
Array array_from(const py::array& array) {
  return array_from(array, static_cast<const kernel::SampledGrid::Samples*>(nullptr));
}

Value value_from(const py::handle& object) {
  if (object.is_none()) return std::monostate();
  if (py::isinstance<py::bool_>(object)) return object.cast<bool>();
  if (py::isinstance<py::int_>(object)) return object.cast<std::int64_t>();
  if (py::isinstance<py::float_>(object)) return object.cast<double>();
  if (py::isinstance<py::str>(object)) return object.cast<std::string>();
  if (py::isinstance<py::array>(object)) return array_from(object.cast<py::array>());
  const auto list = object.cast<py::list>();
  if (!list.empty() && py::isinstance<py::str>(list[0]))
    return list.cast<std::vector<std::string>>();
  return list.cast<std::vector<double>>();
}

io::CellLists cells_from(const py::object& cells) {
  return {cells.attr("offsets").cast<std::vector<std::int64_t>>(),
          cells.attr("connectivity").cast<std::vector<std::int64_t>>()};
}

std::vector<io::Column> columns_from(const py::dict& arrays) {
  std::vector<io::Column> columns;
  for (const auto& [name, object] : arrays) {
    io::Column column{name.cast<std::string>(), 1, {}};
    if (py::isinstance<py::str>(object)) {
      column.values = std::vector<std::string>{object.cast<std::string>()};
    } else {
      Array array = array_from(object.cast<py::array>());
      for (std::size_t k = 1; k < array.shape.size(); ++k) column.components *= array.shape[k];
      if (auto* const x = std::get_if<std::vector<double>>(&array.data))
        column.values = std::move(*x);
      else if (auto* const n = std::get_if<std::vector<std::uint8_t>>(&array.data))
        column.values = std::move(*n);
      else
        column.values = std::get<std::vector<std::int32_t>>(std::move(array.data));
    }
    columns.push_back(std::move(column));
  }
  return columns;
}

// C++ to Python: arrays own their numbers.

template <class T>
py::array owned(std::vector<T> values, std::vector<std::size_t> shape) {
  auto* const kept = new std::vector<T>(std::move(values));
  const py::capsule owner(kept, [](void* p) { delete static_cast<std::vector<T>*>(p); });
  return py::array_t<T>(std::vector<py::ssize_t>(shape.begin(), shape.end()), kept->data(), owner);
}

py::object object_of(Array array) {
  return std::visit(
      [&](auto& values) -> py::object { return owned(std::move(values), std::move(array.shape)); },
      array.data);
}
py::object object_of(Value value) {
  return std::visit(
      [](auto& x) -> py::object {
        using X = std::decay_t<decltype(x)>;
        if constexpr (std::is_same_v<X, std::monostate>)
          return py::none();
        else if constexpr (std::is_same_v<X, Array>)
          return object_of(std::move(x));
        else
          return py::cast(std::move(x));
      },
      value);
}

py::dict dict_of(std::vector<io::Column> columns) {
  py::dict arrays;
  for (io::Column& column : columns) {
    const std::size_t components = column.components;
    arrays[py::str(column.name)] = std::visit(
        [&]<class T>(std::vector<T>& values) -> py::object {
          if constexpr (std::is_same_v<T, std::string>) {
            return values.size() == 1 ? py::object(py::str(values[0])) : py::cast(values);
          } else {
            std::vector<std::size_t> shape = {values.size() / components};
            if (components > 1) shape.push_back(components);
            return owned(std::move(values), std::move(shape));
          }
        },
        column.values);
  }
  return arrays;
}

py::object tuple_of(io::CellLists cells) {
  const std::size_t offsets = cells.offsets.size(), ids = cells.connectivity.size();
  return py::make_tuple(owned(std::move(cells.offsets), {offsets}),
                        owned(std::move(cells.connectivity), {ids}));
}

py::dict dict_of(io::Geometry g) {
  const std::size_t points = g.points.size() / 3;
  py::dict out;
  out["points"] = owned(std::move(g.points), {points, 3});
  out["vertices"] = tuple_of(std::move(g.vertices));
  out["lines"] = tuple_of(std::move(g.lines));
  out["polygons"] = tuple_of(std::move(g.polygons));
  out["strips"] = tuple_of(std::move(g.strips));
  out["point_data"] = dict_of(std::move(g.point_data));
  out["cell_data"] = dict_of(std::move(g.cell_data));
  out["field_data"] = dict_of(std::move(g.field_data));
  return out;
}

py::dict dict_of(Output output) {
  py::dict out;
  for (auto& [name, geometry] : output.geometries)
    out[py::str(name)] = dict_of(std::move(geometry));
  for (auto& [name, value] : output.values) out[py::str(name)] = object_of(std::move(value));
  out["certificate"] = py::bytes(reinterpret_cast<const char*>(output.certificate.data()),
                                 output.certificate.size());
  out["warnings"] = py::cast(output.warnings);
  return out;
}

py::dict run_system(const std::string& name, const py::dict& keywords, int threads,
                    const py::object& progress) {
  std::map<std::string, Value> values;
  for (const auto& [key, object] : keywords) values[key.cast<std::string>()] = value_from(object);
  Arguments arguments(std::move(values));
  const System system = system_of(name);
  const Listener listen = [&](const std::vector<std::string>& shown) {
    const py::gil_scoped_acquire lock;
    if (PyErr_CheckSignals() != 0) throw py::error_already_set();
    if (!progress.is_none())
      for (const std::string& what : shown) progress(what);
  };
  Output output;
  {
    const py::gil_scoped_release unlock;
    output = run(system, std::move(arguments), threads, listen);
  }
  return dict_of(std::move(output));
}

void save(const std::string& path, const py::object& geometry) {
  const auto points = geometry.attr("points").cast<py::array_t<double, py::array::c_style>>();
  io::Geometry g{{points.data(), points.data() + points.size()},
                 cells_from(geometry.attr("vertices")),
                 cells_from(geometry.attr("lines")),
                 cells_from(geometry.attr("polygons")),
                 cells_from(geometry.attr("strips")),
                 columns_from(geometry.attr("point_data")),
                 columns_from(geometry.attr("cell_data")),
                 columns_from(geometry.attr("field_data"))};
  const py::gil_scoped_release unlock;
  io::write_geometry(path, g);
}

}  // namespace
}  // namespace crest::python

PYBIND11_MODULE(_crest, m) {
  using namespace crest::python;
  py::register_exception<crest::kernel::InputError>(m, "InputError", PyExc_ValueError);
  m.def("run", &run_system, py::arg("system"), py::arg("arguments"), py::arg("threads"),
        py::arg("progress"));
  m.def("save", &save, py::arg("path"), py::arg("geometry"));
  m.def("wait_for_stopped", &wait_for_stopped, py::arg("seconds"),
        py::call_guard<py::gil_scoped_release>());
}
