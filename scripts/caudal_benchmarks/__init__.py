"""Benchmarks: cases with known answers, their figures beside the references."""
