"""`app.api` under the wheel's name: the program for scripts and notebooks.

It is imported when a name is asked for. So the command `frustum-lab` starts without numpy.
"""

TYPE_CHECKING = False  # as in `typing`, which is not imported here: a file may hide it
if TYPE_CHECKING:
    from app.api import *  # noqa: F403
else:

    def __getattr__(name):
        """Take a name of the programming interface; a submodule is no such name."""
        if name not in ("app", "widgets"):
            from app import api

            return getattr(api, name)
        raise AttributeError(name)

    def __dir__():
        return __getattr__("__all__")
