# SPDX-License-Identifier: GPL-3.0-or-later
"""What functions return: NumPy arrays with names, for other packages on request."""

from __future__ import annotations

import os
from typing import TYPE_CHECKING, Any, Iterator, NamedTuple

import numpy as np

from . import _crest

if TYPE_CHECKING:  # imported by the methods that need them
    import meshio
    import pyvista
    from vtkmodules.vtkCommonDataModel import vtkPolyData


def _needs(package: str, what: str) -> ImportError:
    return ImportError(f"{what} needs the package {package}, which is not installed")


class Cells(NamedTuple):
    """Cell i has the points connectivity[offsets[i]:offsets[i + 1]]."""

    offsets: np.ndarray  #: (n + 1,) int64
    connectivity: np.ndarray  #: int64

    def __len__(self) -> int:
        return len(self.offsets) - 1

    def lists(self) -> Iterator[np.ndarray]:
        """Each cell's points."""
        for first, last in zip(self.offsets[:-1], self.offsets[1:]):
            yield self.connectivity[first:last]


class Geometry:
    """Points with cells and arrays, as the .vtp file of the command line has them.

    points: (n, 3) float64, units of the input.
    vertices, lines, polygons, strips: Cells; the rows of cell_data come in this order.
    point_data, cell_data: arrays by name, int32 or float64, one row a point or a cell.
    field_data: arrays and texts of the whole.
    """

    def __init__(self, raw: dict[str, Any]):
        self.points: np.ndarray = raw["points"]
        self.vertices = Cells(*raw["vertices"])
        self.lines = Cells(*raw["lines"])
        self.polygons = Cells(*raw["polygons"])
        self.strips = Cells(*raw["strips"])
        self.point_data: dict[str, np.ndarray] = raw["point_data"]
        self.cell_data: dict[str, np.ndarray] = raw["cell_data"]
        self.field_data: dict[str, Any] = raw["field_data"]

    def __repr__(self) -> str:
        return (f"<Geometry: {len(self.points)} points, {len(self.vertices)} vertices, "
                f"{len(self.lines)} lines, {len(self.polygons)} polygons, "
                f"{len(self.strips)} strips>")

    def triangles(self) -> np.ndarray:
        """(m, 3) int64: the polygons. Raises ValueError if one has other than three corners."""
        if len(self.polygons.connectivity) != 3 * len(self.polygons):
            raise ValueError("not all polygons are triangles")
        return self.polygons.connectivity.reshape(-1, 3)

    def to_vtk(self) -> vtkPolyData:
        """A vtkPolyData with copies of all arrays."""
        try:
            from vtkmodules.util.numpy_support import numpy_to_vtk, numpy_to_vtkIdTypeArray
            from vtkmodules.vtkCommonCore import vtkPoints, vtkStringArray
            from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPolyData
        except ImportError:
            raise _needs("vtk (python3-vtk9)", "to_vtk()") from None

        def cell_array(cells: Cells) -> Any:
            array = vtkCellArray()
            array.SetData(numpy_to_vtkIdTypeArray(cells.offsets, deep=True),
                          numpy_to_vtkIdTypeArray(cells.connectivity, deep=True))
            return array

        def add(arrays: dict[str, Any], data: Any) -> None:
            for name, values in arrays.items():
                if isinstance(values, str):
                    array = vtkStringArray()
                    array.InsertNextValue(values)
                else:
                    array = numpy_to_vtk(values, deep=True)
                array.SetName(name)
                data.AddArray(array)

        data = vtkPolyData()
        points = vtkPoints()
        points.SetData(numpy_to_vtk(self.points, deep=True))
        data.SetPoints(points)
        for cells, put in ((self.vertices, data.SetVerts), (self.lines, data.SetLines),
                           (self.polygons, data.SetPolys), (self.strips, data.SetStrips)):
            if len(cells) > 0:
                put(cell_array(cells))
        add(self.point_data, data.GetPointData())
        add(self.cell_data, data.GetCellData())
        add(self.field_data, data.GetFieldData())
        return data

    def to_pyvista(self) -> pyvista.PolyData:
        """A pyvista.PolyData with copies of all arrays."""
        try:
            import pyvista
        except ImportError:
            raise _needs("pyvista", "to_pyvista()") from None
        return pyvista.wrap(self.to_vtk())

    def to_meshio(self) -> meshio.Mesh:
        """A meshio.Mesh. It knows no polylines and strips: they become segments and triangles, each
        with the row of its cell."""
        try:
            import meshio
        except ImportError:
            raise _needs("meshio", "to_meshio()") from None
        blocks: list[tuple[str, np.ndarray]] = []
        sources: list[np.ndarray] = []

        def add(kind: str, cells: list[np.ndarray], source: list[int]) -> None:
            if cells:
                blocks.append((kind, np.array(cells)))
                sources.append(np.array(source))

        first = 0
        for kind, group in (("vertex", self.vertices), ("line", self.lines),
                            ("polygon", self.polygons), ("strip", self.strips)):
            pieces: dict[str, tuple[list[np.ndarray], list[int]]] = {}
            for i, ids in enumerate(group.lists()):
                for name, piece in _pieces(kind, ids):
                    cells, source = pieces.setdefault(name, ([], []))
                    cells.append(piece)
                    source.append(first + i)
            for name, (cells, source) in pieces.items():
                add(name, cells, source)
            first += len(group)
        cell_data = {name: [array[rows] for rows in sources]
                     for name, array in self.cell_data.items()}
        return meshio.Mesh(self.points, blocks, dict(self.point_data), cell_data)

    def save(self, path: str | os.PathLike[str]) -> None:
        """Writes .vtp, the same bytes as the command line's; .npz (all arrays); and, with the
        package meshio, its formats."""
        name = os.fspath(path)
        extension = os.path.splitext(name)[1].lower()
        if extension == ".vtp":
            _crest.save(name, self)
        elif extension == ".npz":
            np.savez(name, **self._flat())
        else:
            self.to_meshio().write(name)

    def _flat(self) -> dict[str, Any]:
        flat: dict[str, Any] = {"points": self.points}
        for kind in ("vertices", "lines", "polygons", "strips"):
            cells = getattr(self, kind)
            flat[kind + "_offsets"], flat[kind] = cells.offsets, cells.connectivity
        for part in ("point", "cell", "field"):
            for name, array in getattr(self, part + "_data").items():
                flat[part + "_" + name] = array
        return flat


def _pieces(kind: str, ids: np.ndarray) -> Iterator[tuple[str, np.ndarray]]:
    """A cell as those that meshio knows."""
    if kind == "vertex":
        for p in ids:
            yield "vertex", ids[:1] if len(ids) == 1 else np.array([p])
    elif kind == "line":
        for a, b in zip(ids[:-1], ids[1:]):
            yield "line", np.array([a, b])
    elif kind == "polygon":
        names = {3: "triangle", 4: "quad"}
        if len(ids) in names:
            yield names[len(ids)], ids
        else:
            for b, c in zip(ids[1:-1], ids[2:]):
                yield "triangle", np.array([ids[0], b, c])
    else:
        for i in range(len(ids) - 2):
            a, b, c = ids[i:i + 3]
            if len({a, b, c}) == 3:
                yield "triangle", np.array([a, b, c] if i % 2 == 0 else [b, a, c])


class Result:
    """What every result has.

    geometry: Geometry, what the command line would write with -o.
    certificate: bytes for verify() and crest-verify; empty: there is none.
    certified: whether there is one.
    data_digest: str, names the data the certificate speaks of.
    warnings: tuple of str.
    """

    geometry: Geometry
    certificate: bytes
    certified: bool
    data_digest: str
    warnings: tuple[str, ...]

    def __init__(self, raw: dict[str, Any]):
        self.certificate = raw["certificate"]
        self.certified = len(self.certificate) > 0
        self.data_digest = raw.get("data_digest", "")
        self.warnings = tuple(raw["warnings"])
        if "geometry" in raw:
            self.geometry = Geometry(raw["geometry"])

    def __repr__(self) -> str:
        parts = [f"{name}: {'x'.join(map(str, value.shape))}" for name, value in
                 vars(self).items() if isinstance(value, np.ndarray)]
        parts.append(f"certificate: {len(self.certificate)} bytes")
        return f"<{type(self).__name__}: {', '.join(parts)}>"

    def to_vtk(self) -> vtkPolyData:
        """The geometry as a vtkPolyData (needs the package vtk)."""
        return self.geometry.to_vtk()

    def to_pyvista(self) -> pyvista.PolyData:
        """The geometry as a pyvista.PolyData (needs the package pyvista)."""
        return self.geometry.to_pyvista()

    def to_meshio(self) -> meshio.Mesh:
        """The geometry as a meshio.Mesh (needs the package meshio)."""
        return self.geometry.to_meshio()

    def save(self, path: str | os.PathLike[str]) -> None:
        """Writes the geometry, by the extension: .vtp, .npz, with the package meshio its formats;
        as .crest the certificate. Raises ValueError for a certificate that is not there."""
        if os.path.splitext(os.fspath(path))[1].lower() != ".crest":
            self.geometry.save(path)
            return
        if not self.certificate:
            raise ValueError(f"{os.fspath(path)}: there is no certificate to write")
        with open(path, "wb") as file:
            file.write(self.certificate)
