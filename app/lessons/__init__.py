"""Lessons and talks: their files, what they ask of the model, and what is answered."""
