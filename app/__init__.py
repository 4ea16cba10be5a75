"""Frustum Lab: how a camera turns a three-dimensional scene into a picture."""

__version__ = "0.1.0"
