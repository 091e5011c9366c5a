import pytest

from tests.conftest import MISSION
from tests.massive import BALL, joint, link, shape
from tests.naming import naming
from tests.reported import messages, places, reported
from urdfkit.lint import engine
from urdfkit.text.diagnostic import Severity

VISUAL, COLLISION = shape("visual", BALL), shape("collision", BALL)
BASE = link("base", VISUAL, COLLISION)


def test_each_link_at_its_first_visual() -> None:
    robot = BASE + link("mast", VISUAL, VISUAL) + joint("base", "mast")
    assert messages("GEO002", robot) == [naming("mast", "visual", "collision")]
    assert places("GEO002", robot) == [(3, "<visual>")]


def test_a_robot_without_collisions_is_one_finding() -> None:
    robot = link("base", VISUAL) + link("frame") + link("mast", VISUAL) + joint("base", "mast")
    assert messages("GEO002", robot) == [naming("none", "2", "visual", "collision")]
    assert places("GEO002", robot) == [(1, '<robot name="example">')]


def test_what_is_all_right() -> None:
    assert messages("GEO002", BASE + link("frame") + joint("base", "frame")) == []


@pytest.mark.parametrize(
    ("target", "severity"), [("classic-ros1", Severity.INFO), ("moveit", Severity.WARNING)]
)
def test_the_severity(target: str, severity: Severity) -> None:
    robot = BASE + link("mast", VISUAL) + joint("base", "mast")
    (found,) = reported("GEO002", robot, targets=(target,))
    assert found.severity is severity


def test_the_mission_s_model() -> None:
    (found,) = engine.check(MISSION, select=["GEO002"]).diagnostics
    assert (found.message, found.severity) == (
        naming("base_footprint", "visual", "collision"),
        Severity.INFO,
    )
    assert (found.span.line, found.span.text) == (25, "<visual>")


def test_a_collision_without_visual() -> None:
    robot = BASE + link("bump", COLLISION, COLLISION) + joint("base", "bump")
    assert messages("GEO002", robot) == [naming("bump", "collision", "visual")]
    assert places("GEO002", robot) == [(3, "<collision>")]
    (found,) = reported("GEO002", robot, targets=("moveit",))
    assert found.severity is Severity.INFO


def test_a_robot_without_shapes() -> None:
    arm = link("base") + link("arm") + joint("base", "arm", "revolute")
    assert messages("GEO002", arm) == [naming("none", "2", "visual", "collision")]
    assert places("GEO002", arm) == [(1, '<robot name="example">')]
    assert messages("GEO002", link("base")) == [naming("neither", "visual", "collision")]
    assert messages("GEO002", '<robot name="parts"/>') == []


class TestMovingLinksWithoutShape:
    def found(
        self, *more: str, mass: float = 0.5, kind: str = "continuous", base: str = BASE
    ) -> int:
        inertial = f'<inertial><mass value="{mass}"/></inertial>'
        robot = base + link("arm", inertial) + joint("base", "arm", kind) + "".join(more)
        return sum("neither" in one for one in messages("GEO002", robot))

    def test_it_is_reported(self) -> None:
        assert self.found() == 1

    def test_what_is_light_or_does_not_move(self) -> None:
        assert self.found(mass=0.0005) == self.found(kind="fixed") == 0

    def test_no_link_has_a_collision(self) -> None:
        assert self.found(base=link("base", VISUAL)) == 0

    @pytest.mark.parametrize("kind", ["fixed", "continuous"])
    def test_a_child_has_a_shape(self, kind: str) -> None:
        assert self.found(link("hand", VISUAL, COLLISION), joint("arm", "hand", kind)) == 0
