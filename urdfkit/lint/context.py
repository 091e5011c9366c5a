"""The description to check; its parts are computed when they are first used."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Mapping
from functools import cached_property, lru_cache, partial

from urdfkit.core import libraries
from urdfkit.core.static_typing import TYPE_CHECKING
from urdfkit.errors import NotApplicable, Unavailable
from urdfkit.lint.description_file import DescriptionFile
from urdfkit.lint.requirements import dynamics_of, need_coal, need_few_bodies, simulation_of
from urdfkit.lint.run_state import RunState
from urdfkit.text.document import CallFrame, Document
from urdfkit.text.file_kinds import has_srdf_tags, is_extension, is_list_of_joints
from urdfkit.text.source import Source

if TYPE_CHECKING:
    from urdfkit.core.progress import Progress
    from urdfkit.lint.report import Launched, UncheckedValues
    from urdfkit.mesh.measures import Measures
    from urdfkit.physics.collision.robot import Collisions
    from urdfkit.physics.dynamics.robot import Dynamics
    from urdfkit.physics.verdicts import Simulation
    from urdfkit.robot.assets.measured_meshes import MeasuredMeshes
    from urdfkit.robot.assets.mesh_files import MeshFiles
    from urdfkit.robot.assets.triangles import Meshes
    from urdfkit.robot.inertials.masses import Masses
    from urdfkit.robot.joint import Joint
    from urdfkit.robot.link import Body, Shape
    from urdfkit.robot.model import RobotModel
    from urdfkit.robot.shapes import MeshSolid
    from urdfkit.robot.stability import Stability
    from urdfkit.robot.tree import KinematicTree
    from urdfkit.ros.controllers import Controller, ParameterFile
    from urdfkit.ros.gazebo.conversion import SdfConversion
    from urdfkit.ros.gazebo.plugins import PluginUse
    from urdfkit.ros.importers.imported import Imported
    from urdfkit.ros.launch.contents import FileUse, LaunchedDescription
    from urdfkit.ros.moveit.config import MoveItConfig
    from urdfkit.ros.moveit.srdf import Srdf
    from urdfkit.ros.mujoco import Compiler
    from urdfkit.ros.targets import TargetFacts, Targets
    from urdfkit.text.grammar import Deviation
    from urdfkit.workspace.resolve import Resolver

    #: Simulates a robot, as `urdfkit.simulate` does. It is passed in, as it is above this package.
    Simulate = Callable[["Context"], Simulation]


class Context(DescriptionFile):
    """Input of the rules: one description file, the robot in it, and its files.

    Attributes:
        parameters: the parameter files of the launch file that loads it.
        run: state of the check; set by the runner.
        launched: the arguments that the user did not set, with their origin; set by `loading`.
        unchecked: other values of its arguments, which are not checked; set by the plan.

    Args:
        cache: True if measures of meshes may be cached for the next run.
        progress: called with the number of mesh files read and the number of all mesh files.
        simulate: simulates the robot, for the rules about simulations; None if they do not run.
    """

    def __init__(
        self,
        source: Source,
        resolver: Resolver,
        arguments: Mapping[str, str] | None = None,
        *,
        trust: bool = False,
        targets: Targets | None = None,
        frame: CallFrame | None = None,
        parameters: tuple[FileUse, ...] = (),
        cache: bool = False,
        progress: Progress | None = None,
        simulate: Simulate | None = None,
    ) -> None:
        super().__init__(source, resolver, arguments, trust=trust, frame=frame)
        self.parameters = parameters
        self._cache = cache
        self._progress = progress
        self._simulate = simulate
        self._given_targets = targets
        self.run = RunState()
        self.launched: tuple[Launched, ...] = ()
        self.unchecked: tuple[UncheckedValues, ...] = ()
        self._other_robots: dict[tuple[object, ...], Context] = {}

    def free(self) -> None:
        """Drop all parts, after which the context is of no use.

        Reference cycles keep it alive until the next full garbage collection; its meshes not.
        """
        vars(self).clear()

    @cached_property
    def deviations(self) -> dict[str, list[Deviation]]:
        """Deviations of the document from the grammar, by the code of the reporting rule."""
        root = self.document.root
        if has_srdf_tags(root) or is_list_of_joints(root):
            return {}
        from urdfkit.text.grammar import deviations
        from urdfkit.text.schema import XACRO_TAGS

        xacro = self.reading.xacro
        if xacro is None:
            calls = root.children if is_extension(root) else ()
            return deviations(self.document, plain=True, claimed={call.tag for call in calls})
        claimed = {*XACRO_TAGS, *(macro.name for macro in xacro.macros)}  # XAC002
        return deviations(self.document, plain=False, claimed=claimed)

    @cached_property
    def is_part(self) -> bool:
        """True for a file that is used inside another one only, and is not a robot by itself.

        It is a library of macros, or a description that another file includes and that has no
        name or no root link.
        """
        xacro, root = self.reading.xacro, self.document.root
        if (xacro is not None and xacro.is_library) or has_srdf_tags(root) or is_extension(root):
            return True
        if root.get("name") is None and self.problems("XAC003"):
            return True  # calls macros of the including file
        if root.get("name") is not None and self.tree.has_base:
            return False
        return self.is_included

    @cached_property
    def is_included(self) -> bool:
        """True if another file of the package includes this one, or may (too many files)."""
        from urdfkit.workspace.includes import is_included

        return is_included(self.source.path, self.resolver.packages)

    @cached_property
    def model(self) -> RobotModel:
        """The robot in the document."""
        from urdfkit.robot.model import RobotModel

        return RobotModel(self.document, self.resolver.packages.explicit)

    @cached_property
    def tree(self) -> KinematicTree:
        """The kinematic tree of the model."""
        from urdfkit.robot.tree import KinematicTree

        return KinematicTree(self.model)

    @property
    def given_targets(self) -> tuple[str, ...]:
        """The targets that the user named; empty if they are detected."""
        return self._given_targets.names if self._given_targets else ()

    @property
    def given_facts(self) -> tuple[TargetFacts, ...]:
        """The facts about the targets that the user named."""
        return self._given_targets.facts if self._given_targets else ()

    @cached_property
    def targets(self) -> Targets:
        """The targets to check for: those that the user named, otherwise the detected ones."""
        return self._given_targets or self.inferred_targets

    @property
    def inferred_targets(self) -> Targets:
        """The targets detected from the model."""
        from urdfkit.ros.targets import infer
        from urdfkit.workspace.manifest import manifest_of

        return infer(self.model, manifest_of(self.resolver, self.source.path))

    @cached_property
    def mujoco(self) -> Compiler:
        """The settings of MuJoCo's compiler in the model."""
        from urdfkit.ros.mujoco import compiler_of

        return compiler_of(self.model)

    @property
    def loads_visuals(self) -> bool:
        """False if the given targets load no visuals, and the model does not request visuals."""
        if not self.given_targets or not all(facts.drops_visuals for facts in self.targets.facts):
            return True
        return self.reading.document is None or not self.mujoco.drops_visuals

    @cached_property
    def stability_on_primitives(self) -> Stability | None:
        """Stability of the robot with all joints at 0, without its meshes."""
        from urdfkit.robot.stability import stand

        return stand(self, meshes=False)

    @cached_property
    def symmetric_joints(self) -> list[tuple[Joint, Joint]]:
        """The pairs of movable left and right joints that are meant to be symmetric."""
        from urdfkit.robot.symmetry import joint_pairs

        return joint_pairs(self.tree)

    @cached_property
    def gazebo(self) -> SdfConversion:
        """The conversion of the model to SDF: merged, dropped and renamed links."""
        from urdfkit.ros.gazebo.conversion import SdfConversion

        return SdfConversion(self.tree)

    def imported(self, importer: str) -> Imported:
        """The model after import into a program: bodies, masses and the order of the joints.

        >>> from urdfkit.lint.loading import read
        >>> robot = read("models/good/gripper.urdf").imported("mujoco")
        >>> [(imported.joint.name, imported.q, imported.v) for imported in robot.joints]
        [('left_finger_joint', 0, 0), ('right_finger_joint', 1, 1)]

        Args:
            importer: a name of `urdfkit.ros.importers.facts.IMPORTERS`.

        Raises:
            UnknownImporter: the name is unknown; the message suggests the nearest.
        """
        from urdfkit.robot.assets.collision_solids import CollisionSolids
        from urdfkit.ros.importers.facts import facts_of
        from urdfkit.ros.importers.imported import Imported

        solids = CollisionSolids(lambda: self.meshes, self.mesh_solid)
        return Imported(self.tree, facts_of(importer), solids)

    @cached_property
    def plugins(self) -> tuple[PluginUse, ...]:
        """The Gazebo plugins of the model."""
        from urdfkit.ros.gazebo.plugins import uses

        return uses(self.model, self.targets)

    @cached_property
    def names_parameters(self) -> bool:
        """True if a launch file or a plugin references a parameter file of controllers."""
        plugins = (plugin for block in self.model.gazebo for plugin in block.all("plugin"))
        return bool(self.parameters) or any(plugin.child("parameters") for plugin in plugins)

    @cached_property
    def controllers(self) -> tuple[tuple[ParameterFile, Controller], ...]:
        """The controllers in the parameter files of the robot, each with its file."""
        if not self.names_parameters:
            return ()
        from urdfkit.ros.controllers import controllers

        return tuple(controllers(self))

    @cached_property
    def srdf(self) -> Srdf | None:
        """The SRDF of the robot's package; None if there is none, or for a part."""
        if self.is_part:
            return None
        from urdfkit.ros.moveit.srdf_reader import find

        return find(self)

    @cached_property
    def possible_srdfs(self) -> list[Srdf]:
        """The SRDFs that may be for the robot, of which ``srdf`` is the only one."""
        if self.srdf is not None or self.is_part:
            return [self.srdf] if self.srdf else []
        from urdfkit.ros.moveit.srdf_reader import candidates

        return candidates(self)

    @property
    def read_srdf(self) -> str:
        """Path of the SRDF, if a rule asked for it and it was found; otherwise empty."""
        srdf: Srdf | None = vars(self).get("srdf")
        return srdf.path if srdf else ""

    @cached_property
    def moveit_config(self) -> MoveItConfig:
        """The configuration of MoveIt for the SRDF, which must exist."""
        from urdfkit.ros.moveit.config import MoveItConfig

        return MoveItConfig(self.required_srdf.path, self.resolver)

    @property
    def required_srdf(self) -> Srdf:
        """The SRDF of the robot, for rules about SRDFs.

        Raises:
            NotApplicable: the robot has no SRDF.
        """
        if self.srdf is None:
            raise NotApplicable("no SRDF")
        return self.srdf

    @cached_property
    def other_variant(self) -> str:
        """Why the SRDF belongs to another variant of the robot; empty if it does not."""
        if self.srdf is None:
            return ""
        from urdfkit.ros.moveit.srdf_variant import other_variant

        return other_variant(self, self.srdf)

    def other_robot(self, path: str, arguments: Mapping[str, str]) -> Context:
        """Another description, read with the same settings; cached."""
        items = tuple(arguments.items())
        if (path, items) not in self._other_robots:
            source = self.source if path == self.source.path else self.resolver.read(path)
            robot = _robot(source, self.resolver, items, self.trust, self._cache)
            self._other_robots[path, items] = robot
        return self._other_robots[path, items]

    def expanded_with(self, arguments: Mapping[str, str]) -> Document | None:
        """This description with other arguments, not cached; None if it cannot be read."""
        return Context(self.source, self.resolver, arguments, trust=self.trust).reading.document

    def names_in_robot(self, path: str) -> frozenset[str]:
        """Names of the links and joints of another description, read with the same arguments."""
        arguments = tuple(sorted(self.arguments.items()))
        return _names(self.resolver.read(path), self.resolver, arguments, self.trust)[1]

    def name_of_robot(self, path: str, arguments: Mapping[str, str]) -> str | None:
        """Name of another description; None if it cannot be read."""
        given = tuple(arguments.items())
        return _names(self.resolver.read(path), self.resolver, given, self.trust)[0]

    @property
    def described_robots(self) -> Iterator[tuple[LaunchedDescription, Context]]:
        """The robots that the launch file describes and that can be expanded."""
        yield from self.expanded(self.launch.descriptions)

    @property
    def configured_robots(self) -> Iterator[tuple[LaunchedDescription, Context]]:
        """The robots that MoveIt gets from the launch file and that can be expanded."""
        yield from self.expanded(self.launch.configured)

    def expanded(
        self, descriptions: Iterable[LaunchedDescription]
    ) -> Iterator[tuple[LaunchedDescription, Context]]:
        """Robots of launch files that can be expanded."""
        for description in descriptions:
            robot = self.other_robot(description.path, description.arguments)
            if robot.reading.document is not None:
                yield description, robot

    @cached_property
    def masses(self) -> Masses:
        """The masses and inertias of the model, and their defects."""
        from urdfkit.robot.inertials.masses import Masses

        return Masses(self.model, self.tree, self.mesh_solid)

    def mesh_solid(self, body: Body) -> MeshSolid | None:
        """A visual or collision as a solid, if it is a mesh and meshes can be measured."""
        if body.shape is None or body.shape.filename is None:
            return None
        try:
            return self.measured.solid(body)
        except Unavailable:
            return None

    @cached_property
    def dynamics(self) -> Dynamics:
        """The robot in Pinocchio.

        Raises:
            Unavailable: Pinocchio is not installed, or cannot represent the robot.
        """
        return dynamics_of(self.tree)

    @cached_property
    def simulation(self) -> Simulation | None:
        """The results of simulations; None if the check makes none, or of a part of a robot.

        Raises:
            Unavailable: the robot cannot be simulated.
        """
        if self._simulate is None or self.is_part or not self.tree.is_sound:
            return None
        return simulation_of(self.model, self.files, partial(self._simulate, self))

    @cached_property
    def collisions(self) -> Collisions:
        """The links that collide with each other; coal is loaded when it is needed.

        Raises:
            Unavailable: the robot has too many bodies; later, if coal is not installed.
        """
        need_few_bodies(self.model)
        from urdfkit.physics.collision.robot import Collisions

        return Collisions(self, need_coal)

    @cached_property
    def files(self) -> MeshFiles:
        """The mesh files that the model references: their paths and detected formats."""
        from urdfkit.robot.assets.mesh_files import MeshFiles

        return MeshFiles(self.model, self.resolver)

    @cached_property
    def measured(self) -> MeasuredMeshes:
        """Measures of the mesh files that the model references.

        Raises:
            Unavailable: a library that measures them is not installed.
        """
        if reason := libraries.why_unmeasured():
            raise Unavailable(f"meshes are {reason}")
        from urdfkit.mesh import measure_cache
        from urdfkit.robot.assets.measured_meshes import MeasuredMeshes

        cache = measure_cache.shared(cached=self._cache)
        return MeasuredMeshes(self.model, self.files, cache, self._progress)

    def measures(self, shape: Shape) -> Measures | str:
        """The measures of a mesh, or a predicate about the file that states why there are none."""
        if reason := libraries.why_unmeasured():
            return f"is {reason}"
        return self.measured.measures(shape)

    @cached_property
    def meshes(self) -> Meshes:
        """The triangles of the mesh files."""
        from urdfkit.robot.assets.triangles import Meshes

        return Meshes(self.files, self._progress)


@lru_cache(maxsize=4)  # the launch files of a workspace start the same few robots
def _robot(
    source: Source,
    resolver: Resolver,
    arguments: tuple[tuple[str, str], ...],
    trust: bool,
    cache: bool,
) -> Context:
    return Context(source, resolver, dict(arguments), trust=trust, cache=cache)


@lru_cache(maxsize=64)  # robots that share launch files and SRDFs ask for the same ones
def _names(
    source: Source, resolver: Resolver, arguments: tuple[tuple[str, str], ...], trust: bool
) -> tuple[str | None, frozenset[str]]:
    """The names of a robot, and of its links and joints; none if it cannot be read."""
    robot = Context(source, resolver, dict(arguments), trust=trust)
    if not robot.is_readable:
        return None, frozenset()
    model = robot.model
    return model.name, frozenset({*model.links_by_name, *model.joints_by_name})
