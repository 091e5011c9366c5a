"""Pieces of robots with Gazebo tags, for tests."""

BODY = (
    '<inertial><mass value="1"/>'
    '<inertia ixx="0.01" ixy="0" ixz="0" iyy="0.01" iyz="0" izz="0.01"/></inertial>'
)
BASE = f'<link name="base">{BODY}</link>\n'


def plugin(file: str, tags: str = "", name: str = "p") -> str:
    """A plugin of the model."""
    return f'<gazebo>\n<plugin name="{name}" filename="{file}">{tags}</plugin>\n</gazebo>\n'


def sensor(kind: str, inside: str, reference: str = "base") -> str:
    """A sensor with something in it."""
    return (
        f'<gazebo reference="{reference}">\n<sensor name="s" type="{kind}">\n'
        f"<update_rate>10</update_rate>\n{inside}</sensor>\n</gazebo>\n"
    )


def block(tags: str, reference: str = "base") -> str:
    """A block of a link or joint; of the model without a reference."""
    at = f' reference="{reference}"' if reference else ""
    return f"<gazebo{at}>\n{tags}\n</gazebo>\n"


def child(
    name: str,
    kind: str = "continuous",
    *,
    parent: str = "base",
    inside: str = BODY,
    xyz: str = "0 0 0",
    axis: str = "0 1 0",
) -> str:
    """A link and the joint that it hangs on, ``<name>_joint``."""
    limit = '<limit lower="-1" upper="1" effort="1" velocity="1"/>'
    return (
        f'<link name="{name}">{inside}</link>\n'
        f'<joint name="{name}_joint" type="{kind}"><parent link="{parent}"/>'
        f'<child link="{name}"/><origin xyz="{xyz}"/><axis xyz="{axis}"/>'
        f"{limit if kind in ('revolute', 'prismatic') else ''}</joint>\n"
    )


def wheel(name: str, y: float, *, radius: float = 0.1, axis: str = "0 1 0", at: float = 0.0) -> str:
    """A driven wheel with a cylinder; ``at`` is the offset of the tyre along its axle."""
    shape = (
        f'<collision><origin xyz="0 {at} 0" rpy="1.57079632679 0 0"/><geometry>'
        f'<cylinder radius="{radius}" length="0.04"/></geometry></collision>'
    )
    return child(name, inside=BODY + shape, xyz=f"0 {y} 0", axis=axis)


WHEELS = BASE + wheel("left", 0.15) + wheel("right", -0.15)
