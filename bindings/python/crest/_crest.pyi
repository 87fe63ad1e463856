# SPDX-License-Identifier: GPL-3.0-or-later
from typing import Any, Callable, Optional

class InputError(ValueError):
    """What is wrong with the input, in one line: "ELEMENT: PROBLEM; REMEDY"."""

def run(system: str, arguments: dict[str, Any], threads: int,
        progress: Optional[Callable[[str], object]]) -> dict[str, Any]: ...
def save(path: str, geometry: Any) -> None: ...
def wait_for_stopped(seconds: float) -> bool: ...
