"""Values in files: problems and solutions, tables of influence coefficients."""
