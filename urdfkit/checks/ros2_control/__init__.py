"""``<ros2_control>`` and the interfaces of its joints."""

from __future__ import annotations

from urdfkit.lint.context import Subject

#: Former codes and names of rules.
REDIRECTS = {
    "RCT013": "RCT001", "controllers-name-unknown-joint": "RCT001",
    "RCT008": "RCT002", "RCT031": "RCT002", "joint-cannot-move": "RCT002",
    "command-on-mimic": "RCT002", "mimic-by-parameter": "RCT002",
    "RCT011": "RCT005", "RCT028": "RCT005", "plugin-missing": "RCT005",
    "hardware-plugin-mismatch": "RCT005", "hardware-misspelt": "RCT005",
    "RCT018": "RCT007", "duplicate-component": "RCT007",
    "RCT019": "RCT009", "RCT020": "RCT009", "command-range-wider-than-limit": "RCT009",
    "empty-command-range": "RCT009", "initial-value-outside-limits": "RCT009",
    "RCT004": "RCT017", "RCT006": "RCT017", "RCT022": "RCT017", "RCT023": "RCT017",
    "control-block-refused": "RCT017", "unknown-interface": "RCT017", "type-misspelt": "RCT017",
    "unknown-control-element": "RCT017", "control-parameter-refused": "RCT017",
    "RCT033": "RCT021", "RCT040": "RCT021", "no-state-interface": "RCT021",
    "state-not-offered": "RCT021",
    "RCT041": "RCT032", "sensor-not-simulated": "RCT032", "sensor-unknown": "RCT032",
}  # fmt: skip


def applies(subject: Subject) -> bool:
    """True if there are transmissions, ros2_control or plugins that run controllers."""
    model = subject.model
    if model.transmissions or model.ros2_controls or subject.parameters:
        return True
    plugins = (plugin for block in model.gazebo for plugin in block.all("plugin"))
    return any("control" in (plugin.get("filename") or "") for plugin in plugins)
