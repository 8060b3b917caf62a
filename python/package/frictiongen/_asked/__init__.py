"""What a system can be asked: one file for each kind of question."""
