# SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
"""What the package takes from its callers, checked before the core sees it."""
from __future__ import annotations

import json
import math
import operator
import os
from typing import Any, Callable, Iterable, Mapping, Optional

FIDELITIES = ("live", "draft", "standard", "reference")
BACKENDS = ("auto", "cpu", "cuda")


def path_bytes(value: Any, name: str) -> bytes:
    try:
        path = os.fsencode(os.fspath(value))
    except TypeError:
        raise TypeError(f"{name}: This must be a path; given is {value!r}.") from None
    if not path or b"\0" in path:
        raise ValueError(f"{name}: This must be a path; given is {value!r}.")
    return path


def text(value: Any, name: str) -> str:
    if not isinstance(value, str):
        raise TypeError(f"{name}: This must be a text; given is {value!r}.")
    if not _is_unicode(value):
        raise ValueError(f"{name}: This must be Unicode text; given is {value!r}.")
    return value


def _is_unicode(value: str) -> bool:
    """Without halves of pairs, as names of files that are not UTF-8 have them."""
    try:
        value.encode()
    except UnicodeEncodeError:
        return False
    return True


def optional_text(value: Optional[str], name: str) -> str:
    if value is None:
        return ""
    if value == "":
        raise ValueError(f"{name}: This must be a name; given is an empty text.")
    return text(value, name)


def texts(value: Any, name: str) -> list[str]:
    """Of a text, which stands alone, or of several."""
    if isinstance(value, str):
        return [text(value, name)]
    if not isinstance(value, Iterable):
        raise TypeError(f"{name}: This must be a text or a list of texts; given is {value!r}.")
    return [text(one, name) for one in value]


def word(value: Any, name: str, allowed: tuple[str, ...]) -> str:
    if not isinstance(value, str) or value not in allowed:
        raise ValueError(f"{name}: This must be {', '.join(allowed[:-1])} or {allowed[-1]}; given is {value!r}.")
    return value


def whole(value: Any, name: str, least: int, most: int) -> int:
    try:
        if isinstance(value, bool):
            raise TypeError
        number = operator.index(value)
    except TypeError:
        raise TypeError(f"{name}: This must be a whole number from {least} to {most}; given is {value!r}.") from None
    if not least <= number <= most:
        raise ValueError(f"{name}: This must be a whole number from {least} to {most}; given is {number}.")
    return number


def place(value: Any, name: str, count: int) -> int:
    """Of something in a row of so many; -1 is the last."""
    try:
        return whole(value, name, -count, count - 1) % count
    except ValueError as error:
        raise IndexError(str(error)) from None


def number(value: Any, name: str, least: float, most: float) -> float:
    try:
        if isinstance(value, (bool, str)):
            raise TypeError
        given = float(value)
    except OverflowError:
        given = math.inf
    except (TypeError, ValueError):
        raise TypeError(f"{name}: This must be a number from {least} to {most}; given is {value!r}.") from None
    if not least <= given <= most:
        raise ValueError(f"{name}: This must be a number from {least} to {most}; given is {given}.")
    return given


def _plain(value: Any) -> Any:
    """For JSON: what numpy and pandas hold."""
    if hasattr(value, "tolist"):
        return value.tolist()
    raise TypeError


def json_text(value: Any, name: str) -> str:
    try:
        written = json.dumps(value, default=_plain, allow_nan=False, ensure_ascii=False)
    except TypeError:
        raise TypeError(f"{name}: This must be a number, a text, a list or a dictionary; given is {value!r}.") from None
    except ValueError as error:
        wrong = "not hold itself" if "ircular" in str(error) else "be a finite number"
        raise ValueError(f"{name}: This must {wrong}; given is {value!r}.") from None
    except RecursionError:
        raise ValueError(f"{name}: This is nested too deeply.") from None
    if not _is_unicode(written):
        raise ValueError(f"{name}: This must be Unicode text; given is {value!r}.")
    return written


def setting(value: Any, name: str) -> str:
    """A number or a word as the command line takes it."""
    if isinstance(value, str):
        return text(value, name)
    try:
        number = float(value)
    except OverflowError:
        raise ValueError(f"{name}: This must be a number up to 1.8e308.") from None
    except (TypeError, ValueError):
        raise TypeError(f"{name}: This must be a number or a word; given is {value!r}.") from None
    if not math.isfinite(number):
        raise ValueError(f"{name}: This must be a finite number; given is {value!r}.")
    return str(int(number)) if number == int(number) and abs(number) < 1e15 else repr(number)


def settings(values: Optional[Mapping[str, Any]], name: str) -> dict[str, str]:
    if values is None:
        return {}
    if not isinstance(values, Mapping):
        raise TypeError(f"{name}: This must be a dictionary; given is {values!r}.")
    return {text(key, name): setting(value, f"{name}[{key!r}]") for key, value in values.items()}


def physics_text(physics: Any) -> str:
    """"heat=off,vapour=on", also of {"heat": False, "vapour": True}."""
    if physics is None:
        return ""
    if isinstance(physics, Mapping):
        words = {True: "on", False: "off"}
        return ",".join(f"{text(part, 'physics')}={words.get(on, on)}" for part, on in physics.items())
    return text(physics, "physics")


def call(progress: Any) -> Optional[Callable[[float, str], Any]]:
    if progress is not None and not callable(progress):
        raise TypeError(f"progress: This must be a function of a share and a text; given is {progress!r}.")
    return progress


def machine(backend: Any, threads: Any) -> dict[str, Any]:
    return {"backend": word(backend, "backend", BACKENDS), "threads": whole(threads, "threads", 0, 1024)}


def how(fidelity: Any, backend: Any, seed: Any, threads: Any, physics: Any, knobs: Any) -> dict[str, Any]:
    return {
        "fidelity": word(fidelity, "fidelity", FIDELITIES),
        "seed": whole(seed, "seed", 0, 2**64 - 1),
        "physics": physics_text(physics),
        "knobs": settings(knobs, "knobs"),
        **machine(backend, threads),
    }
