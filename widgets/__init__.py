"""The Qt window: panes, controls, and the wires between them and the store."""
