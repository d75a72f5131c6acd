"""For authors of exercises: from one source to both notebooks, and the laws of the workbook.

Names are imported from the modules, since jupytext, which reads sources, is slow to import.
"""
