"""Models that cannot be: each error says what, where, and what to do."""

from __future__ import annotations

import json
import re
from pathlib import Path

import pytest
from own_models import CAR, own

import groundroll as gr
from groundroll.derive.core.model import ModelError
from groundroll.derive.emit.own import derive_file
from groundroll.model.models import Model

GOOD = """
from groundroll.derive import (
    Body, Equation, Force, Input, Model, Parameter, Part, Quantity, State, i, j,
)

a = Parameter("l_front", "front_arm", "m", "front axle ahead of the CG", sign=">0")
C = Parameter("C_front", "front_stiffness", "N/rad", "of the front axle")
steering = Input("steering", "steering", "rad", "of the front wheels")
alpha = Quantity("alpha", "slip", "rad", "slip angle")
F = Quantity("F", "side_force", "N", "to the left")
late = State("late", "late_slip", "rad", "slip as the tire follows it")

def law(felt):
    slip = felt.velocity.dot(j) / felt.velocity.dot(i) - steering
    chain = (Equation(alpha, slip, "slip"), Equation(F, C * alpha, "tire"))
    return Force(-F * j, chain=chain)

car = Model("car", "A car.", body=Body(speed="held", stands="level"), parts=[
    Part("front", a * i, law, asks=(steering,)),
    Part("rear", -a * i, law, asks=(steering,)),
])
"""

SECOND = 'D = Parameter("{}", "{}", "{}", "of the {} axle")\ndef law'

CASES = {
    "a part named twice": (
        {'"rear"': '"front"'},
        r"car: two parts are called 'front'; each needs its own name",
    ),
    "a parameter with two units": (
        {
            "def law": SECOND.format("C_front", "front_stiffness", "N", "front"),
            "C * alpha": "C * alpha + D",
        },
        r"C_front has two units: '.*' and '.*'; give one of them another symbol",
    ),
    "a parameter with two meanings": (
        {
            "def law": SECOND.format("C_front", "front_stiffness", "N/rad", "rear"),
            "C * alpha": "(C + D) * alpha",
        },
        r"C_front has two meanings: 'of the .* axle' and 'of the .* axle'; give one",
    ),
    "two parameters with one name": (
        {
            "def law": SECOND.format("C_rear", "front_stiffness", "N/rad", "rear"),
            "C * alpha": "(C + D) * alpha",
        },
        r"C_front and C_rear have the same name 'front_stiffness'; .* each needs its own",
    ),
    "a law that uses an input it did not ask for": (
        {", asks=(steering,)": ""},
        r"the law of front uses steering without asking: Part\(\.\.\., asks=\(steering,\)\)",
    ),
    "inputs that are asked for without a tuple": (
        {"asks=(steering,)": "asks=steering"},
        r"line 19: front: asks is a tuple, as in asks=\(steering,\)",
    ),
    "a position that is a number": (
        {"a * i, law": "2 * i, law"},
        r"line 19: position of front along x: the right side has unit 1, the left side m",
    ),
    "a position with a wrong unit": (
        {"a * i, law": "C * i, law"},
        r"position of front along x: the right side has unit kg\*m/s\*\*2, the left side m",
    ),
    "a position that is no vector": (
        {"a * i, law": "a, law"},
        r"the place of front is l_front; expected a vector along i, j and k: write",
    ),
    "a force that is no vector": (
        {"-F * j": "-F"},
        r"the force of front is -F; expected a vector along i, j and k: .* as F \* j",
    ),
    "a state without a rate": (
        {"C * alpha": "C * late"},
        r"car: the state late has no rate; .*Force\(\.\.\., rates=\{late: \.\.\.\}\)",
    ),
    "a rate with a wrong unit": (
        {"chain=chain)": "chain=chain, rates={late: alpha - late})"},
        r"rate of late of front: the right side has unit 1, the left side 1/s",
    ),
    "a law that returns nothing": (
        {"    return Force": "    Force"},
        r"the law of front returns None; it is to return a Force",
    ),
    "a law that raises": (
        {"    slip =": "    felt.wind\n    slip ="},
        r"line 14: AttributeError: 'Felt' object has no attribute 'wind'",
    ),
    "a law that is none": (
        {"a * i, law": "a * i, 3"},
        r"line 19: front: its law is 3; expected a function of what is felt",
    ),
    "a part that is none": ({"parts=[": "parts=[3,"}, r"car: 3 stands among its parts and is no"),
    "no parts": ({"parts=[": "parts=[] and ["}, r"car has no parts"),
    "a body that is held otherwise": (
        {'"held"': '"hold"'},
        r"line 18: Body: speed is 'hold'; it is one of 'free' and 'held'",
    ),
    "a wrong term": (
        {"C * alpha": "C + alpha"},
        r"line 15: F \(tire\): in C_front \+ alpha: C_front has unit .* but alpha has unit 1",
    ),
    "no unit": ({'"N/rad"': '"N/furlong"'}, r"'N/furlong' is no unit; units are made of kg, m, s"),
    "what nothing defines": (
        {"C * alpha": 'C * Quantity("beta", "beta", "rad", "")'},
        r"car: beta is neither state, input nor parameter, and no equation defines it",
    ),
    "a function that cannot be compiled": (
        {"C * alpha": 'C * __import__("sympy").erf(alpha)'},
        r"erf has no CasADi operation; there are Abs, Max, .*tanh",
    ),
    "an input with a name that is taken": (
        {'"steering", "steering"': '"t", "steering"'},
        r"'t' is an argument of groundroll's functions .*; call the quantity otherwise",
    ),
    "a model whose name is none": (
        {'Model("car"': 'Model("my car"'},
        r"'my car' cannot name a model: letters, digits and _ only",
    ),
    "a model that ships": (
        {'Model("car"': 'Model("landing_roll"'},
        r"'landing_roll' is a model that ships; call yours otherwise",
    ),
    "a file that raises": ({"def law": "1 / 0\ndef law"}, r"line 13: ZeroDivisionError: division"),
    "a file that leaves": ({"def law": "raise SystemExit\ndef law"}, r"line 13: SystemExit"),
    "a file that is no Python": (
        {"def law(felt):": "def law(felt)"},
        r"line 13: SyntaxError: expect",
    ),
    "a file without a model": (
        {"car = Model(": "car = (lambda *_, **__: None)("},
        r"has no model at its top level: name one there, as in car = Model\('car', \.\.\.\)",
    ),
    "a file with several models": (
        {"car = Model(": 'other = Model("other", "", Body(), [])\ncar = Model('},
        r"has several models, other, car: say which with --name",
    ),
}


@pytest.mark.parametrize("name", CASES)
def test_a_model_that_cannot_be_teaches(name: str, tmp_path: Path) -> None:
    changes, message = CASES[name]
    text = GOOD
    for old, new in changes.items():
        assert old in text
        text = text.replace(old, new)
    file = tmp_path / "mine.py"
    file.write_text(text)
    with pytest.raises(ModelError, match=rf"^{re.escape(str(file))}.*{message}"):
        derive_file(file, tmp_path / "out")
    assert not (tmp_path / "out").exists()


def test_without_these_changes_it_can_be(tmp_path: Path) -> None:
    (tmp_path / "mine.py").write_text(GOOD)
    assert derive_file(tmp_path / "mine.py", tmp_path / "out").name == "car"


@pytest.mark.parametrize(
    ("file", "message"),
    [
        ("none.py", r"there is no file .*none\.py"),
        ("mine.txt", r"mine\.txt is no Python file; its name must end in \.py"),
    ],
)
def test_a_file_that_is_none_is_said(file: str, message: str, tmp_path: Path) -> None:
    (tmp_path / "mine.txt").write_text(GOOD)
    with pytest.raises(ModelError, match=message):
        derive_file(tmp_path / file, tmp_path / "out")


def test_no_folder_of_other_things_is_written_over(tmp_path: Path) -> None:
    file = tmp_path / "mine.py"
    file.write_text(GOOD)
    with pytest.raises(ModelError, match="holds other things than a pack; give an empty folder"):
        derive_file(file, tmp_path)
    with pytest.raises(ModelError, match=r"mine\.py is a file; a pack is a folder"):
        derive_file(file, file)


# --- Packs ------------------------------------------------------------------------------------


def test_a_folder_that_is_no_pack_says_how_to_make_one(tmp_path: Path) -> None:
    (tmp_path / "notes.txt").write_text("mine")
    with pytest.raises(gr.GroundrollError, match=r"is no pack: .* `groundroll derive model\.py"):
        Model.load(tmp_path)


def test_a_folder_that_is_not_there_is_said(tmp_path: Path) -> None:
    with pytest.raises(gr.GroundrollError, match=r"there is no folder .*nowhere; .groundr"):
        Model.load(tmp_path / "nowhere")


@pytest.mark.parametrize("text", ["", "{", "[]", "{}", '{"name": 3}'])
def test_facts_that_are_spoilt_are_said(text: str, tmp_path: Path) -> None:
    (tmp_path / "facts.json").write_text(text)
    with pytest.raises(gr.GroundrollError, match="derive"):
        Model.load(tmp_path)


def test_a_pack_of_another_version_says_the_way_out(tmp_path: Path) -> None:
    facts = json.loads((own("single_track").folder / "facts.json").read_text())
    (tmp_path / "facts.json").write_text(json.dumps({**facts, "version": "0.0.1"}))
    with pytest.raises(gr.GroundrollError, match=r"groundroll 0\.0\.1.*derive"):
        Model.load(tmp_path)


# --- Aircraft -----------------------------------------------------------------------------------

CALLS = {
    "simulate": lambda plane, model: gr.simulate(plane, model),
    "linearize": lambda plane, model: gr.linearize(plane, model),
    "ensemble": lambda plane, model: gr.ensemble(plane, 1.0, model),
    "step_response": lambda plane, model: gr.step_response(plane, model, "r", "steering"),
}


@pytest.mark.parametrize("call", CALLS)
def test_all_that_an_aircraft_lacks_is_listed_at_once(call: str) -> None:
    bare = gr.Aircraft("bare", {"m": 1500.0, "g": 9.81}, own={"l_front": 1.2})
    with pytest.raises(gr.GroundrollError) as problem:
        CALLS[call](bare, own("single_track"))
    told = str(problem.value)
    assert "bare" in told
    assert "single_track" in told
    for name in ("l_rear", "C_front", "C_rear", "Izz"):
        assert f"({name}" in told
    assert "(l_front" not in told


@pytest.mark.parametrize("call", CALLS)
def test_what_an_aircraft_lacks_for_the_landing_roll_is_listed(call: str) -> None:
    with pytest.raises(gr.GroundrollError) as problem:
        CALLS[call](CAR, "landing_roll")
    told = str(problem.value)
    assert "landing_roll" in told
    for name in ("x_cg", "rho", "CL_gamma", "Ap"):
        assert name in told
