"""The methods of a system, one file for each group of them."""
