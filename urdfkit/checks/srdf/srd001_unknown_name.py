"""The SRDF contains an unknown name.

- An unknown link, joint or group in a group, state, end effector, virtual or passive joint: MoveIt
  drops the group or state, and planning fails with "group not found" or with joints that never
  move. A warning for the group of a state if the SRDF has no groups: Pinocchio reads the state.
- An unknown link in the collision matrix (warning): "Link is not known to URDF. Cannot disable
  collisions"; the entry has no effect. Not for a link that the robot has with other arguments.
- A state that sets a joint outside its group (warning): MoveIt ignores the value.

The SRDF is out of date, or the name is misspelt.

Sources:
    SRDF: https://wiki.ros.org/srdf
    srdfdom, model.cpp: https://github.com/moveit/srdfdom/blob/ros2/src/model.cpp
    MoveIt, robot_model.cpp: https://github.com/moveit/moveit2/blob/main/moveit_core/robot_model/src/robot_model.cpp
    moveit/moveit_tutorials#728: https://github.com/moveit/moveit_tutorials/issues/728
"""

import re
from functools import cached_property

from urdfkit.checks.srdf.namesakes import has_incomplete_namesake, names_in_namesakes
from urdfkit.core.suggest import SIMILAR, Suggester, hint_for
from urdfkit.lint.misspelt_names import corrected_definition
from urdfkit.lint.rules import Context, Finding, Findings, Need, Related, Severity, rule
from urdfkit.lint.switched_off import all_sources, is_switched_off, uncalled_macro
from urdfkit.robot.samples import link_xml
from urdfkit.ros.moveit.samples import named_xml, srdf_files
from urdfkit.ros.moveit.srdf import Srdf, is_free_flyer
from urdfkit.ros.moveit.srdf_variant import names_of_namesakes
from urdfkit.text.comments import blank_comments
from urdfkit.text.document import Attribute
from urdfkit.text.editing.edits import fix_value

BAD = named_xml("bad", link_xml("forearm"))
GOOD = BAD.replace('"bad"', '"good"')
FILES = srdf_files(
    '<group name="arm"><link name="forarm"/></group>',
    '<group name="arm"><link name="forearm"/></group>',
)
FIXED_FILES = {"bad.srdf": FILES["good.srdf"].replace(b"good", b"bad", 1)}


#: A link whose name ends after an expression.
_MADE = re.compile(rb"<link\b[^<>]*?\bname\s*=\s*[\"'][^\"'<>]*[})]([^\"'<>{}()]+)[\"']")


@rule(
    Severity.ERROR,
    needs=(Need.MODEL, Need.SRDF),
    help="fix the name, or generate the SRDF for this robot",
    reports_missing=True,
)
def check(context: Context) -> Findings:
    srdf = context.required_srdf
    elsewhere = set[str]()
    if has_incomplete_namesake(context, srdf):
        elsewhere = set(srdf.unknown)
    elif srdf.unknown:
        elsewhere = names_in_namesakes(context, srdf) | names_of_namesakes(context)
    suggestions = _Suggestions(context, srdf)
    for kind, attribute in srdf.references():
        if kind != "group" and attribute.value in elsewhere:
            continue
        is_known = attribute.value in srdf.known(kind) or is_free_flyer(attribute)
        if attribute.value and not is_known:
            finding = suggestions.unknown(kind, attribute)
            yield _of_other_arguments(context, kind, attribute, finding, bool(srdf.groups))
    links = srdf.known("link") | elsewhere
    uncalled = _Uncalled(context)
    for pair in (*srdf.root.all("disable_collisions"), *srdf.root.all("enable_collisions")):
        for key in ("link1", "link2"):
            name = pair.attributes.get(key)
            if not name or name.value in links or uncalled.may_make(name.value):
                continue
            if not is_switched_off(context, name.value):
                yield suggestions.unknown("link", name)._replace(
                    help="compute the collision matrix again, or fix the name",
                    severity=Severity.WARNING,
                )
    yield from _not_in_group(context, srdf)


def _of_other_arguments(
    context: Context, kind: str, attribute: Attribute, finding: Finding, has_groups: bool
) -> Finding:
    """The finding, as a warning if it is for Pinocchio, or of the robot with other arguments."""
    if kind != "group" and (macro := uncalled_macro(context, attribute.value)):
        who = f"{kind} '{attribute.value}'"
        return finding._replace(
            message=f"{who} is in macro '{macro}', which the robot does not call",
            help="call the macro, or generate the SRDF for this robot",
            fix=None,
            group_key=macro,
        )
    if kind != "group" and is_switched_off(context, attribute.value):
        return finding._replace(
            message=f"{kind} '{attribute.value}' is inside a false condition of the robot",
            help="write a .srdf.xacro with the same argument, or pass it to the robot",
            fix=None,
        )
    is_for_pinocchio = attribute.element.tag == "group_state" and not has_groups
    return finding._replace(severity=Severity.WARNING) if is_for_pinocchio else finding


class _Uncalled:
    """The links in macros that this robot does not call, such as those of its other grippers."""

    def __init__(self, context: Context) -> None:
        self._context = context
        self._made = tuple(context.model.links_by_name)

    @cached_property
    def _ends(self) -> tuple[str, ...]:
        """What follows the expressions in their names."""
        texts = (blank_comments(source.data) for source in all_sources(self._context))
        found = {end.decode("utf-8", "replace") for text in texts for end in _MADE.findall(text)}
        return tuple(end for end in found if not any(name.endswith(end) for name in self._made))

    def may_make(self, name: str) -> bool:
        """True if another call could make a link of a name."""
        return name.endswith(self._ends)


class _Suggestions:
    """Findings about unknown names, of which the first few get a suggestion."""

    def __init__(self, context: Context, srdf: Srdf) -> None:
        self._context = context
        self._srdf = srdf
        self._number = 0

    def unknown(self, kind: str, name: Attribute) -> Finding:
        context, known = self._context, frozenset[str]()
        self._number += 1
        if self._number <= Suggester.MAX_WORDS:
            known = self._srdf.known(kind) - _siblings(name)
        suggested = Suggester(known).suggested(name.value)
        model = context.model
        defined = (model.links_by_name if kind == "link" else model.joints_by_name).get(suggested)
        fix = corrected_definition(context, defined, name.value) if kind != "group" else None
        fix = fix or fix_value(name, suggested)
        longer = [other for other in known if other.endswith(f"_{name.value}")]
        hint = Suggester(known, SIMILAR).hint(name.value)
        if not hint and len(longer) == 1:  # the prefix is forgotten
            hint = hint_for(longer[0])
        message = f"unknown {kind} '{name.value}'{hint}"
        arguments = " ".join(f"{key}:={value}" for key, value in context.arguments.items())
        related = Related(
            context.document.root.span, f"compared with this robot{arguments and ', '}{arguments}"
        )
        key = name.value if fix else kind
        return Finding(name, message, fix=fix, group_key=key, related=(related,))


def _siblings(name: Attribute) -> set[str]:
    """The other names in a group or a state, which are not suggested again."""
    parent = name.element.parent
    if parent is None or parent.tag not in ("group", "group_state"):
        return set()
    return {other.get(name.name) or "" for other in parent.all(name.element.tag)}


def _not_in_group(context: Context, srdf: Srdf) -> Findings:
    for state in srdf.states:
        group = state.get("group") or ""
        links = srdf.links_of(group)
        for element in state.all("joint") if links else ():
            joint = context.model.joints_by_name.get(element.get("name") or "")
            if joint is None or joint.child is None or joint.child_name in links:
                continue
            yield Finding(
                element,
                f"state '{state.get('name')}': joint '{joint.name}' is not in group '{group}'",
                "remove the joint from the state, or add it to the group",
                related=(Related(srdf.groups_by_name[group][0].span, "group defined here"),),
                severity=Severity.WARNING,
            )
