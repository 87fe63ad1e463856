# SPDX-License-Identifier: GPL-3.0-or-later
"""What a drawing says about its sheets."""

import numpy as np
import pytest

import crest

V = np.array([[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]], dtype=float)
F = np.array([[0, 2, 1], [0, 1, 3], [1, 2, 3], [2, 0, 3]])


def two_bodies(shift):
    return np.vstack([V, V + shift]), np.vstack([F, F + 4])


@pytest.mark.parametrize("shift, style, words", [
    ((3, 0, 0), "fishbone", "proved"),
    ((3, 0, 0), "streamlines", "proved"),
    ((0.2, 0.1, 0.1), "fishbone", "not claimed"),  # through one another
    ((1, 0, 0), "fishbone", "proved"),  # a corner on a corner of the other: one point
    ((0.25, 0.25, -1), "fishbone", "not claimed"),  # a corner on a face of the other
    ((3, 0, 0), "contours", "not claimed"),
])
def test_sheets(shift, style, words):
    drawing = crest.lineart(*two_bodies(shift), style=style, view=(30, 20), width=20)
    assert drawing.sheets == words
