"""Pictures in two dimensions: what they are made of (`drawing`), and a writer for each format.

`svg` writes SVG; `figure` writes PNG and PDF by matplotlib, and holds what every figure of matplotlib
needs; `files` writes a file of the kind that its name asks for, and PNG of given pixels. `letters` knows how
much room text takes, `thinning` leaves out points that nobody would see.
"""
