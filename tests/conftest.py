"""What the tests share: the project's models, and the real robots beside the checkout."""

import gc
import importlib
import json
import os
import shutil
import sys
from collections import Counter
from collections.abc import Iterator
from functools import cache
from pathlib import Path
from typing import Any, NamedTuple
from zlib import crc32

import pytest
from hypothesis import settings
from hypothesis.internal.conjecture import providers

from tests import libsdformat
from urdfkit.lint.context import Context
from urdfkit.lint.loading import read
from urdfkit.text.source import Source
from urdfkit.workspace import search_root
from urdfkit.workspace.resolve import Resolver

# Each run of the tests measures meshes itself, and leaves nothing behind.
os.environ["URDFKIT_CACHE_DIR"] = ""

# Without bytecode each worker rewrites 600 files of tests, and each process compiles urdfkit.
sys.dont_write_bytecode = False
os.environ.pop("PYTHONDONTWRITEBYTECODE", None)

# How long an example takes is the machine's affair.
settings.register_profile("default", deadline=None, max_examples=25, derandomize=True)
settings.register_profile("thorough", deadline=None, max_examples=150)
settings.load_profile("default")

ROOT = Path(__file__).resolve().parents[1]
MODELS = ROOT / "models"
#: Robots of the project: that of the mission, which has defects, and three that are sound.
MISSION = MODELS / "gazebo_pkg" / "urdf" / "waking_robot_new.xacro"
ARM = MODELS / "good" / "two_link_arm" / "urdf" / "two_link_arm.urdf"
GRIPPER = MODELS / "good" / "gripper.urdf"
MOBILE_BASE = MODELS / "good" / "mobile_base" / "urdf" / "mobile_base.urdf.xacro"

#: Reference material beside the checkout; not part of the project.
SHARED = ROOT.parent / "shared"
CORPUS = SHARED / "corpus"
SEED = SHARED / "seeds" / "000_aa3f46a524d8a61f.txt"

#: Variables that lead to packages of this machine.
SEARCH_PATHS = (
    "AMENT_PREFIX_PATH",
    "ROS_PACKAGE_PATH",
    "ROS_DISTRO",
    "GAZEBO_MODEL_PATH",
    "GZ_SIM_RESOURCE_PATH",
    "IGN_GAZEBO_RESOURCE_PATH",
)

needs_corpus = pytest.mark.skipif(
    not CORPUS.is_dir(), reason="the corpus of real robots is not beside this checkout"
)
needs_seed = pytest.mark.skipif(
    not SEED.is_file(), reason="the mission's text is not beside this checkout"
)


class CorpusRobot(NamedTuple):
    """A model of the corpus."""

    repository: Path
    facts: dict[str, Any]  # as the manifest has them

    def __str__(self) -> str:
        name = f"{self.repository.name}/{self.facts['path']}"
        return " ".join([name, *self.facts["xacro_args"]])

    @property
    def path(self) -> Path:
        return self.repository / self.facts["path"]

    @property
    def arguments(self) -> dict[str, str]:
        """The xacro arguments that it needs."""
        return dict(argument.split(":=", 1) for argument in self.facts["xacro_args"])

    @property
    def alone(self) -> Context:
        """It, with the packages around it and none of this machine."""
        return Context(Source.read(self.path), Resolver(environment={}), self.arguments)

    def read(self) -> Context:
        """It, as a person reads it."""
        return read(self.path, arguments=self.arguments)


def manifest() -> Iterator[CorpusRobot]:
    """Every model of the corpus.

    Nothing where the corpus is absent: a test parametrised with it is then skipped.
    """
    file = CORPUS / "MANIFEST.json"
    if not file.is_file():
        return
    for repository in json.loads(file.read_text(encoding="utf-8"))["repos"]:
        for facts in repository["models"]:
            yield CorpusRobot(CORPUS / repository["dir"], facts)


def model_id(entry: object) -> str | None:
    """A readable name for a manifest entry in a parametrised test."""
    return str(entry) if isinstance(entry, CorpusRobot) else None


#: Directories and files of tests that check whole robots, write documents or start other programs:
#: minutes, where the rest takes seconds. ``pytest -m "not slow"`` leaves them out.
SLOW = (
    "tests/checks/checking/test_cfg003_robot_not_checked.py::test_the_gate_fails_for_an_arm",
    "tests/checks/gazebo_sensors/test_gaz072_view_blocked.py::test_primitives_agree",
    "tests/cli/mesh/test_capsules.py",
    "tests/cli/mesh/test_shaping.py",
    "tests/cli/mesh/test_spheres.py",
    "tests/cli/test_collisions.py",
    "tests/cli/test_configured.py",
    "tests/cli/test_failures.py::test_ctrl_c_ends",
    "tests/cli/test_mcp.py",
    "tests/cli/test_options.py::test_both_parsers",
    "tests/cli/test_own_process.py",
    "tests/cli/test_pages.py",
    "tests/cli/test_project.py",
    "tests/cli/test_render.py",
    "tests/cli/test_special_files.py",
    "tests/cli/test_report.py",
    "tests/cli/test_result_cache.py",
    "tests/cli/test_result_entry.py",
    "tests/consumers/test_corpus.py",
    "tests/consumers/test_new_target.py",
    "tests/core/test_disk.py::test_a_new_reader",
    "tests/core/test_disk.py::test_nothing_is_read_past",
    "tests/core/test_disk_full.py",
    "tests/false_alarms/",
    "tests/integration/",
    "tests/test_injection.py",
    "tests/test_kills.py",
    "tests/lint/test_engine.py",
    "tests/lint/test_fix.py",
    "tests/lint/test_fix_consistency.py",
    "tests/lint/test_formatting.py",
    "tests/lint/test_rule_packages.py",
    "tests/lsp/test_answers.py",
    "tests/lsp/test_injection.py",
    "tests/lsp/test_server.py",
    "tests/mesh/parts/",
    "tests/mesh/repair/test_repair.py",
    "tests/mesh/test_",
    "tests/output/bundle/test_bundle.py::test_robots_of_the_corpus",
    "tests/output/bundle/test_injection.py",
    "tests/output/comparison/test_comparison.py",
    "tests/output/conversion/",
    "tests/output/report/",
    "tests/output/simulation/",
    "tests/output/test_exchange.py",
    "tests/output/test_overview.py",
    "tests/physics/",
    "tests/pytest_plugin/",
    "tests/render/",
    "tests/robot/inertials/test_diagnosis.py::test_no_proposal",
    "tests/ros/gazebo/test_conversion.py",
    "tests/ros/importers/test_against_engines.py",
    "tests/ros/launch/test_corpus.py",
    "tests/ros/launch/test_robot_arguments.py",
    "tests/scan/test_scan.py",
    "tests/test_against_check_urdf.py",
    "tests/test_bad_input.py",
    "tests/test_corpus",
    "tests/test_crashes.py",
    "tests/test_docs.py",
    "tests/test_endless_text.py",
    "tests/test_fixing_corpus.py",
    "tests/test_fuzz.py",
    "tests/test_golden",
    "tests/test_models.py",
    "tests/test_pages.py",
    "tests/test_planted.py",
    "tests/test_playground.py",
    "tests/test_safe_fixes.py",
    "tests/test_site.py",
    "tests/test_testing.py",
    "tests/text/editing/test_formatter.py",
    "tests/text/test_xml_errors.py",
    "tests/viewer/",
    "tests/xacro/test_bombs.py",
    "tests/xacro/test_budget.py",
    "tests/xacro/test_identity.py",
    "tests/xacro/test_places.py::test_every_attribute",
    "tests/xacro/test_upstream.py",
)


#: Tests of which one of so many is run unless ``--thorough``; none if 0, but with ``--sample``. The
#: first name that fits counts.
SAMPLED = {
    "tests/checks/checking/test_cfg003_robot_not_checked.py::test_the_gate_fails_for_an_arm": 0,
    "tests/cli/test_pages.py": 12,
    "tests/cli/test_result_cache.py::test_a_change_is_seen": 3,
    "tests/cli/test_result_cache.py::test_what_is_not_kept": 2,
    "tests/cli/test_result_cache.py::test_a_variable": 3,
    "tests/cli/test_special_files.py": 6,
    "tests/consumers/test_corpus.py": 40,
    "tests/core/test_disk_full.py::test_it_is_one_error": 4,
    "tests/integration/test_action.py::test_the_script_of_gitlab": 0,
    "tests/integration/test_action.py::test_each_robot_gets": 0,
    "tests/integration/test_action.py::test_python_imports": 0,
    "tests/integration/test_action.py::test_each_variant": 0,
    "tests/integration/test_action.py::test_it_installs": 0,
    "tests/integration/test_action.py::test_gitlab": 0,
    "tests/integration/test_pre_commit.py": 0,
    "tests/lint/test_formatting.py::test_real_robots": 0,
    "tests/lint/test_rule_packages.py::test_the_tests_of_the_example": 0,
    "tests/mesh/parts/test_parts.py::test_every_part_can": 4,
    "tests/mesh/test_capsule_fitting.py::test_boxes": 0,
    "tests/mesh/test_containment.py": 3,
    "tests/mesh/test_load_corpus.py": 0,
    "tests/mesh/test_native_crashes.py::test_vhacdx": 0,
    "tests/mesh/test_simplify.py::test_an_error_is_kept": 0,
    "tests/mesh/test_simplify.py::test_a_plate": 0,
    "tests/mesh/test_sphere_fitting.py": 0,
    "tests/mesh/test_warnings.py": 8,
    "tests/mesh/writers/test_collada.py::test_the_parts": 4,
    "tests/output/bundle/test_bundle.py::test_robots_of_the_corpus": 40,
    "tests/output/conversion/test_mjcf.py::test_robots_of_the_corpus": 20,
    "tests/output/conversion/test_own_dynamics.py::test_a_robot_with_too_many": 0,
    "tests/output/conversion/test_sdf.py::test_robots_of_the_corpus": 20,
    "tests/output/conversion/test_sdf.py::test_pieces_of_robots": 3,
    "tests/output/conversion/test_usd.py::test_robots_of_the_corpus": 20,
    "tests/output/report/test_browser.py::test_the_width": 0,
    "tests/output/report/test_browser.py": 2,
    "tests/output/report/test_browser_view.py": 2,
    "tests/output/report/test_html.py::test_the_same_robot": 0,
    "tests/physics/collision/test_against_pinocchio.py": 0,
    "tests/physics/collision/test_sampling.py::test_a_robot_that_crashes": 0,
    "tests/physics/collision/test_sampling.py::test_two_seeds": 2,
    "tests/physics/collision/test_srdf_matrix.py::test_the_panda": 0,
    "tests/pytest_plugin/test_files.py::test_several_processes": 0,
    "tests/render/test_layers.py::test_names_in_a_crowd": 0,
    "tests/robot/inertials/test_diagnosis.py::test_no_proposal": 0,
    "tests/ros/gazebo/test_rejection.py::test_libsdformat_agrees": 3,
    "tests/ros/importers/test_against_engines.py::test_a_real_robot": 40,
    "tests/scan/test_scan.py::test_dask": 0,
    "tests/test_against_check_urdf.py": 3,
    "tests/test_bad_input.py::test_huge": 4,
    "tests/test_corpus.py::test_parts": 0,
    "tests/test_corpus.py": 6,
    "tests/test_docs.py::test_the_road_in_readme": 0,
    "tests/test_docs.py::test_the_animation": 0,
    "tests/test_endless_text.py::test_a_comment_of_200_000": 0,
    "tests/test_endless_text.py": 4,
    "tests/test_fixing_corpus.py": 12,
    "tests/test_fuzz.py::test_a_short_run": 6,
    "tests/test_golden_gazebo.py::test_no_errors_on_real_robots": 0,
    "tests/test_injection.py::test_a_page_runs_nothing": 0,
    "tests/test_injection.py::test_a_format": 12,
    "tests/test_injection.py::test_a_text": 4,
    "tests/test_kills.py": 3,
    "tests/test_pages.py": 3,
    "tests/test_planted.py::test_it_is_found": 30,
    "tests/test_playground.py": 0,
    "tests/test_safe_fixes.py": 3,
    "tests/test_site.py": 0,
    "tests/text/test_xml_errors.py::TestBounds": 4,
    "tests/viewer/test_server.py::test_what_fails": 0,
    "tests/xacro/test_bombs.py::test_an_expression_ends_without": 0,
    "tests/xacro/test_bombs.py::test_files_end": 40,
    "tests/xacro/test_bombs.py": 40,
    "tests/xacro/test_budget.py": 8,
    "tests/xacro/test_identity.py": 6,
    "tests/xacro/test_places.py::test_every_element": 0,
}
#: The same of tests with a parameter for each robot of the corpus.
SAMPLED_ROBOTS = 10
#: The same of those with 0, for ``--sample``.
SAMPLED_RARELY = 12
#: The same in another way of a file with 0: one of three tests, in one of so many runs. A browser,
#: or the built pages, are made once for the tests of a file.
SAMPLED_FILES = 4


def pytest_addoption(parser: pytest.Parser) -> None:
    parser.addoption(
        "--thorough",
        action="store_true",
        help="all parameters of the sampled tests, and more examples for each property",
    )
    parser.addoption(
        "--sample",
        type=int,
        metavar="N",
        help="other parameters of the sampled tests for each number, and some that are not sampled",
    )


def pytest_configure(config: pytest.Config) -> None:
    if config.getoption("thorough"):
        settings.load_profile("thorough")
    else:  # constants of all modules that are loaded: 10 s, and other examples in another order
        patch = pytest.MonkeyPatch()
        patch.setattr(providers, "is_local_module_file", lambda path: False, raising=False)


def pytest_xdist_auto_num_workers(config: pytest.Config) -> int | None:
    """Processes for a whole run only: a file of tests is run sooner than they start."""
    return None if config.args_source is pytest.Config.ArgsSource.TESTPATHS else 0


def pytest_ignore_collect(collection_path: Path, config: pytest.Config) -> bool | None:
    """Files that are left out need not be imported."""
    is_left_out = config.getoption("markexpr") == "not slow"
    return (is_left_out and collection_path.relative_to(ROOT).as_posix().startswith(SLOW)) or None


def pytest_itemcollected(item: pytest.Item) -> None:
    if item.nodeid.startswith(SLOW):
        item.add_marker(pytest.mark.slow)


@pytest.hookimpl(tryfirst=True)
def pytest_collection_modifyitems(config: pytest.Config, items: list[pytest.Item]) -> None:
    """Leave out what is not sampled, unless tests are chosen by name."""
    chosen = config.getoption("keyword") or any("::" in argument for argument in config.args)
    if chosen or config.getoption("thorough"):
        return
    sample: int | None = config.getoption("sample")
    seen: Counter[str] = Counter()
    kept: list[pytest.Item] = []
    left_out: list[pytest.Item] = []
    for item in items:
        name = item.nodeid.partition("[")[0]
        number = seen[name] + crc32(name.encode()) + (sample or 0)  # other robots for other tests
        seen[name] += 1
        every = _one_of(item, name)
        if not every and sample is not None:
            file = name.partition("::")[0]
            every = SAMPLED_RARELY
            if file in SAMPLED:
                every, number = _rarely(file, seen[file], sample)
            seen[file] += 1
        (left_out if not every or number % every else kept).append(item)
    items[:] = kept
    config.hook.pytest_deselected(items=left_out)


def pytest_collection_finish() -> None:
    """A check of several robots collects garbage: thousands of tests are none."""
    gc.collect()
    gc.freeze()


def _rarely(file: str, place: int, sample: int) -> tuple[int, int]:
    """Of how many tests of a file one is run, and the number of the one at this place."""
    turn, rest = divmod(crc32(file.encode()) + sample, SAMPLED_FILES)
    every = SAMPLED_RARELY // SAMPLED_FILES
    return (every, place + turn) if rest == 0 else (0, 0)


@cache
def _sampled(name: str) -> int | None:
    return next((every for start, every in SAMPLED.items() if name.startswith(start)), None)


def _one_of(item: pytest.Item, name: str) -> int:
    """Of how many tests like this one is run."""
    parameters = item.callspec.params if hasattr(item, "callspec") else {}
    found = _sampled(name)
    if found is None:
        found = SAMPLED_ROBOTS if {"entry", "model"} & parameters.keys() else 1
    return found if parameters else min(found, 1)


@pytest.fixture
def corpus() -> Path:
    """The directory of real robots; the test is skipped where it is absent."""
    if not CORPUS.is_dir():
        pytest.skip("the corpus of real robots is not beside this checkout")
    return CORPUS


@pytest.fixture
def gazebo_pkg(tmp_path: Path) -> Path:
    """A copy of the mission's package, which a test may change."""
    return Path(shutil.copytree(MODELS / "gazebo_pkg", tmp_path / "gazebo_pkg"))


@pytest.fixture
def only_the_corpus(monkeypatch: pytest.MonkeyPatch) -> None:
    """No packages of this machine."""
    for variable in SEARCH_PATHS:
        monkeypatch.delenv(variable, raising=False)


@pytest.fixture(scope="session")
def sdformat() -> Path:
    """A program for ``tests.libsdformat.convert``."""
    return libsdformat.build(ROOT / ".pytest_cache" / "libsdformat")


@pytest.fixture
def rough_meshes(monkeypatch: pytest.MonkeyPatch) -> None:
    """Few points of surfaces, few voxels: for tests that do not depend on how exact meshes are."""
    pytest.importorskip("numpy")
    numbers = {
        "distance": ("MAX_VERTICES", "SAMPLES", "FARTHEST", "_MANY_SAMPLES", "_GUIDES"),
        "convex_decomposition": ("_VOXELS",),
        "sphere_fitting": (
            *("_COLUMNS", "_SURFACE", "_MEDIAL", "_ELSEWHERE", "_MAX_ROUGH", "_MAX_POINTS"),
        ),
        "capsule_fitting": ("_COLUMNS", "_MAX_POINTS", "_SURFACE"),
        "cover_quality": ("_COLUMNS", "_SURFACE"),
    }
    for name, constants in numbers.items():
        module = importlib.import_module(f"urdfkit.mesh.{name}")
        for constant in constants:
            monkeypatch.setattr(module, constant, getattr(module, constant) // 20)


@pytest.fixture
def small_pictures(monkeypatch: pytest.MonkeyPatch) -> None:
    """For tests of reports that do not look at the images, which take most of their time."""
    module = importlib.import_module("urdfkit.output.report.data_uris")
    for name in ("SHEET", "MARKED"):
        monkeypatch.setattr(module, name, (128, 72))


@pytest.fixture(scope="session", autouse=True)
def _no_test_is_beside_another(tmp_path_factory: pytest.TempPathFactory) -> Iterator[None]:
    """A missing package is looked for in the directories above: here, in those of all other tests.

    They would answer for one another, and the search would take longer with every test and with
    every directory next to the checkout.
    """
    base = tmp_path_factory.getbasetemp()
    with pytest.MonkeyPatch.context() as patch:
        above = map(str, (base, *base.parents, *ROOT.parents))
        shared = search_root._SYSTEM_DIRECTORIES.union(above)
        patch.setattr(search_root, "_SYSTEM_DIRECTORIES", shared)
        patch.setenv("TMPDIR", str(base))  # the same for processes
        yield
