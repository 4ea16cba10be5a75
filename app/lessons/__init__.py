"""Lessons and talks: their files, their formulas over the model, and the marking of answers."""
