# SPDX-License-Identifier: GPL-3.0-or-later
"""Pictures for notebooks: a train at the moment of a hit, and a row as it stands."""

from __future__ import annotations

import math
from typing import Iterable

WIDTH = 640  # width of a picture in pixels
BLOCK, FLOOR = "#0072B2", "#555555"

Point = tuple[float, float]


def block(foot: float, height: float, thickness: float, tilt: float) -> list[Point]:
    """The corners of a block that turns by `tilt` about its front edge, which is at foot + thickness on the floor."""
    sine, cosine = math.sin(tilt), math.cos(tilt)
    corners = [(0.0, 0.0), (-thickness, 0.0), (-thickness, height), (0.0, height)]
    return [(foot + thickness + x * cosine + y * sine, y * cosine - x * sine) for x, y in corners]


def svg(blocks: Iterable[list[Point]], title: str) -> str:
    """A picture of blocks on a floor, to scale."""
    blocks = list(blocks)
    low = min(x for corners in blocks for x, _ in corners)
    high = max(x for corners in blocks for x, _ in corners)
    top = max(y for corners in blocks for _, y in corners)
    scale = (WIDTH - 20) / (high - low)
    height = min(top * scale, 400.0)
    scale = min(scale, height / top)

    def place(x: float, y: float) -> str:
        return f"{10 + (x - low) * scale:.2f},{10 + height - y * scale:.2f}"

    polygons = "".join(
        f'<polygon points="{" ".join(place(*corner) for corner in corners)}" fill="{BLOCK}" fill-opacity="0.8"/>'
        for corners in blocks
    )
    return (
        f'<svg xmlns="http://www.w3.org/2000/svg" width="{WIDTH}" height="{height + 20:.0f}" role="img">'
        f"<title>{title}</title>{polygons}"
        f'<line x1="0" x2="{WIDTH}" y1="{10 + height:.2f}" y2="{10 + height:.2f}" stroke="{FLOOR}"/></svg>'
    )


def row_svg(row) -> str:
    """A row as it is set up."""
    foot, blocks = 0.0, []
    for k, domino in enumerate(row.dominoes):
        foot += domino.gap if k else 0.0
        blocks.append(block(foot, domino.height, domino.thickness, domino.lean))
        foot += domino.thickness
    return svg(blocks, repr(row))


def train_svg(train) -> str:
    """The last dominoes of a train when its head hits the next domino."""
    import ctypes

    from . import _api as api
    from ._library import lib, raise_status

    one = train.structure()
    angles = api.dom_angles()
    raise_status(lib.dom_angles_find(ctypes.byref(one), None, ctypes.byref(angles)))
    tilts = []

    @api.dom_visit
    def visit(link, context) -> bool:
        tilts.append(link.contents.theta)
        return len(tilts) < 8

    raise_status(lib.dom_chain_walk(ctypes.byref(one), None, angles.theta_c, visit, None))
    # Positions are distances from the back of the head's foot. The gap before a domino is s times the height
    # of this domino.
    blocks = [block(one.d + one.s * one.r, one.r, one.r * one.d, 0.0)]
    size, foot = 1.0, 0.0
    for tilt in tilts:
        blocks.append(block(foot, size, size * one.d, tilt))
        foot -= one.s * size + size / one.r * one.d
        size /= one.r
    return svg(blocks, repr(train))
