"""Pictures of Caudal's results, from statistics.txt and the VTU files."""
