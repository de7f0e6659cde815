"""Gusts: a side force on the tail that varies over time, and how far it pushes the aircraft."""

import numpy as np

import groundroll as gr

plane = gr.Aircraft.load("brott-physical")
force = gr.gusts.crosswind(plane, "12 kt")  # what the tail makes of a wind across the runway
print(f"12 kt across the runway are {force:.0f} N on the tail")

disturbances = {
    "a gust": gr.gusts.one_minus_cosine(peak=force, start=0.5, length=1.0),
    "a wind that sets in": gr.gusts.step(force, start=0.5),
    "a gust in a wind": gr.gusts.step(0.3 * force) + gr.gusts.one_minus_cosine(force, 0.5, 1.0),
    "a record": gr.gusts.sampled([0.0, 0.5, 0.9, 1.4], [0.0, 120.0, -80.0, 0.0]),
    "a function": lambda t: 100.0 * np.sin(2 * np.pi * 0.8 * t),
}
for name, disturbance in disturbances.items():
    run = gr.simulate(plane, disturbance=disturbance, t=5.0)
    print(f"{name:<20} {abs(run['Y']).max():6.2f} m off, {run['psi'][-1]:+.3f} rad at the end")

# How a gust is answered: metrics of any state; after a step, on the way to a steady turn.
gust = gr.simulate(plane, disturbance=disturbances["a gust"]).metrics("r")
print(f"yaw rate: {gust.peak:.3f} rad/s after {gust.peak_time:.2f} s,", end=" ")
print(f"back {gust.recovery_time:.2f} s after the gust; {gust.displacement:.2f} m aside")
wind = gr.simulate(plane, disturbance=disturbances["a wind that sets in"]).metrics("r")
print(f"yaw rate: {wind.steady:.3f} rad/s in the end, {wind.overshoot:.0%} overshoot")

# An array of peaks gives a run for each.
peaks = np.array([50.0, 100.0, 200.0])
run = gr.simulate(plane, disturbance=gr.gusts.one_minus_cosine(peaks, start=0.5), t=3.0)
print("offset after 3 s:", run["Y"][:, -1].round(2), "m")
