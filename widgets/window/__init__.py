"""The main window: what it opens, saves, exports and says."""
