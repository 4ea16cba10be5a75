"""Starting and ending: display, OpenGL, log, settings, language."""
