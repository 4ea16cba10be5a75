"""Scenes ready to draw: built-in, from files, and one file for each phenomenon."""
