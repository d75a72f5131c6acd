"""Controllers that have no plan: each does in every step what it was told last."""
