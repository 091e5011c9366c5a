"""Which findings mean that libsdformat rejects a robot as a whole, and Gazebo has none of it.

Source: libsdformat 12.3 on robots with one defect each. It reads URDF by urdfdom: a defect in a
joint rejects the robot, one in a link loses but that part of the link.
"""

from __future__ import annotations

from collections.abc import Iterable

from urdfkit.text.diagnostic import Diagnostic, Severity

#: In the messages of rules that have milder findings, too.
REJECTED, REJECTED_BY_GZ = "Gazebo rejects the model", "gz-sim rejects the model"

#: Rules whose findings reject the robot.
ALWAYS = frozenset("JNT001 JNT002 NAM001 REF001 TRE001 TRE002 TRE003 URD015".split())
#: Rules with findings that reject the robot, as their messages say.
SOMETIMES = frozenset("GAZ004 GAZ010 GAZ040 GAZ047".split())
#: Rules whose findings reject the robot where they are about a joint.
IN_JOINTS = frozenset("URD003 URD004 URD005".split())
#: Errors that reject the robot where they are about its root element.
OF_ROOT = frozenset("URD003 URD011".split())
#: Rules that also report what rejects nothing: only their errors count.
_ONLY_ERRORS = frozenset(("JNT002", "JNT006"))
#: What the reader of SDF rejects after the conversion: that of gz, not that of Gazebo Classic.
BY_GZ = frozenset(("JNT006",))

CODES = ALWAYS | SOMETIMES | IN_JOINTS | OF_ROOT | BY_GZ


def rejecting(diagnostics: Iterable[Diagnostic]) -> list[tuple[str, Diagnostic]]:
    """The findings for which a robot is rejected, each with who rejects it."""
    found = []
    for one in diagnostics:
        if one.code in _ONLY_ERRORS and one.severity is not Severity.ERROR:
            continue
        says = one.message if one.code in SOMETIMES else ""
        in_joint = any(call.element.startswith("joint/") for call in one.calls)
        of_root = one.severity is Severity.ERROR and any("/" not in c.element for c in one.calls)
        if (
            one.code in ALWAYS
            or (one.code in IN_JOINTS and in_joint)
            or (one.code in OF_ROOT and of_root)
            or REJECTED in says
        ):
            found.append(("libsdformat", one))
        elif one.code in BY_GZ or REJECTED_BY_GZ in says:
            found.append(("gz", one))
    return found
