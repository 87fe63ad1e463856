# SPDX-License-Identifier: GPL-3.0-or-later
"""Numbers at vertices, faces and corners through encode() and decode()."""

import pickle

import numpy as np
import pytest

import crest
from conftest import program

TYPES = ["i1", "u1", "i2", "u2", "i4", "u4", "i8", "u8", "f4", "f8"]


def numbers(shape, dtype, seed):
    """Of all magnitudes, with what is no number."""
    random = np.random.default_rng(seed)
    dtype = np.dtype(dtype)
    if dtype.kind == "f":
        x = random.normal(size=shape).astype(dtype)
        x.flat[:5] = np.nan, np.inf, -np.inf, -0.0, np.finfo(dtype).tiny / 2
        return x
    bounds = np.iinfo(dtype)
    x = random.integers(bounds.min, bounds.max, size=shape, dtype=dtype, endpoint=True)
    x.flat[:2] = bounds.min, bounds.max
    return x


def same(a, b):
    """Bit for bit, of one type."""
    return a.dtype == b.dtype and a.shape == b.shape and a.tobytes() == b.tobytes()


def turns(F, G):
    """Where the first corner of each face of F is in that of G."""
    return np.argmax(G == F[:, :1], axis=1)


@pytest.mark.parametrize("extra", [(), (1,), (4,)])
def test_round_trip(extra, here):
    V, F = crest.read_mesh("ellipsoid.off")
    n, m = len(V), len(F)
    data = {site: {f"{t}{extra}": numbers((*shape, *extra), t, i) for i, t in enumerate(TYPES)}
            for site, shape in (("point_data", (n,)), ("cell_data", (m,)), ("corner_data", (m, 3)))}
    coded = crest.encode(V, F, keep_order=True, **data)
    mesh = crest.decode(coded.stream)
    W, G = mesh
    assert (W == V).all() and coded.attribute_bytes > 0
    assert mesh.V is W and mesh.F is G
    first = turns(F, G)
    squeezed = () if extra == (1,) else extra
    for site in data:
        found = getattr(mesh, site)
        assert list(found) == list(data[site])
        for name, given in data[site].items():
            array = found[name]
            if site == "corner_data":  # as the corners of F
                array = np.take_along_axis(
                    array.reshape(m, 3, -1), (np.arange(3) + first[:, None])[:, :, None] % 3, axis=1)
            assert same(array.reshape(given.shape), given), (site, name)
            assert found[name].shape == given.shape[:given.ndim - len(extra)] + squeezed
    again = pickle.loads(pickle.dumps(mesh))
    assert same(again.point_data[f"f4{extra}"], mesh.point_data[f"f4{extra}"])


def test_in_the_streams_order(here):
    V, F = crest.read_mesh("blend.ply")
    coded = crest.encode(V, F, point_data={"place": V, "number": np.arange(len(V))})
    mesh = crest.decode(coded.stream)
    assert (mesh.point_data["place"] == mesh.V).all()
    assert (mesh.point_data["number"] == coded.vertex_order).all()
    assert mesh.cell_data == mesh.corner_data == {}


def test_places_without_numbers(here):
    V, F = crest.read_mesh("ellipsoid.off")
    gaps = np.arange(len(V)) % 3 == 0
    given = np.ma.array(V.astype("f4"), mask=np.repeat(gaps[:, None], 3, axis=1))
    whole = np.ma.array(np.arange(len(F), dtype="i2"))
    coded = crest.encode(V, F, keep_order=True, point_data={"normal": given}, cell_data={"id": whole})
    mesh = crest.decode(coded.stream)
    found = mesh.point_data["normal"]
    assert (np.ma.getmaskarray(found) == given.mask).all() and (found == given).all()
    assert not np.ma.isMaskedArray(mesh.cell_data["id"])
    other = given.copy()
    other.data[gaps] = 7  # what is under a mask does not matter
    assert crest.encode(V, F, keep_order=True, point_data={"normal": other},
                        cell_data={"id": whole}).stream == coded.stream


def test_bytes_are_the_programs(here, tmp_path):
    """A file with normals, colours and numbers of faces."""
    V, F = crest.read_mesh("ellipsoid.off")
    normals = numbers((len(V), 3), "f4", 1)
    normals[~np.isfinite(normals)] = 0
    colours, ids = numbers((len(V), 3), "u1", 2), numbers(len(F), "i4", 3)
    with open(tmp_path / "a.ply", "w") as file:
        file.write(f"ply\nformat ascii 1.0\nelement vertex {len(V)}\n")
        for name in "xyz":
            file.write(f"property double {name}\n")
        for name in ("nx", "ny", "nz"):
            file.write(f"property float {name}\n")
        for name in ("red", "green", "blue"):
            file.write(f"property uchar {name}\n")
        file.write(f"element face {len(F)}\nproperty list uchar int vertex_indices\n"
                   "property int id\nend_header\n")
        for v, n, c in zip(V, normals, colours):
            file.write(" ".join([*map(repr, map(float, [*v, *n])), *map(str, c)]) + "\n")
        for f, i in zip(F, ids):
            file.write("3 " + " ".join(map(str, [*f, i])) + "\n")
    program("crest", "encode", tmp_path / "a.ply", "-o", tmp_path / "a.cmc", "--certificate",
            tmp_path / "a.crest", "--quiet")
    stream = (tmp_path / "a.cmc").read_bytes()
    mesh = crest.decode(stream)
    given = {"point_data": {}, "cell_data": {}}
    columns = {"normal": normals, "red": colours[:, 0], "green": colours[:, 1], "blue": colours[:, 2],
               "rgb": colours, "id": ids, "nx": normals[:, 0], "ny": normals[:, 1], "nz": normals[:, 2]}
    for site in given:
        for name, array in getattr(mesh, site).items():
            (given[site][name],) = [x for key, x in columns.items()
                                    if x.shape == (len(V) if site == "point_data" else len(F),
                                                   *array.shape[1:]) and x.dtype == array.dtype
                                    and (array.ndim > 1 or key == name)]
    assert len(given["point_data"]) >= 2 and list(given["cell_data"]) == ["id"]
    coded = crest.encode(V, F, **given)
    assert coded.stream == stream
    assert coded.certificate == (tmp_path / "a.crest").read_bytes()


def test_bad_attributes(here):
    V, F = crest.read_mesh("ellipsoid.off")
    n, m = len(V), len(F)
    half = np.ma.array(V, mask=np.arange(3 * n).reshape(n, 3) % 2 == 0)
    for keywords in ({"point_data": {"a": np.zeros(n - 1)}}, {"point_data": {"a": np.zeros((n, 2, 2))}},
                     {"point_data": {"a": np.zeros((n, 0))}}, {"point_data": {"a": np.zeros(n, bool)}},
                     {"point_data": {"a": np.zeros(n, complex)}}, {"cell_data": {"a": np.zeros(n)}},
                     {"corner_data": {"a": np.zeros(3 * m)}}, {"point_data": {"a": ["x"] * n}},
                     {"point_data": {"a": half}},
                     {"point_data": {"a": np.zeros(n)}, "connectivity_only": True}):
        with pytest.raises(crest.InputError):
            crest.encode(V, F, **keywords)
    with pytest.raises(TypeError):
        crest.encode(V, F, point_data={3: np.zeros(n)})
    stream = crest.encode(V, F, point_data={"a": V}).stream
    with pytest.raises(crest.InputError):
        crest.decode(stream, max_numbers=3 * n - 1)
    assert len(crest.decode(stream, max_numbers=3 * n).point_data["a"]) == n
