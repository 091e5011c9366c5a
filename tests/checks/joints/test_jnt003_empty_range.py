import pytest

from tests.jointed import joint, limit, robot
from tests.naming import naming
from tests.reported import fixed, messages, places, reported


@pytest.mark.parametrize(("kind", "unit"), [("revolute", "rad"), ("prismatic", "m")])
def test_a_lower_limit_above_the_upper_one(kind: str, unit: str) -> None:
    text = robot(joint("j", kind, limit("2.5", "-1.5")))
    assert messages("JNT003", text) == [
        naming("j", "lower", f"2.5 {unit}", "upper", f"-1.5 {unit}")
    ]
    assert places("JNT003", text) == [(4, limit("2.5", "-1.5"))]
    assert limit("-1.5", "2.5") in fixed("JNT003", text)


@pytest.mark.parametrize(
    ("written", "ends", "missing"),
    [('lower="0.5"', ("0.5", "0"), "upper"), ('upper="-0.5"', ("0", "-0.5"), "lower")],
)
def test_what_is_not_written_is_0(written: str, ends: tuple[str, str], missing: str) -> None:
    content = f'<limit {written} effort="1" velocity="1"/>'
    (found,) = reported("JNT003", robot(joint("j", "revolute", content)))
    assert found.message == naming(
        "j", "lower", f"{ends[0]} rad", "upper", f"{ends[1]} rad", missing, "0"
    )
    assert found.fix is None


@pytest.mark.parametrize(("lower", "upper"), [("1", "-1"), ("1", "0"), ("0", "-1")])
def test_a_joint_that_is_free_in_pybullet_is_not_turned_into_one_that_is_not(
    lower: str, upper: str
) -> None:
    for kind, remedy in (("revolute", "make it continuous"), ("prismatic", "set them far apart")):
        (found,) = reported("JNT003", robot(joint("j", kind, limit(lower, upper))))
        assert found.fix is None
        assert found.help == naming(remedy)


@pytest.mark.parametrize(
    ("kind", "content"),
    [
        ("revolute", limit("-1", "1")),
        ("revolute", limit("1", "x")),  # URD005
        ("continuous", limit("1", "-1")),  # JNT020
        ("fixed", limit("1", "-1")),
        ("revolute", ""),
    ],
)
def test_no_finding(kind: str, content: str) -> None:
    assert reported("JNT003", robot(joint("j", kind, content))) == []


@pytest.mark.parametrize(
    ("other", "help", "ends"),
    [
        (limit("0", "0.98"), "write upper=\"0.98\", as joint 'ring' has", ("0", "0.98")),
        (limit("0", "0.97"), "swap them", ("-0.98", "0")),
        (limit("-0.98", "0"), "swap them", ("-0.98", "0")),
    ],
)
def test_the_sign_of_one_limit(other: str, help: str, ends: tuple[str, str]) -> None:
    """Another finger shows which of the two is wrong."""
    text = robot(joint("pinky", "revolute", limit("0", "-0.98")), joint("ring", "revolute", other))
    (found,) = reported("JNT003", text)
    assert found.help == help
    assert limit(*ends) in fixed("JNT003", text).splitlines()[3]
