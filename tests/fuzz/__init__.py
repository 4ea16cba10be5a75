"""Random documents, states and files, and the tools that use them."""
