"""A tag that only Gazebo reads is outside a `<gazebo>` block.

Gazebo reads the robot with a URDF parser, which ignores tags that are not URDF: friction (`mu1`,
`mu2`), contact stiffness (`kp`, `kd`), `preserveFixedJoint`, sensors and plugins inside a link or
joint are lost without a message. Move the tag into `<gazebo reference="...">` with the name of the
link or joint.

Sources:
    SDFormat extensions to URDF: http://sdformat.org/tutorials?tut=sdformat_urdf_extensions
    gazebosim/gazebo-classic#3391: https://github.com/gazebosim/gazebo-classic/issues/3391
"""

from collections.abc import Iterator

from urdfkit.lint.rules import Context, Finding, Findings, Fix, Severity, rule
from urdfkit.robot.samples import element_xml, link_xml, robot_xml
from urdfkit.ros.catalog.extensions import extensions
from urdfkit.text.document import Element
from urdfkit.text.editing.edits import STEP, insert_after, insert_last, lines_of, remove_elements
from urdfkit.text.grammar import owner

BAD = link_xml("wheel", "<mu1>0.5</mu1>")
GOOD = robot_xml(link_xml("wheel"), element_xml('gazebo reference="wheel"', "<mu1>0.5</mu1>"))
FIXED = GOOD.replace('"wheel"/>', '"wheel">\n</link>')

_OF_A_LINK = '<gazebo reference="...">, with the name of a link'
#: Instead of tags that Gazebo does not read in the block either, by the element that owns them.
_INSTEAD = {
    "link": {
        "surface": "move it into <collision> in {}",
        "friction": "write <mu1> and <mu2> in {}",
        "max_contacts": "write <maxContacts> in {}",
        "laser_retro": "write <laserRetro> in {}",
    },
    "joint": {
        "surface": f"move it into <collision> in {_OF_A_LINK}",
        "friction": "write <dynamics friction=...> in the joint",
        "max_contacts": f"write <maxContacts> in {_OF_A_LINK}",
        "laser_retro": f"write <laserRetro> in {_OF_A_LINK}",
    },
}


@rule(Severity.WARNING)
def check(context: Context) -> Findings:
    misplaced = [element for element, *_ in context.deviations.get("URD008", ())]
    fixes = _fixes(context, misplaced)
    for element in misplaced:
        assert element.parent is not None
        if element.parent.tag == "mujoco":
            continue  # a <sensor> of MuJoCo
        yield Finding(
            element,
            f"{owner(element.parent)}: <{element.tag}> inside <{element.parent.tag}> is ignored",
            _help(element),
            fixes.get(element),
            group_key=f"{element.tag} in {element.parent.tag}",
            severity=Severity.INFO if _is_zero_pose(element) else None,
        )


def _fixes(context: Context, misplaced: list[Element]) -> dict[Element, Fix]:
    """The fix that moves all tags of one link or joint at once, by tag."""
    groups: dict[Element, list[Element]] = {}
    for element in misplaced:
        owner = _owner(element)
        if owner is not None and _is_for(element, owner) and element.frame is owner.frame:
            groups.setdefault(owner, []).append(element)
    fixes: dict[Element, Fix] = {}
    for owner, elements in groups.items():
        if fix := _moved(context, owner, elements):
            fixes |= dict.fromkeys(elements, fix)
    return fixes


def _is_for(element: Element, owner: Element) -> bool:
    """True if Gazebo reads a tag in the block of a link or joint."""
    extension = extensions().get(element.tag)
    return extension is not None and extension.on == owner.tag


def _moved(context: Context, owner: Element, elements: list[Element]) -> Fix | None:
    """Edits that move tags into the existing block of the owner, or into a new block after it."""
    name = owner.attributes.get("name")
    if name is None or name.written_in is not None:
        return None
    blocks = [block for block in context.model.gazebo if block.get("reference") == name.value]
    if any(block.child(element.tag) for block in blocks for element in elements):
        return None  # the block has the tag already
    removals = remove_elements(elements)
    lines = [line for element in elements for line in lines_of(element)]
    title = f'move it into <gazebo reference="{name.value}">'
    if fit := [b for b in blocks if b.frame is owner.frame and b.tag_at.source is name.span.source]:
        return Fix(title, (*removals, *insert_last(fit[0], lines)))
    block = (f'<gazebo reference="{name.span.text}">', *(STEP + line for line in lines))
    return Fix(title, (*removals, *insert_after(owner, (*block, "</gazebo>"))))


def _help(element: Element) -> str:
    if element.tag == "pose":  # an <origin> in URDF
        return "use the <origin> of the joint, or that of the shape"
    owner = _owner(element)
    name = owner.get("name") if owner else None
    extension = extensions().get(element.tag)
    if owner is None or not name:
        return "move it into a <gazebo> block"
    if element.tag == "plugin" or (extension and extension.on == "model"):
        return "move it into a <gazebo> block without a reference"
    if extension and extension.on not in (owner.tag, "any"):
        return f'move it into <gazebo reference="...">, with the name of a {extension.on}'
    block = f'<gazebo reference="{name}">'
    if element.tag in _INSTEAD[owner.tag]:
        return _INSTEAD[owner.tag][element.tag].format(block)
    return f"move it into {block}"


def _is_zero_pose(element: Element) -> bool:
    """True for a ``<pose>`` without effect."""
    words = element.text.split()
    return element.tag == "pose" and all(word.strip("+-0.") == "" for word in words)


def _owner(element: Element) -> Element | None:
    """The link or joint that contains an element."""
    owners = [ancestor for ancestor in _ancestors(element) if ancestor.tag in ("link", "joint")]
    return owners[-1] if owners else None


def _ancestors(element: Element) -> Iterator[Element]:
    while element.parent is not None:
        element = element.parent
        yield element
