"""The gallery of models in ``docs/models``: for each its parts list, its equations and a picture.

Run it after a model has changed; a test says when. The models of the tests are in it too: they
are what somebody with an installed package would write.
"""

from __future__ import annotations

import sys
from collections.abc import Mapping
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

ROOT = Path(__file__).parent.parent
sys.path.insert(0, str(ROOT / "tests"))

from own_models import NAMES, PLANES, own  # noqa: E402

import groundroll as gr  # noqa: E402

HOME = Path(__file__).parent / "models"


@dataclass(frozen=True)
class Shown:
    """What a page says and draws.

    Attributes
    ----------
    title : str
    words : str
        What there is to see in the model.
    caption : str
        What there is to see in the picture.
    run : mapping of str to anything
        What `simulate` is given.
    over_time : tuple of str
        What is drawn over time; the runway from above if empty.
    plane : str
        A packaged aircraft; for a model of the tests its own.
    """

    title: str
    words: str
    caption: str
    run: Mapping[str, Any] = field(default_factory=dict)
    over_time: tuple[str, ...] = ()
    plane: str = ""


GALLERY = {
    "linear": Shown(
        "The linear model of the thesis",
        "Main gear, tail wheel and fin, each a force proportional to its angle, at a speed that is"
        " held. It has closed forms: where the gear may stand, up to which speed.",
        "A kick of 3 m/s to the right at 60 km/h.",
        {"v0": 3.0, "speed": "60 km/h", "t": 2.0},
        ("v", "r", "psi"),
        "brott",
    ),
    "nonlinear": Shown(
        "The non-linear model of the thesis",
        "The same parts with tires that saturate: the magic formula for the main gear, measured"
        " points for the tail wheel.",
        "The same kick as on the page of the linear model: the tires saturate.",
        {"v0": 3.0, "speed": "60 km/h", "t": 2.0},
        ("v", "r", "psi"),
        "brott",
    ),
    "rollout": Shown(
        "The roll-out: a level body whose speed falls",
        "Left and right wheels with brakes, a steered third wheel, fin and rudder, wind. The body"
        " stays level, so the loads follow from the balance.",
        "A Cessna 170 at 40 kt in a crosswind of 3 kt, hands off: a ground loop.",
        {"u0": "40 kt", "crosswind": "3 kt", "t": 8.0},
        plane="cessna-170",
    ),
    "landing_roll": Shown(
        "The landing roll: six degrees of freedom on sprung legs",
        "Everything: legs that spring, a tail wheel that swivels, slipstream over fin and"
        " tailplane, brakes left and right, wind.",
        "The same crosswind as on the page of the roll-out.",
        {"u0": "40 kt", "crosswind": "3 kt", "t": 8.0},
        plane="cessna-170",
    ),
    "single_track": Shown(
        "A single-track car",
        "The smallest model with a name in the field: two axles, the front one steered. A test"
        " holds it to the closed form of the textbook.",
        "A step of 2 degrees of steering at 108 km/h: yaw rate and side forces.",
        {"steering": "2 deg", "t": 2.0},
        ("r", "F_front", "F_rear"),
    ),
    "four_wheels": Shown(
        "A car with left and right wheels and brakes",
        "One wheel law stands four times under four names; three inputs; a speed that falls.",
        "Only the left brakes, a third of full: the car turns left.",
        {"u0": "90 km/h", "brake_left": 0.33, "t": 4.0},
    ),
    "lagging": Shown(
        "An aircraft whose tail lags",
        "A law with a state of its own: the slip angle as the flow follows it.",
        "A push of 500 N at the tail from 0.2 s on: the angle at the tail, and as the force sees"
        " it.",
        {"push": gr.gusts.step("500 N", 0.2), "t": 1.5},
        ("alpha_tail", "late_tail", "r"),
    ),
    "corners": Shown(
        "A car on laws with corners",
        "`Max`, `Min`, `Abs`, `sign`, `tanh` and `Piecewise` in laws: tires that let go, scrub, a"
        " brake that holds, walls.",
        "Steered into the wall at 72 km/h.",
        {"u0": 20.0, "steering": "1 deg", "t": 2.5},
        ("Y", "W", "F_front"),
    ),
    "driver": Shown(
        "A car that somebody steers",
        "A part without a force that drives an input of the others: the steering is an output now,"
        " and the lane that the driver wants is an input.",
        "A change of lane by 3.5 m.",
        {"lane": gr.signals.step("3.5 m", 0.5), "t": 8.0},
        ("Y", "steering"),
    ),
    "level_loads": Shown(
        "A winged car on three wheels",
        "A level body whose loads follow from weight, lift, pitching moment and thrust.",
        "Full brakes from 90 km/h: as the speed falls the wing lets go, and the loads grow.",
        {"u0": 25.0, "brake": 1.0, "t": 2.5},
        ("u", "Fz_left", "Fz_rear"),
    ),
    "trailer": Shown(
        "A car with a trailer",
        "The trailer is a force that is linear in the accelerations of its hitch, and two states.",
        "A pulse of steering at 90 km/h: the trailer swings.",
        {"u0": 25.0, "steering": gr.signals.step("2 deg", 0.5, 1.0), "t": 5.0},
        ("r", "bend_hitch"),
    ),
    "table": Shown(
        "A table with a load on top",
        "A free body on three sprung legs, which hold on to the ground; the load is felt by its"
        " acceleration alone.",
        "Let go with its legs pressed 5 cm into the ground.",
        {"Z0": -0.95, "t": 1.0},
        ("Z", "theta", "N_behind"),
    ),
}


def plane_of(name: str) -> gr.Aircraft:
    shown = GALLERY[name]
    return gr.Aircraft.load(shown.plane) if shown.plane else PLANES[name]


def model_of(name: str) -> gr.Model:
    return own(name) if name in NAMES else gr.Model.load(name)


def source_of(name: str) -> Path:
    """The file with the parts list."""
    if name in NAMES:
        return ROOT / "tests" / "models" / f"{name}.py"
    return ROOT / "derive" / "models" / f"{name}.py"


def page(name: str) -> str:
    """A page of the gallery."""
    shown, model = GALLERY[name], model_of(name)
    q = model.quantities
    lists = [
        f"- {what}: {', '.join(f'`{s}` ({q[s].name}, {q[s].unit})' for s in group)}"
        for what, group in (("states", model.states), ("inputs", model.inputs))
        if group
    ]
    return "\n".join(
        (
            "<!-- Written by docs/gallery.py: do not edit. -->",
            f"# {shown.title}",
            "",
            shown.words,
            "",
            *lists,
            "",
            f"![{shown.caption}]({name}.png)",
            "",
            shown.caption,
            "",
            "## Its parts list",
            "",
            *_parts_list(name),
            "",
            "## Its equations",
            "",
            "SI units and radians; SAE axes: x forward, y right, z down.",
            "",
            *_equations(name, model),
            "",
        )
    )


def _parts_list(name: str) -> tuple[str, ...]:
    """The file of a model: of one that ships as it is when the page is read."""
    source = source_of(name)
    where = source.relative_to(ROOT).as_posix()
    if name in NAMES:
        text = source.read_text(encoding="utf-8").rstrip()
        return f"From `{where}`:", "", "```python", text, "```"
    return (
        f"From `{where}`:",
        "",
        f"```{{literalinclude}} ../../{where}",
        ":language: python",
        "```",
    )


def _equations(name: str, model: gr.Model) -> tuple[str, ...]:
    """The sheet of a model, below a heading of the page."""
    if name in NAMES:
        text = (model.folder / "EQUATIONS.md").read_text(encoding="utf-8")
        sheet = text.partition("\n## ")[2].rstrip()
        return (f"### {sheet}".replace("\n## ", "\n### "),)
    sheet = f"../../generated/{name}/EQUATIONS.md"
    return (
        f"From `generated/{name}/EQUATIONS.md`:",
        "",
        f"```{{include}} {sheet}",
        ":heading-offset: 2",
        "```",
    )


def index() -> str:
    """The page with all of them."""
    rows = [f"| [{shown.title}]({name}.md) | {shown.words} |" for name, shown in GALLERY.items()]
    names = "\n".join(GALLERY)
    return (
        "<!-- Written by docs/gallery.py: do not edit. -->\n# Models\n\n"
        "Each model is a body and a list of parts. The first four ship with groundroll; the others"
        " are\nmodels of its tests, as anybody with the package can write them: see"
        " [a model of your own](../extending.md).\n\n"
        "| model | what there is to see |\n|---|---|\n" + "\n".join(rows) + "\n\n"
        "```{toctree}\n:hidden:\n\n" + names + "\n```\n"
    )


def pages() -> dict[str, str]:
    """All pages by the names of their files."""
    return {"index.md": index(), **{f"{name}.md": page(name) for name in GALLERY}}


def draw(name: str, path: Path) -> None:
    """The picture of a page."""
    shown = GALLERY[name]
    run = gr.simulate(plane_of(name), model_of(name), **shown.run)
    axes = run.plot(shown.over_time)[0] if shown.over_time else gr.runway_view(run)
    axes.figure.savefig(path, dpi=100)


def main() -> None:
    """Write every page and every picture."""
    import matplotlib as mpl

    mpl.use("Agg")
    HOME.mkdir(exist_ok=True)
    for name, text in pages().items():
        (HOME / name).write_text(text, encoding="utf-8")
    for name in GALLERY:
        draw(name, HOME / f"{name}.png")


if __name__ == "__main__":
    main()
