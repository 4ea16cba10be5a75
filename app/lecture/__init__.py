"""The model in the lectures' terms: notation, stages, typed matrices, the frame by steps."""
