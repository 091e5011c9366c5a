"""Lidars, cameras, IMUs and force-torque sensors in MJCF, and their poses."""

from pathlib import Path

import pytest

from urdfkit.text.source import Source

mujoco = pytest.importorskip("mujoco")
np = pytest.importorskip("numpy")
from tests.output.conversion.test_mjcf import INERTIAL, LIMIT, arm, loaded


def test_lidars_measure(tmp_path: Path) -> None:
    wall = (
        '<collision><origin xyz="2 0 -0.5"/><geometry><box size="0.2 9 9"/></geometry></collision>'
    )
    tag = (
        '<gazebo reference="base"><sensor name="scan" type="gpu_lidar"><lidar><scan><horizontal>'
        "<samples>3</samples><min_angle>-0.5</min_angle><max_angle>0.5</max_angle></horizontal>"
        "</scan><range><min>0.1</min><max>30</max></range></lidar></sensor></gazebo>"
    )
    model, parts = loaded(arm(LIMIT, tip=INERTIAL + wall, more=tag), tmp_path / "o")
    data = mujoco.MjData(model)
    mujoco.mj_forward(model, data)
    assert data.sensordata == pytest.approx([1.9 / np.cos(0.5), 1.9, 1.9 / np.cos(0.5)])
    assert model.sensor_cutoff.tolist() == [30] * 3
    at = "gazebo/base/sensor/scan"
    assert parts[at] == "kept: rangefinders"
    assert parts[f"{at}/lidar/range/max"] == "kept: cutoff"
    assert parts[f"{at}/lidar/range/min"].startswith("lost: ")


def test_rays_of_a_lidar_are_limited(tmp_path: Path) -> None:
    tag = (
        '<gazebo reference="base"><sensor name="scan" type="ray"><ray><scan><horizontal>'
        "<samples>1000000000</samples><min_angle>0</min_angle><max_angle>6</max_angle></horizontal>"
        "<vertical><samples>32</samples><min_angle>0</min_angle><max_angle>1</max_angle></vertical>"
        "</scan></ray></sensor></gazebo>"
    )
    model, parts = loaded(arm(LIMIT, more=tag), tmp_path / "o")
    assert model.nsensor == 352
    at = "gazebo/base/sensor/scan/ray/scan/vertical/samples"
    assert parts[at] == "approximated: 352 rangefinders for 32000000000 rays"


@pytest.mark.parametrize(
    ("pose", "position", "turn"),
    [
        ('<pose degrees="true">0.1 0 0 0 0 90</pose>', (0.1, 0, 0), 90),
        ('<pose rotation_format="quat_xyzw">0.1 0 0 0 0 1 1</pose>', (0.1, 0, 0), 90),
        ('<pose relative_to="base">0.1 0 0 0 0 0.5</pose>', (0.1, 0, -0.5), np.degrees(0.5)),
        ('<pose relative_to="turn">0.1 0 0 0 0 0</pose>', (0.1, 0, 0), 0),
    ],
)
def test_poses_of_sensors(
    pose: str, position: tuple[float, ...], turn: float, tmp_path: Path
) -> None:
    tag = f'<gazebo reference="tip"><sensor name="s" type="imu">{pose}</sensor></gazebo>'
    model, parts = loaded(arm(LIMIT, more=tag), tmp_path / "o")
    half = np.radians(turn) / 2
    assert model.site("s").pos == pytest.approx(position)
    assert model.site("s").quat == pytest.approx([np.cos(half), 0, 0, np.sin(half)])
    assert parts["gazebo/tip/sensor/s/pose"] == "kept: pose"


@pytest.mark.parametrize(
    ("pose", "reason"),
    [
        ("<pose>1 2 3</pose>", "the pose is not 6 finite numbers"),
        ('<pose relative_to="x">1 2 3 0 0 0</pose>', "relative to 'x', which is not a link"),
    ],
)
def test_an_invalid_pose_is_lost(pose: str, reason: str, tmp_path: Path) -> None:
    tag = f'<gazebo reference="tip"><sensor name="s" type="imu">{pose}</sensor></gazebo>'
    model, parts = loaded(arm(LIMIT, more=tag), tmp_path / "o")
    assert not model.site("s").pos.any()
    assert parts["gazebo/tip/sensor/s/pose"].startswith("lost")
    assert reason in parts["gazebo/tip/sensor/s/pose"]


def test_the_pose_of_a_camera_is_in_its_sensor(tmp_path: Path) -> None:
    tag = (
        '<gazebo reference="tip"><sensor name="s" type="camera"><pose>1 0 0 0 0 1.5707963267948966'
        "</pose><camera><pose>0.2 0 0 0 0 0</pose></camera></sensor></gazebo>"
    )
    model, _ = loaded(arm(LIMIT, more=tag), tmp_path / "o")
    assert model.cam_pos[0] == pytest.approx([1, 0.2, 0])


@pytest.mark.parametrize(
    ("frame", "turn"), [("", 0.0), ("<frame>sensor</frame>", 1.0), ("<frame>parent</frame>", -0.5)]
)
def test_axes_and_place_of_a_force_torque_sensor(frame: str, turn: float, tmp_path: Path) -> None:
    tag = (
        '<gazebo reference="turn"><sensor name="s" type="force_torque"><pose>0.1 0 0 0 0 1</pose>'
        f"<force_torque>{frame}<measure_direction>parent_to_child</measure_direction>"
        "</force_torque></sensor></gazebo>"
    )
    text = arm(LIMIT, more=tag).data.replace(b'"0 0 0.5"', b'"0 0 0.5" rpy="0 0 0.5"')
    model, parts = loaded(Source("arm.urdf", text), tmp_path / "o")
    assert model.site("s").pos == pytest.approx([0.1, 0, 0])
    assert model.site("s").quat == pytest.approx([np.cos(turn / 2), 0, 0, np.sin(turn / 2)])
    at = "gazebo/turn/sensor/s/force_torque"
    assert parts[f"{at}/measure_direction"] == "kept: sensors"
    data = mujoco.MjData(model)
    mujoco.mj_forward(model, data)
    assert data.sensordata[2] == pytest.approx(2 * 9.81)  # the parent bears the child


def test_rays_with_names_of_other_devices(tmp_path: Path) -> None:
    sensors = "".join(
        f'<sensor name="{name}" type="gpu_lidar"><lidar/></sensor>' for name in ("a", "a_0", "A")
    )
    tag = f'<gazebo reference="tip">{sensors}</gazebo>'
    model, _ = loaded(arm(LIMIT, more=tag), tmp_path / "o")
    assert len({model.sensor(number).name for number in range(model.nsensor)}) == 3
