"""The three pictures as widgets, and what the hand does in them."""
