"""What urdfdom makes of a file: its verdict, its words, its tree, nothing of our own.

Each module here follows one part of the original: `xml_verdict` its XML, `numbers` its numbers,
`links` and `joints` what it reads of them, `tree` how it joins them.

Source: urdfdom 3.0 with TinyXML 2.6; the program check_urdf of the same version is the oracle of
the tests.
"""
