"""From a parts list to generated code: the only place where physics is written.

A model is a body and a list of parts; this is its vocabulary. Read `core` for what the words mean,
`parts` for what ships, `models` for how they are put together, `theory` for what follows in closed
form, and `emit` for how it becomes code.

>>> from groundroll.derive import Body, Equation, Force, Input, Model, Parameter, Part, i, j
"""

from .core.body import Body, Ixx, Ixz, Iyy, Izz, g, m, u_held, wind_x, wind_y
from .core.equation import Equation
from .core.frames import X, Y, Z, i, j, k, p, phi, psi, q, r, theta, u, v, w
from .core.model import Model, ModelError
from .core.part import Event, Felt, Force, Part
from .core.quantity import Constant, Input, Parameter, Quantity, State
from .core.unit import UnitError

__all__ = [
    "Body",
    "Constant",
    "Equation",
    "Event",
    "Felt",
    "Force",
    "Input",
    "Ixx",
    "Ixz",
    "Iyy",
    "Izz",
    "Model",
    "ModelError",
    "Parameter",
    "Part",
    "Quantity",
    "State",
    "UnitError",
    "X",
    "Y",
    "Z",
    "g",
    "i",
    "j",
    "k",
    "m",
    "p",
    "phi",
    "psi",
    "q",
    "r",
    "theta",
    "u",
    "u_held",
    "v",
    "w",
    "wind_x",
    "wind_y",
]
