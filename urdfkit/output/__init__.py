"""What is written: reports, comparisons, diagrams, formats."""
