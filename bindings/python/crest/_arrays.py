# SPDX-License-Identifier: GPL-3.0-or-later
"""What users give, as the extension module takes it: checked, dense, of one type."""

from __future__ import annotations

import math
from typing import Any, Sequence

import numpy as np

from ._crest import InputError


def _numbers(x: Any, name: str) -> np.ndarray:
    """An array of real numbers."""
    if np.ma.isMaskedArray(x):
        raise InputError(f"{name}: is a masked array; fill or drop what is masked")
    array = np.asarray(x)
    if array.dtype.kind not in "iuf" or array.dtype.itemsize > 8:
        if array.size == 0:
            raise InputError(f"{name}: is empty")
        raise InputError(
            f"{name}: has the type {array.dtype}; give integers or doubles")
    return array


def _shaped(x: Any, name: str, columns: int) -> np.ndarray:
    array = _numbers(x, name)
    if array.ndim != 2 or array.shape[1] != columns:
        raise InputError(
            f"{name}: has the shape {array.shape}; give one of (n, {columns})")
    if len(array) == 0:
        raise InputError(f"{name}: is empty")
    return array


def _doubles(array: np.ndarray, name: str) -> np.ndarray:
    """The same numbers as doubles: float32 is widened, integers must fit."""
    doubles = np.array(array, dtype=np.float64, order="C")
    if array.dtype.kind in "iu" and array.dtype.itemsize == 8:
        # Beyond 2^53 a comparison of the two types would round, too.
        lost = (np.abs(doubles) >= 2.0**53)
        if lost.any():
            first = np.argwhere(lost)[0]
            raise InputError(
                f"{name}[{first[0]}]: {array[tuple(first)]} may be no double; give doubles")
    return doubles


def rows(x: Any, name: str, columns: int) -> np.ndarray:
    """(n, columns) doubles, n > 0."""
    return _doubles(_shaped(x, name, columns), name)


def values(x: Any, name: str, count: int, of: str) -> np.ndarray:
    """(count,) doubles."""
    array = _numbers(x, name)
    if array.shape != (count,):
        raise InputError(
            f"{name}: has the shape {array.shape}; give ({count},), one number a {of}")
    return _doubles(array, name)


def same_rows(x: Any, name: str, columns: int, count: int, of: str) -> np.ndarray:
    """(count, columns) doubles."""
    array = rows(x, name, columns)
    if len(array) != count:
        raise InputError(f"{name}: has {len(array)} rows; give {count}, one a {of}")
    return array


def cells(x: Any, name: str, columns: int) -> np.ndarray:
    """(m, columns) indices as int64, whatever their integer type; their range is checked later."""
    array = _shaped(x, name, columns)
    if array.dtype.kind == "f":
        raise InputError(f"{name}: has the type {array.dtype}; give integers that name vertices")
    if array.dtype == np.uint64 and (array > np.uint64(2**63 - 1)).any():
        first = np.argwhere(array > np.uint64(2**63 - 1))[0]
        raise InputError(
            f"{name}[{first[0]}]: names vertex {array[tuple(first)]}; count from 0")
    return np.array(array, dtype=np.int64, order="C")


def volume(x: Any, name: str) -> np.ndarray:
    """Samples in their own type."""
    array = _numbers(x, name)
    if array.ndim not in (2, 3):
        raise InputError(f"{name}: has {array.ndim} dimensions; give 3, or 2 of an image")
    if array.size == 0:
        raise InputError(f"{name}: is empty")
    if array.dtype == np.float16:
        array = array.astype(np.float32)
    return np.array(array, dtype=array.dtype.newbyteorder("="), order="C")


def octets(x: Any, name: str) -> np.ndarray:
    """bytes, bytearray, memoryview or an array of uint8."""
    try:
        return np.array(np.frombuffer(x, dtype=np.uint8))
    except (TypeError, ValueError, BufferError) as error:
        if isinstance(x, (bytes, bytearray)) and len(x) == 0:
            return np.zeros(0, dtype=np.uint8)
        raise TypeError(f"{name}: is no bytes: {error}") from None


def number(x: Any, name: str, low: float = -math.inf, high: float = math.inf) -> float:
    """A finite double within bounds."""
    if isinstance(x, (bool, np.bool_, str, bytes)):
        raise TypeError(f"{name}: is no number: {x!r}")
    value = float(x)
    if not math.isfinite(value) or not low <= value <= high:
        raise InputError(f"{name}: {value} is not a number from {low} to {high}")
    return value


def maybe_number(x: Any, name: str, low: float = -math.inf,
                 high: float = math.inf) -> float | None:
    return None if x is None else number(x, name, low, high)


def whole(x: Any, name: str, low: int, high: int) -> int:
    """An integer within bounds."""
    if isinstance(x, (bool, np.bool_)) or not hasattr(x, "__index__"):
        raise TypeError(f"{name}: is no integer: {x!r}")
    value = x.__index__()
    if not low <= value <= high:
        raise InputError(f"{name}: {value} is not an integer from {low} to {high}")
    return value


def word(x: Any, name: str, words: Sequence[Any]) -> Any:
    """One of the words."""
    if x not in words:
        raise InputError(f"{name}: {x!r} is none of {', '.join(map(str, words))}")
    return x


def numbers(x: Any, name: str, count: int) -> list[float]:
    """So many finite numbers."""
    given = list(np.ravel(_numbers(x, name)))
    if len(given) != count:
        raise InputError(f"{name}: has {len(given)} numbers; give {count}")
    return [number(y, name) for y in given]


def attribute(x: Any, name: str, places: tuple[int, ...]) -> tuple[np.ndarray, np.ndarray | None]:
    """Numbers in their own type, (all places, k), and 1 at the places that have none, if any."""
    masked = np.ma.isMaskedArray(x) and bool(np.ma.getmaskarray(x).any())
    array = _numbers(np.ma.getdata(x) if np.ma.isMaskedArray(x) else x, name)
    extra = array.ndim - len(places)
    if array.shape[:len(places)] != places or extra not in (0, 1) or array.size == 0:
        wanted = ", ".join(map(str, places))
        raise InputError(f"{name}: has the shape {array.shape}; give ({wanted},) or ({wanted}, k)")
    count = math.prod(places)
    if array.dtype == np.float16:
        array = array.astype(np.float32)
    array = np.array(array, dtype=array.dtype.newbyteorder("="), order="C").reshape(count, -1)
    if not masked:
        return array, None
    mask = np.ma.getmaskarray(x).reshape(count, -1)
    if (mask.any(axis=1) != mask.all(axis=1)).any():
        raise InputError(f"{name}: masks some numbers of a place and not all; mask all of them")
    array[mask] = 0
    return array, mask.any(axis=1).astype(np.uint8)
