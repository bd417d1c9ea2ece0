"""Studies of the ideal-fluid salmon: runs, tables and plots."""
