"""Names of parameters that a node of Nav2 or slam_toolbox does not have, or lacks."""

from urdfkit.core.suggest import CLOSE_TYPO, is_typo, nearest
from urdfkit.lint.rules import Finding, Findings, Severity
from urdfkit.ros.catalog import data
from urdfkit.ros.launch.known_parameters import GivenValue, given_values
from urdfkit.ros.launch.node_parameters import NodeParameters
from urdfkit.text.located_yaml import Value

#: Letters of words that are not typos of each other.
_SHORT = 3


def misspelt(node: NodeParameters) -> Findings:
    """Parameters that the node ignores, and that are one letter away from one that it reads."""
    for given in given_values(node):
        if suggested := _meant(given):
            yield Finding(
                given.at.span,
                f"'{node.name}': unknown parameter '{given.at}'; did you mean '{suggested}'?",
                f"write {suggested}",
                severity=Severity.WARNING,
            )


def _meant(given: GivenValue) -> str | None:
    names = {name.rpartition(".")[2] for name in given.known}
    if given.at in names or not isinstance(given.value, Value | list):
        return None
    suggested = nearest(given.at, names, CLOSE_TYPO) or next(
        (name for name in names if len(name) > 4 and is_typo(given.at, name)), None
    )
    is_other = suggested in given.siblings or (suggested and _is_of_other_axis(given.at, suggested))
    return None if is_other else suggested


def _is_of_other_axis(name: str, other: str) -> bool:
    """True for ``az_max`` and ``ay_max``, which differ in a short word."""
    pairs = zip(name.split("_"), other.split("_"), strict=False)
    return any(word != known and len(word) <= _SHORT >= len(known) for word, known in pairs)


def missing(node: NodeParameters) -> Findings:
    """Parameters without which the node does not start; only if it has others."""
    required: dict[str, str] = data("node_parameters")["required"].get(node.name, {})
    for name, since in required.items():
        if name not in node.values and len(node.values) > 1:
            yield Finding(
                node.at,
                f"'{node.name}' of {since} stops: parameter '{name}' is not given",
                f"add {name}",
                severity=Severity.WARNING,
            )
