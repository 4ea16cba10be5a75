"""What a lecture says of the model: notation, stages and morph, typed matrices, the frame by steps."""
