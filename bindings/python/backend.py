# SPDX-License-Identifier: GPL-3.0-or-later
"""Makes the wheel (PEP 517): CMake builds and installs, this packs. Nothing is downloaded.

    pip wheel . --no-index

CREST_BUILD names a build folder to use, configured for the interpreter that runs this; else there
is one for a while.
"""

import base64
import hashlib
import os
import re
import subprocess
import sys
import sysconfig
import tempfile
import zipfile
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]


class UnsupportedOperation(Exception):
    """There is no source distribution: take the repository."""


def build_sdist(sdist_directory, config_settings=None):
    raise UnsupportedOperation("take the repository")


def build_wheel(wheel_directory, config_settings=None, metadata_directory=None):
    with tempfile.TemporaryDirectory() as folder:
        build = os.environ.get("CREST_BUILD") or os.path.join(folder, "build")
        stage = os.path.join(folder, "stage")
        if os.environ.get("CREST_BUILD"):
            _require_this_interpreter(build)
        else:
            _run("-S", str(ROOT), "-B", build, "-G", "Ninja", "-DCREST_WITH_PYTHON=ON",
                 "-DCREST_BUILD_TESTS=OFF", f"-DPython_EXECUTABLE={sys.executable}")
        _run("--build", build, "--target", "_crest")
        _run("--install", build, "--component", "python", "--strip", "--prefix", stage)
        packages = list(Path(stage).glob("**/crest/__init__.py"))
        return _pack(packages[0].parent, Path(wheel_directory))


def _require_this_interpreter(build):
    cache = (Path(build) / "CMakeCache.txt").read_text()
    named = re.search(r"^Python_EXECUTABLE:\w+=(.*)$", cache, re.MULTILINE)
    if not named or not os.path.samefile(named[1], sys.executable):
        raise SystemExit(f"{build} is not configured with -DCREST_WITH_PYTHON=ON "
                         f"-DPython_EXECUTABLE={sys.executable}")


def _run(*arguments):
    subprocess.run(["cmake", *arguments], check=True)


def _pack(package, target):
    version = re.search(r'"(.*)"', (package / "_version.py").read_text())[1]
    tag = "cp{0}{1}-cp{0}{1}-{2}".format(*sys.version_info[:2], re.sub(
        r"[.-]", "_", sysconfig.get_platform()))
    info = f"crest-{version}.dist-info"
    files = {f"crest/{file.name}": file.read_bytes() for file in sorted(package.iterdir())
             if file.is_file()}
    files[f"{info}/METADATA"] = (
        f"Metadata-Version: 2.1\nName: crest\nVersion: {version}\n"
        "Summary: Certified extraction of surface topology\nLicense: GPL-3.0-or-later\n"
        # NumPy is the machine's, as VTK is: named here, pip would ask an index for it.
        "Requires-Python: >=3.11\n").encode()
    files[f"{info}/WHEEL"] = (
        f"Wheel-Version: 1.0\nGenerator: crest\nRoot-Is-Purelib: false\nTag: {tag}\n").encode()
    record = "".join(f"{name},sha256={_digest(data)},{len(data)}\n"
                     for name, data in files.items())
    files[f"{info}/RECORD"] = (record + f"{info}/RECORD,,\n").encode()
    name = f"crest-{version}-{tag}.whl"
    with zipfile.ZipFile(target / name, "w", zipfile.ZIP_DEFLATED) as wheel:
        for path, data in files.items():
            entry = zipfile.ZipInfo(path, date_time=(1980, 1, 1, 0, 0, 0))  # the same bytes again
            entry.external_attr = 0o644 << 16
            wheel.writestr(entry, data, zipfile.ZIP_DEFLATED)
    return name


def _digest(data):
    return base64.urlsafe_b64encode(hashlib.sha256(data).digest()).rstrip(b"=").decode()
