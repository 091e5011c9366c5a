"""``urdfkit importers``: what simulators and dynamics libraries make of a robot."""

import csv
from collections.abc import Iterable, Iterator
from io import StringIO
from itertools import groupby
from typing import Any

from urdfkit.cli import gazebo, output
from urdfkit.cli.decorators import described, in_formats, option
from urdfkit.cli.options import UsageError, words
from urdfkit.cli.robot import check_options, one_robot, only_file, robot
from urdfkit.core.words import counted
from urdfkit.lint.context import Context
from urdfkit.lint.engine import check
from urdfkit.ros.importers.changes import changes
from urdfkit.ros.importers.facts import GAZEBO, IMPORTERS, ImporterFacts, UnknownImporter, chosen
from urdfkit.ros.importers.imported import Imported, ImportedBody, ImportedJoint
from urdfkit.ros.importers.index_map import IndexMap, index_map
from urdfkit.text.diagnostic import Diagnostic, Severity
from urdfkit.text.source import Span, shown

VERSION = 1

#: Rules about the graph of links and joints, for programs that are not targets.
STRUCTURE = ("JNT001", "NAM001", "REF001", "TRE")


@described("importers")
@one_robot
@option("--for NAMES", "Programs. [default: all]", to="names", multiple=True)
@option("--map FROM:TO", "Indices of FROM in the order of TO.", to="pair")
@in_formats("text", "json", "csv")
def command(asked: dict[str, Any], names: tuple[str, ...], pair: str | None, form: str) -> int:
    """Show what simulators make of a robot.

    The programs are drake, gazebo, genesis, isaac (Isaac Lab, which merges fixed joints),
    isaac-sim (Isaac Sim's importer, which does not), mujoco, newton, pinocchio, pybullet and
    yourdfpy; none need be installed. Errors that a program stops at come first.

    Exit codes: 0 done, 2 the file cannot be read, or two programs have different joints.

    Examples:
        urdfkit importers robot.urdf.xacro
        urdfkit importers robot.urdf.xacro --for mujoco,pinocchio
        urdfkit importers robot.urdf.xacro --map isaac:mujoco
    """
    asked_for = words({"for": names}, "for")
    if pair is not None:
        return _map(asked, asked_for, pair, form)
    if form == "csv" and not asked_for:
        raise UsageError("--format csv needs --for or --map")
    if GAZEBO in asked_for:
        if len(set(asked_for)) > 1 or form == "csv":
            raise UsageError("--for gazebo stands alone, as text or JSON")
        return gazebo.show(robot(asked), form, old=False)
    facts = chosen(asked_for or IMPORTERS)
    context = robot(asked)
    robots = [context.imported(one.name) for one in facts]
    if form == "csv":
        output.write("".join(_csv(robots)))
        return 0
    errors = {one.name: _errors(asked, context, one) for one in facts} if asked_for else {}
    lines = _reports(robots, errors) if asked_for else _overview(robots)
    output.json_or_page(form, lambda: _as_json(robots, errors), lines)
    return 0


def _map(asked: dict[str, Any], names: list[str], pair: str, form: str) -> int:
    source, colon, target = pair.partition(":")
    if names:
        raise UsageError("--map names its programs itself; leave --for out")
    if not (colon and source and target):
        raise UsageError(f"--map {pair}: expected FROM:TO, such as isaac:mujoco")
    if GAZEBO in (source, target):
        raise UsageError(f"--map {pair}: gazebo finds joints by name, and has no order of them")
    try:
        chosen((source, target))
    except UnknownImporter as error:
        raise UsageError(f"--map {pair}: {error}") from error
    context = robot(asked)
    found = index_map(context.imported(source), context.imported(target))
    if form == "csv":
        output.write("".join(_map_csv(found)))
    else:
        output.json_or_page(form, lambda: _map_as_json(found), [_map_line(found)])
    return 0


def _errors(asked: dict[str, Any], context: Context, facts: ImporterFacts) -> list[Diagnostic]:
    """The errors of a check for a program; only those of the tree if it is not a target."""
    options = check_options(asked, only_file(asked))
    if facts.target:
        options = options._replace(targets=(facts.target,))
    else:
        options = options._replace(select=STRUCTURE)
    report = check(context.source, options=options)
    return [one for one in report.diagnostics if one.severity is Severity.ERROR]


def _place(span: Span) -> str:
    return f"{shown(span.source.path)}:{span.line}"


def _overview(robots: list[Imported]) -> Iterator[str]:
    """A row for each program, followed by the joint orders that differ."""
    model = robots[0].tree.model
    yield f"{counted(len(model.links), 'link')}, {model.mass:g} kg, as programs import them:"
    yield ""
    rows = [(" program   ", f"{'bodies':>6} {'mass / kg':>10} {'DoF':>4}  order  root")]
    orders: dict[tuple[str, ...], str] = {}
    for one in robots:
        order = tuple(joint.joint.name for joint in one.joints)
        letter = orders.setdefault(order, _letter(len(orders)))
        row = f"{len(_moving(one)):>6} {_total(one):>10} {_freedom(one):>4}  {letter:<5}  "
        rows.append((f" {one.facts.name}", row + _root(one)))
    yield from output.two_columns(rows)
    yield ""
    for order, letter in orders.items():
        yield from output.indented(", ".join(order) or "no joints", f"{letter}: ", "   ")


def _letter(number: int) -> str:
    return chr(ord("A") + number)


def _moving(one: Imported) -> list[ImportedBody]:
    world = one.facts.merges_into_world
    return [body for body in one.bodies if not (world and body.name == "world")]


def _total(one: Imported) -> str:
    masses = [body.mass for body in _moving(one)]
    known = [mass for mass in masses if mass is not None]
    return f"{sum(known):.4g}" if len(known) == len(masses) else "?"


def _kilograms(one: Imported) -> str:
    total = _total(one)
    return "of unknown mass" if total == "?" else f"{total} kg"


def _freedom(one: Imported) -> int:
    return sum(joint.nv for joint in one.joints)


def _root(one: Imported) -> str:
    if one.root_is_free is None:
        return "welded or free"
    return "free" if one.root_is_free else "welded"


def _reports(robots: list[Imported], errors: dict[str, list[Diagnostic]]) -> Iterator[str]:
    for number, one in enumerate(robots):
        if number:
            yield ""
        yield from _report(one, errors[one.facts.name])


def _report(one: Imported, errors: list[Diagnostic]) -> Iterator[str]:
    facts = one.facts
    if errors:
        flag = f" --target {facts.target}" if facts.target else ""
        yield f"{facts.title} may reject this robot: 'urdfkit check{flag}' reports"
        for error in errors:
            text = f"{_place(error.span)}: {error.message} ({error.code})"
            yield from output.indented(text)
        yield "Without these errors:"
        yield ""
    number = len(_moving(one))
    yield from output.wrapped(
        f"{facts.title}: {counted(len(one.tree.model.links), 'link')} become "
        f"{number} {'body' if number == 1 else 'bodies'}, {_kilograms(one)}; {_about_root(one)}"
    )
    yield from _changes(one)
    yield ""
    yield from _joints(one)


def _about_root(one: Imported) -> str:
    how = one.facts.about_root
    what = "the root is " + ("welded to the world" if one.root_is_free is False else "free")
    if one.root_is_free is None:
        return how
    return f"{what} ({how})" if how else what


def _changes(one: Imported) -> Iterator[str]:
    """The changes, grouped by file."""
    for path, group in groupby(changes(one), key=lambda change: change.at.span.source.path):
        yield ""
        yield shown(path)
        for change in group:
            yield from output.indented(change.text, f"  {change.at.span.line:>4}  ", " " * 8)


def _joints(one: Imported) -> Iterator[str]:
    rows = [("    q    v  joint", "  type")]
    rows += (
        (f"{joint.q:>5}{joint.v:>5}  {', '.join(joint.names)}", f"  {joint.joint.kind}")
        for joint in one.joints
    )
    yield from output.two_columns(rows if one.joints else [("no joint moves", "")])


def _as_json(robots: list[Imported], errors: dict[str, list[Diagnostic]]) -> dict[str, Any]:
    return {
        "version": VERSION,
        "importers": [_robot_as_json(one, errors.get(one.facts.name)) for one in robots],
    }


def _robot_as_json(one: Imported, errors: list[Diagnostic] | None) -> dict[str, Any]:
    found: dict[str, Any] = {
        "name": one.facts.name,
        "title": one.facts.title,
        "root": _root(one),
        "bodies": [
            {"name": body.name, "mass": body.mass, "links": [link.name for link in body.links]}
            for body in one.bodies
        ],
        "joints": [
            {
                "name": joint.joint.name,
                "names": list(joint.names),
                "type": joint.joint.kind,
                "q": joint.q,
                "nq": joint.nq,
                "v": joint.v,
                "nv": joint.nv,
                **_placed(joint.joint.at.span),
            }
            for joint in one.joints
        ],
        "changes": [{"text": change.text, **_placed(change.at.span)} for change in changes(one)],
    }
    if errors is not None:
        found["errors"] = [
            {"code": error.code, "message": error.message, **_placed(error.span)}
            for error in errors
        ]
    return found


def _placed(span: Span) -> dict[str, Any]:
    return {"file": shown(span.source.path), "line": span.line}


def _csv(robots: list[Imported]) -> Iterator[str]:
    header = ("importer", "joint", "type", "q", "nq", "v", "nv", "file", "line")
    yield _csv_text(header, (_row(one, joint) for one in robots for joint in one.joints))


def _row(robot: Imported, one: ImportedJoint) -> tuple[object, ...]:
    at, numbers = one.joint.at.span, (one.q, one.nq, one.v, one.nv)
    place = shown(at.source.path), at.line
    return (robot.facts.name, one.joint.name, one.joint.kind, *numbers, *place)


def _map_csv(found: IndexMap) -> Iterator[str]:
    names = (joint.joint.name for joint in found.joints)
    rows = zip(names, range(len(found.joints)), found.indices, strict=True)
    yield _csv_text(("joint", found.target, found.source), rows)


def _csv_text(header: Iterable[object], rows: Iterable[Iterable[object]]) -> str:
    text = StringIO()
    csv.writer(text, lineterminator="\n").writerows((header, *rows))
    return text.getvalue()


def _map_line(found: IndexMap) -> str:
    source, target = found.source.replace("-", "_"), found.target.replace("-", "_")
    name = f"{source}_to_{target}"
    return f"{name} = {list(found.indices)}  # q_{target} = q_{source}[{name}]"


def _map_as_json(found: IndexMap) -> dict[str, Any]:
    return {
        "version": VERSION,
        "from": found.source,
        "to": found.target,
        "joints": [joint.joint.name for joint in found.joints],
        "indices": list(found.indices),
    }
