"""What becomes of an aircraft that was pushed: survival and basins."""
