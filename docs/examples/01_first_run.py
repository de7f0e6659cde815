"""A first run: the thesis's aircraft after a sideways push of 0.1 m/s."""

import groundroll as gr

plane = gr.Aircraft.load("brott")  # a packaged aircraft; the path of your own file works too
run = gr.simulate(plane, model="nonlinear", v0=0.1, t=5.0)
print(run)  # states and outputs by name: run["v"], run["yaw_rate"], run["alpha"], ...
print(run.metrics())

tricycle = plane.replace(main_gear_arm="-0.5 m", tail_wheel_stiffness=0.0)  # units are welcome
print(gr.linearize(tricycle, model="linear"))

run.plot(("y", "theta"))[0].figure.savefig("first_run.png")
