from __future__ import annotations

from tests.gazebos import BASE, plugin
from tests.reported import places, reported
from urdfkit.ros.catalog import plugins


def test_a_vendors_library_is_told_once() -> None:
    text = BASE + plugin("libvendor.so") + plugin("libvendor.so") + plugin("libother.so")
    assert places("GAZ011", text) == [(4, "libvendor.so"), (10, "libother.so")]


def test_a_slip_is_told_elsewhere() -> None:
    assert reported("GAZ011", BASE + plugin("libgazebo_ros_diffdrive.so")) == []


def test_every_library_of_the_catalogue_is_known() -> None:
    assert reported("GAZ011", BASE + "".join(plugin(file) for file in plugins.files())) == []


def test_no_name_is_told_elsewhere() -> None:
    assert reported("GAZ011", BASE + plugin("")) == []
