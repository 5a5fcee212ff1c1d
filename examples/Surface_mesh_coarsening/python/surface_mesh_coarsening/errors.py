# SPDX-License-Identifier: GPL-3.0-or-later
"""Exceptions that tell what would have worked."""

from . import _core


class UnreachableNumberOfVertices(ValueError):
    """No result has the number of vertices asked for; `nearest` is the nearest number that works."""

    def __init__(self, message: str, nearest: int):
        super().__init__(message)
        self.nearest = nearest

    def __str__(self) -> str:
        return f"{self.args[0]} (nearest number that works: {self.nearest})"


class UnreachableDistance(ValueError):
    """No result keeps to the distance asked for; `nearest` is the bound of the closest result that was found."""

    def __init__(self, message: str, nearest: float):
        super().__init__(message)
        self.nearest = nearest

    def __str__(self) -> str:
        return f"{self.args[0]} (nearest distance found: {self.nearest:.4g})"


_core.set_exceptions(UnreachableNumberOfVertices, UnreachableDistance)
