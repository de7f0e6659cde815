"""groundloop."""
