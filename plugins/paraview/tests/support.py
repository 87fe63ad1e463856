# SPDX-License-Identifier: GPL-3.0-or-later
"""What the tests share: the plugin, the program to compare with, inputs made by it."""
import hashlib
import os
import subprocess
import unittest

from paraview import servermanager, simple

CREST = os.environ["CREST"]  # the program
VERIFY = os.environ["CREST_VERIFY"]
WORK = os.environ["CREST_WORK"]  # a folder for files

simple._DisableFirstRenderCameraReset()
simple.LoadPlugin(os.environ["CREST_PLUGIN"], remote=False, ns=vars(simple))


def path(name):
    return os.path.join(WORK, name)


def crest(*arguments, code=0):
    """Runs the program in the tests' folder; its certificate, summary, or complaint."""
    run = subprocess.run([CREST, *arguments], cwd=WORK, capture_output=True, text=True)
    if run.returncode != code:
        raise AssertionError(f"crest {' '.join(arguments)}: {run.returncode}\n{run.stderr}")
    return run.stdout + run.stderr


def made(name, *arguments):
    """A file of crest sample, made once; meshes pass crest clean, so that coordinates are doubles in
    a format that ParaView and Crest read alike."""
    if not os.path.exists(path(name)):
        if name.endswith(".vtp"):
            crest("sample", *arguments, "-o", name + ".off")
            crest("clean", name + ".off", "-o", name)
        else:
            crest("sample", *arguments, "-o", name)
    return path(name)


def opened(name, *arguments):
    """The file in ParaView."""
    file = made(name, *arguments)
    readers = {
        ".vtp": simple.XMLPolyDataReader,
        ".vtu": simple.XMLUnstructuredGridReader,
        ".vti": simple.XMLImageDataReader,
    }
    return readers[os.path.splitext(file)[1]](FileName=[file])


def fetch(filter, port=0):
    return servermanager.Fetch(filter, idx=port)


def cells(filter, port=0):
    return fetch(filter, port).GetNumberOfCells()


def field(filter, name, port=0):
    return fetch(filter, port).GetFieldData().GetAbstractArray(name).GetVariantValue(0).ToString()


def digest(file):
    with open(path(file), "rb") as f:
        return hashlib.sha256(f.read()).hexdigest()


class Messages:
    """The errors and warnings of a filter while it is updated."""

    def __init__(self, filter):
        self.errors, self.warnings = [], []
        self.algorithm = filter.GetClientSideObject()
        self.observers = []
        for event, lines in (("ErrorEvent", self.errors), ("WarningEvent", self.warnings)):
            def note(caller, name, text, lines=lines):
                lines.append(text)
            note.CallDataType = "string0"
            self.observers.append(self.algorithm.AddObserver(event, note))

    def of_update(filter):
        messages = Messages(filter)
        filter.UpdatePipeline()
        return messages


def main():
    """Leaves by the end of the script: several processes must end together."""
    program = unittest.main(verbosity=2, exit=False)
    if not program.result.wasSuccessful():
        raise SystemExit(1)
