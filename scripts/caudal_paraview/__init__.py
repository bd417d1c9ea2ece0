"""A script that opens a run in ParaView as the pictures of scripts/plot show it."""
