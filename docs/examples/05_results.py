"""Results: kept with their provenance, as tables, and in a notebook."""

import numpy as np

import groundroll as gr

plane = gr.Aircraft.load("brott-physical").replace(main_gear_arm=np.array([0.3, 0.5, 0.7]))
runs = gr.simulate(plane, model="linear", v0=0.1, t=2.0, samples=201)

path = runs.save("runs.npz")  # parameters, their sources, digest of the equations, versions
again = gr.Trajectory.load(path)  # refuses files that are damaged or from other equations
assert np.array_equal(again["Y"], runs["Y"])

frame = runs.to_pandas()  # pip install 'groundroll[pandas]'
print(frame.groupby("run")[["Y", "psi"]].last())

data = runs.to_xarray()  # pip install 'groundroll[xarray]'; a is a coordinate of the runs
print(data["Y"].isel(t=-1).to_series())
