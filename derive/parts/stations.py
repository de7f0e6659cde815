"""Where fin, tailplane, propeller and wing tips are, from the CG, z down."""

from __future__ import annotations

from groundroll.derive.core.quantity import Parameter

z_fin = Parameter("z_fin", "fin_depth", "m", "centre of the fin below the CG; negative: above")
x_h = Parameter("x_h", "tailplane_arm", "m", "tailplane ahead of the CG; negative: behind")
z_h = Parameter("z_h", "tailplane_depth", "m", "tailplane below the CG; negative: above")
z_thrust = Parameter("z_thrust", "thrust_line_depth", "m", "line of thrust below the CG")
x_propeller = Parameter("x_propeller", "propeller_arm", "m", "propeller ahead of the CG")
propeller_diameter = Parameter(
    "propeller_diameter", "propeller_diameter", "m", "of the propeller", sign=">0"
)
x_tip = Parameter("x_tip", "wing_tip_arm", "m", "wing tips ahead of the CG")
z_tip = Parameter("z_tip", "wing_tip_depth", "m", "wing tips below the CG; negative: above")
