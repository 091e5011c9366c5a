"""fix() on real robots and on damaged ones: nothing gets worse, and twice is once."""

import shutil
import tempfile
from collections import Counter
from pathlib import Path
from typing import Any

import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st

from tests.conftest import CORPUS, MODELS, CorpusRobot, manifest, model_id, needs_corpus
from urdfkit.lint.engine import check, contexts
from urdfkit.lint.fix import fix
from urdfkit.lint.options import Options
from urdfkit.text.diagnostic import Severity
from urdfkit.text.source import Source

pytestmark = pytest.mark.usefixtures("only_the_corpus")

#: One entry of each file: with other arguments the same text is fixed.
ENTRIES = list({entry.path: entry for entry in manifest()}.values())


@pytest.fixture(scope="module")
def copy(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A copy of all real robots."""
    directory = tmp_path_factory.mktemp("corpus") / "corpus"
    shutil.copytree(CORPUS, directory, symlinks=True)
    return directory


@needs_corpus
@pytest.mark.parametrize("entry", ENTRIES, ids=model_id)
def test_safe_fixes_leave_nothing_new(copy: Path, entry: CorpusRobot) -> None:
    file, arguments = copy / entry.path.relative_to(CORPUS), entry.arguments
    fixes = fix(file, arguments=arguments, force=True)
    assert [one for one in fixes.left if one.diagnostic.fix and not one.reason] == []
    if not fixes.files:
        return
    before = check(file, arguments=arguments)
    fixes.write()
    after = check(file, arguments=arguments)
    assert not _codes(after) - _codes(before)
    assert _codes(after) == _codes(fixes.report)
    assert {one.path for one in after.skipped} <= {one.path for one in before.skipped}


#: Robots that are large, or much like others, are left out: their checks take long.
SOME = [entry for entry in ENTRIES[::2] if "pr2" not in entry.facts["path"]]


@needs_corpus
@pytest.mark.parametrize("entry", SOME, ids=model_id)
def test_unsafe_fixes_add_no_error_and_are_applied_once(entry: CorpusRobot) -> None:
    file, arguments = entry.path, entry.arguments
    fixes = fix(file, arguments=arguments, force=True, unsafe=True)
    texts = {rewrite.path: rewrite.after for rewrite in fixes.files}
    if texts:
        before = check(file, arguments=arguments)
        assert not _errors(fixes.report) - _errors(before)
        old, new = (_parts(file, arguments, some) for some in ({}, texts))
        reported = "".join(
            f"{call.message} {call.element} {[note.message for note in found.related]}"
            for found in fixes.applied
            for call in found.calls
        )
        assert [
            name for name in old.keys() & new if old[name] != new[name] and name not in reported
        ] == []
        again = fix(
            file, arguments=arguments, force=True, unsafe=True, options=Options(texts=texts)
        )
        assert [one.code for one in again.applied] == []


def _parts(file: Path, arguments: Any, texts: dict[str, bytes]) -> dict[str, tuple[Any, ...]]:
    """What mechanics knows of each link and joint, by its name."""
    # The first is the robot as it was named; launch files may start others from the same file.
    context, *_ = contexts(Options(arguments=arguments, texts=texts), [file])
    assert context is not None
    if context.reading.document is None:
        return {}
    parts: dict[str, tuple[Any, ...]] = {}
    for link in context.model.links:
        inertial = link.inertial
        tensor = inertial.tensor.value if inertial and inertial.tensor else None
        parts[link.name] = (link.mass, tensor, inertial and inertial.origin)
    for joint in context.model.joints:
        parts[joint.name] = (joint.kind, joint.origin, joint.axis and joint.axis.value)
    return parts


def _codes(report: Any) -> Counter[str]:
    return Counter(one.code for one in report.diagnostics)


def _errors(report: Any) -> Counter[str]:
    found = (one for one in report.diagnostics if one.severity is Severity.ERROR)
    return Counter(one.code for one in found)


#: What a mistake does to a robot.
SLIPS = (
    (b"<origin", b"<orgin"),
    (b'link="', b'link="x'),
    (b"limit ", b"limti "),
    (b"lower=", b"upper="),
    (b"xyz=", b"xzy="),
    (b'type="revolute"', b'type="Revolute"'),
    (b'type="continuous"', b'type="fixed"'),
    (b"<axis", b"<mu1>1</mu1><axis"),
    (b"</link>", b"<kp>1e6</kp></link>"),
    (b"1.57", b"90"),
    (b"0 0 1", b"0 0 1.0001"),
    (b".stl", b".STL"),
    (b"<geometry>", b"<geometry><material name='m'/>"),
    (b"</joint>", b"<anchor/></joint>"),
    (b'ixx="', b'ixx="100'),
    (b"<?xml", b"\n<?xml"),
    (b"\n", b"\r\n"),
)


def _robots() -> list[Path]:
    real = (entry.path for entry in ENTRIES)
    small = [file for file in real if file.is_file() and file.stat().st_size < 30_000]
    return [
        *sorted(MODELS.rglob("*.urdf")),
        MODELS / "gazebo_pkg/urdf/waking_robot_new.xacro",
        *small,
    ]


@settings(suppress_health_check=[HealthCheck.function_scoped_fixture])
@given(st.data())
def test_a_damaged_robot_is_fixed_once_and_for_all(data: st.DataObject) -> None:
    """In memory, where the files beside the robot are found as ever."""
    file = data.draw(st.sampled_from(_robots()))
    text = Source.read(file).data
    for old, new in data.draw(st.lists(st.sampled_from(SLIPS), min_size=1, max_size=4)):
        places = text.count(old)
        if places:
            text = _replaced(text, old, new, data.draw(st.integers(0, min(places, 20) - 1)))
    unsafe = data.draw(st.booleans())
    with tempfile.TemporaryDirectory() as directory:
        robot = Path(directory) / file.name
        robot.write_bytes(text)
        before = check(robot)
        once = fix(robot, unsafe=unsafe, force=True)
        once.write()
        after = check(robot)
        assert not _errors(after) - _errors(before) or _hidden(before)
        assert after.crashed == ()
        twice = fix(robot, unsafe=unsafe, force=True)
        assert [one.code for one in twice.applied] == []
        assert twice.files == ()


def _replaced(text: bytes, old: bytes, new: bytes, number: int) -> bytes:
    """The text with one of the occurrences replaced."""
    at = -1
    for _ in range(number + 1):
        at = text.index(old, at + 1)
    return text[:at] + new + text[at + len(old) :]


def _hidden(report: Any) -> bool:
    """True if rules could not look, because the robot could not be read."""
    return any("read" in one.reason or "expand" in one.reason for one in report.skipped)
