"""Matrices, camera frame, probes, scene, measurements."""
