"""The friction of mecanum wheels in Gazebo, which stands for their rollers.

A wheel grips along the axis of the roller that touches the ground, `fdir1` with `mu1`, and slides
across it, with `mu2`. MecanumDrive and mecanum_drive_controller turn the wheel at (x, y) by
``vx - vy - (x + y) wz`` if x y > 0, else by ``vx + vy + (x - y) wz``: its grip is along (1, -1),
else (1, 1).

Source: ``MecanumDrive.cc`` and ``examples/worlds/mecanum_drive.sdf`` of gz-sim.
"""

from __future__ import annotations

from collections.abc import Mapping

from urdfkit.core.record import Record
from urdfkit.core.spatial import IDENTITY
from urdfkit.lint.context import Context
from urdfkit.lint.rules import Finding, Findings
from urdfkit.robot.placed import Placed
from urdfkit.ros.gazebo.values import text_of
from urdfkit.text.document import Element

_WHEELS = 4
#: The coefficients of a wheel, along ``fdir1`` and across it.
_KEYS = ("mu1", "mu2")
#: Ratio of two coefficients from which a wheel slides in one direction.
_UNEQUAL = 1.5
_RIGHT = "write 1 -1 0 for front left and rear right, 1 1 0 for the others"


class Roller(Record):
    """The rollers of a wheel."""

    link: str
    direction: Element  # fdir1 in the frame of the body
    body: str  # the link of that frame
    friction: Mapping[str, Placed[float]]  # mu1 and mu2, as far as they are given

    @property
    def is_isotropic(self) -> bool:
        """True if both coefficients are given, and much the same."""
        values = sorted(one.value for one in self.friction.values())
        return len(values) == 2 and 0 < values[1] <= _UNEQUAL * values[0]

    @property
    def grips_forwards_left(self) -> bool | None:
        """True for a grip along (1, 1), False along (1, -1); None along any other line."""
        try:
            x, y, _ = map(float, text_of(self.direction).split())
        except ValueError:
            return None
        mu1, mu2 = (self.friction[key].value if key in self.friction else 1.0 for key in _KEYS)
        return None if abs(abs(x) - abs(y)) > 0.01 or not x else (x * y > 0) == (mu1 >= mu2)


def wrong_rollers(context: Context, rollers: list[Roller]) -> Findings:
    """Wheels of a mecanum drive that do not let the robot move sideways as commanded."""
    if len(rollers) != _WHEELS:
        return
    first = rollers[0].direction
    if all(roller.is_isotropic for roller in rollers):
        for roller in rollers:
            mu1, mu2 = (roller.friction[key] for key in _KEYS)
            yield Finding(
                mu2,
                f"mecanum wheel '{roller.link}' has a friction coefficient of {mu2.value:g} across "
                f"<fdir1>, and {mu1.value:g} along it: it does not roll sideways",
                "write <mu2>0</mu2>",
            )
    elif len({tuple(text_of(roller.direction).split()) for roller in rollers}) == 1:
        yield Finding(
            first,
            f"the four mecanum wheels have the same <fdir1>, {text_of(first)}: the robot cannot "
            "move sideways or turn",
            _RIGHT,
        )
    elif all(_is_mirrored(context, rollers, roller) for roller in rollers):
        yield Finding(
            first,
            f"<fdir1> of the four mecanum wheels is mirrored, as {text_of(first)} of "
            f"'{rollers[0].link}': the robot moves to the right instead of to the left",
            _RIGHT,
        )


def _is_mirrored(context: Context, rollers: list[Roller], roller: Roller) -> bool:
    """True if a wheel grips along the other diagonal than its corner demands."""
    frames = context.tree.frames
    places = [frames[one.link].position for one in rollers if one.link in frames]
    body = frames.get(roller.body)
    grip = roller.grips_forwards_left
    if len(places) < _WHEELS or body is None or body.rotation != IDENTITY or grip is None:
        return False
    x, y = (
        frames[roller.link].position[axis] - sum(place[axis] for place in places) / _WHEELS
        for axis in (0, 1)
    )
    return abs(x * y) > 1e-6 and grip == (x * y > 0)
