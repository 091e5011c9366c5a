"""What a glance at a model tells: the rules that cannot have anything to say about it.

Most robots are sound trees with plain names, and importing a rule costs more than running it.
The answers here are cautious: a rule that is not named as silent may still find nothing.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from urdfkit.model import RobotModel
    from urdfkit.tree import KinematicTree

#: Silent if links and joints form one tree.
ABOUT_TREES = frozenset("NAM001 NAM002 REF001 TRE001 TRE002 TRE003 TRE004 TRE006".split())

#: Silent if every name is plain.
ABOUT_NAMES = frozenset("NAM003 NAM004 NAM005 NAM007 NAM008 NAM010".split())


def silent(model: RobotModel, tree: KinematicTree) -> set[str]:
    """The codes of rules that need not be imported for a model."""
    codes: set[str] = set()
    if tree.is_sound:
        codes |= ABOUT_TREES
    if _names_are_plain(model):
        codes |= ABOUT_NAMES
    if len(model.materials) < 2:
        codes.add("NAM006")
    if not any(body.material for link in model.links for body in link.visuals):
        codes |= {"NAM009", "REF003"}
    if not any(joint.mimic for joint in model.joints):
        codes.add("REF004")
    if not any(joint.kind == "fixed" and joint.at.child("axis") for joint in model.joints):
        codes.add("JNT020")
    if not any(name.endswith("base_footprint") for name in model.links_by_name):
        codes.add("TRE008")
    if len(model.joints) < 1000:
        codes.add("TRE009")
    return codes


def _names_are_plain(model: RobotModel) -> bool:
    """True if no joint is named as a link, and all names are such as ``wheel_2-tyre``."""
    links = model.links_by_name
    return not any(joint.name in links for joint in model.joints) and all(
        name.value.isascii()
        and name.value[:1].isalpha()
        and name.value.replace("-", "_").isidentifier()
        and name.value != "world"
        for name in model.names
    )
