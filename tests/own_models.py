"""Models that nobody shipped: a car with a steered axle, and one that brakes left and right."""

from __future__ import annotations

from functools import cache
from pathlib import Path
from tempfile import mkdtemp

import sympy as sp

import groundroll as gr
from groundroll.derive.core.body import Body
from groundroll.derive.core.equation import Equation
from groundroll.derive.core.frames import i, j
from groundroll.derive.core.model import Model
from groundroll.derive.core.part import Felt, Force, Law, Part
from groundroll.derive.core.quantity import Input, Parameter, Quantity
from groundroll.derive.emit.catalogue import Pack
from groundroll.derive.emit.pack import pack_files, write
from groundroll.models import Model as Loaded

a = Parameter("l_f", "front_axle_arm", "m", "front axle ahead of the CG", sign=">0")
b = Parameter("l_r", "rear_axle_arm", "m", "rear axle behind the CG", sign=">0")
w = Parameter("w_half", "half_track", "m", "half the distance of the wheels", sign=">0")
Cf = Parameter("C_f", "front_stiffness", "N/rad", "cornering stiffness of the front axle")
Cr = Parameter("C_r", "rear_stiffness", "N/rad", "cornering stiffness of the rear axle")
delta = Input("delta", "steering", "rad", "angle of the front wheels, to the right")
push = Input("F_side", "side_force", "N", "a force on the CG, to the right")
brake_left = Input("B_left", "brake_left", "N", "force of the left brake, backward")
brake_right = Input("B_right", "brake_right", "N", "force of the right brake, backward")
slip = Quantity("slip", "slip_angle", "rad", "angle of the axle's velocity to its wheels")
F_axle = Quantity("F_axle", "axle_force", "N", "side force of the axle, to the left")


def _axle(stiffness: Quantity, turned: sp.Expr) -> Law:
    def law(felt: Felt) -> Force:
        velocity = felt.velocity
        chain = (
            Equation(slip, sp.atan2(velocity.dot(j), velocity.dot(i)) - turned, "slip"),
            Equation(F_axle, stiffness * slip, "linear tire"),
        )
        return Force(-F_axle * j, chain=chain)

    return law


def _push(felt: Felt) -> Force:
    return Force(push * j)


def _brake(by: Quantity) -> Law:
    return lambda felt: Force(-by * i)


AXLES = [
    Part("front", a * i, _axle(Cf, delta), asks=(delta,), kind="wheel"),
    Part("rear", -b * i, _axle(Cr, sp.S.Zero), kind="wheel"),
]
MODELS = {
    "car": Model(
        "car",
        "A single-track car at a held speed, with steering and a side force.",
        Body(speed="held", stands="level"),
        [*AXLES, Part("push", 0 * i, _push, asks=(push,))],
    ),
    "braked": Model(
        "braked",
        "A single-track car with a free speed, steering and two brakes.",
        Body(speed="free", stands="level"),
        [
            *AXLES,
            Part("left", -w * j, _brake(brake_left), asks=(brake_left,)),
            Part("right", w * j, _brake(brake_right), asks=(brake_right,)),
        ],
    ),
}


def written(name: str, folder: Path, **parts: Model) -> Path:
    """The folder of the pack of a model, made there."""
    model = parts.get("model", MODELS[name]).derive()
    write(folder, pack_files(Pack(model.name, model.summary, model=model)))
    return folder


@cache
def own(name: str) -> Loaded:
    """One of the models, as anybody would load it."""
    return Loaded.load(written(name, Path(mkdtemp(prefix="groundroll-")) / name))


def sedan(name: str = "car") -> gr.Aircraft:
    """A car for one of the models: what aircraft have too, and the model's own parameters."""
    given = {"m": 1200.0, "Izz": 1500.0, "g": 9.81, **({"u": 30.0} if name == "car" else {})}
    own = {"l_f": 1.2, "l_r": "1400 mm", "C_f": "1000 N/deg", "C_r": 70_000.0}
    return gr.Aircraft(
        "sedan", given, "A family car", own=own if name == "car" else {**own, "half_track": 0.75}
    )
