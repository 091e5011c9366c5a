"""An ignore comment names a rule that does not exist.

The comment suppresses nothing. `urdfkit rules` lists the codes; the beginning of a code selects
all rules that begin with it. The former code of a rule that was merged with another one still
suppresses the warnings and infos of both, but not errors; a former code is an info.
"""

from urdfkit.errors import UnknownRule
from urdfkit.lint.rule_index import ignore_note, matching
from urdfkit.lint.rules import Context, Finding, Findings, Severity, rule

BAD = """\
<robot name="r">
  <!-- urdfkit: ignore[TRE999] closed by the gripper -->
  <link name="a"/>
</robot>
"""
GOOD = BAD.replace("TRE999", "TRE003")


@rule(Severity.WARNING, needs=(), help="name a rule that exists; 'urdfkit rules' lists them")
def check(context: Context) -> Findings:
    for word, span in (code for ignore in context.ignores for code in ignore.codes):
        try:
            matching(word)
        except UnknownRule as error:
            yield Finding(span, str(error))
            continue
        if message := ignore_note(word):
            yield Finding(span, message, "write the new code", severity=Severity.INFO)
