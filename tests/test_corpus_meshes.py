"""The meshes of real robots resolve as independent tools found them to.

The corpus states for every model which references lead to no file when its repository alone is
at hand. Here the repositories lie side by side, which changes nothing: none supplies the package of
another.
"""

import json
import shutil
from pathlib import Path
from typing import Any

import pytest

from tests.conftest import CORPUS, CorpusRobot, manifest, model_id, needs_corpus
from urdfkit.lint.context import Context
from urdfkit.text.source import Source
from urdfkit.workspace.resolve import Resolver

#: Its package.xml exports the directory to Gazebo's model path.
ON_THE_MODEL_PATH = "model://mid360.stl"

#: The corpus lists no more missing references of a model than these.
LISTED = 40

#: Two tests of the urdf package, which no XML reader takes.
NOT_XML = {"fail_pr2_desc_no_joint2.urdf", "fail_three_links_one_joint.urdf"}

#: The models that can be read, and whose references the corpus knows.
ENTRIES = [
    entry
    for entry in manifest()
    if "meshes_missing" in entry.facts.get("expect", {}) and entry.path.name not in NOT_XML
]


def missing(path: Path, arguments: dict[str, str]) -> tuple[set[str], int]:
    """The references of a model that lead to no file, and the number of references."""
    context = Context(Source.read(path), Resolver(environment={}), arguments)
    if context.reading.document is None:
        pytest.fail(f"does not expand: {context.reading.problems[0].message}")
    meshes = context.files.meshes
    return {mesh.at.value for mesh in meshes if mesh.located.path is None}, len(meshes)


def below_corpus(references: set[str]) -> set[str]:
    """With file:// paths as the corpus states them: relative to it."""
    return {reference.replace(f"file://{CORPUS}/", "file://") for reference in references}


@needs_corpus
@pytest.mark.parametrize("entry", ENTRIES, ids=model_id)
def test_meshes_of_a_real_robot(entry: CorpusRobot) -> None:
    facts, path = entry.facts["expect"], entry.path
    found, count = missing(path, entry.arguments)
    stated = set(facts["meshes_missing"]) | set(facts["meshes_absent_only_in_this_copy"])
    if len(facts["meshes_missing"]) < LISTED:
        assert below_corpus(found) == stated - {ON_THE_MODEL_PATH}
    else:
        assert stated <= found
        assert {reference.split("/")[2] for reference in found} == {"nao_meshes"}
    assert count == facts["mesh_references"]
    if facts["meshes_resolve"]:
        assert found == set()


@needs_corpus
def test_every_kind_of_outcome_occurs() -> None:
    facts = [model["expect"] for _, model in ENTRIES]
    assert sum(bool(fact["meshes_missing"]) for fact in facts) > 10
    assert sum(bool(fact["meshes_absent_only_in_this_copy"]) for fact in facts) > 10
    assert sum(bool(fact["meshes_resolve"]) for fact in facts) > 10
    assert {rule for fact in facts for rule in fact["mesh_rules"]} == {
        "package.xml",
        "relative",
        "file-uri",
    }


def layouts() -> list[tuple[str, dict[str, Any]]]:
    """What the CMake files of the corpus install, where that is another layout."""
    file = CORPUS / "INSTALL_LAYOUT.json"
    if not file.is_file():
        return []
    found = json.loads(file.read_text(encoding="utf-8")).items()
    return [(name, layout) for name, layout in found if name.startswith("ros2_control_demos/")]


@needs_corpus
def test_models_that_only_an_installed_layout_makes_whole(tmp_path: Path) -> None:
    """ros2_control_demos with the CMake files that the corpus leaves out."""
    name = "ros2_control_demos"
    copy = shutil.copytree(CORPUS / name, tmp_path / "src" / name)
    for directory, layout in layouts():
        rows = "".join(
            f"install(DIRECTORY {source}\n  DESTINATION {target})\n"
            for source, target in layout["install_directory"]
        )
        text = f"project({layout['project']})\n{rows}"
        package = tmp_path / "src" / directory
        if package.is_dir():
            package.chmod(0o755)
            (package / "CMakeLists.txt").write_text(text, encoding="utf-8")
    robots = [entry for entry in ENTRIES if entry.repository.name == name]
    assert len(robots) == 16
    for robot in robots:
        found, _ = missing(copy / robot.facts["path"], robot.arguments)
        assert found == set(), robot.facts["path"]
