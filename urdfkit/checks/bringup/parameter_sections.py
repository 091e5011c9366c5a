"""Sections of parameter files that no node and no plugin reads: they are below another name."""

from itertools import chain

from urdfkit.checks.bringup.costmaps import COSTMAPS, class_of_active_layer, has_default_plugins
from urdfkit.core.suggest import CLOSE_TYPO, SIMILAR, nearest
from urdfkit.lint.rules import Context, Finding, Findings, Related, Severity
from urdfkit.ros.catalog import data
from urdfkit.ros.launch.contents import StartedProgram
from urdfkit.ros.launch.robot_arguments import launches_of_workspace
from urdfkit.ros.node_parameters import NodeParameters
from urdfkit.text.located_yaml import Value, items, mapping, scalar, scalars

#: Programs that start several nodes, or nodes of other names.
_CONTAINERS = ("component_container", "gzserver", "gazebo", "ros2_control_node", "move_group")


def misnamed_sections(context: Context, files: dict[str, list[NodeParameters]]) -> Findings:
    """Parameter files that a node loads, but whose sections belong to other nodes."""
    for path, sections in files.items():
        users = [node for node in context.launch.programs if path in node.parameters.files]
        yield from _misspelt_servers(sections, users)
        if not context.launch.has_scopes:
            yield from _outside_namespace(sections, users)
            yield from _of_other_nodes(context, path, users, files)


def _of_other_nodes(
    context: Context, path: str, users: list[StartedProgram], files: dict[str, list[NodeParameters]]
) -> Findings:
    """A file of parameters for other nodes than those that load it, whose names are known."""
    sections = {section.name: section for section in reversed(files[path])}
    are_known = all(map(_has_known_name, users)) and not any("*" in name for name in sections)
    if not sections or not are_known:
        return
    unserved = [user for user in users if not _has_section(user, files)]
    names = {*COSTMAPS, *(user.name for user in users)}
    is_for_none = sections.keys().isdisjoint(names)
    spare = [name for name in sections if name not in names]
    for node in unserved[:1] if is_for_none else unserved:
        likely = node.executable if node.executable in spare else None
        likely = likely or nearest(node.name, spare, SIMILAR if is_for_none else CLOSE_TYPO)
        words = (node.name, node.package)  # many nodes have the name of their package
        likely = likely or next(
            (name for name in spare if any(_is_same_word(name, word) for word in words)), None
        )
        if likely is None and not is_for_none:
            continue
        section = sections.get(likely or "", files[path][0])
        if not _is_read_elsewhere(section, path, node, context):
            help = f"write {node.name}, or name the node {section.name}"
            yield _of_other_name(section, node, node.name, help)


def _is_same_word(name: str, other: str) -> bool:
    """True for ``joy`` and ``joy_node``."""
    return name.removesuffix("_node") == other.removesuffix("_node")


def _has_section(node: StartedProgram, files: dict[str, list[NodeParameters]]) -> bool:
    """True if one of the files of a node has parameters of it: others may be of other nodes."""
    sections = chain.from_iterable(files.get(path, ()) for path in node.parameters.files)
    return any(section.name == node.name for section in sections)


def _is_read_elsewhere(
    section: NodeParameters, path: str, node: StartedProgram, context: Context
) -> bool:
    """True if another launch file loads a parameter file for the node of a section.

    If it starts the same program with the right name, the name of this node is wrong.
    """
    programs = chain.from_iterable(
        launch.programs for launch in launches_of_workspace(path, context.resolver)
    )
    return any(
        path in program.parameters.files
        and _node_name(program).removesuffix(".py") == section.name
        and program.key != node.key
        for program in programs
    )


def _of_other_name(section: NodeParameters, node: StartedProgram, name: str, help: str) -> Finding:
    """Parameters of a section that the node with another name does not read."""
    return Finding(
        section.at,
        f"parameters of '{section.name}' are not read: the node is '{name}'",
        help,
        related=(Related(node.span, "the node that loads the file"),),
    )


def _outside_namespace(sections: list[NodeParameters], users: list[StartedProgram]) -> Findings:
    """Sections without the namespace in which their node is started."""
    namespaces: dict[str, set[str]] = {}
    for section in sections:
        if "*" in f"{section.namespace}/{section.name}":
            return
        namespaces.setdefault(section.name, set()).add(section.namespace.strip("/"))
    for section in sections:
        owners = [user for user in users if _node_name(user) == section.name]
        written = namespaces[section.name]
        if owners and all(user.namespace and user.namespace not in written for user in owners):
            namespace = owners[0].namespace
            help = f"write the section below {namespace}:, or below /**:"
            yield _of_other_name(section, owners[0], f"/{namespace}/{section.name}", help)


def _node_name(program: StartedProgram) -> str:
    """The name of a node, or its likely default name."""
    is_manager = program.executable == "ros2_control_node"
    return program.name or ("controller_manager" if is_manager else program.executable)


def _misspelt_servers(sections: list[NodeParameters], users: list[StartedProgram]) -> Findings:
    """Misspelt sections of servers of Nav2."""
    managed = data("nodes")["lifecycle"].split()
    servers = {
        user.executable: user for user in users if user.executable in managed and not user.name
    }
    lacking = servers.keys() - {section.name for section in sections}
    known = {*servers, *data("node_parameters")["nodes"]}  # a map_saver is no map_server
    for section in sections:
        suggested = nearest(section.name, lacking) if section.name not in known else None
        if suggested and suggested.startswith(section.name.partition("_")[0]):
            yield _of_other_name(section, servers[suggested], suggested, f"write {suggested}")


def _has_known_name(program: StartedProgram) -> bool:
    """True for a single node with a known name."""
    return (
        bool(program.name)
        and program.namespace == ""
        and not any(program.executable.startswith(name) for name in _CONTAINERS)
    )


def unread_plugins(node: NodeParameters) -> Findings:
    """The parameters of a default plugin below another name: the node runs with its defaults."""
    listed = {item.text for value in node.values.values() for item in scalars(value)}
    listed.update(value.text for value in node.values.values() if isinstance(value, Value))
    for key, defaults in data("nodes")["lists"].items():
        is_given = any(_belongs_to(given, name) for given in node.values for name in defaults)
        is_of_costmap = key in ("plugins", "filters")
        if len(defaults) != 1 or is_given or (is_of_costmap and node.name not in COSTMAPS):
            continue
        default = defaults[0]
        for name, value in items(node.values) if has_default_plugins(node, key, defaults) else ():
            is_unread = name not in listed and "plugin" in mapping(value)
            if is_unread and nearest(name, [default]):
                yield Finding(
                    name.span,
                    f"'{node.name}': the parameters of '{name}' are not read: {key} has "
                    f"'{default}'",
                    f"write {default}, or write {name} in {key}",
                )


def _belongs_to(given: str, name: str) -> bool:
    """True for the section of a plugin, and for a parameter of it with dots."""
    return given == name or given.startswith(f"{name}.")


def misplaced(node: NodeParameters) -> Findings:
    """Costmap parameters that are not below the costmap's name twice, its namespace and node."""
    is_nested = node.name in node.namespace.split("/") or "*" in node.namespace
    if node.name in COSTMAPS and not is_nested and "robot_base_frame" in node.values:
        yield Finding(
            node.at,
            f"the parameters of '{node.name}' are not read: the node is '{node.name}/{node.name}'",
            f"write {node.name} twice, the second below the first",
            severity=Severity.ERROR,
        )


def unlisted_filters(node: NodeParameters) -> Findings:
    """A filter that a costmap does not load; an info, as it may be left for later use."""
    listed = {name.text for key in ("plugins", "filters") for name in scalars(node.values.get(key))}
    for name, section in items(node.values) if node.name in COSTMAPS else ():
        kind = class_of_active_layer(section)
        if kind.endswith("Filter") and name not in listed:
            yield Finding(
                name.span,
                f"'{node.name}' does not load '{name}', which filters does not have",
                f'write filters: ["{name}"]',
                severity=Severity.INFO,
            )


def unnumbered_filters(node: NodeParameters) -> Findings:
    """Filters of laser_filters that it does not load, as they have another name than filter1."""
    filters = [
        name
        for name, section in items(node.values)
        if (kind := scalar(section, "type")) and kind.text.startswith("laser_filters/")
    ]
    expected = [f"filter{number}" for number in range(1, len(filters) + 1)]
    for name in filters:
        if name not in expected:
            free = next(other for other in expected if other not in filters)
            yield Finding(
                name.span,
                f"'{node.name}' does not load '{name}': it looks for filter1, filter2 and so on",
                f"write {free}",
            )
