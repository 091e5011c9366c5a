"""``urdfkit importers``: a robot after the import by simulators and dynamics libraries."""

from collections.abc import Iterator
from itertools import groupby
from math import isclose
from typing import Any

from urdfkit.cli import gazebo, options, output
from urdfkit.cli.decorators import described, in_formats, option
from urdfkit.cli.progress import working
from urdfkit.cli.robot import one_robot, only_file, robot
from urdfkit.core.words import counted
from urdfkit.lint.context import Context
from urdfkit.lint.engine import check
from urdfkit.ros.importers.changes import changes
from urdfkit.ros.importers.facts import GAZEBO, IMPORTERS, ImporterFacts, UnknownImporter, selected
from urdfkit.ros.importers.imported import Imported, ImportedBody, ImportedJoint
from urdfkit.ros.importers.index_map import IndexMap, index_map
from urdfkit.ros.importers.mass_differences import ROUNDING, mass_differences
from urdfkit.text.diagnostic import Diagnostic, Severity
from urdfkit.text.source import Span, shown
from urdfkit.text.terminal import RED

VERSION = 1
COLORS = {"(?<= )may reject this robot(?=: 'urdfkit check)": RED}

#: Rules about the graph of links and joints, for programs that are not targets.
STRUCTURE = ("JNT001", "NAM001", "REF001", "TRE")


@described("importers")
@one_robot
@option("--for NAMES", "Programs. [default: all]", to="names", multiple=True)
@option("--map FROM:TO", "Indices of FROM in the order of TO.", to="pair")
@in_formats("text", "json", "csv")
def command(inputs: dict[str, Any], names: tuple[str, ...], pair: str | None, format: str) -> int:
    """Show how simulators import a robot.

    The programs are drake, gazebo, genesis, isaac (Isaac Lab, which merges fixed joints),
    isaac-sim (Isaac Sim's importer, which does not), mujoco, newton, pinocchio, pybullet and
    yourdfpy; none needs to be installed. Errors that make a program reject the robot come first.

    Exit codes: 0 done, 2 the file cannot be read, or two programs have different joints.

    Examples:
        urdfkit importers robot.urdf.xacro
        urdfkit importers robot.urdf.xacro --for mujoco,pinocchio
        urdfkit importers robot.urdf.xacro --map isaac:mujoco
    """
    programs = options.words({"for": names}, "for")
    if pair is not None:
        return _map(inputs, programs, pair, format)
    if format == "csv" and not programs:
        raise options.UsageError("--format csv needs --for or --map")
    if GAZEBO in programs:
        if len(set(programs)) > 1 or format == "csv":
            raise options.UsageError("--for gazebo allows no other program, and only text or JSON")
        return gazebo.show(robot(inputs), format, old=False)
    facts = selected(programs or IMPORTERS)
    context = robot(inputs)
    robots = [context.imported(importer.name) for importer in facts]
    if format == "csv":
        output.write(_csv(robots))
        return 0
    errors = {item.name: _errors(inputs, context, item) for item in facts} if programs else {}
    lines = _reports(robots, errors) if programs else _overview(robots)
    output.json_or_page(format, lambda: _as_json(robots, errors), lines, COLORS)
    return 0


def _map(inputs: dict[str, Any], names: list[str], pair: str, format: str) -> int:
    source, colon, target = pair.partition(":")
    if names:
        raise options.UsageError("--map and --for cannot be combined")
    if not (colon and source and target):
        raise options.UsageError(f"--map {pair}: expected FROM:TO, such as isaac:mujoco")
    if GAZEBO in (source, target):
        raise options.UsageError(
            f"--map {pair}: gazebo has no joint order: it finds joints by name"
        )
    try:
        selected((source, target))
    except UnknownImporter as error:
        raise options.UsageError(f"--map {pair}: {error}") from error
    context = robot(inputs)
    result = index_map(context.imported(source), context.imported(target))
    if format == "csv":
        output.write(_map_csv(result))
    else:
        output.json_or_page(format, lambda: _map_as_json(result), [_map_line(result)])
    return 0


def _errors(inputs: dict[str, Any], context: Context, facts: ImporterFacts) -> list[Diagnostic]:
    """The errors of a check for a program; only those of the tree if it is not a target."""
    settings = options.check_options(inputs, only_file(inputs))
    if facts.target:
        settings = settings._replace(targets=(facts.target,))
    else:
        settings = settings._replace(select=STRUCTURE)
    with working():
        report = check(context.source, options=settings)
    return [error for error in report.diagnostics if error.severity is Severity.ERROR]


def _overview(robots: list[Imported]) -> Iterator[str]:
    """A row for each program, followed by the joint orders that differ."""
    tree = robots[0].tree
    model = tree.model
    if not tree.is_sound:
        yield from output.wrapped(f"programs may reject this robot: {tree.unsound}")
        yield ""
    yield f"{counted(len(model.links), 'link')}, {model.mass:g} kg, as programs import them:"
    yield ""
    rows = [(" program   ", f"{'bodies':>6} {'mass / kg':>10} {'DoF':>4}  order  root")]
    orders: dict[tuple[str, ...], str] = {}
    for imported in robots:
        order = tuple(joint.joint.name for joint in imported.joints)
        letter = orders.setdefault(order, chr(ord("A") + len(orders)))
        freedom = sum(joint.nv for joint in imported.joints)
        row = f"{len(_moving(imported)):>6} {_total(imported):>10} {freedom:>4}"
        rows.append((f" {imported.facts.name}", f"{row}  {letter:<5}  {_root(imported)}"))
    yield from output.two_columns(rows)
    yield ""
    for order, letter in orders.items():
        yield from output.indented(", ".join(order) or "no joints", f"{letter}: ", "   ")
    yield from _masses(robots)


def _masses(robots: list[Imported]) -> Iterator[str]:
    """Why masses differ, the programs with the same cause in one line."""
    programs: dict[str, list[str]] = {}
    for imported in robots:
        for cause in mass_differences(imported):
            programs.setdefault(cause, []).append(imported.facts.name)
    yield from ["", "masses differ:"] if programs else []
    for cause, names in programs.items():
        yield from output.indented(cause, f"  {', '.join(names)}: ")


def _moving(imported: Imported) -> list[ImportedBody]:
    world = imported.facts.merges_into_world
    return [body for body in imported.bodies if not (world and body.name == "world")]


def _total(imported: Imported) -> str:
    masses = [body.mass for body in _moving(imported)]
    known = [mass for mass in masses if mass is not None]
    if len(known) < len(masses):
        return "?"
    total, whole = sum(known), imported.tree.model.mass
    # The same masses in another order may round to another last digit.
    return f"{whole if isclose(total, whole, rel_tol=ROUNDING) else total:g}"


def _root(imported: Imported) -> str:
    if imported.root_is_free is None:
        return "welded or free"
    return "free" if imported.root_is_free else "welded"


def _reports(robots: list[Imported], errors: dict[str, list[Diagnostic]]) -> Iterator[str]:
    for number, imported in enumerate(robots):
        if number:
            yield ""
        yield from _report(imported, errors[imported.facts.name])


def _report(imported: Imported, errors: list[Diagnostic]) -> Iterator[str]:
    facts = imported.facts
    if errors:
        flag = f" --target {facts.target}" if facts.target else ""
        yield f"{facts.title} may reject this robot: 'urdfkit check{flag}' reports"
        yield from output.errors((str(error.span), error.message, error.code) for error in errors)
        yield "Without these errors:"
        yield ""
    number = len(_moving(imported))
    bodies = "1 body" if number == 1 else f"{number} bodies"
    total = _total(imported)
    mass = "of unknown mass" if total == "?" else f"{total} kg"
    yield from output.wrapped(
        f"{facts.title}: {counted(len(imported.tree.model.links), 'link')} become "
        f"{bodies}, {mass}; {_about_root(imported)}"
    )
    yield from _changes(imported)
    yield ""
    yield from _joints(imported)


def _about_root(imported: Imported) -> str:
    alternative = imported.facts.about_root
    state = "the root is " + ("welded to the world" if imported.root_is_free is False else "free")
    if imported.root_is_free is None:
        return alternative
    return f"{state} ({alternative})" if alternative else state


def _changes(imported: Imported) -> Iterator[str]:
    """The changes, grouped by file."""
    for path, group in groupby(changes(imported), key=lambda change: change.at.span.source.path):
        yield ""
        yield shown(path)
        for change in group:
            yield from output.indented(change.text, f"  {change.at.span.line:>4}  ", " " * 8)


def _joints(imported: Imported) -> Iterator[str]:
    rows = [("    q    v  joint", "  type")]
    rows += (
        (f"{joint.q:>5}{joint.v:>5}  {', '.join(joint.names)}", f"  {joint.joint.kind}")
        for joint in imported.joints
    )
    yield from output.two_columns(rows if imported.joints else [("no joint moves", "")])


def _as_json(robots: list[Imported], errors: dict[str, list[Diagnostic]]) -> dict[str, Any]:
    return {
        "version": VERSION,
        "importers": [
            _robot_as_json(imported, errors.get(imported.facts.name)) for imported in robots
        ],
    }


def _robot_as_json(imported: Imported, errors: list[Diagnostic] | None) -> dict[str, Any]:
    document: dict[str, Any] = {
        "name": imported.facts.name,
        "title": imported.facts.title,
        "root": _root(imported),
        "bodies": [
            {"name": body.name, "mass": body.mass, "links": [link.name for link in body.links]}
            for body in imported.bodies
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
            for joint in imported.joints
        ],
        "changes": [
            {"text": change.text, **_placed(change.at.span)} for change in changes(imported)
        ],
    }
    if errors is not None:
        document["errors"] = [
            {"code": error.code, "message": error.message, **_placed(error.span)}
            for error in errors
        ]
    return document


def _placed(span: Span) -> dict[str, Any]:
    return {"file": shown(span.source.path), "line": span.line}


def _csv(robots: list[Imported]) -> str:
    header = ("importer", "joint", "type", "q", "nq", "v", "nv", "file", "line")
    return output.csv_text(
        header, (_row(imported, joint) for imported in robots for joint in imported.joints)
    )


def _row(robot: Imported, joint: ImportedJoint) -> tuple[object, ...]:
    numbers, location = (joint.q, joint.nq, joint.v, joint.nv), _placed(joint.joint.at.span)
    return (robot.facts.name, joint.joint.name, joint.joint.kind, *numbers, *location.values())


def _map_csv(result: IndexMap) -> str:
    names = (joint.joint.name for joint in result.joints)
    rows = zip(names, range(len(result.joints)), result.indices, strict=True)
    return output.csv_text(("joint", result.target, result.source), rows)


def _map_line(result: IndexMap) -> str:
    source, target = result.source.replace("-", "_"), result.target.replace("-", "_")
    name = f"{source}_to_{target}"
    return f"{name} = {list(result.indices)}  # q_{target} = q_{source}[{name}]"


def _map_as_json(result: IndexMap) -> dict[str, Any]:
    return {
        "version": VERSION,
        "from": result.source,
        "to": result.target,
        "joints": [joint.joint.name for joint in result.joints],
        "indices": list(result.indices),
    }
