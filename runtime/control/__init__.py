"""Whether an aircraft can be held: by a pilot who is late, in a crosswind."""
