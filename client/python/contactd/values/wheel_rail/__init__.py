"""Values of a wheel on its rail. Users import them from contactd.wheel_rail."""
