"""What every room needs and knows no aircraft: units, arrays, errors, files, progress, words."""
