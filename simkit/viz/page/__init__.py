"""The page that shows a scene in a browser: its HTML, style and scripts, and a server for terminals."""
