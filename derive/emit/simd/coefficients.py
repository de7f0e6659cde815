"""Write ``coefficients.json``: the numbers the emitted kernels need, from 40-digit arithmetic.

The Runge-Kutta tableau is DOP853 (Dormand and Prince's eighth-order pair with the error
estimators and the dense output of E. Hairer and G. Wanner, "Solving Ordinary Differential
Equations I", 2nd ed., program ``dop853.f``), read from SciPy's transcription of it (BSD licence,
``scipy/integrate/_ivp/dop853_coefficients.py``).  The polynomials are minimax fits by Remez
exchange, rounded to double from the highest coefficient down.

Run ``python -m groundroll.derive.simd.coefficients``; emitting kernels needs neither mpmath nor
SciPy.
"""

from __future__ import annotations

import json
from collections.abc import Callable
from pathlib import Path
from typing import Any

import mpmath as mp

Fit = Callable[[Any], Any]
TARGET = Path(__file__).with_name("coefficients.json")


def remez(
    f: Fit, weight: Fit, top: mp.mpf, degree: int, bottom: float = 0
) -> tuple[list[Any], mp.mpf]:
    """Minimax polynomial on ``(bottom, top)``.

    Parameters
    ----------
    f, weight : callable
        Function to fit, and the factor that turns an error of it into the error that counts.
    top, bottom : mpf
        Ends of the interval.
    degree : int
        Degree of the polynomial.

    Returns
    -------
    coefficients : list of mpf
        In ascending order.
    error : mpf
        Largest weighted error.
    """
    count = degree + 2

    def spread(points: int) -> list[Any]:
        angles = [mp.pi * (k + mp.mpf("0.5")) / points for k in range(points)]
        return [bottom + (top - bottom) * (1 - mp.cos(angle)) / 2 for angle in angles]

    nodes, grid = spread(count), spread(600)
    for _ in range(12):
        system, right = mp.matrix(count, count), mp.matrix(count, 1)
        for row, s in enumerate(nodes):
            for power in range(degree + 1):
                system[row, power] = s**power
            system[row, degree + 1] = (-1) ** row / weight(s)
            right[row] = f(s)
        solution = mp.lu_solve(system, right)
        coefficients = list(solution)[: degree + 1]
        residual = [(mp.polyval(coefficients[::-1], s) - f(s)) * weight(s) for s in grid]
        nodes = alternation(grid, residual, count) or nodes
    return coefficients, max(abs(value) for value in residual)


def alternation(grid: list[Any], residual: list[Any], count: int) -> list[Any] | None:
    """Pick the extremum of each run of equal sign; ``None`` if there are too few runs."""
    best: list[int] = []
    for index, value in enumerate(residual):
        if best and (residual[best[-1]] > 0) == (value > 0):
            if abs(value) > abs(residual[best[-1]]):
                best[-1] = index
        else:
            best.append(index)
    return [grid[k] for k in best[:count]] if len(best) >= count else None


def polynomial(name: str, ratio: Fit, top: mp.mpf, degree: int) -> dict[str, Any]:
    """Fit ``P`` in ``function(t) = t + t s P(s)``, ``s = t**2``, for a relative error bound."""
    coefficients, error = remez(lambda s: (ratio(s) - 1) / s, lambda s: s / ratio(s), top, degree)
    print(f"{name}: degree {degree}, relative error {mp.nstr(error, 3)}")
    return {"coefficients": [float(c) for c in coefficients], "error": float(error)}


def exponential(degree: int) -> dict[str, Any]:
    """Fit ``P`` in ``expm1(r) = r + r**2 P(r)`` between half a power of two down and up."""
    half = mp.log(2) / 2 * mp.mpf("1.001")
    coefficients, error = remez(
        lambda r: (mp.expm1(r) - r) / r**2,
        lambda r: r**2 / mp.exp(r),
        half,
        degree,
        -half * mp.mpf("1.001"),
    )
    print(f"exp: degree {degree}, relative error {mp.nstr(error, 3)}")
    return {"coefficients": [float(c) for c in coefficients], "error": float(error)}


def logarithm(degree: int) -> dict[str, Any]:
    """Fit ``P`` in ``log((1 + s) / (1 - s)) = 2 s + s z P(z)``, ``z = s**2``."""
    top = ((mp.sqrt(2) - 1) / (mp.sqrt(2) + 1)) ** 2 * mp.mpf("1.001")

    def rest(z: Any) -> Any:
        return (2 * mp.atanh(mp.sqrt(z)) / mp.sqrt(z) - 2) / z

    coefficients, error = remez(rest, lambda z: z / 2, top, degree)
    print(f"log: degree {degree}, relative error {mp.nstr(error, 3)}")
    return {"coefficients": [float(c) for c in coefficients], "error": float(error)}


def split(constant: mp.mpf, bits: int, parts: int) -> list[float]:
    """Cody-Waite parts: each but the last has ``bits`` significant bits, so products are exact."""
    pieces = []
    for _ in range(parts - 1):
        exponent = mp.floor(mp.log(abs(constant), 2)) - bits + 1
        piece = mp.floor(constant / mp.mpf(2) ** exponent) * mp.mpf(2) ** exponent
        pieces.append(float(piece))
        constant -= piece
    return [*pieces, float(constant)]


def tableau() -> dict[str, Any]:
    """DOP853 as nested lists of doubles."""
    from scipy.integrate._ivp import dop853_coefficients as source

    return {
        "A": [[float(a) for a in source.A[i, :i]] for i in range(source.N_STAGES_EXTENDED)],
        "B": [float(b) for b in source.B],
        "C": [float(c) for c in source.C],
        "E3": [float(e) for e in source.E3[: source.N_STAGES]],
        "E5": [float(e) for e in source.E5[: source.N_STAGES]],
        "D": [[float(d) for d in row] for row in source.D],
    }


def rodas5p() -> dict[str, Any]:
    """Rodas5P as published, in the form with increments (Hairer and Wanner, section IV.7).

    With gamma the diagonal: stages at x + A k and t + c h, rates plus C k / h plus h d times the
    derivative by time; new states x + b k; dense output from H k.
    """
    a = [
        [],
        [3.0],
        [2.849394379747939, 0.45842242204463923],
        [-6.954028509809101, 2.489845061869568, -10.358996098473584],
        [2.8029986275628964, 0.5072464736228206, -0.3988312541770524, -0.04721187230404641],
        [
            *(-7.502846399306121, 2.561846144803919, -11.627539656261098),
            *(-0.18268767659942256, 0.030198172008377946),
        ],
    ]
    last = a[5]
    c = [
        [],
        [-14.155112264123755],
        [-17.97296035885952, -2.859693295451294],
        [147.12150275711716, -1.41221402718213, 71.68940251302358],
        [165.43517024871676, -0.4592823456491126, 42.90938336958603, -5.961986721573306],
        [
            *(24.854864614690072, -3.0009227002832186, 47.4931110020768),
            *(5.5814197821558125, -0.6610691825249471),
        ],
        [
            *(30.91273214028599, -3.1208243349937974, 77.79954646070892),
            *(34.28646028294783, -19.097331116725623, -28.087943162872662),
        ],
        [
            *(37.80277123390563, -3.2571969029072276, 112.26918849496327),
            *(66.9347231244047, -40.06618937091002, -54.66780262877968, -9.48861652309627),
        ],
    ]
    nodes = [0.0, 0.6358126895828704, 0.4095798393397535, 0.9769306725060716, 0.4288403609558664]
    slopes = [
        *(0.21193756319429014, -0.42387512638858027, -0.3384627126235924),
        *(1.8046452872882734, 2.325825639765069),
    ]
    dense = [
        [
            *(25.948786856663858, -2.5579724845846235, 10.433815404888879, -2.3679251022685204),
            *(0.524948541321073, 1.1241088310450404, 0.4272876194431874, -0.17202221070155493),
        ],
        [
            *(-9.91568850695171, -0.9689944594115154, 3.0438037242978453, -24.495224566215796),
            *(20.176138334709044, 15.98066361424651, -6.789040303419874, -6.710236069923372),
        ],
        [
            *(11.419903575922262, 2.8879645146136994, 72.92137995996029, 80.12511834622643),
            *(-52.072871366152654, -59.78993625266729, -0.15582684282751913, 4.883087185713722),
        ],
    ]
    return {
        "gamma": 0.21193756319429014,
        "A": [*a, [*last, 1.0], [*last, 1.0, 1.0]],
        "C": c,
        "c": [*nodes, 1.0, 1.0, 1.0],
        "d": [*slopes, 0.0, 0.0, 0.0],
        "b": [*last, 1.0, 1.0, 1.0],
        "H": dense,
    }


def collocation(count: int) -> dict[str, Any]:
    """Gauss-Legendre nodes on [-1, 1] and what becomes of values at them.

    Row i of a table says what a unit value at node i contributes: to the integrals from -1 to each
    node as fractions of the interval, and to the coefficients of the Chebyshev series.
    """
    legendre = mp.taylor(lambda x: mp.legendre(count, x), 0, count)[::-1]
    nodes = sorted(mp.re(z) for z in mp.polyroots(legendre, maxsteps=200, extraprec=200))
    values = mp.matrix(count, count)
    integrals = mp.matrix(count, count)
    for i, z in enumerate(nodes):
        for k in range(count):
            values[i, k] = mp.chebyt(k, z)
            integrals[i, k] = mp.quad(lambda x, k=k: mp.chebyt(k, x), [-1, z]) / 2
    series = values**-1
    integral = integrals * series
    return {
        "nodes": [float(z) for z in nodes],
        "integral": [[float(integral[k, i]) for k in range(count)] for i in range(count)],
        "series": [[float(series[k, i]) for k in range(count)] for i in range(count)],
    }


def main() -> None:
    """Compute every number and write the file."""
    mp.mp.dps = 40
    eighth = mp.tan(mp.pi / 8)
    data = {
        "atan": polynomial("atan", lambda s: mp.atan(mp.sqrt(s)) / mp.sqrt(s), eighth**2, 9),
        "sin": polynomial(
            "sin", lambda s: mp.sin(mp.sqrt(s)) / mp.sqrt(s), (mp.pi / 2) ** 2 * mp.mpf("1.001"), 7
        ),
        "exp": exponential(9),
        "log": logarithm(6),
        "tan_pi_8": float(eighth),
        "pi_parts": split(mp.pi, 33, 3),
        "ln2_parts": split(mp.log(2), 33, 2),
        "dop853": tableau(),
        "rodas5p": rodas5p(),
        "collocation": collocation(16),
    }
    TARGET.write_text(json.dumps(data, indent=1) + "\n")


if __name__ == "__main__":
    main()
