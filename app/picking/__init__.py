"""What is under a pixel, and what a drag means."""
