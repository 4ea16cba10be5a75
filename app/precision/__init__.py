"""Levels of precision and their predicted error, what is at risk, the quality that is drawn."""
