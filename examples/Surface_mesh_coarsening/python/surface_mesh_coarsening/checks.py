# SPDX-License-Identifier: GPL-3.0-or-later
"""Checks of arguments that are no arrays. Messages name the parameter."""

from __future__ import annotations

import numbers
import operator
from typing import Any

_LARGEST = 2**63 - 1


def whole(value: Any, name: str, least: int = 0) -> int:
    try:
        number = operator.index(value)
    except TypeError:
        if not isinstance(value, numbers.Real):
            raise TypeError(f"{name} is {value!r}, not a number") from None
        if value != value or value in (float("inf"), -float("inf")) or value != int(value):
            raise ValueError(f"{name} is {value!r}, not a whole number") from None
        number = int(value)
    if number < least:
        raise ValueError(f"{name} is {number}, and has to be at least {least}")
    if number > _LARGEST:
        raise ValueError(f"{name} is {number}, and has to be at most {_LARGEST}")
    return number


def real(value: Any, name: str) -> float:
    if not isinstance(value, numbers.Real) or isinstance(value, bool):
        raise TypeError(f"{name} is {value!r}, not a number")
    try:
        number = float(value)
    except OverflowError:
        raise ValueError(f"{name} is too large for a floating-point number") from None
    if number != number:
        raise ValueError(f"{name} is NaN")
    return number


def flag(value: Any, name: str) -> bool:
    if str(value) not in ("True", "False") or isinstance(value, str):  # those of NumPy have a type of their own
        raise TypeError(f"{name} is {value!r}, not True or False")
    return bool(value)


def text(value: Any, name: str) -> str:
    if not isinstance(value, str):
        raise TypeError(f"{name} is {value!r}, not a string")
    return value
