"""What a lecture says of the model: notation, stages, typed matrices, the frame by steps."""
