"""The main window and its components."""
