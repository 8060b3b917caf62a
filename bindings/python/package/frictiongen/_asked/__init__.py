"""The methods of a system, with one file for each group."""
