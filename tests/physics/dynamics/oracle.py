"""A robot by numpy and the standard library alone: nothing of urdfkit is used here."""

from __future__ import annotations

import re
from collections.abc import Mapping
from typing import Any
from xml.etree import ElementTree

import numpy as np


def numbers(element: ElementTree.Element | None, key: str, default: str) -> Any:
    text = element.get(key, default) if element is not None else default
    return np.array([float(part) for part in text.split()])


def turn(axis: Any, angle: float) -> Any:
    """By the exponential of a matrix: scaled down, summed, squared up."""
    x, y, z = np.asarray(axis) / np.linalg.norm(axis) * angle / 1024
    small = np.array([[0, -z, y], [z, 0, -x], [-y, x, 0]])
    term = total = np.eye(3)
    for order in range(1, 10):
        term = term @ small / order
        total = total + term
    return np.linalg.matrix_power(total, 1024)


def origin(element: ElementTree.Element) -> Any:
    at = element.find("origin")
    roll, pitch, yaw = numbers(at, "rpy", "0 0 0")
    frame = np.eye(4)
    frame[:3, :3] = turn([0, 0, 1], yaw) @ turn([0, 1, 0], pitch) @ turn([1, 0, 0], roll)
    frame[:3, 3] = numbers(at, "xyz", "0 0 0")
    return frame


def moved(joint: ElementTree.Element, position: float) -> Any:
    axis, frame = numbers(joint.find("axis"), "xyz", "1 0 0"), np.eye(4)
    if joint.get("type") == "prismatic":
        frame[:3, 3] = axis / np.linalg.norm(axis) * position
    elif joint.get("type") in ("revolute", "continuous") and position:
        frame[:3, :3] = turn(axis, position)
    return frame


def parsed(text: bytes) -> ElementTree.Element:
    return ElementTree.fromstring(re.sub(rb"^\s*<\?xml[^>]*>", b"", text))  # some misspell it


class Frames:
    """Where links are at a pose of all joints, in the frame of the root."""

    def __init__(self, robot: ElementTree.Element, pose: Mapping[str, float]) -> None:
        self.pose = pose
        self.parents: dict[str | None, Any] = {}
        self.found: dict[str | None, Any] = {}
        for joint in robot.findall("joint"):
            parent, child = joint.find("parent"), joint.find("child")
            assert parent is not None
            assert child is not None
            self.parents[child.get("link")] = (parent.get("link"), joint)

    def __getitem__(self, link: str | None) -> Any:
        if link not in self.parents:
            return np.eye(4)
        if link not in self.found:
            above, joint = self.parents[link]
            own = moved(joint, self.pose.get(joint.get("name") or "", 0.0))
            self.found[link] = self[above] @ origin(joint) @ own
        return self.found[link]


def placement(text: bytes, link: str, pose: Mapping[str, float]) -> Any:
    return Frames(parsed(text), pose)[link]


def mass_and_center(text: bytes, pose: Mapping[str, float]) -> tuple[float, Any]:
    """Of all links, at a pose of all joints, in the frame of the root."""
    robot = parsed(text)
    frames = Frames(robot, pose)
    mass, moment = 0.0, np.zeros(3)
    for link in robot.findall("link"):
        inertial = link.find("inertial")
        weight = inertial.find("mass") if inertial is not None else None
        if inertial is None or weight is None:
            continue
        value = float(weight.get("value") or 0)
        mass += value
        moment += value * (frames[link.get("name")] @ origin(inertial))[:3, 3]
    return mass, moment / mass if mass else np.zeros(3)
