"""An aircraft: its file, its values and what follows from them, and how far they hold."""
