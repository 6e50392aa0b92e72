"""Files of values: problems and solutions, tables of influence coefficients."""
