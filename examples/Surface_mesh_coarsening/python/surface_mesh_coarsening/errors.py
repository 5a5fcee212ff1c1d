# SPDX-License-Identifier: GPL-3.0-or-later
"""Exceptions with the nearest attainable value."""

from . import _core


class UnreachableNumberOfVertices(ValueError):
    """No result has the requested number of vertices; `nearest` is the nearest attainable number."""

    def __init__(self, message: str, nearest: int):
        super().__init__(message)
        self.nearest = nearest

    def __str__(self) -> str:
        return f"{self.args[0]} (nearest number that works: {self.nearest})"


class UnreachableDistance(ValueError):
    """No result is within the requested distance; `nearest` is the bound of the closest result found."""

    def __init__(self, message: str, nearest: float):
        super().__init__(message)
        self.nearest = nearest

    def __str__(self) -> str:
        return f"{self.args[0]} (nearest distance found: {self.nearest:.4g})"


_core.set_exceptions(UnreachableNumberOfVertices, UnreachableDistance)
