"""Levels of precision and their predicted errors, risks, and the drawing quality."""
