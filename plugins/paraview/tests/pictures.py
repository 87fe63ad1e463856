# SPDX-License-Identifier: GPL-3.0-or-later
"""The pictures of docs/paraview.md: pvpython pictures.py FOLDER. As a test (without FOLDER) they must
show lines in their colours over the surface."""
import os
import sys
import unittest

import support
from certificates import BLEND, HANDLES, TWIST
from paraview import servermanager, simple
from support import fetch, opened, path

SIZE = [900, 600]


def view_of(direction):
    view = simple.CreateView("RenderView")
    view.ViewSize = SIZE
    view.UseColorPaletteForBackground = 0
    view.Background = [1, 1, 1]
    view.OrientationAxesVisibility = 0
    view.CameraPosition, view.CameraFocalPoint, view.CameraViewUp = direction, [0, 0, 0], [0, 0, 1]
    return view


def show(view, filter, port, colour, width=1.0, opacity=1.0, points=None):
    display = simple.Show(simple.OutputPort(filter, port), view)
    display.Representation = "Surface"
    display.ColorArrayName = [None, ""]
    display.AmbientColor = display.DiffuseColor = colour
    display.LineWidth, display.Opacity = width, opacity
    if points:
        display.PointSize = points
        display.RenderPointsAsSpheres = 1
    if width > 1:
        display.RenderLinesAsTubes = 1
    return display


def save(view, file):
    simple.ResetCamera(view)
    view.GetActiveCamera().Dolly(1.3)
    simple.SaveScreenshot(file, view, ImageResolution=SIZE)


def coloured(display, array, of, first, last, low, high):
    """By an array, between two colours."""
    table = simple.GetColorTransferFunction(array + os.path.basename(of))
    table.RGBPoints = [low, *first, high, *last]
    display.ColorArrayName = [of, array]
    display.LookupTable = table


def ridges(file):
    filter = simple.CrestRidges(Input=opened(*BLEND), SupportMode="Auto (noise)", Keep="Significant")
    view = view_of([3, -4, 2.5])
    show(view, filter, 2, [0.85, 0.85, 0.82])
    lines = show(view, filter, 0, [0, 0, 0], 4)
    coloured(lines, "colour", "CELLS", [0.1, 0.2, 0.8], [0.8, 0.1, 0.1], 0, 1)
    show(view, filter, 1, [0, 0, 0], points=12)
    save(view, file)
    return fetch(filter, 0).GetNumberOfCells()


def reeb(file):
    filter = simple.CrestReebGraph(Input=opened(*HANDLES), Expression="x + 0.3*y + 0.1*z")
    view = view_of([1, -5, 4])
    tiles = show(view, filter, 3, [0.8, 0.8, 0.8], opacity=0.45)
    table = simple.GetColorTransferFunction("arc")
    table.ApplyPreset("Rainbow Uniform", True)
    tiles.ColorArrayName = ["CELLS", "arc"]
    tiles.LookupTable = table
    table.RescaleTransferFunction(0, fetch(filter, 0).GetNumberOfCells() - 1)
    show(view, filter, 0, [0.1, 0.1, 0.1], 5)
    show(view, filter, 1, [0.8, 0.1, 0.1], points=14)
    save(view, file)
    return fetch(filter, 0).GetNumberOfCells()


def modes(file):
    filter = simple.CrestModeSurface(Input=opened(*TWIST), Mode="0.5", Neutral=1, Degenerate=1)
    view = view_of([4, -5, 3])
    surface = show(view, filter, 0, [0.7, 0.7, 0.7], opacity=0.75)
    coloured(surface, "mode", "CELLS", [0.95, 0.75, 0.2], [0.2, 0.65, 0.65], -0.5, 0.5)
    show(view, filter, 1, [0, 0.4, 0.15], 4)
    outline = show(view, filter.Input, 0, [0.4, 0.4, 0.4])
    outline.Representation = "Outline"
    save(view, file)
    return fetch(filter, 0).GetNumberOfCells()


PICTURES = {"paraview-ridges.png": ridges, "paraview-reeb.png": reeb, "paraview-modes.png": modes}


class Pictures(unittest.TestCase):
    def test_pictures(self):
        """Neither empty nor of one colour: the lines' colours are seen on the surface."""
        for name, draw in PICTURES.items():
            self.assertGreater(draw(path(name)), 0)
            reader = simple.PNGSeriesReader(FileNames=[path(name)])
            image = fetch(reader)
            colours = image.GetPointData().GetScalars()
            seen = {}
            for i in range(0, image.GetNumberOfPoints(), 3):
                key = tuple(int(c) // 64 for c in colours.GetTuple(i)[:3])
                seen[key] = seen.get(key, 0) + 1
            total = sum(seen.values())
            self.assertLess(seen.get((3, 3, 3), 0), 0.9 * total, name)
            self.assertGreater(len([n for n in seen.values() if n > total // 2000]), 4, name)


if __name__ == "__main__":
    if len(sys.argv) > 1:
        for name, draw in PICTURES.items():
            draw(os.path.join(sys.argv[1], name))
    else:
        support.main()
