"""Lessons: their files, what they ask, what is answered, and that all of it is right."""
