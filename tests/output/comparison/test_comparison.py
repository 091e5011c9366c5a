"""compare(): two states of a robot, from files and from git."""

import base64
import io
import json
import os
import subprocess
import sys
from math import cos, pi, sin
from pathlib import Path
from typing import Any

import pytest

from urdfkit.core.installation import install_command
from urdfkit.errors import UnreadableFile, UnreadableRobot, UrdfkitError
from urdfkit.lint.options import Options
from urdfkit.output.comparison import KINDS, Comparison, compare, surfaces
from urdfkit.output.comparison import html as as_html
from urdfkit.output.comparison import json as as_json
from urdfkit.output.comparison import markdown as as_markdown
from urdfkit.output.comparison import text as as_text
from urdfkit.output.comparison.differences import Tolerances

ARM = """\
<robot name="arm">
  <link name="base"><inertial><mass value="2"/>
    <inertia ixx="0.1" ixy="0" ixz="0" iyy="0.1" iyz="0" izz="0.1"/></inertial>
    <visual><geometry><mesh filename="base.obj"/></geometry></visual></link>
  <link name="upper"><inertial><mass value="1"/>
    <inertia ixx="0.1" ixy="0" ixz="0" iyy="0.1" iyz="0" izz="0.1"/></inertial></link>
  <link name="tool"/>
  <joint name="shoulder" type="revolute"><origin xyz="0 0 1" rpy="0 0 0"/>
    <parent link="base"/><child link="upper"/><axis xyz="0 1 0"/>
    <limit lower="-1" upper="2" effort="40" velocity="2"/></joint>
  <joint name="flange" type="fixed"><origin xyz="0.5 0 0"/>
    <parent link="upper"/><child link="tool"/></joint>
</robot>
"""
TRIANGLE = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n"


@pytest.fixture
def pair(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """Two directories with one robot each."""
    monkeypatch.chdir(tmp_path)
    for name in ("a", "b"):
        (tmp_path / name).mkdir()
        (tmp_path / name / "arm.urdf").write_text(ARM)
        (tmp_path / name / "base.obj").write_text(TRIANGLE)
    return tmp_path


def changed(pair: Path, old: str, new: str, **allowed: Any) -> Comparison:
    """What one change of the text makes different."""
    assert old in ARM
    (pair / "b" / "arm.urdf").write_text(ARM.replace(old, new))
    return compare("a/arm.urdf", "b/arm.urdf", tolerances=Tolerances(**allowed))


def test_the_same_robot_does_not_differ(pair: Path) -> None:
    found = compare("a/arm.urdf", "b/arm.urdf")
    assert found.kinds == set()
    assert (found.differences, found.moved, found.new_findings, found.fixed_findings) == (
        (),
        (),
        (),
        (),
    )
    assert as_text.render(found).splitlines() == ["a/arm.urdf -> b/arm.urdf", "no differences"]


def test_progress_is_reported_in_steps(pair: Path) -> None:
    reported: list[tuple[int, int]] = []
    compare("a/arm.urdf", "b/arm.urdf", progress=lambda done, total: reported.append((done, total)))
    assert reported == [(0, 3), (1, 3), (2, 3)]


def test_a_frame_that_moved_carries_what_hangs_on_it(pair: Path) -> None:
    """The flange is 0.5 m from the shoulder: turned by t, it moves by 2 * 0.5 * sin(t / 2)."""
    turn = 0.1
    found = changed(pair, 'rpy="0 0 0"', f'rpy="0 {turn} 0"')
    upper, tool = found.moved
    assert (upper.link, upper.distance, upper.carried) == ("upper", 0.0, False)
    assert (tool.link, tool.carried) == ("tool", True)
    assert tool.distance == pytest.approx(sin(turn / 2), abs=1e-12)
    assert [upper.angle, tool.angle] == pytest.approx([turn, turn], abs=1e-9)
    assert found.kinds == {"frames"}
    assert "upper      0.000     5.730" in as_text.render(found)
    assert "and 1 child link with them" in as_text.render(found)


def test_a_turn_by_half_a_circle_is_one(pair: Path) -> None:
    found = changed(pair, 'rpy="0 0 0"', f'rpy="0 0 {pi}"')
    assert found.moved[0].angle == pytest.approx(pi, abs=1e-7)
    assert found.moved[1].distance == pytest.approx(1.0, abs=1e-12)


def test_the_total_is_that_of_all_links_where_they_are(pair: Path) -> None:
    """2 kg at the origin and 1 kg, then 2 kg, 1 m above it."""
    found = changed(pair, '<mass value="1"/>', '<mass value="2"/>')
    assert (found.whole.mass, found.whole_after.mass) == (3.0, 4.0)
    assert found.centers is not None
    assert found.centers[0] == pytest.approx((0, 0, 1 / 3))
    assert found.centers[1] == pytest.approx((0, 0, 1 / 2))
    assert found.center_moved == pytest.approx(1 / 6)
    assert found.kinds == {"masses"}
    assert "(166.7 mm)" in as_text.render(found)


def test_where_nothing_joins_the_parts_they_have_no_centre(pair: Path) -> None:
    """They were taken for bodies at one place."""
    joint = ARM[ARM.index("<joint") : ARM.index("</joint>") + len("</joint>")]
    found = changed(pair, joint, "")
    assert (found.whole_after.mass, found.centers, found.center_moved) == (3.0, None, 0.0)
    assert found.whole_after.reason == "no joint connects the roots base, upper"
    assert "masses" not in found.kinds


def test_tolerances_hold_for_frames_and_totals(pair: Path) -> None:
    wide = {"position": 0.02, "rotation": 0.01}
    assert changed(pair, 'xyz="0 0 1"', 'xyz="0 0 1.019"', **wide).kinds == set()
    assert changed(pair, 'xyz="0 0 1"', 'xyz="0 0 1.021"', **wide).kinds == {"frames"}
    assert changed(pair, 'value="2"', 'value="2.2"', mass=0.1, position=1).kinds == set()
    assert changed(pair, 'value="2"', 'value="2.2"', mass=0.09, position=1).kinds == {"masses"}


def test_findings_that_came_and_went(pair: Path) -> None:
    found = changed(pair, 'lower="-1" upper="2"', 'lower="3" upper="2"')
    assert [one.code for one in found.new_findings] == ["JNT003"]
    assert found.kinds == {"limits", "findings"}
    back = compare("b/arm.urdf", "a/arm.urdf")
    assert [one.code for one in back.fixed_findings] == ["JNT003"]
    assert back.kinds == {"limits"}
    assert "- b/arm.urdf:10:" in as_text.render(back)


def test_a_finding_on_another_line_with_other_numbers_is_the_same(pair: Path) -> None:
    (pair / "a" / "arm.urdf").write_text(ARM.replace('lower="-1"', 'lower="3"'))
    (pair / "b" / "arm.urdf").write_text("\n\n" + ARM.replace('lower="-1"', 'lower="4"'))
    found = compare("a/arm.urdf", "b/arm.urdf")
    assert (found.new_findings, found.fixed_findings) == ((), ())


def test_surfaces_are_measured(pair: Path) -> None:
    """The mesh turned about an edge: its far vertex is 0.01 off."""
    pytest.importorskip("trimesh")
    pytest.importorskip("scipy")
    bent = TRIANGLE.replace("v 0 1 0", f"v 0 {cos(0.01)} {sin(0.01)}")
    (pair / "b" / "base.obj").write_text(bent)
    (one,) = compare("a/arm.urdf", "b/arm.urdf").differences
    assert (one.kind, one.name) == ("meshes", "base")
    assert one.after == pytest.approx(sin(0.01), rel=0.01)
    assert compare("a/arm.urdf", "b/arm.urdf", tolerances=Tolerances(position=0.011)).kinds == set()


def test_the_same_surface_in_other_bytes_does_not_differ(pair: Path) -> None:
    pytest.importorskip("trimesh")
    pytest.importorskip("scipy")
    (pair / "b" / "base.obj").write_text("# again\nv 0 1 0\nv 0 0 0\nv 1 0 0\nf 2 3 1\n")
    assert compare("a/arm.urdf", "b/arm.urdf").kinds == set()


def test_without_trimesh_the_bytes_are_compared(
    pair: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    def missing(*_: object) -> None:
        raise ImportError

    monkeypatch.setattr(surfaces, "_distance", missing)
    (pair / "b" / "base.obj").write_text(TRIANGLE + "\n")
    found = compare("a/arm.urdf", "b/arm.urdf")
    assert [str(one) for one in found.differences] == [
        "link 'base': the file of its visual mesh 'base.obj' differs"
    ]
    assert install_command("meshes") in as_text.render(found)


def test_a_mesh_that_is_gone(pair: Path) -> None:
    (pair / "b" / "base.obj").unlink()
    found = compare("a/arm.urdf", "b/arm.urdf")
    assert "link 'base': the file of its visual mesh 'base.obj' is not found any more" in map(
        str, found.differences
    )
    assert [one.code for one in found.new_findings] == ["MSH001"]


# --- git


def git(directory: Path, *words: str) -> None:
    who = ["-c", "user.name=t", "-c", "user.email=t@example.org", "-c", "init.defaultBranch=main"]
    subprocess.run(["git", *who, *words], cwd=directory, check=True, capture_output=True)


@pytest.fixture
def repository(pair: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """A robot in a directory of a repository, committed, then changed."""
    top = pair / "a"
    (top / "urdf").mkdir()
    for name in ("arm.urdf", "base.obj"):
        (top / name).rename(top / "urdf" / name)
    git(top, "init")
    git(top, "add", ".")
    git(top, "commit", "-m", "one")
    (top / "urdf" / "arm.urdf").write_text(ARM.replace('lower="-1"', 'lower="3"'))
    git(top, "commit", "-am", "two")
    monkeypatch.chdir(top)
    return top


def test_revisions_from_the_top_and_from_a_directory(
    repository: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    kinds = {"limits", "findings"}
    assert compare("HEAD~1:urdf/arm.urdf", "HEAD:urdf/arm.urdf").kinds == kinds
    monkeypatch.chdir(repository / "urdf")
    assert compare("HEAD~1:arm.urdf", "arm.urdf").kinds == kinds
    assert compare("HEAD~1:urdf/arm.urdf", "HEAD:./arm.urdf").kinds == kinds
    assert compare("HEAD:arm.urdf", "arm.urdf").kinds == set()


@pytest.mark.skipif(sys.platform != "linux", reason="elsewhere names of files are text")
def test_a_repository_whose_name_is_no_text(
    repository: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    renamed = repository.with_name(os.fsdecode(b"caf\xe9"))
    repository.rename(renamed)
    monkeypatch.chdir(renamed)
    assert compare("HEAD~1:urdf/arm.urdf", "HEAD:urdf/arm.urdf").kinds == {"limits", "findings"}


def test_a_package_that_a_revision_did_not_have(repository: Path) -> None:
    (repository / "hand").mkdir()
    options = Options(packages={"hand": str(repository / "hand")})
    found = compare("HEAD~1:urdf/arm.urdf", "urdf/arm.urdf", options=options)
    assert found.kinds == {"limits", "findings"}


def test_a_package_in_a_repository_below(repository: Path) -> None:
    (repository / "below" / "hand").mkdir(parents=True)
    (repository / "below" / "hand" / "package.xml").write_text(
        "<package><name>hand</name></package>"
    )
    (repository / "below" / "hand" / "base.obj").write_text(TRIANGLE)
    git(repository / "below", "init")
    robot = repository / "urdf" / "arm.urdf"
    robot.write_text(robot.read_text().replace('"base.obj"', '"package://hand/base.obj"'))
    git(repository, "commit", "-am", "three")
    assert compare("HEAD:urdf/arm.urdf", "urdf/arm.urdf").kinds == set()


def test_findings_of_a_revision_name_its_file(repository: Path) -> None:
    found = compare("HEAD:urdf/arm.urdf", "HEAD~1:urdf/arm.urdf")
    assert [one.span.source.path for one in found.fixed_findings] == ["HEAD:urdf/arm.urdf"]
    assert found.before == "HEAD:urdf/arm.urdf"


def test_a_file_that_is_gone_from_the_working_tree(repository: Path) -> None:
    git(repository, "rm", "-r", "urdf")
    assert compare("HEAD~1:urdf/arm.urdf", "HEAD:urdf/arm.urdf").kinds == {"limits", "findings"}


@pytest.mark.parametrize(
    ("word", "reason"),
    [
        ("HEAD:no.urdf", "no file 'no.urdf' in revision 'HEAD'"),
        ("nobody:urdf/arm.urdf", "no git revision 'nobody'"),
        ("--exec:urdf/arm.urdf", "no git revision '--exec'"),
        (":urdf/arm.urdf", "no git revision ''"),
        ("HEAD:", "no file '' in revision 'HEAD'"),
    ],
)
def test_what_git_does_not_have_is_said(repository: Path, word: str, reason: str) -> None:
    with pytest.raises(UrdfkitError, match=reason):
        compare(word, "urdf/arm.urdf")


def test_what_cannot_be_read_is_said(pair: Path) -> None:
    (pair / "b" / "arm.urdf").write_text("<robot")
    with pytest.raises(UnreadableRobot, match=r"b/arm\.urdf:1:1: "):
        compare("a/arm.urdf", "b/arm.urdf")
    with pytest.raises(UnreadableFile, match="none"):
        compare("a/arm.urdf", "none.urdf")


@pytest.mark.parametrize(
    ("name", "text", "reason"),
    [
        ("m.sdf", "<sdf><model name='m'/></sdf>", "the root element is <sdf>, not <robot>"),
        ("c.yaml", "node:\n  ros__parameters: {}\n", "is a parameter file and describes no robot"),
        ("m.xacro", "<robot name='m'/>", "it has no link"),
    ],
)
def test_what_is_no_robot_does_not_lack_each_link(
    pair: Path, name: str, text: str, reason: str
) -> None:
    (pair / name).write_text(text)
    with pytest.raises(UnreadableRobot, match=rf"{name}.*{reason}"):
        compare("a/arm.urdf", name)


def test_a_revision_that_cannot_be_read_is_named(repository: Path) -> None:
    (repository / "urdf" / "arm.urdf").write_text("<robot>\n<link></robot>")
    git(repository, "commit", "-am", "three")
    with pytest.raises(UnreadableRobot, match=r"^HEAD:urdf/arm\.urdf:2:1: "):
        compare("HEAD~1:urdf/arm.urdf", "HEAD:urdf/arm.urdf")


# --- formats


def test_json_has_everything(pair: Path) -> None:
    found = changed(pair, 'lower="-1" upper="2"', 'lower="3" upper="2"')
    document = json.loads(as_json.render(found))
    assert document["version"] == 1
    assert document["kinds"] == ["limits", "findings"]
    (limit,) = document["differences"]
    assert (limit["before"], limit["after"]) == (-1.0, 3.0)
    assert limit["sentence"] == "joint 'shoulder': lower -1 -> 3"
    (came,) = document["findings"]["came"]
    assert (came["code"], came["path"], came["line"]) == ("JNT003", "b/arm.urdf", 10)
    assert set(document["kinds"]) <= set(KINDS)


def test_nothing_of_a_robot_becomes_markup(pair: Path) -> None:
    evil = "x|`</td><img src=x onerror=alert(1)>@all[l](http://e)"
    text = ARM.replace("tool", evil.replace("<", "&lt;"))
    (pair / "b" / "arm.urdf").write_text(text)
    page = as_markdown.render(compare("a/arm.urdf", "b/arm.urdf"))
    assert "img src" in page
    for piece in ("<img", "[l](", "`"):
        assert page.count(piece) == page.count(f"\\{piece}")
    assert "@all" not in page
    rows = [line for line in page.splitlines() if line.startswith("| link")]
    assert len(rows) == 1  # it is now called otherwise
    assert {line.replace("\\|", "").count("|") for line in rows} == {3}


def test_markdown_fits_a_comment(pair: Path) -> None:
    links = "".join(f'<link name="l{number}"/>' for number in range(3000))
    found = changed(pair, '<link name="tool"/>', f'<link name="tool"/>{links}')
    page = as_markdown.render(found)
    assert len(page) <= 65_536
    assert page.endswith("_Cut to 65536 characters; the JSON has everything._\n")
    assert page.splitlines()[-3].startswith("| link ")


BALL = '<visual><geometry><sphere radius="0.5"/></geometry></visual>'
BOX = '<visual><geometry><box size="1 1 1"/></geometry></visual>'


def test_html_is_whole_and_escaped(pair: Path) -> None:
    pytest.importorskip("jinja2")
    pytest.importorskip("PIL")
    evil = "</script><script>alert(1)</script>"
    old = ARM.replace('<link name="tool"/>', f'<link name="tool">{BOX}</link>')
    new = old.replace("tool", evil.replace("<", "&lt;"))
    (pair / "a" / "arm.urdf").write_text(old)
    (pair / "b" / "arm.urdf").write_text(new)
    found = compare("a/arm.urdf", "b/arm.urdf", has_images=True)
    assert len(found.images) == 2
    assert all(one.startswith("data:image/webp;base64,") for one in found.images)
    page = as_html.render(found)
    assert page.count("<script>") == 1
    assert "&lt;/script&gt;&lt;script&gt;alert(1)" in page
    assert page.count('src="data:') == 2
    assert "src=" not in page.replace('src="data:', "")


def test_images_show_what_is_gone_and_what_is_new(pair: Path) -> None:
    """A red box in the state before, where the state after has a green one."""
    np = pytest.importorskip("numpy")
    image = pytest.importorskip("PIL.Image")
    old = ARM.replace('<link name="tool"/>', f'<link name="tool">{BOX}</link>')
    (pair / "a" / "arm.urdf").write_text(old)
    (pair / "b" / "arm.urdf").write_text(old.replace("tool", "hand").replace(BOX, BALL))
    found = compare("a/arm.urdf", "b/arm.urdf", has_images=True)
    shown = []
    for address in found.images:
        data = base64.b64decode(address.partition(",")[2])
        pixels = np.asarray(image.open(io.BytesIO(data)).convert("RGB"), dtype=int)
        red, green, blue = (pixels[..., i] for i in range(3))
        reds = np.count_nonzero((red > 2 * green) & (red > 2 * blue))
        greens = np.count_nonzero((green > 1.5 * red) & (green > 1.5 * blue))
        shown.append((reds > 5000, greens > 5000))
    assert shown == [(True, False), (False, True)]


def test_a_rename_is_reported_in_chinese(pair: Path) -> None:
    pytest.importorskip("jinja2")
    (pair / "b" / "arm.urdf").write_text(ARM.replace("tool", "hand"))
    page = as_html.render(compare("a/arm.urdf", "b/arm.urdf"), language="zh")
    assert "<code>tool</code></th><td>改名为 <code>hand</code></td>" in page
    assert '<span class="badge warning">名称</span>' in page


def test_text_in_another_layout_is_no_new_finding(tmp_path: Path) -> None:
    """A robot and its expansion: the stray text stood on a line of its own."""
    shape = '<geometry>s\n<box size="1 1 1"/></geometry>'
    before = f'<robot name="r"><link name="a"><visual>{shape}</visual></link></robot>'
    for name, text in (("a", before), ("b", before.replace(">s", ">\n  s\n"))):
        (tmp_path / f"{name}.urdf").write_text(text)
    found = compare(str(tmp_path / "a.urdf"), str(tmp_path / "b.urdf"))
    assert (found.new_findings, found.fixed_findings) == ((), ())
    (tmp_path / "a.urdf").write_text(before.replace(">s", ">"))
    found = compare(str(tmp_path / "a.urdf"), str(tmp_path / "b.urdf"))
    assert [finding.code for finding in found.new_findings] == ["URD017"]
