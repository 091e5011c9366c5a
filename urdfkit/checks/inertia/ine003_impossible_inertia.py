"""An inertia tensor is physically inconsistent: no body can have it.

The three principal moments, the eigenvalues of the matrix, must all be positive, and none may
exceed the sum of the other two (the triangle inequality). The diagonal alone is not sufficient:
large products of inertia make an eigenvalue negative. Gazebo and MuJoCo reject such a body; engines
that accept it create energy or diverge, and controllers that use it compute wrong torques.

MuJoCo has no tolerance for rounding: if it is a target, a tensor that violates the inequality in
its last digits is an error as well. With `<mujoco><compiler balanceinertia="true"/>` MuJoCo makes
the moments equal instead: a warning if it is the only target.

Most often a digit is wrong, the numbers are in the wrong order (URDF has ixx ixy ixz iyy iyz izz,
SDF and many programs ixx iyy izz first), the products have the opposite sign, or the tensor is
about another frame. Take it from the CAD program, or compute it from the shape.

Sources:
    Traversaro et al. 2016, physical consistency: https://arxiv.org/abs/1610.08703
    Wensing et al. 2017, physical consistency: https://arxiv.org/abs/1701.04395
    sdformat, Link.cc: https://github.com/gazebosim/sdformat/blob/main/src/Link.cc
    MuJoCo, user_objects.cc: https://github.com/google-deepmind/mujoco/blob/main/src/user/user_objects.cc
    gazebosim/ros_gz#155: https://github.com/gazebosim/ros_gz/issues/155
"""

from urdfkit.checks.inertia.copies import together
from urdfkit.lint.rules import Context, Finding, Findings, Severity, rule
from urdfkit.robot.inertials.defects import InertiaDefect
from urdfkit.robot.inertials.impossible_tensors import diagnose_impossible
from urdfkit.robot.inertials.link_comparison import LinkInertia
from urdfkit.robot.inertials.masses import Masses
from urdfkit.robot.inertials.tensor_fix import replacement
from urdfkit.robot.inertials.tensor_text import format_moments
from urdfkit.robot.samples import inertial_xml, link_xml

#: Relative excess over the sum of the other moments that no other order of addition changes.
_LEAST_EXCESS = 1e-9

BAD = link_xml("arm", inertial_xml("2", "0.01 0.01 0.15"))
FIXED = GOOD = BAD.replace('"0.15"', '"0.015"')


@rule(
    Severity.ERROR,
    help="take the tensor about the centre of mass from the CAD program, or compute it",
    computes_fix=True,
)
def check(context: Context) -> Findings:
    masses = context.masses
    for defect in (InertiaDefect.INDEFINITE, InertiaDefect.TRIANGLE_INEQUALITY):
        links = masses.defects.get(defect, ())
        for finding in together((inertia, _finding(inertia, masses)) for inertia in links):
            is_balanced = defect is InertiaDefect.TRIANGLE_INEQUALITY and _is_balanced(context)
            yield finding._replace(severity=Severity.WARNING) if is_balanced else finding
    exact = tuple(target.name for target in context.given_facts if target.rejects_rounding)
    if exact and not context.mujoco.balances_inertia:
        for inertia in masses.inertias:
            low, middle, high = inertia.moments
            if not inertia.breaks_triangle and high > (low + middle) * (1 + _LEAST_EXCESS):
                yield _finding(inertia, masses)._replace(targets=exact)


def _is_balanced(context: Context) -> bool:
    """True if MuJoCo is the only target, and corrects the tensors."""
    targets = context.given_facts
    is_exact = bool(targets) and all(target.rejects_rounding for target in targets)
    return is_exact and context.mujoco.balances_inertia


def _finding(inertia: LinkInertia, masses: Masses) -> Finding:
    low, middle, high = inertia.moments
    if inertia.is_indefinite:
        moments = format_moments(inertia.moments)
        message = f"principal moments of inertia {moments} are not all positive"
        weight = -low / max(abs(high), -low)
    else:
        which = "moments" if inertia.is_diagonal else "principal moments"
        message = (
            f"the {which} of inertia violate the triangle inequality: "
            f"{high:.3g} > {low:.3g} + {middle:.3g} kg·m²"
        )
        weight = (high - low - middle) / high
    diagnosis = diagnose_impossible(inertia, masses)
    fix = replacement(inertia, diagnosis.tensor)
    return Finding(
        inertia.at,
        f"link '{inertia.link.name}': {message}",
        diagnosis.describe(inertia.tensor),
        fix,
        weight=weight,
    )
