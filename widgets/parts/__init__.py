"""Small widgets and words that know no pane and no panel."""
