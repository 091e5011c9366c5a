"""The robot asks for a version of URDF that older readers refuse.

Version 1.1 brought capsules and quaternions, 1.2 more joint limits. urdfdom 6 reads them; urdfdom
3.0.1, which Debian 12 has, refuses the whole robot. Keep to 1.0 unless the robot needs more and all
your programs read it.

Sources:
    urdfdom, model.cpp: https://github.com/ros/urdfdom/blob/rolling/urdf_parser/src/model.cpp
    ros/urdfdom#238: https://github.com/ros/urdfdom/issues/238
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from urdfkit.lint.rules import Finding, rule
from urdfkit.text.diagnostic import Severity

if TYPE_CHECKING:
    from urdfkit.lint.context import Subject

BAD = '<robot name="cart" version="1.2">\n  <link name="base"/>\n</robot>\n'
GOOD = BAD.replace("1.2", "1.0")


@rule(
    "URD014",
    "newer-version",
    Severity.WARNING,
    help='write version="1.0" unless the robot needs more',
)
def check(subject: Subject) -> Iterator[Finding]:
    for _, attribute, *_ in subject.deviations.get("URD014", ()):
        assert attribute is not None
        yield Finding(attribute, f"version {attribute.value} of URDF is refused by older readers")
