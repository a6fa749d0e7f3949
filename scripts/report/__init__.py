"""The report of a sweep: statistics, tables, plots and a page."""
