"""Aircraft of other programs: every one of JSBSim's that has wheels, against JSBSim itself."""

from __future__ import annotations

import csv
import random
from functools import cache
from pathlib import Path
from typing import Any

import jsbsim
import numpy as np
import pytest

import groundroll as gr
from groundroll.cli import main
from groundroll.exchange.jsbsim_reader import read_jsbsim
from groundroll.exchange.taken import Found

ROOT = Path(jsbsim.get_default_root_dir())
DATA = Path(__file__).parent / "data"
AIRCRAFT = {f.stem: f for f in sorted(ROOT.glob("aircraft/*/*.xml")) if f.stem == f.parent.name}
#: What is refused, and why. It may only get shorter.
REFUSED = {
    "J246": "no <emptywt>",  # a rocket
    "SGS": "no wheels in pairs",  # all its contacts are at the origin
    "Short_S23": "0 wheels",  # a flying boat
    "Submarine_Scout": "no wheels in pairs",  # an airship
    "ZLT-NT": "2 wheels",  # an airship
    "ah1s": "no wheel on the centerline",  # a helicopter on skids
    "ball": "1 wheels",
    "ballx": "1 wheels",
    "blank": "expected <fdm_config>",
    "minisgs": "no wheels in pairs",  # all its contacts are at the origin
    "mk82": "0 wheels",  # a bomb
    "paraglider": "2 wheels",
    "pogo-jsbsim": "its CG is not between wheels",  # stands on its tail
    "weather-balloon": "0 wheels",
    "wrightFlyer1903": "no wheel on the centerline",  # four on skids
}
_LINES = (DATA / "jsbsim_gear.csv").read_text().splitlines()
GEAR = {row["aircraft"]: row for row in csv.DictReader(_LINES)}
INCH, POUND, FOOT = 0.0254, 0.45359237, 0.3048
SLUG_FT2 = 14.593902937206364 * FOOT**2


@cache
def found(name: str) -> Found:
    return read_jsbsim(AIRCRAFT[name])


@pytest.mark.parametrize("name", [name for name in AIRCRAFT if name not in REFUSED])
def test_every_aircraft_on_wheels_is_imported(name: str, tmp_path: Path) -> None:
    made = gr.import_aircraft(AIRCRAFT[name], tmp_path / "plane.toml")
    plane = gr.Aircraft.load(made.path)
    taken = found(name).taken
    assert {"m", "Izz", "x_cg", "x_main", "track", "k_main", "k_third", "B5"} <= set(taken)
    for s, each in taken.items():
        assert float(plane.given[s]) == pytest.approx(each.si, rel=1e-12, abs=1e-300), s
    stations = sorted(float(plane[s]) for s in ("x_main", "x_nose", "x_tail") if s in taken)
    assert len(stations) >= 2
    assert gr.Aircraft.load(made.path).title


@pytest.mark.parametrize("name", REFUSED)
def test_what_does_not_stand_on_three_wheels_is_refused_with_the_reason(
    name: str, tmp_path: Path
) -> None:
    with pytest.raises(gr.GroundrollError, match=REFUSED[name]):
        gr.import_aircraft(AIRCRAFT[name], tmp_path / "plane.toml")
    assert list(tmp_path.iterdir()) == []


@pytest.mark.parametrize("name", [n for n in GEAR if n not in REFUSED and n != "aircraft"])
def test_stations_are_those_of_the_file_within_a_millimetre(name: str) -> None:
    """Against facts that were read out of the files by hand."""
    row, taken = GEAR[name], found(name).taken
    wheels = {k: float(x) for k, _, x in (w.partition(":") for w in row["wheels_x_in"].split("; "))}
    third = "x_nose" if "x_nose" in taken else "x_tail"
    mains = [x for k, x in wheels.items() if "main" in k.lower() or "MLG" in k or "SKID" in k]
    assert min(abs(taken["x_main"].si - x * INCH) for x in mains) < 1e-3
    others = [x for k, x in wheels.items() if abs(x * INCH - taken["x_main"].si) > 1e-3]
    assert min(abs(taken[third].si - x * INCH) for x in others) < 1e-3
    assert taken["x_cg"].si == pytest.approx(float(row["cg_x_in"]) * INCH, abs=1e-3)
    assert taken["m"].si == pytest.approx(
        float(row["with_pointmasses_lb"]) * POUND, abs=0.06 * POUND
    )
    assert taken["b_wing"].si == pytest.approx(float(row["span_ft"]) * FOOT, rel=1e-9)
    if "Ap" in taken:
        area = float(row["fin_area_ft2"]) * FOOT**2
        assert taken["Ap"].si == pytest.approx(area, rel=1e-9)


@cache
def peer(name: str) -> Any:
    """The aircraft in JSBSim, without fuel."""
    fdm = jsbsim.FGFDMExec(str(ROOT))
    fdm.set_debug_level(0)
    assert fdm.load_model(name)
    for k in range(8):
        tank = f"propulsion/tank[{k}]/contents-lbs"
        if fdm.get_property_manager().hasNode(tank):
            fdm[tank] = 0.0
    return fdm


def at(fdm: Any, conditions: dict[str, float]) -> dict[str, float]:
    """Coefficients of moments that JSBSim has in flight, above the effect of the ground."""
    base = {"ic/h-agl-ft": 300.0, "ic/vt-kts": 80.0, "ic/alpha-deg": 0.0, "ic/beta-deg": 0.0}
    for key, value in (base | conditions).items():
        fdm[key] = value
    assert fdm.run_ic()
    area = fdm["aero/qbar-psf"] * fdm["metrics/Sw-sqft"]
    span = area * fdm["metrics/bw-ft"]
    return {"Cl": fdm["moments/l-aero-lbsft"] / span, "Cn": fdm["moments/n-aero-lbsft"] / span}


@pytest.mark.parametrize("name", ["J3Cub", "c172p", "c310", "pc7", "DHC6", "x24b"])
def test_mass_and_inertia_are_those_of_jsbsim(name: str) -> None:
    fdm, taken = peer(name), found(name).taken
    at(fdm, {})
    assert taken["m"].si == pytest.approx(fdm["inertia/weight-lbs"] * POUND, rel=1e-6)
    assert taken["x_cg"].si == pytest.approx(fdm["inertia/cg-x-in"] * INCH, abs=1e-5)
    for s in ("Ixx", "Iyy", "Izz", "Ixz"):
        if s in taken:
            sign = -1 if s == "Ixz" else 1  # of the matrix of inertia
            inertia = sign * fdm[f"inertia/{s.lower()}-slugs_ft2"] * SLUG_FT2
            assert taken[s].si == pytest.approx(inertia, rel=1e-5, abs=1e-6 * taken["Izz"].si)


@pytest.mark.parametrize("name", ["J3Cub", "c172p", "pc7"])
def test_derivatives_about_the_cg_are_those_of_jsbsim(name: str) -> None:
    fdm, taken = peer(name), found(name).taken
    angle = np.radians(0.5)
    speed = {"ic/vt-kts": taken["u"].si / 0.514444} if "u" in taken else {}
    right, left = (at(fdm, {**speed, "ic/beta-deg": by}) for by in (0.5, -0.5))
    for coefficient in ("Cl", "Cn"):
        slope = (right[coefficient] - left[coefficient]) / (2 * angle)
        assert taken[f"{coefficient}_beta"].si == pytest.approx(slope, rel=0.05, abs=1e-3)


@pytest.mark.parametrize(("name", "attitude"), [("J3Cub", 12.1), ("c172p", 3.5)])
def test_what_is_imported_rolls(name: str, attitude: float, tmp_path: Path) -> None:
    plane = gr.Aircraft.load(gr.import_aircraft(AIRCRAFT[name], tmp_path / "plane.toml").path)
    assert float(plane["theta_ground"]) == pytest.approx(np.radians(attitude), abs=0.02)
    plane = plane.replace(CL_gamma=3.0, u=17.0)
    run = gr.simulate(plane, "landing_roll", t=3.0, v0=0.2)
    assert np.isfinite(run["psi"]).all()
    assert abs(run["phi"]).max() < 0.3


@pytest.mark.parametrize("name", ["cessna-170", "cessna-172p"])
def test_what_is_exported_is_imported_with_the_same_numbers(name: str, tmp_path: Path) -> None:
    plane = gr.Aircraft.load(name).replace(Ixz=120.0, toe=0.0)
    file = tmp_path / "aircraft" / "plane" / "plane.xml"
    file.parent.mkdir(parents=True)
    gr.export(plane, "jsbsim", file, "landing_roll")
    again = gr.Aircraft.load(gr.import_aircraft(file, tmp_path / "plane.toml").path)
    for s in (
        *("m", "Ixx", "Iyy", "Izz", "Ixz", "a", "a_third", "b", "track", "z_main", "z_third"),
        *("k_main", "c_main", "k_third", "c_third", "mu_roll_left", "mu_roll_third"),
        *("steering_ratio", "swivels", "S_wing", "b_wing", "c_wing", "Ap", "S_h", "x_h"),
    ):
        assert float(again[s]) == pytest.approx(float(plane[s]), rel=1e-8, abs=1e-9), s
    # and JSBSim reads it as both
    fdm = jsbsim.FGFDMExec(str(tmp_path))
    fdm.set_debug_level(0)
    assert fdm.load_model("plane")
    assert fdm.run_ic()
    assert fdm["inertia/ixz-slugs_ft2"] * SLUG_FT2 == pytest.approx(-120.0, rel=1e-6)


AVL = """
 Vortex Lattice Output -- Total Forces

  Alpha =   3.00000     pb/2V =  -0.00000     p'b/2V =  -0.00000
  CXtot =   0.00900     Cltot =  -0.00000     Cl'tot =  -0.00000
  CYtot =  -0.00000     Cmtot =  -0.04500
  CLtot =   0.56000

 Stability-axis derivatives...

                             alpha                beta
                  ----------------    ----------------
 z' force CL |    CLa =   5.012345    CLb =   0.000000
 y  force CY |    CYa =   0.000000    CYb =  -0.301234
 x' mom.  Cl'|    Cla =   0.000000    Clb =  -0.101000
 y  mom.  Cm |    Cma =  -0.912000    Cmb =   0.000000
 z' mom.  Cn'|    Cna =   0.000000    Cnb =   0.081000

                     roll rate  p'      pitch rate  q'        yaw rate  r'
                  ----------------    ----------------    ----------------
 y  force CY |    CYp =  -0.050000    CYq =   0.000000    CYr =   0.210000
 x' mom.  Cl'|    Clp =  -0.520000    Clq =   0.000000    Clr =   0.150000
 y  mom.  Cm |    Cmp =   0.000000    Cmq = -12.300000    Cmr =   0.000000
 z' mom.  Cn'|    Cnp =  -0.030000    Cnq =   0.000000    Cnr =  -0.095000

                  aileron      d01     elevator     d02     rudder       d03     flap     d04
                  ----------------    ----------------    ----------------
 y  force CY |   CYd01 =   0.000100   CYd02 =   0.000000   CYd03 =   0.002800
 x' mom.  Cl'|   Cld01 =   0.006100   Cld02 =   0.000000   Cld03 =   0.000100
 y  mom.  Cm |   Cmd01 =   0.000000   Cmd02 =  -0.022000   Cmd03 =   0.000000
 z' mom.  Cn'|   Cnd01 =  -0.000100   Cnd02 =   0.000000   Cnd03 =  -0.001200
"""


def test_derivatives_of_avl_come_before_those_of_jsbsim(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    (tmp_path / "plane.st").write_text(AVL)
    words = ["import", str(AIRCRAFT["J3Cub"]), "--with", str(tmp_path / "plane.st")]
    out = tmp_path / "plane.toml"
    assert main([*words, "--out", str(out)]) == 0
    said = capsys.readouterr()
    assert said.out == ""
    assert "control flap, of which the model knows nothing" in said.err
    assert "Lift_propwash" in said.err
    plane = gr.Aircraft.load(out)
    degree = np.radians(1)
    expected = {
        "CL_alpha": 5.012345,
        "CY_beta": -0.301234,
        "Cl_beta": -0.101,
        "Cn_beta": 0.081,
        "Cm_alpha": -0.912,
        "Cm_q": -12.3,
        "Cl_p": -0.52,
        "Cl_r": 0.15,
        "Cn_r": -0.095,
        "CY_r": 0.21,
        "CL_0": 0.56 - 5.012345 * 3 * degree,
        "Cm_0": -0.045 + 0.912 * 3 * degree,
        "Cl_aileron": 0.0061 / degree,
        "Cm_elevator": -0.022 / degree,
        "Cn_rudder": -0.0012 / degree,
        "CY_rudder": 0.0028 / degree,
    }
    for s, value in expected.items():
        assert float(plane[s]) == pytest.approx(value, rel=1e-9), s
    assert main([*words, "--out", str(out)]) == 2
    assert "exists; --force overwrites it" in capsys.readouterr().err


@pytest.mark.parametrize(
    ("text", "told"),
    [
        ("", "no element found"),
        ("<fdm_config>", "no element found"),
        ("<aircraft/>", "found <aircraft>; expected <fdm_config>"),
        ("<fdm_config name='x'/>", "no <emptywt>"),
        (
            "<fdm_config><mass_balance><emptywt unit='STONE'>9</emptywt></mass_balance>"
            "</fdm_config>",
            "unknown unit 'STONE'.*LBS",
        ),
        (
            "<fdm_config><mass_balance><emptywt>heavy</emptywt></mass_balance></fdm_config>",
            "emptywt: found 'heavy'; expected a number",
        ),
    ],
)
def test_what_is_wrong_is_said(text: str, told: str, tmp_path: Path) -> None:
    file = tmp_path / "plane.xml"
    file.write_text(text)
    with pytest.raises(gr.GroundrollError, match=told):
        gr.import_aircraft(file, tmp_path / "plane.toml")
    with pytest.raises(gr.GroundrollError, match=r"expected a name ending in \.toml"):
        gr.import_aircraft(file, tmp_path / "plane.txt")
    (tmp_path / "bad.st").write_text(AVL.replace("5.012345", "********"))
    with pytest.raises(gr.GroundrollError, match=r"line 13: CLa: found '\*+'; expected a number"):
        gr.import_aircraft(AIRCRAFT["J3Cub"], tmp_path / "plane.toml", tmp_path / "bad.st")
    (tmp_path / "aft.st").write_text(f" Geometric axis orientation,  X aft, Z up\n{AVL}")
    with pytest.raises(gr.GroundrollError, match="expected the standard one"):
        gr.import_aircraft(AIRCRAFT["J3Cub"], tmp_path / "plane.toml", tmp_path / "aft.st")
    assert not (tmp_path / "plane.toml").exists()


@pytest.mark.parametrize("seed", range(4))
def test_a_mutated_file_is_read_or_refused_in_words(seed: int, tmp_path: Path) -> None:
    rng, text = random.Random(seed), AIRCRAFT["J3Cub"].read_text()
    pieces = ["<", ">", "1e999", "nan", "-", "unit=", "0", "&#0;", "</x>", "\u0660", "1" * 400, ""]
    file, refused = tmp_path / "plane.xml", 0
    for _ in range(60):
        many = text
        for _ in range(rng.randint(1, 4)):
            k = rng.randrange(len(many))
            many = many[:k] + rng.choice(pieces) + many[k + rng.randint(0, 12) :]
        file.write_text(many)
        try:
            made = read_jsbsim(file)
        except gr.GroundrollError:
            refused += 1
        else:
            assert all(np.isfinite(each.si) for each in made.taken.values())
    assert 0 < refused < 60
