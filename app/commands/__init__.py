"""The command line: its entry point and the commands."""
