# SPDX-License-Identifier: GPL-3.0-or-later
"""The shared library, its errors, interrupts and threads."""

from __future__ import annotations

import ctypes
import os
import signal
import threading
from collections import namedtuple
from concurrent.futures import ThreadPoolExecutor
from contextlib import contextmanager
from pathlib import Path
from typing import Any, Iterator

from . import _api as api


def _load() -> ctypes.CDLL:
    """Loads the library: $DOMINO_LIBRARY, or else the one installed with this module, or else the system's."""
    here = Path(__file__).resolve().parent
    named = os.environ.get("DOMINO_LIBRARY")
    installed = [str(parent / "lib" / api.SONAME) for parent in here.parents if (parent / "lib" / api.SONAME).exists()]
    for path in [named] if named else [*installed[:1], api.SONAME]:
        try:
            library = ctypes.CDLL(path)
            break
        except OSError as error:
            problem = error
    else:
        raise ImportError(f"cannot load {api.SONAME}: {problem}; name its path in the environment variable DOMINO_LIBRARY")
    for name, (result, arguments) in api.FUNCTIONS.items():
        function = getattr(library, name)
        function.restype, function.argtypes = result, arguments
    return library


lib = _load()
version: str = lib.dom_version().decode()


class DominoError(ArithmeticError):
    """Raised if a question has no answer. `status` is the name of the library's status, such as "STOPS"."""

    def __init__(self, message: str, status: str = ""):
        super().__init__(message)
        self.status = status


class OutOfRange(DominoError, ValueError):
    """Raised if a parameter is outside its range. `parameter` is the name of the parameter."""

    def __init__(self, message: str, status: str = "", parameter: str = ""):
        super().__init__(message, status)
        self.parameter = parameter


# The parameters whose names in this module differ from those in the library.
PARAMETERS = {"tilt": "theta"} | {member: name for name, member in api.EFFECTS.items()}


def record(name: str, fields: str, doc: str, defaults: Any = ()) -> Any:
    """Returns a class of named tuples, for answers."""
    made = namedtuple(name, fields, defaults=defaults, module="domino")
    made.__doc__ = doc
    return made


def number_of(given: str, values: dict[str, Any], what: str, status: str = "") -> Any:
    """Returns what a word such as "hollow" stands for."""
    if given not in values:
        raise OutOfRange(f"{what}: {given!r} is not one of {', '.join(values)}", status or f"BAD_{what.upper()}", what)
    return values[given]


def effect_members(given: dict[str, Any]) -> dict[str, Any]:
    """Returns the members of a structure of the library for effects such as friction=0.2; other effects are off."""
    for name in given:
        if name not in api.EFFECTS:
            raise TypeError(f"there is no parameter '{name}'; the effects are {', '.join(api.EFFECTS)}")
    return {member: given.get(name, 0.0) for name, member in api.EFFECTS.items()}


def status_name(status: int) -> str:
    """Returns the name of a status, such as "STOPS"."""
    return api.dom_status(status).name.removeprefix("DOM_")


def raise_status(status: int, where: str = "") -> None:
    """Raises an error unless the status is DOM_OK. `where` says which train or domino has no answer."""
    if status == api.dom_status.DOM_OK:
        return
    name = status_name(status)
    text = lib.dom_status_text(status).decode() + where
    if name == "INTERRUPTED":
        raise KeyboardInterrupt
    if name == "NO_MEMORY":
        raise MemoryError(text)
    if name.startswith("BAD_"):
        parameter = name.removeprefix("BAD_").lower()
        parameter = PARAMETERS.get(parameter, parameter)
        raise OutOfRange(f"{parameter}: {text}", name, parameter)
    raise DominoError(text, name)


def computing(tol: float | None) -> api.dom_compute:
    """Returns a struct dom_compute."""
    compute = lib.dom_compute_default()
    if tol is not None:
        compute.tol = tol
    return compute


@contextmanager
def interruptible(compute: api.dom_compute) -> Iterator[None]:
    """A context in which ^C ends a computation of the library and then raises KeyboardInterrupt.

    Python runs signal handlers only between its own instructions. So `run` does the work on another thread, while this
    one waits.
    """
    flag = ctypes.c_int(0)
    compute.interrupt = ctypes.pointer(flag)
    before: Any = None
    main = threading.current_thread() is threading.main_thread()
    if main:
        before = signal.getsignal(signal.SIGINT)

        def on_interrupt(number: int, frame: Any) -> None:
            flag.value = 1

        signal.signal(signal.SIGINT, on_interrupt)
    try:
        yield
    finally:
        compute.interrupt = None
        if main:
            signal.signal(signal.SIGINT, before)
    if flag.value and main and callable(before):
        raise KeyboardInterrupt


CORES = len(os.sched_getaffinity(0)) if hasattr(os, "sched_getaffinity") else os.cpu_count() or 1
_pool = ThreadPoolExecutor(CORES + 1, "domino")


def run(function: Any, *arguments: Any) -> Any:
    """Calls a function of the library on another thread, so that this thread can react to ^C."""
    return _pool.submit(function, *arguments).result()


def run_all(calls: list[Any]) -> list[Any]:
    """Calls functions without arguments on all cores, and returns their results in order."""
    return [future.result() for future in [_pool.submit(call) for call in calls]]


@api.dom_parallel
def parallel(count: int, task: Any, context: int, pool: int) -> int:
    """A dom_parallel that runs the tasks of a study on all cores. The thread that calls it waits until they end."""
    numbers = iter(range(count))  # a thread that takes the next number holds Python's lock

    def work() -> None:
        for k in numbers:
            task(k, context)

    threads = [threading.Thread(target=work) for _ in range(min(CORES, count) - 1)]
    for thread in threads:
        thread.start()
    work()
    for thread in threads:
        thread.join()
    return api.dom_status.DOM_OK
