"""What results have in common: records, tables, files, and the one door to their pictures."""
