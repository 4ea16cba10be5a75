"""The command line: one entry, and what its commands share."""
