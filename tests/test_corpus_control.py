"""What the rules about control and packages say of every real robot, exactly."""

from __future__ import annotations

from tests.conftest import manifest, needs_corpus
from urdfkit.lint import engine

#: Each was looked at: the numbers and names are as told.
EXPECTED = {
    # a step of the tutorial that ends before the transmissions
    ("RCT010", "urdf_sim_tutorial/urdf/09-publishjoints.urdf.xacro"),
    # 2 pi commanded where the limit is pi, and velocities likewise
    ("RCT009", "ros2_control_demos/example_7/description/ros2_control/r6bot.ros2_control.xacro"),
    # meshes of packages beside it, which package.xml does not name
    (
        "PKG001",
        "pb_rm_simulation/src/rm_simulation/pb_rm_simulation/urdf/simulation_waking_robot.xacro",
    ),
    ("PKG001", "pb_rm_simulation/src/rm_nav_bringup/urdf/sentry_robot_real.xacro"),
    ("PKG001", "pb_rm_simulation/src/rm_nav_bringup/urdf/sentry_robot_sim.xacro"),
}


@needs_corpus
def test_every_real_robot() -> None:
    found: list[tuple[str, str]] = []
    for folder, model in manifest():
        arguments = dict(argument.split(":=", 1) for argument in model["xacro_args"])
        report = engine.check(
            folder / model["path"], arguments=arguments, select=["RCT", "PKG"], ignore=["CFG003"]
        )
        assert report.crashed == ()
        found += [
            (one.code, one.span.source.path.partition("/corpus/")[2]) for one in report.diagnostics
        ]
    assert set(found) == EXPECTED
    assert len(found) == len(EXPECTED), "each once"
