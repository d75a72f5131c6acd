"""A scene as pixels, without a browser and without a GPU: what reports and saved notebooks show."""
