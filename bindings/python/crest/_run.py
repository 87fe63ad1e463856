# SPDX-License-Identifier: GPL-3.0-or-later
"""Runs a system of the extension module."""

from __future__ import annotations

import atexit
import sys
import warnings
from typing import Any, Callable, Optional

from . import _crest
from ._arrays import whole

Progress = Optional[Callable[[str], object]]


def run(system: str, arguments: dict[str, Any], threads: int, progress: Progress) -> dict[str, Any]:
    """What the system gives; its warnings are spoken where the user's call stands."""
    threads = whole(threads, "threads", 0, 1024)
    if progress is not None and not callable(progress):
        raise TypeError(f"progress: cannot be called: {progress!r}")
    raw = _crest.run(system, arguments, threads, progress)
    for text in raw["warnings"]:
        warnings.warn(text, stacklevel=3)
    return raw


@atexit.register
def _wait_for_stopped() -> None:
    # A process that ends by Ctrl-C takes nothing down, and the user waits for nothing.
    if getattr(sys, "last_type", None) is not KeyboardInterrupt:
        _crest.wait_for_stopped(1.0)
