"""The dock: camera, lens, image, animation."""
