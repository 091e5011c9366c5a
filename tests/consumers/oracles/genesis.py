"""Genesis: its reader of URDF, without its simulator, which needs PyTorch."""

import importlib
import os
import sys
from functools import cache
from importlib.util import find_spec
from types import ModuleType
from typing import Any, NoReturn

import numpy

from tests.consumers.reading import Reading

PACKAGE = "genesis-world"
MODULE = "genesis"

CAUSES = {
    "XML declaration not well-formed": ("XML declaration", "XML007"),
    "unmatched data": ("number", "URD005"),
    "matching parent and child": ("a link below itself", "TRE003"),
    "DaeMalformedError": ("broken mesh", "MSH009"),
    "not physical": ("inertia", "INE001 INE003"),
    "Two links with name": ("two links of one name", "NAM001"),
    "Two joints with name": ("two joints of one name", "NAM001"),
    "Two materials with name": ("two materials of one name", "NAM001"),
    "invalid (parent|child) link name": ("unknown link", "REF001"),
    "invalid mimic joint": ("unknown leader", "REF001"),
    "invalid joint name": ("transmission of an unknown joint", "REF001"),
    "not all connected|both base links": ("roots", "TRE002 TRE003"),
    "cycles": ("cycle", "TRE003"),
    "Require joint limit": ("no limit", "JNT002"),
    "Asset file not found": ("missing file", "MSH001 MSH002 XAC011"),
    "could not convert string": ("number", "URD005"),
    "Missing required": ("missing part", "URD003 URD004 RCT024"),
    "'NoneType' object|no attribute|KeyError": ("missing part", "URD003 URD004"),
}


def read(path: str) -> Reading:
    """What it makes of a URDF."""
    robot = _reader().URDF.load(path)
    frames = {
        link.name: [*place[:3, 3].tolist(), *place[:3, :3].flatten().tolist()]
        for link, place in robot.link_fk().items()
    }
    for link in robot.links:
        if link.inertial and not _is_physical(link.inertial.inertia):
            raise ValueError(f"the inertia of {link.name} is not physical")
    masses = [link.inertial.mass for link in robot.links if link.inertial]
    return Reading(sum(mass or 0.0 for mass in masses), frames)


def _is_physical(tensor: Any) -> bool:
    """What the simulator asks of a tensor, in engine/entities/rigid_entity/description.py."""
    moments = numpy.linalg.eigvalsh(tensor)
    tolerance = 1e-6 * abs(moments).max() + 1e-9
    return bool(moments[0] >= -tolerance and moments[0] + moments[1] >= moments[2] - tolerance)


@cache
def _reader() -> Any:
    """``genesis.ext.urdfpy``, imported without the packages above it."""
    spec = find_spec(MODULE)
    assert spec is not None
    assert spec.submodule_search_locations is not None
    above = {MODULE: "", f"{MODULE}.ext": "ext"}
    for name, below in above.items():
        module = ModuleType(name)
        module.__path__ = [os.path.join(place, below) for place in spec.submodule_search_locations]
        sys.modules[name] = module
    sys.modules[MODULE].raise_exception = _raise  # type: ignore[attr-defined]
    reader = importlib.import_module(f"{MODULE}.ext.urdfpy")
    for name in above:
        del sys.modules[name]
    return reader


def _raise(message: str) -> NoReturn:
    raise ValueError(message)
