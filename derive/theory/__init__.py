"""What follows in closed form, for an aircraft and for the linear model."""
