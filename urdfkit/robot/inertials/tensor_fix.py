"""Replacement of a tensor, and advice where it is not replaced."""

from urdfkit.robot import inertia
from urdfkit.robot.inertials.diagnosis import Diagnosis
from urdfkit.robot.inertials.link_comparison import LinkInertia
from urdfkit.robot.inertials.tensor_entries import differs, is_possible
from urdfkit.robot.inertials.tensor_text import digits
from urdfkit.robot.joint import Joint
from urdfkit.robot.joint_loads import is_effort_excessive
from urdfkit.robot.link import Tensor
from urdfkit.robot.rigid_bodies import properties_of
from urdfkit.robot.values import number
from urdfkit.text.diagnostic import Fix
from urdfkit.text.document import Attribute
from urdfkit.text.editing.edits import all_or_none, from_macro, replace_value


def advice(link: LinkInertia, diagnosis: Diagnosis) -> str:
    """Advice about a tensor, in one line; empty if the help of the rule is sufficient."""
    if diagnosis.tensor and (joint := excessive_joint(link, diagnosis.tensor)):
        return f"give it more mass first: joint '{joint.name}' has too much effort for less inertia"
    if not from_macro(link.at):
        return diagnosis.describe(link.tensor)
    where = "correct it in the macro, or in the values that it is called with"
    return f"the tensor {diagnosis.cause}; {where}" if diagnosis.cause else ""


def excessive_joint(link: LinkInertia, tensor: Tensor) -> Joint | None:
    """The joint whose effort is excessive for a new tensor of a link, but not for the present one.

    ``urdfkit simulate`` fails such a robot: a virtual link of 1 g between two joints of a hand.
    """
    joint = link.body.joint
    if joint is None or is_effort_excessive(joint, link.body.properties):
        return None
    parts = (
        own._replace(tensor=inertia.rotated(tensor, (frame @ link.inertial.origin).rotation))
        if part is link.link
        else own
        for part, frame in link.body.links
        for own in (properties_of(part, frame),)
    )
    return joint if is_effort_excessive(joint, inertia.combined(parts)) else None


def replacement(link: LinkInertia, tensor: Tensor | None) -> Fix | None:
    """A fix that replaces a tensor that is written as numbers.

    Correct entries keep their text; moved entries and entries with changed sign keep their digits.
    None if the effort of a joint is too large for the tensor, and in a macro whose mass is an
    expression: there the tensor should be one, too.
    """
    if tensor is None or _is_computed(link) or excessive_joint(link, tensor):
        return None
    changed = _changed(link, tensor)
    attributes = link.at.attributes
    edits = all_or_none(replace_value(attributes[key], text) for key, text in changed.items())
    title = " ".join(f'{key}="{text}"' for key, text in changed.items())
    return Fix.of(f"write {title}", edits)


def _is_computed(link: LinkInertia) -> bool:
    """True for a tensor in a macro whose mass is an expression."""
    mass = link.inertial.mass
    is_literal = mass is None or not isinstance(mass.at, Attribute) or mass.at.literal
    return from_macro(link.at) and not is_literal


def _changed(link: LinkInertia, tensor: Tensor) -> dict[str, str]:
    """The new texts of the wrong entries, by name."""
    texts = {key: link.at.attributes[key].value.strip() for key in Tensor._fields}
    written_as = {-old: _negated(texts[key]) for key, old in link.tensor._asdict().items()}
    written_as |= {old: texts[key] for key, old in link.tensor._asdict().items()}
    new = {
        key: (written_as.get(value) if value else None) or text
        for (key, value), text in zip(tensor._asdict().items(), digits(tensor), strict=True)
    }
    wrong = [key for key in Tensor._fields if number(texts[key]) != number(new[key])]
    worse = [key for key in wrong if new[key] in written_as.values() or differs(key, link, tensor)]
    mixed = tensor._replace(
        **{key: old for key, old in link.tensor._asdict().items() if key not in worse}
    )
    return {key: new[key] for key in (worse if is_possible(mixed) else wrong)}


def _negated(text: str) -> str:
    return text[1:] if text.startswith("-") else f"-{text.removeprefix('+')}"
