"""Panels of the drawer: matrices, camera frame, kinds, probes, explanation, measurements."""
