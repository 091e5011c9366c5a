"""Robots for other libraries: with xacro expanded and packages found, which they cannot do."""

from __future__ import annotations

from io import BytesIO
from typing import TYPE_CHECKING, Any

from urdfkit.errors import MissingLibrary, UnreadableRobot

if TYPE_CHECKING:
    from yourdfpy import URDF

    from urdfkit.subject import Subject


def to_yourdfpy(robot: Subject, **options: Any) -> URDF:
    """The robot as yourdfpy has it: a scene of trimesh with forward kinematics.

    yourdfpy reads plain URDF and looks for packages around the file only; here xacro is expanded,
    and meshes are looked for wherever urdfkit finds them.

    Args:
        robot: as `urdfkit.read` gives it.
        options: for ``yourdfpy.URDF.load``, such as ``load_meshes=False``.

    Raises:
        MissingLibrary: yourdfpy is not installed.
        UnreadableRobot: yourdfpy does not get through it; ``urdfkit.check`` says why.
    """
    try:
        from yourdfpy import URDF
    except ImportError as error:
        raise MissingLibrary("this needs yourdfpy: pip install 'urdfkit[exchange]'") from error

    def found(fname: str) -> str:
        return robot.resolver.locate(fname, robot.source.path).path or fname

    try:
        urdf: URDF = URDF.load(BytesIO(robot.text), filename_handler=found, **options)
    except Exception as error:  # whatever a defect of a robot leads to there
        raise UnreadableRobot(f"yourdfpy cannot read {robot.source.path}: {error}") from error
    return urdf
