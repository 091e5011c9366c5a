"""An ignore comment suppresses nothing.

The defect is fixed, the comment is above another element, or it names no rule in brackets. An
unused comment would hide the next defect there: delete it.
"""

from urdfkit.lint.rule_index import codes_of, get
from urdfkit.lint.rules import Context, Finding, Findings, Fix, Severity, rule
from urdfkit.text.editing.edits import remove_spans

BAD = """\
<robot name="r">
  <!-- urdfkit: ignore[TRE003] closed by the gripper -->
  <link name="a"/>
</robot>
"""
GOOD = BAD.replace("urdfkit: ignore[TRE003] ", "")
FIXED = BAD.replace("  <!-- urdfkit: ignore[TRE003] closed by the gripper -->\n", "")


@rule(Severity.WARNING, needs=(), help="delete the comment")
def check(context: Context) -> Findings:
    from urdfkit.lint.suppress import apply_suppressions

    hits = apply_suppressions(context.run.diagnostics, context.ignores).hits
    chosen = context.run.chosen
    for ignore in context.ignores:
        codes = [code for code, _ in ignore.codes]
        if not codes:
            help = "write urdfkit: ignore[CODE], with the codes of rules in brackets"
            yield Finding(ignore.span, "ignore comment without a rule", help)
        elif ignore.span not in hits and (chosen is None or _ran(codes, chosen)):
            place = ignore.span
            # Another robot that includes the file may need the comment.
            is_own = ignore.span.source is context.source
            fix = Fix("delete the comment", remove_spans([ignore.span])) if is_own else None
            message = f"unused ignore comment: no finding of {', '.join(codes)} here"
            yield Finding(place, message, fix=fix)


def _ran(words: list[str], chosen: frozenset[str]) -> bool:
    """True if every rule that the comment names surely ran; unknown ones are CFG002's."""
    from urdfkit.errors import UnknownRule

    try:
        return all(_has_run(codes_of(word), chosen) for word in words)
    except UnknownRule:  # removed
        return False


def _has_run(codes: list[str], chosen: frozenset[str]) -> bool:
    return bool(codes) and all(code in chosen and not get(code).preview for code in codes)
