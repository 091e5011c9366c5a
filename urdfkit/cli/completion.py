"""``urdfkit completion``, and completion of values that click cannot complete."""

from __future__ import annotations

import os
from collections.abc import Callable, Iterable
from typing import TYPE_CHECKING, TypeAlias

import click
from click.shell_completion import (
    CompletionItem,
    ShellComplete,
    add_completion_class,
    get_completion_class,
)

from urdfkit.cli import options
from urdfkit.cli.decorators import described
from urdfkit.errors import UrdfkitError

if TYPE_CHECKING:
    from urdfkit.lint.context import Context

SHELLS = ("bash", "zsh", "fish")
#: Environment variable of completion requests; click derives it from the program name.
VARIABLE = "_URDFKIT_COMPLETE"

#: Returns the values of an option for the words before it.
_Values: TypeAlias = "Callable[[list[str]], Iterable[str]]"


@described("completion")
@click.argument("shell", type=click.Choice(SHELLS))
def command(shell: str) -> int:
    """Print a completion script for a shell.

    It completes options, targets, codes, formats, views, links, joints and elements of the robot
    on the command line, and file names.

    Exit codes: 0 done, 2 usage error.

    Examples:
        urdfkit completion bash > ~/.local/share/bash-completion/completions/urdfkit
        urdfkit completion fish > ~/.config/fish/completions/urdfkit.fish
    """
    kind = get_completion_class(shell)
    assert kind is not None
    program = click.get_current_context().find_root().command
    click.echo(kind(program, {}, "urdfkit", VARIABLE).source())
    return 0


def register() -> None:
    """Let click complete the values of options, and file names by default."""
    for shell in SHELLS:
        kind = get_completion_class(shell)
        assert kind is not None
        add_completion_class(type(f"{shell}_values", (_WithValues, kind), {}), shell)


class _WithValues(ShellComplete):
    def get_completions(self, args: list[str], incomplete: str) -> list[CompletionItem]:
        return super().get_completions(args, incomplete) or completed(args, incomplete)


def completed(words: list[str], incomplete: str) -> list[CompletionItem]:
    """The completions of a word.

    Args:
        words: the words before it, without the program name.
    """
    values = _OF_OPTIONS.get(words[-1]) if words else None
    if words[:1] == ["explain"]:
        values = _codes
    elif words[:1] == ["trace"] and os.path.isfile(words[-1]):
        values = _elements
    if values is None:
        return [CompletionItem(incomplete, type="file")]
    complete, comma, last = incomplete.rpartition(",")
    try:
        matches = [value for value in values(words) if value.startswith(last)]
    except (ImportError, UrdfkitError):  # no readable robot, or an extra is missing
        return []
    return [CompletionItem(complete + comma + value) for value in matches]


def _targets(_: list[str]) -> Iterable[str]:
    from urdfkit.ros.targets import TARGETS

    return TARGETS


def _codes(_: list[str]) -> Iterable[str]:
    from urdfkit.lint import rule_index

    return rule_index.codes()


def _formats(_: list[str]) -> Iterable[str]:
    from urdfkit.output import formats

    return formats.names()


def _links(words: list[str]) -> Iterable[str]:
    return sorted(_robot(words).model.links_by_name)


def _joints(words: list[str]) -> Iterable[str]:
    """The joints that can be moved: not those that are fixed or follow others."""
    joints = _robot(words).model.joints_by_name
    return sorted(name for name, joint in joints.items() if joint.is_single_dof and not joint.mimic)


def _elements(words: list[str]) -> Iterable[str]:
    return dict.fromkeys(element.path for element in _robot(words).document.root.children)


def _positions(words: list[str]) -> Iterable[str]:
    return (f"{name}=" for name in _joints(words))


def _robot(words: list[str]) -> Context:
    """The robot of a command line.

    Raises:
        UrdfkitError: there is no robot, or it cannot be read.
    """
    from urdfkit.lint.loading import read

    values = {options.FILES: words}
    file = next((word for word in words[1:] if os.path.isfile(word)), "")
    return read(file, arguments=options.arguments(values))


def _views(_: list[str]) -> Iterable[str]:
    from urdfkit.render.camera import VIEWS

    return (*VIEWS, "all")


def _layers(_: list[str]) -> Iterable[str]:
    from urdfkit.render.layers import LAYERS

    return ("visual", "collision", *LAYERS)


_OF_OPTIONS: dict[str, _Values] = {
    "--contact": _links,
    "--format": _formats,
    "--ignore": _codes,
    "--jacobian": _links,
    "--joint": _positions,
    "--layers": _layers,
    "--link": _links,
    "--select": _codes,
    "--sweep": _joints,
    "--target": _targets,
    "--transform": _links,
    "--view": _views,
}
