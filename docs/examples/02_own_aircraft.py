"""An aircraft of one's own: a file with units, and what follows from it."""

from pathlib import Path

import groundroll as gr

Path("my-plane.toml").write_text(
    """
title = "A homebuilt taildragger"

[airframe]
mass = "600 kg"
yaw_inertia = { value = "1100 kg m^2", source = "scaled from Brott", estimate = true }
tail_area = "0.65 m^2"
tail_lift_slope = "0.08 1/deg"

[stations] # from the weight-and-balance sheet, behind its datum
cg_station = "17.5 in"
main_gear_station = "-4 in"
tail_station = "165 in"

[main_tires]
cornering_stiffness = { value = "380 N/deg", source = "6.00-6, by load", estimate = true }

[tail_wheel]
tail_wheel_stiffness = { value = "60 N/deg", source = "a guess", estimate = true }

[runway]
speed = "80 km/h"
air_density = "1.225 kg/m^3"
gravity = "9.81 m/s^2"
"""
)
plane = gr.Aircraft.load("my-plane.toml")
print(plane)
print(f"main gear {plane['a']:.3f} m ahead of the CG, tail {plane['b']:.3f} m behind it")

for name, variant in {"down": plane, "raised": plane.replace(Ct=0.0)}.items():
    lin = gr.linearize(variant, model="linear")
    verdict = "stable" if lin.decay_rate > 0 else "unstable: errors double in"
    doubling = "" if lin.decay_rate > 0 else f" {0.693 / -lin.decay_rate:.2f} s"
    print(f"tail wheel {name}: {verdict}{doubling}")
