# SPDX-License-Identifier: GPL-3.0-or-later
"""Exceptions with the nearest attainable value."""

from decimal import ROUND_CEILING, Context, Decimal

from . import _core


class UnreachableNumberOfVertices(ValueError):
    """No result has the requested number of vertices; `nearest` is the nearest attainable number."""

    def __init__(self, message: str, nearest: int):
        super().__init__(message, nearest)  # `args` suffice to pickle it
        self.nearest = nearest

    def __str__(self) -> str:
        return f"{self.args[0]} (nearest number that works: {self.nearest})"


class UnreachableDistance(ValueError):
    """No result is within the requested distance; `nearest` is the bound of the closest result found."""

    def __init__(self, message: str, nearest: float):
        super().__init__(message, nearest)  # `args` suffice to pickle it
        self.nearest = nearest

    def __str__(self) -> str:
        rounded_up = Context(prec=4, rounding=ROUND_CEILING).plus(Decimal(self.nearest))  # the printed distance works, too
        return f"{self.args[0]} (nearest distance found: {rounded_up.normalize():g})"


_core.set_exceptions(UnreachableNumberOfVertices, UnreachableDistance)
