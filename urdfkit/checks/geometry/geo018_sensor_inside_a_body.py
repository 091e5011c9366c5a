"""A lidar or a camera is inside the body of the robot.

All around it, and wherever it looks, is the visual of another link that is fixed to it, further
away than the housing of a sensor is thick: a simulated lidar measures the walls about it, a camera
sees them or what a renderer makes of their backs, and a real one has a frame in TF where it cannot
be. The origin of a joint was left at zero, has a wrong sign, or ends at the wrong edge of the
body. Sensors are those of `<gazebo>`, with their least distance and their angles, and links that
are called laser, lidar or camera.

Sources:
    gazebosim/gazebo-classic#1564: https://github.com/gazebosim/gazebo-classic/issues/1564
    REP 103, axes of cameras: https://www.ros.org/reps/rep-0103.html
    measured: of 671 public robots one has it, 0.5 mm deep.
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from urdfkit.core.spatial import Transform, Vector, rotate
from urdfkit.lint.rules import Finding, Need, rule
from urdfkit.robot.assets.point_containment import PointContainment
from urdfkit.robot.shapes import AXES
from urdfkit.ros.gazebo.optical_sensors import OpticalSensor, kind_of, optical_sensors
from urdfkit.text.diagnostic import Confidence, Related, Severity

if TYPE_CHECKING:
    from urdfkit.lint.context import Subject
    from urdfkit.robot.model import Body, Joint, Link
    from urdfkit.robot.rigid_bodies import RigidBody

BAD = """\
<link name="base">
  <visual>
    <geometry><box size="0.4 0.3 0.2"/></geometry>
  </visual>
</link>
<link name="laser"/>
<joint name="laser_joint" type="fixed">
  <parent link="base"/>
  <child link="laser"/>
  <origin xyz="0.1 0 0"/>
</joint>"""
GOOD = BAD.replace("0.1 0 0", "0.1 0 0.15")

#: What is nearer, in m, may be the housing of a sensor that only its name gives away.
_HOUSING = {"lidar": 0.04, "camera": 0.05}

#: The same where a `<sensor>` says from which distance on it sees.
_THIN = 0.02


#: A sensor that stands on a body may be so deep in it, in m.
_SKIN = 0.002


@rule(
    "GEO018",
    "sensor-inside-a-body",
    Severity.WARNING,
    needs=(Need.MODEL, Need.MESHES),
    help="measure its place from the origin of the parent link: forward, left and up, in m",
)
def check(subject: Subject) -> Iterator[Finding]:
    reported: set[str] = set()
    for eye in optical_sensors(subject.model):
        body = subject.masses.body_of.get(eye.link)
        joint = _mounting(subject, eye, body) if body else None
        around = _around(subject, eye, body) if body and joint else None
        if joint is None or around is None or joint.name in reported:
            continue
        reported.add(joint.name)
        shape, link, depth = around
        yield Finding(
            joint.at.child("origin") or joint.at,
            f"{eye.who} is inside link '{link.name}', {depth:.2g} m behind the walls of its "
            f"{shape.at.tag}",
            related=(Related(shape.at.span, f"the {shape.at.tag} of '{link.name}'"),),
            confidence=Confidence.INFERRED,
            weight=depth,
        )


def _mounting(subject: Subject, eye: OpticalSensor, body: RigidBody) -> Joint | None:
    """The joint that holds the sensor on the body: above it are other parts of the sensor."""
    found, name = None, eye.link
    for _ in body.links[1:]:
        above = next(iter(subject.tree.parents[name]), None)
        if above is None or above.kind != "fixed" or above.parent is None:
            break
        found, name = above, above.parent.value
        if not kind_of(name):
            break
    return found


def _around(
    subject: Subject, eye: OpticalSensor, body: RigidBody
) -> tuple[Body, Link, float] | None:
    """The shape around a sensor, its link, and how far away it is in the middle."""
    frames = {link.name: frame for link, frame in body.links}
    place = frames[eye.link] @ eye.frame
    least = max(_HOUSING[eye.kind] if not eye.type else _THIN, eye.least)
    for link, frame in body.links:
        if kind_of(link.name):
            continue
        there = frame.inverse @ place
        ahead, aside = (_turned(there, ways) for ways in (eye.directions, _ASIDE[eye.kind]))
        for bodies in (link.visuals, link.collisions if eye.type == "ray" else ()):
            enclosure = PointContainment(bodies, subject.lump, subject.meshes)
            walls = enclosure.depths(there.position, ahead + aside, eye.least, least)
            # Nobody knows which way a camera looks that only its name gives away.
            is_blunt = eye.kind == "camera" and not eye.type
            depth = min(walls) if is_blunt else sorted(walls[: len(ahead)])[len(ahead) // 2]
            if min(walls) > _SKIN and depth > least:
                return bodies[0], link, depth
    return None


#: Where else there must be a wall, so that it is not merely before the sensor.
_ASIDE: dict[str, list[Vector]] = {
    "lidar": [(0.0, 0.0, 1.0), (0.0, 0.0, -1.0)],
    "camera": [*AXES[1:], (-1.0, 0.0, 0.0), (0.0, -1.0, 0.0), (0.0, 0.0, -1.0)],
}


def _turned(frame: Transform, ways: list[Vector]) -> list[Vector]:
    return [rotate(frame.rotation, way) for way in ways]
