"""The wheel's name of `app.api`, the program for scripts and notebooks."""

from app.api import *  # noqa: F403
