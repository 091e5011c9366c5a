"""Macros that compute a tensor in the place of one that is the same for all."""

from pathlib import Path

import pytest

from tests.xacros import HEAD
from urdfkit.lint.fix import fix
from urdfkit.lint.fix_session import Fixes
from urdfkit.lint.loading import load

MACRO = """\
  <xacro:macro name="inertial" params="mass">
    <!-- a guess -->
    <inertial>
      <mass value="${mass}"/>
      <inertia ixx="0.1" ixy="0" ixz="0" iyy="0.1" iyz="0" izz="0.1"/>
    </inertial>
  </xacro:macro>
"""
BOX = '<geometry><box size="${w} 0.2  .1"/></geometry>'
CYLINDER = '<geometry><cylinder radius="0.06" length="0.05"/></geometry>'
SPHERE = '<geometry><sphere radius="${w/2}"/></geometry>'
MESH = '<geometry><mesh filename="a.stl"/></geometry>'
PROPERTY = '  <xacro:property name="w" value="0.3"/>\n'


def link(name: str, mass: float, geometry: str, origin: str = "") -> str:
    return (
        f'  <link name="{name}">\n    <collision>{origin}{geometry}</collision>\n'
        f'    <xacro:inertial mass="{mass}"/>\n  </link>\n'
    )


def fixed(directory: Path, body: str, name: str = "r.xacro") -> tuple[Fixes, Path]:
    file = directory / name
    file.write_text(f"{HEAD}\n{body}</robot>\n")
    fixes = fix(file, unsafe=True, select=["XAC014"])
    fixes.write()
    return fixes, file


def moments(file: Path, name: str) -> tuple[float, float, float]:
    inertial = load(file).links_by_name[name].inertial
    assert inertial is not None
    assert inertial.tensor is not None
    tensor = inertial.tensor.value
    assert (tensor.ixy, tensor.ixz, tensor.iyz) == (0, 0, 0)
    return tensor.ixx, tensor.iyy, tensor.izz


def test_each_shape_has_its_closed_form(tmp_path: Path) -> None:
    links = link("box", 6, BOX) + link("wheel", 0.5, CYLINDER) + link("ball", 2, SPHERE)
    fixes, file = fixed(tmp_path, PROPERTY + MACRO + links)
    assert [one.code for one in fixes.applied] == ["XAC014"]
    assert moments(file, "box") == pytest.approx(
        (6 / 12 * (0.2**2 + 0.1**2), 6 / 12 * (0.3**2 + 0.1**2), 6 / 12 * (0.3**2 + 0.2**2))
    )
    side = 0.5 / 12 * (3 * 0.06**2 + 0.05**2)
    assert moments(file, "wheel") == pytest.approx((side, side, 0.5 / 2 * 0.06**2))
    assert moments(file, "ball") == pytest.approx((0.4 * 2 * 0.15**2,) * 3)
    text = file.read_text()
    assert '<xacro:box_inertial mass="6" x="${w}" y="0.2" z=".1"/>' in text
    assert '<xacro:sphere_inertial mass="2" radius="${w/2}"/>' in text
    assert 'name="inertial"' not in text
    assert fix(file, unsafe=True).files == ()


@pytest.mark.parametrize(
    ("above", "reported"),
    [("  <!-- all alike -->\n", True), ("  <!-- robot -->\n\n", False), ("", False)],
)
def test_a_comment_above_the_macro_stays_and_is_named(
    tmp_path: Path, above: str, reported: bool
) -> None:
    fixes, file = fixed(tmp_path, above + MACRO + link("a", 6, CYLINDER) + link("b", 1, CYLINDER))
    assert above in file.read_text()
    fix = fixes.applied[0].fix
    assert fix is not None
    assert fix.title.endswith("; the comment above was about the old one") == reported


def test_the_inertial_is_where_the_shape_is(tmp_path: Path) -> None:
    origin = '<origin rpy="1.5 0 0" xyz="0 0 ${w}"/>'
    links = link("a", 6, BOX, origin) + link("b", 1, BOX, '<origin xyz="0 0 0"/>')
    _, file = fixed(tmp_path, PROPERTY + MACRO + links)
    inertial = load(file).links_by_name["a"].inertial
    assert inertial is not None
    assert list(inertial.origin.position) == [0, 0, 0.3]
    assert 'z=".1" xyz="0 0 ${w}" rpy="1.5 0 0"/>' in file.read_text()
    assert '<xacro:box_inertial mass="1" x="${w}" y="0.2" z=".1"/>' in file.read_text()


def test_calls_for_other_shapes_keep_the_macro(tmp_path: Path) -> None:
    links = link("a", 6, BOX) + link("b", 1, MESH)
    fixes, file = fixed(tmp_path, PROPERTY + MACRO + links)
    text = file.read_text()
    assert len(fixes.applied) == 1
    assert '<xacro:inertial mass="1"/>' in text
    assert text.index('name="inertial"') < text.index('name="box_inertial"')
    assert moments(file, "b") == (0.1, 0.1, 0.1)


def test_a_call_in_a_macro_is_edited_once_for_all_its_uses(tmp_path: Path) -> None:
    wheel = """\
  <xacro:macro name="wheel" params="name mass r">
    <link name="${name}">
      <visual><geometry><sphere radius="${r}"/></geometry></visual>
      <xacro:inertial mass="${mass}"/>
    </link>
  </xacro:macro>
  <xacro:wheel name="a" mass="1" r="0.1"/>
  <xacro:wheel name="b" mass="4" r="0.2"/>
"""
    fixes, file = fixed(tmp_path, MACRO + wheel)
    assert len(fixes.applied) == 1
    assert '<xacro:sphere_inertial mass="${mass}" radius="${r}"/>' in file.read_text()
    assert moments(file, "b") == pytest.approx((0.4 * 4 * 0.04,) * 3)


def test_a_shape_that_another_macro_makes_cannot_be_passed_on(tmp_path: Path) -> None:
    shape = f'  <xacro:macro name="shape" params="r">{SPHERE}</xacro:macro>\n'
    links = link("a", 6, '<xacro:shape r="1"/>') + link("b", 1, '<xacro:shape r="2"/>')
    fixes, _ = fixed(tmp_path, PROPERTY + MACRO + shape + links)
    assert fixes.applied == ()


@pytest.mark.parametrize(
    ("old", "new"),
    [
        ('params="mass"', 'params="mass other:=1"'),  # fine: the calls do not give it
        ("<inertial>\n", "<inertial>\n      <origin xyz='0 0 0.0'/>\n"),
    ],
)
def test_harmless_variants(tmp_path: Path, old: str, new: str) -> None:
    body = MACRO.replace(old, new) + link("a", 6, CYLINDER) + link("b", 1, CYLINDER)
    assert len(fixed(tmp_path, body)[0].applied) == 1


@pytest.mark.parametrize(
    ("old", "new"),
    [
        ("<inertial>\n", "<inertial>\n      <origin xyz='0 0 0.1'/>\n"),
        ("${mass}", "${mass * 2}"),
        ("    </inertial>\n", "    </inertial>\n    <visual/>\n"),
    ],
)
def test_a_macro_that_does_more_is_left(tmp_path: Path, old: str, new: str) -> None:
    body = MACRO.replace(old, new) + link("a", 6, CYLINDER) + link("b", 1, CYLINDER)
    fixes, _ = fixed(tmp_path, body)
    assert fixes.applied == ()
    assert [one.reason for one in fixes.left] == [""]


def test_names_that_are_taken_are_not_taken_again(tmp_path: Path) -> None:
    other = '  <xacro:macro name="{}" params="m"><link name="${{m}}"/></xacro:macro>\n'
    links = link("a", 6, CYLINDER) + link("b", 1, CYLINDER)
    _, file = fixed(tmp_path, other.format("cylinder_inertial") + MACRO + links)
    assert 'name="solid_cylinder_inertial"' in file.read_text()


def test_the_macro_of_an_included_file_stays_for_others(tmp_path: Path) -> None:
    (tmp_path / "macros.xacro").write_text(f"{HEAD}\n{MACRO}</robot>\n")
    include = '  <xacro:include filename="macros.xacro"/>\n'
    links = link("a", 6, CYLINDER) + link("b", 1, CYLINDER)
    fixes, file = fixed(tmp_path, include + links)
    assert len(fixes.files) == 2
    library = (tmp_path / "macros.xacro").read_text()
    assert 'name="inertial"' in library
    assert 'name="cylinder_inertial"' in library
    assert "cylinder_inertial mass" in file.read_text()
