import pytest

from tests.conftest import MISSION
from tests.massive import inertial, joint, link
from tests.naming import naming
from tests.reported import messages, places, reported
from urdfkit.lint import engine
from urdfkit.text.diagnostic import Severity

MOMENTS = (0.1, 0.1, 0.1)


def chain(*masses: float, kind: str = "revolute") -> str:
    robot = link("base", inertial(5, MOMENTS))
    above = "base"
    for number, mass in enumerate(masses):
        robot += link(f"l{number}", inertial(mass, MOMENTS))
        robot += joint(above, f"l{number}", kind)
        above = f"l{number}"
    return robot


def test_a_light_link_with_a_heavy_one_on_it() -> None:
    robot = chain(0.005, 15)
    assert messages("INE014", robot) == [naming("l0", "0.005 kg", "15 kg", "3000", "1000")]
    assert places("INE014", robot) == [(4, "0.005")]


@pytest.mark.parametrize(
    ("robot", "found"),
    [
        (chain(0.011, 10), 0),
        (chain(0.009, 10), 1),
        (chain(0.009, 3, 3, 4), 1),  # all that it carries
        (chain(10, 0.001), 0),  # a light hand on a heavy arm
        (chain(0.001), 0),
        (chain(1e-7, 10), 0),  # INE004
        (chain(0.001, 10, kind="fixed"), 0),  # one body
    ],
)
def test_what_is_extreme(robot: str, found: int) -> None:
    assert len(messages("INE014", robot)) == found


@pytest.mark.parametrize(
    ("targets", "severity"),
    [((), Severity.INFO), (("pinocchio",), Severity.INFO), (("gz-jetty",), Severity.WARNING)],
)
def test_who_suffers(targets: tuple[str, ...], severity: Severity) -> None:
    (found,) = reported("INE014", chain(0.001, 10), targets=targets)
    assert found.severity is severity


def test_the_mission_s_model_is_calm_across_its_fixed_joints() -> None:
    assert engine.check(MISSION, select=["INE014"]).diagnostics == ()
