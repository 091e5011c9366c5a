"""A macro is called without the `xacro:` prefix.

xacro copies the element unchanged, without a message. The links of the macro are then missing, and
the next program reports an unknown parent link, or nothing at all. Write `<xacro:name .../>`.

Sources:
    xacro: https://wiki.ros.org/xacro
    measured: 6 of 676 public models lack links because of it
"""

from urdfkit.lint.rules import Context, Finding, Findings, Fix, Need, Severity, rule
from urdfkit.robot.samples import element_xml, joint_xml, xacro_xml
from urdfkit.text import schema
from urdfkit.text.document import Element
from urdfkit.text.editing.edits import rename_element

BAD = xacro_xml(
    element_xml(
        'xacro:macro name="arm" params="side"',
        '<link name="${side}_arm"/>',
        joint_xml("fixed", name="${side}", child="${side}_arm"),
    ),
    '<link name="base"/>',
    '<arm side="left"/>',
)
FIXED = GOOD = BAD.replace("<arm", "<xacro:arm")


@rule(
    Severity.ERROR,
    needs=(Need.XACRO, Need.MODEL),
    help="write the tag, and its end tag, with the prefix: <xacro:...>",
    hides_parts=("",),
)
def check(context: Context) -> Findings:
    # <robot> is not a call, even if a macro has this name.
    macros = {macro.name for macro in context.xacro.macros} - {"robot"}
    stack = [(context.document.root, schema.ROBOT)]
    while stack:
        element, grammar = stack.pop()
        for child in element.children:
            if inner := grammar.children.get(child.tag):
                if not inner.open:
                    stack.append((child, inner))
            elif child.tag in macros:
                message = f"macro '{child.tag}' is called without the xacro: prefix"
                yield Finding(child, message, fix=_fix(child))
            elif schema.XACRO_TAGS.get(child.tag) in child.attributes:  # else it is of others
                message = f"<{child.tag}> is a tag of xacro without its prefix"
                yield Finding(child, message, fix=_fix(child))


def _fix(element: Element) -> Fix | None:
    edits = rename_element(element, f"xacro:{element.tag}")
    return Fix.of(f"write <xacro:{element.tag}>", edits)
