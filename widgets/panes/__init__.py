"""The three pictures as widgets, and the mouse and the keyboard in them."""
