"""Problems that reading a launch file meets."""

from urdfkit.lint.rules import Context, Findings, reported


def launch_problems(context: Context, code: str) -> Findings:
    """The findings of a rule; those with the same message are one, as a file may have many."""
    for finding in reported(context, code):
        yield finding._replace(group_key=finding.message)
