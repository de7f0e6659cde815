"""Stability over speed: any parameter may be an array, and results have its shape."""

import numpy as np
from matplotlib import pyplot

import groundroll as gr
from groundroll.view.plots import style

plane = gr.Aircraft.load("brott-physical")
speed = np.linspace(5.0, 50.0, 91)  # m/s
rates = {}
for name, gear in {"tail wheel down": plane, "tail wheel raised": plane.replace(Ct=0.0)}.items():
    lin = gr.linearize(gear, model="linear", speed=speed)
    window = gr.speed_window(gear)  # closed form; NaN where there is none
    unstable = (
        "at no speed" if np.isnan(window.low) else f"{window.low:.1f} to {window.high:.1f} m/s"
    )
    print(f"{name}: unstable {unstable}")
    rates[name] = lin.decay_rate

with style():
    figure, axes = pyplot.subplots(figsize=(6, 3.5))
    for name, rate in rates.items():
        axes.plot(speed, rate, label=name)
    axes.axhline(0.0, color="black", linewidth=0.8)
    axes.set(xlabel="speed (m/s)", ylabel="decay rate (1/s), stable above zero")
    axes.legend()
    figure.savefig("over_speed.png", dpi=120)
