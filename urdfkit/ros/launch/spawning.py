"""The programs that put models into Gazebo, and their command lines.

Sources: ``create.cpp`` of gazebosim/ros_gz; ``spawn_entity.py`` and ``spawn_model`` of
ros-simulation/gazebo_ros_pkgs (ros2 and noetic-devel).
"""

from __future__ import annotations

import re

from urdfkit.core.record import Record
from urdfkit.ros.launch.contents import StartedProgram, Word


class Spawner(Record):
    """A program that puts models into Gazebo.

    Attributes:
        valued, plain: its options with and without a value.
        required: groups of options, of each of which one must be there.
        is_strict: True if it stops at other options; else it ignores them.
    """

    valued: frozenset[str]
    plain: frozenset[str]
    required: tuple[tuple[str, ...], ...]
    is_strict: bool = True

    @property
    def known(self) -> frozenset[str]:
        """All its options."""
        return self.valued | self.plain


_POSE = "x y z R P Y"
_CREATE = Spawner(
    frozenset(f"world file param string topic name flagfile {_POSE}".split()),
    frozenset(("allow_renaming", "noallow_renaming", "stdin", "help")),
    (("file", "param", "string", "topic", "stdin"),),
    is_strict=False,
)
_ENTITY = Spawner(
    frozenset(
        "file topic database entity reference_frame gazebo_namespace robot_namespace timeout wait "
        f"spawn_service_timeout {_POSE}".split()
    ),
    frozenset("stdin unpause package_to_model b h help".split()),
    (("entity",), ("file", "topic", "database", "stdin")),
)
_MODEL = Spawner(
    frozenset(
        "file param database model reference_frame gazebo_namespace robot_namespace wait J "
        f"{_POSE}".split()
    ),
    frozenset("urdf sdf stdin unpause package_to_model b h help".split()),
    (("model",), ("urdf", "sdf"), ("file", "param", "database", "stdin")),
)
#: By package and executable.
SPAWNERS = {
    ("ros_gz_sim", "create"): _CREATE,
    ("ros_ign_gazebo", "create"): _CREATE,
    ("gazebo_ros", "spawn_entity.py"): _ENTITY,
    ("gazebo_ros", "spawn_model"): _MODEL,
}
_NUMBER = re.compile(r"-[\d.]")


def options(started: StartedProgram, spawner: Spawner) -> tuple[dict[str, Word], bool]:
    """The options, with the words of their values; False if there may be others."""
    given: dict[str, Word] = {}
    is_known = True
    words = iter(started.words)
    for word in words:
        text = word.text
        if text is None or not text.startswith("-") or _NUMBER.match(text):
            is_known = is_known and text is not None
            continue
        if text.startswith("--ros-args"):
            break
        option, _, value = text.lstrip("-").partition("=")
        if not spawner.is_strict:
            option = option.replace("-", "_")  # gflags takes both
        given[option] = Word(value, word.span) if value else word
        if option in spawner.valued and not value:
            given[option] = next(words, word)
    return given, is_known
