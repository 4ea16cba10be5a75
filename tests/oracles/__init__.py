"""Independent answers to compare the program's with; nothing here imports its formulas."""
