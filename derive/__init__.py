"""From kinematic vectors to generated code: the only place where the physics is written.

Read in this order: `quantities` (what the symbols mean), `kinematics` (vectors), `tire` and
`components` (forces), `newton` (equations of motion), `model` (everything assembled),
`linear` (linearisation and closed forms), `jacobian`, `emit` (code).
"""
