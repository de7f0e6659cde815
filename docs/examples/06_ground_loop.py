"""The picture of the README: one gust, two gears, seen from above.

The taildragger has its tail wheel off the ground, as after touching down on the main wheels, which
then carry everything. The tricycle is the same airframe with the main gear behind the CG and some
weight on a nose wheel, which makes no side force here. The forward speed is constant in the model,
so the picture ends before that stops being a fair description.
"""

import sys

import groundroll as gr

plane = gr.Aircraft.load("brott-physical").replace(speed="60 km/h", tail_wheel_stiffness=0.0)
gust = gr.gusts.one_minus_cosine(peak="-500 N", start="0.3 s", length="1 s")
behind = plane.replace(main_gear_arm="-0.5 m", main_gear_weight_fraction=0.86)
ahead = plane.replace(main_gear_weight_fraction=1.0)
tricycle = gr.simulate(behind, disturbance=gust, t=2.5, Y0=-6.5)
taildragger = gr.simulate(ahead, disturbance=gust, t=2.5, Y0=6.5)

labels = ["tricycle, gear 0.50 m behind the CG", "taildragger, gear 0.64 m ahead of it"]
axes = gr.runway_view([tricycle, taildragger], labels=labels, width=27)
axes.figure.savefig(sys.argv[1] if len(sys.argv) > 1 else "ground-loop.png", dpi=110)

gr.animate([tricycle, taildragger], "ground-loop.gif", labels=labels, width=27, fps=10)
