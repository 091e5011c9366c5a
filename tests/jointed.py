"""Robots for the tests of the rules about joints."""


def joint(name: str, kind: str, content: str = "", parent: str = "base") -> str:
    """A joint that holds the link of its name, with that link; on two lines."""
    return (
        f'<link name="{name}_link"/>\n'
        f'<joint name="{name}" type="{kind}"><parent link="{parent}"/>'
        f'<child link="{name}_link"/>{content}</joint>\n'
    )


def limit(lower: str, upper: str, effort: str = "10", velocity: str = "1") -> str:
    return f'<limit lower="{lower}" upper="{upper}" effort="{effort}" velocity="{velocity}"/>'


def mimic(leader: str, rest: str = "") -> str:
    return f'<mimic joint="{leader}" {rest}/>'


def robot(*joints: str) -> str:
    """Joints on a base; the joint with the number n from 0 is on line 4 + 2 n."""
    return '<link name="base"/>\n' + "".join(joints)


def of_xacro(content: str) -> str:
    return f'<robot name="r" xmlns:xacro="http://www.ros.org/wiki/xacro">{content}</robot>'
