"""The document, its text and files, and the store with its undo."""
