"""Short simulations of a robot in MuJoCo. Lengths in m, angles in rad, energies in J."""

from collections.abc import Iterator
from typing import Any

import mujoco
import numpy as np

from urdfkit.core import temporary
from urdfkit.lint.context import Context
from urdfkit.mesh.geometry import Floats
from urdfkit.output.bundle import Bundle
from urdfkit.output.bundle.consumers import CONSUMERS
from urdfkit.output.bundle.writing import write_files
from urdfkit.output.conversion.writing import assembled, assets, compiled, floats
from urdfkit.output.simulation.verdicts import Simulation, Verdict
from urdfkit.robot.kinematics import positions
from urdfkit.text.source import Span

#: Links that are in one another by more, push each other away.
OVERLAP = 1e-3
#: A robot may gain the energy that lifts it by so much, and a part of its largest kinetic energy.
LIFT, PART = 1e-3, 0.01
#: A joint that gives way by more does not hold.
SAG = 0.02
#: Seconds that a robot is released and held for, and steps: where the finer one is calm, the
#: coarser is at fault.
RELEASED, HELD, STEP, FINE_STEP = 2.0, 1.0, 0.002, 0.0005
#: How fast the joints are held, in rad/s: what a stiff drive does.
_STIFFNESS = 30.0

_BAD = (
    mujoco.mjtWarning.mjWARN_BADQPOS,
    mujoco.mjtWarning.mjWARN_BADQVEL,
    mujoco.mjtWarning.mjWARN_BADQACC,
)


def run(robot: Context, base: str) -> Simulation:
    """All simulations of a robot; the arguments are those of `urdfkit.output.simulation`."""
    mujoco.set_mju_user_warning(_ignore)
    is_free = floats(robot, base)
    bundle = Bundle(robot, CONSUMERS["mujoco"])
    with temporary.scratch() as directory:
        write_files(assets(bundle), directory)
        made = assembled(robot, bundle, directory, is_free=is_free)
        model = compiled(made, robot)
        if is_free:
            height = _lowest(model, robot)
            if height is not None:
                plane = mujoco.mjtGeom.mjGEOM_PLANE
                made.spec.worldbody.add_geom(type=plane, size=(0, 0, 1), pos=(0, 0, height))
                model = compiled(made, robot)
    model.opt.integrator = mujoco.mjtIntegrator.mjINT_IMPLICITFAST
    model.opt.enableflags |= mujoco.mjtEnableBit.mjENBL_ENERGY
    model.opt.disableflags |= mujoco.mjtDisableBit.mjDSBL_ACTUATION
    verdicts = [*_overlaps(model, robot), *_released(model, robot)]
    if not is_free:
        verdicts += _held(model, robot)
    return Simulation(is_free, tuple(verdicts))


def _ignore(warning: str) -> None:
    """MuJoCo writes what it warns of to a file in the current directory otherwise."""


def _started(model: Any, robot: Context) -> Any:
    """A robot with its joints at zero, or at the end of their range that is nearest to it.

    What follows another joint is where that takes it.
    """
    data = mujoco.MjData(model)
    for number in np.flatnonzero(model.jnt_limited):
        at = model.jnt_qposadr[number]
        data.qpos[at] = np.clip(data.qpos[at], *model.jnt_range[number])
    moving = positions(robot.tree, {})
    given = {name: float(data.joint(name).qpos[0]) for name in moving}
    for name, position in positions(robot.tree, given).items():
        data.joint(name).qpos[0] = position
    mujoco.mj_forward(model, data)
    return data


def _lowest(model: Any, robot: Context) -> float | None:
    """The height of the lowest point of all that collides, at the start."""
    data = _started(model, robot)
    lowest = [
        float(at[2] + (turn.reshape(3, 3) @ box[:3])[2] - np.abs(turn.reshape(3, 3)[2]) @ box[3:])
        for at, turn, box, collides in zip(
            data.geom_xpos, data.geom_xmat, model.geom_aabb, model.geom_contype, strict=True
        )
        if collides
    ]
    return min(lowest, default=None)


def _overlaps(model: Any, robot: Context) -> Iterator[Verdict]:
    """Links that are in one another at the start."""
    data = _started(model, robot)
    neighbours = {frozenset(robot.tree.ends(joint) or ()) for joint in robot.model.joints}
    deepest: dict[tuple[str, str], float] = {}
    for contact in data.contact:
        first, second = sorted(
            model.body(model.geom_bodyid[geom]).name for geom in (contact.geom1, contact.geom2)
        )
        depth = -float(contact.dist)
        if depth > OVERLAP and "world" not in (first, second):
            deepest[first, second] = max(depth, deepest.get((first, second), 0.0))
    for names, depth in sorted(deepest.items(), key=lambda pair: -pair[1]):
        links = " and ".join(f"'{name}'" for name in names)
        text = f"links {links} overlap by {depth * 1e3:.3g} mm at the start"
        if frozenset(names) in neighbours:  # whom MuJoCo leaves out elsewhere
            text += "; MuJoCo collides them, since the parent is welded to the world"
        yield Verdict("overlap", False, text, depth, OVERLAP, names, _collision(robot, names[0]))
    if not deepest:
        yield Verdict("overlap", True, "no links overlap at the start", 0.0, OVERLAP)


def _released(model: Any, robot: Context) -> Iterator[Verdict]:
    """Without drives a robot may fall, but not blow up nor gain energy."""
    gain, bound, bad = _gained_energy(model, robot, STEP)
    if bad is None and gain <= bound:
        text = f"released for {RELEASED:g} s, it gains {gain:.2g} J (bound {bound:.2g} J)"
        yield Verdict("energy", True, text, gain, bound)
        return
    fine, fine_bound, fine_bad = _gained_energy(model, robot, FINE_STEP)
    is_coarse = fine_bad is None and fine <= fine_bound
    why = f", but not with steps of {FINE_STEP * 1e3:g} ms" if is_coarse else ""
    if bad is None:
        text = f"released for {RELEASED:g} s, it gains {gain:.3g} J (bound {bound:.2g} J){why}"
        yield Verdict("energy", False, text, gain, bound)
        return
    joint = model.joint(model.dof_jntid[bad]).name if bad < model.nv else ""
    text = f"released, its simulation diverges at joint '{joint}'{why}"
    yield Verdict("stability", False, text, gain, bound, (joint,), _joint(robot, joint))


def _gained_energy(model: Any, robot: Context, step: float) -> tuple[float, float, int | None]:
    """The most energy over that of the start, its bound, and the coordinate that diverges."""
    model.opt.timestep = step
    data = _started(model, robot)
    start = most = float(data.energy.sum())
    kinetic = 0.0
    for _ in range(round(RELEASED / step)):
        mujoco.mj_step(model, data)
        most = max(most, float(data.energy.sum()))
        kinetic = max(kinetic, float(data.energy[1]))
        for kind in _BAD:
            if data.warning[kind].number:
                return most - start, 0.0, int(data.warning[kind].lastinfo)
    weight = float(model.body_mass.sum()) * 9.81
    return most - start, LIFT * weight + PART * kinetic, None


def _held(model: Any, robot: Context) -> Iterator[Verdict]:
    """Each joint is held where it is, by no more than its effort."""
    model.opt.timestep = FINE_STEP
    model.opt.disableflags |= mujoco.mjtDisableBit.mjDSBL_CONTACT
    data = _started(model, robot)
    needed, start = data.qfrc_bias.copy(), data.qpos.copy()
    most = _efforts(model)
    for _ in range(round(HELD / FINE_STEP)):
        data.qfrc_applied = np.clip(_torques(model, data, start), -most, most)
        mujoco.mj_step(model, data)
    sags = False
    for number in range(model.njnt):
        at, dof = model.jnt_qposadr[number], model.jnt_dofadr[number]
        sag = abs(float(data.qpos[at] - start[at]))
        if sag > SAG and np.isfinite(most[dof]):
            sags = True
            name = model.joint(number).name
            unit, force = ("m", "N") if _slides(model, number) else ("rad", "N·m")
            text = (
                f"joint '{name}' gives way by {sag:.2g} {unit} in {HELD:g} s: to hold still it "
                f"needs {abs(float(needed[dof])):.3g} {force}, its effort is {most[dof]:g} {force}"
            )
            yield Verdict("hold", False, text, sag, SAG, (name,), _joint(robot, name))
    if not sags and np.isfinite(most).any():
        yield Verdict("hold", True, "its joints hold it with their efforts", 0.0, SAG)


def _torques(model: Any, data: Any, start: Floats) -> Floats:
    """What brings a robot back to where it was, critically damped."""
    moved = np.zeros(model.nv)
    mujoco.mj_differentiatePos(model, moved, 1.0, start, data.qpos)
    wanted = -(_STIFFNESS**2) * moved - 2 * _STIFFNESS * data.qvel
    found = np.zeros(model.nv)
    mujoco.mj_mulM(model, data, found, wanted)
    torques: Floats = found + data.qfrc_bias
    return torques


def _efforts(model: Any) -> Floats:
    """The most that each coordinate may be driven with; without a limit endless."""
    found = np.full(model.nv, np.inf)
    for number in range(model.njnt):
        if model.jnt_actfrclimited[number]:
            found[model.jnt_dofadr[number]] = model.jnt_actfrcrange[number][1]
    return found


def _slides(model: Any, number: int) -> bool:
    return bool(model.jnt_type[number] == mujoco.mjtJoint.mjJNT_SLIDE)


def _collision(robot: Context, link: str) -> Span | None:
    found = robot.model.links_by_name.get(link)
    return found.collisions[0].at.span if found and found.collisions else None


def _joint(robot: Context, name: str) -> Span | None:
    found = robot.model.joints_by_name.get(name)
    return found.at.span if found else None
